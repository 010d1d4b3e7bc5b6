#include "fd_fpk/characteristics/characteristics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "base/process/parallel_for.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Number of straight chords that represent the path of one time step in the phase plane.
constexpr int kChords = 10;
// Maximum duration of a characteristic, in mean times between impulses; the mass that receives no
// impulse for a longer time is negligible.
constexpr double kMaxDecayTimes = 40;
constexpr long kMostSteps = 20000;
// Maximum duration of a characteristic along a limit cycle, in mean times between impulses. Mass
// that receives no impulse before the maximum duration continues from the cell of the last state: a
// fraction of 9e-4 of the mass at the beginning of the characteristic, and a larger fraction of
// mass that starts later. For the example `relaxation` the residual of the power balance is 1.4e-3
// with the maximum duration 7, 1.1e-3 with 14, and 4.6e-3 with 4 mean times between impulses.
constexpr double kMaxCycleDecayTimes = 7;
// Lower limit of the area flux of a characteristic, which decays to zero for overdamped motion.
constexpr double kLeastFlux = 1e-200;

int cell_index_at(const GridAxis& axis, double x) {
  const auto& faces = axis.faces();
  const auto above = std::upper_bound(faces.begin(), faces.end(), x);
  return std::clamp(static_cast<int>(above - faces.begin()) - 1, 0, axis.cell_count() - 1);
}

// Reserves memory for `count` elements of a vector. A new capacity is at least twice the old
// capacity, so that many small insertions copy each element only a few times.
template <class T>
void reserve_at_least(std::vector<T>& elements, std::size_t count) {
  if (count > elements.capacity()) elements.reserve(std::max(count, 2 * elements.capacity()));
}

// Returns (1 - exp(-x)) / x, the mean of exp(-s) over 0 < s < x.
double mean_of_decay(double x) {
  constexpr double kSmall = 0.01;  // the remainder of the series is below 2e-13 x
  if (std::abs(x) > kSmall) return -std::expm1(-x) / x;
  return 1 - x / 2 * (1 - x / 3 * (1 - x / 4 * (1 - x / 5)));
}

class HermiteCubicInterpolant {
 public:
  HermiteCubicInterpolant(const DeterministicFlow& flow, const PhaseState& from,
                          const PhaseState& to, double time)
      : from_(from),
        to_(to),
        a_{time * from.v, time * flow.acceleration(from)},
        b_{time * to.v, time * flow.acceleration(to)} {}

  PhaseState operator()(double s) const {
    const double t = 1 - s;
    const double p = t * t * (1 + 2 * s), q = s * s * (1 + 2 * t), m = s * t * t, n = -s * s * t;
    return {p * from_.y + q * to_.y + m * a_.y + n * b_.y,
            p * from_.v + q * to_.v + m * a_.v + n * b_.v};
  }

 private:
  PhaseState from_, to_, a_, b_;
};

}  // namespace

struct Characteristics::TracingState {
  PhaseState state;
  int i, j;
  double flux;
  std::size_t first;  // index of the first cell visit of the characteristic in TracedPart::visits
};

Characteristics::Characteristics(const problem::System& system, const PhasePlaneGrid& grid,
                                 double impulse_rate, int characteristics_per_cell,
                                 const base::Deadline& deadline)
    : grid_(grid),
      deadline_(deadline),
      flow_(system),
      rate_(impulse_rate),
      rest_(fd_fpk::find_rest_points(flow_, grid, impulse_rate)),
      at_rest_(static_cast<std::size_t>(grid.size()), false) {
  for (std::size_t n = 0; n < rest_.size(); ++n) {
    if (rest_[n].contact) contacts_.push_back(static_cast<int>(n));
    for (const auto& [cell, share] : rest_[n].cells) at_rest_[cell] = true;
  }
  trace_characteristics_from_box_edges(characteristics_per_cell);
  for (const WallSide side : {WallSide::left, WallSide::right}) {
    if (flow_.wall(side)) trace_characteristics_from_wall(side, characteristics_per_cell);
  }
  sort_wall_characteristics();
  if (rest_.empty()) trace_characteristics_from_uncovered();
  trace_through_uncrossed_cells();
  normalise_characteristic_areas();
  find_characteristics_after_impacts(from_outside_);
  find_characteristics_after_impacts(from_walls_);
}

std::string Characteristics::failure_reason() const {
  if (out_of_time_)
    return "characteristics: max_seconds expired during their construction; increase max-seconds";
  if (visits_.size() <= kMaxCharacteristicCellVisits) return "";
  return fmt::format("characteristics: more than {} cell visits; use a coarser grid",
                     kMaxCharacteristicCellVisits);
}

// Traces characteristics of the motion from the sides of the computational box where motion enters
// the computational box. Motion that does not enter the computational box through its sides starts
// at a wall or near an unstable equilibrium.
void Characteristics::trace_characteristics_from_box_edges(int characteristics_per_cell) {
  constexpr double kInside = 1e-12;
  const double length = grid_.x1_max() - grid_.x1_min();
  const double y_min = grid_.x1_min() + kInside * length;
  const double y_max = grid_.x1_max() - kInside * length, v_max = (1 - kInside) * grid_.x2_max();
  std::vector<TraceStart> starts;
  const auto lay = [&](const PhaseState& from, double flux) {
    if (flux > 0) starts.push_back({from, flux});
  };
  const auto at_each = [&](const GridAxis& axis, int first, int last, const auto& start) {
    for (int i = first; i < last; ++i) {
      const double width = axis.cell_width(i) / characteristics_per_cell;
      for (int k = 0; k < characteristics_per_cell; ++k)
        start(axis.face_position(i) + (k + 0.5) * width, width);
    }
  };
  at_each(grid_.x1, 0, grid_.nx(), [&](double y, double width) {
    lay({y, v_max}, -flow_.acceleration({y, v_max}) * width);
    lay({y, -v_max}, flow_.acceleration({y, -v_max}) * width);
  });
  if (!flow_.wall(WallSide::right)) {
    at_each(grid_.x2, 0, grid_.v_cell_count() / 2, [&](double v, double width) {
      lay({y_max, v}, -v * width);
    });
  }
  if (!flow_.wall(WallSide::left)) {
    at_each(grid_.x2, grid_.v_cell_count() / 2, grid_.v_cell_count(), [&](double v, double width) {
      lay({y_min, v}, v * width);
    });
  }
  from_outside_ = trace_characteristics(starts);
}

// At a wall with a rest point of the motion no characteristic starts in the innermost cell of the
// rest point. Motion from the innermost cell of a rest point in contact is a cascade of impacts.
// Mass in the innermost cell of an equilibrium at a wall counts as mass at rest.
void Characteristics::trace_characteristics_from_wall(WallSide side, int characteristics_per_cell) {
  const int middle = grid_.v_cell_count() / 2;
  const double y = flow_.wall(side)->position;
  const bool rests =
      std::ranges::any_of(rest_, [&](const RestPoint& place) { return place.y == y; });
  WallCharacteristics& wall_characteristics = this->wall_characteristics(side);
  std::vector<TraceStart> starts;
  for (int j = grid_.v_cell_count() - 1; j >= (rests ? middle + 1 : middle); --j) {
    const double width = grid_.x2.cell_width(j) / characteristics_per_cell;
    for (int k = characteristics_per_cell - 1; k >= 0; --k) {
      const double speed = grid_.x2.face_position(j) + (k + 0.5) * width;
      wall_characteristics.speeds.push_back(speed);
      wall_characteristics.below.push_back(speed - width / 2);
      wall_characteristics.tracks.push_back(static_cast<int>(from_walls_.size() + starts.size()));
      starts.push_back({{y, inward_sign(side) * speed}, speed * width});
    }
  }
  const std::vector<Characteristic> traced = trace_characteristics(starts);
  from_walls_.insert(from_walls_.end(), traced.begin(), traced.end());
}

void Characteristics::sort_wall_characteristics() {
  if (from_left_.speeds.empty() || from_right_.speeds.empty()) return;
  std::vector<int> order(from_walls_.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater<>(), [&](int n) { return from_walls_[n].energy; });
  std::vector<Characteristic> sorted;
  std::vector<int> place(order.size());
  for (const int n : order) {
    place[n] = static_cast<int>(sorted.size());
    sorted.push_back(from_walls_[n]);
  }
  from_walls_ = std::move(sorted);
  for (WallCharacteristics* wall_characteristics : {&from_left_, &from_right_}) {
    for (int& track : wall_characteristics->tracks) track = place[track];
  }
}

// Traces characteristics that start at the faces through which the motion enters a cell, for each
// cell whose area is not covered by the strips of other characteristics. Inside a limit cycle the
// cells are not covered, since motion inside the limit cycle starts near an unstable equilibrium
// instead of a side of the computational box. The strips of the additional characteristics cover
// the missing fraction of the cell area. Cells are processed in the order of increasing energy,
// since motion away from an unstable equilibrium passes cells of lower energy first.
void Characteristics::trace_characteristics_from_uncovered() {
  constexpr double kMissing = 0.3;  // largest accepted fraction of the area without strips
  constexpr double kInside = 1e-9;  // distance of the starts from the faces, in cell widths
  const int nv = grid_.v_cell_count();
  const Eigen::VectorXd areas = grid_.cell_areas();
  Eigen::VectorXd covered = Eigen::VectorXd::Zero(grid_.size());
  const auto add_areas_of_visits = [&](std::size_t first) {
    for (std::size_t n = first; n < visits_.size(); ++n) {
      covered(visits_[n].cell) += visits_[n].share;
    }
  };
  const auto missing_fraction = [&](int cell) { return 1 - covered(cell) / areas(cell); };
  add_areas_of_visits(0);
  std::vector<std::pair<double, int>> uncovered;  // energies and indices of cells
  for (int cell = 0; cell < grid_.size(); ++cell) {
    if (missing_fraction(cell) < kMissing) continue;
    uncovered.emplace_back(
        flow_.mechanical_energy({grid_.x1.cell_centre(cell / nv), grid_.x2.cell_centre(cell % nv)}),
        cell);
  }
  std::ranges::sort(uncovered);
  for (const auto& [energy, cell] : uncovered) {
    const double missing = missing_fraction(cell);
    if (missing < kMissing) continue;
    const std::size_t first = visits_.size();
    const int i = cell / nv, j = cell % nv;
    const double y = grid_.x1.cell_centre(i), width_y = grid_.x1.cell_width(i);
    const double v = grid_.x2.cell_centre(j), width_v = grid_.x2.cell_width(j);
    const auto trace_if_inflow = [&](const PhaseState& from, double inflow) {
      if (inflow > 0) from_outside_.push_back(trace_characteristic(from, missing * inflow));
    };
    const double half_y = (0.5 - kInside) * width_y, half_v = (0.5 - kInside) * width_v;
    trace_if_inflow({v > 0 ? y - half_y : y + half_y, v}, std::abs(v) * width_v);
    trace_if_inflow({y, v - half_v}, flow_.acceleration({y, v - half_v}) * width_y);
    trace_if_inflow({y, v + half_v}, -flow_.acceleration({y, v + half_v}) * width_y);
    add_areas_of_visits(first);
  }
}

// Traces a characteristic from each cell that no other characteristic crosses, where the flow
// converges strongly. The narrow strip about a characteristic from an uncrossed cell has a
// negligible area in other cells.
void Characteristics::trace_through_uncrossed_cells() {
  constexpr double kNarrow = 1e-9;
  std::vector<bool> crossed = at_rest_;
  const auto mark = [&](std::size_t first) {
    for (std::size_t n = first; n < visits_.size(); ++n) crossed[visits_[n].cell] = true;
  };
  mark(0);
  for (int i = grid_.nx() - 1; i >= 0; --i) {
    for (int j = 0; j < grid_.v_cell_count(); ++j) {
      if (crossed[i * grid_.v_cell_count() + j]) continue;
      const std::size_t first = visits_.size();
      from_outside_.push_back(
          trace_characteristic({grid_.x1.cell_centre(i), grid_.x2.cell_centre(j)},
                               kNarrow * grid_.x1.cell_width(i) * grid_.x2.cell_width(j)));
      mark(first);
    }
  }
}

// Returns the index of the equilibrium whose innermost cells contain the given state of the motion.
std::optional<int> Characteristics::equilibrium_with_cells_containing(const PhaseState& at) const {
  const int cell =
      cell_index_at(grid_.x1, at.y) * grid_.v_cell_count() + cell_index_at(grid_.x2, at.v);
  if (!at_rest_[cell]) return std::nullopt;
  for (std::size_t n = 0; n < rest_.size(); ++n) {
    const RestPoint& place = rest_[n];
    const bool inside =
        !place.contact && std::ranges::any_of(place.cells, [&](const RestMassFractionInCell& c) {
          return c.cell == cell;
        });
    if (inside && flow_.mechanical_energy(at) < place.escape_energy) return static_cast<int>(n);
  }
  return std::nullopt;
}

// Traces the characteristics from the given start states in several threads. The returned
// characteristics and their cell visits are in the order of the start states, for any number of
// threads.
std::vector<Characteristic> Characteristics::trace_characteristics(
    const std::vector<TraceStart>& starts) {
  constexpr std::size_t kStartsPerPart = 64;  // many parts, since characteristics differ in length
  std::vector<TracedPart> parts((starts.size() + kStartsPerPart - 1) / kStartsPerPart);
  std::atomic<std::size_t> visit_count = visits_.size();
  base::parallel_for(parts.size(), base::kOneThreadPerProcessor, [&](std::size_t k) {
    const std::size_t last = std::min(starts.size(), (k + 1) * kStartsPerPart);
    for (std::size_t n = k * kStartsPerPart; n < last; ++n) {
      trace_characteristic(starts[n], visit_count, parts[k]);
    }
  });
  reserve_at_least(visits_, visit_count);
  reserve_at_least(durations_, visit_count);
  std::vector<Characteristic> tracks;
  for (TracedPart& part : parts) {
    for (Characteristic& track : part.tracks) {
      track.first += visits_.size();
      track.last += visits_.size();
      tracks.push_back(track);
    }
    visits_.insert(visits_.end(), part.visits.begin(), part.visits.end());
    durations_.insert(durations_.end(), part.durations.begin(), part.durations.end());
    out_of_time_ = out_of_time_ || part.out_of_time;
    part = {};  // frees memory, which the visits would otherwise take twice
  }
  return tracks;
}

void Characteristics::trace_characteristic(const TraceStart& start,
                                           std::atomic<std::size_t>& visit_count,
                                           TracedPart& part) const {
  const PhaseState& from = start.state;
  TracingState at{.state = from,
                  .i = cell_index_at(grid_.x1, from.y),
                  .j = cell_index_at(grid_.x2, from.v),
                  .flux = start.flux,
                  .first = part.visits.size()};
  if (deadline_.has_deadline_passed()) part.out_of_time = true;
  const auto own_visits = [&] { return part.visits.size() - at.first; };
  const auto must_stop_tracing = [&] {
    return out_of_time_ || part.out_of_time ||
           visit_count + own_visits() > kMaxCharacteristicCellVisits;
  };
  // An accessible interval of displacements is reused for a later state if the ratio of the smaller
  // to the larger of the two energies is at least kReuseRatio
  constexpr double kReuseRatio = 0.7;
  Characteristic track{.first = at.first, .last = 0, .energy = flow_.mechanical_energy(from)};
  AccessibleDisplacements accessible_displacements = flow_.accessible_displacements(from);
  double energy = track.energy - accessible_displacements.least_potential, time = 0;
  for (long step = 0;; ++step) {
    if ((track.characteristic_end.rest = equilibrium_with_cells_containing(at.state))) break;
    if (must_stop_tracing() || (step > kMostSteps && rate_ * time > kMaxDecayTimes)) break;
    // Along a limit cycle no rest point ends a characteristic, so that its duration is limited.
    if (rest_.empty() && rate_ * time > kMaxCycleDecayTimes) break;
    const double left =
        flow_.mechanical_energy(at.state) - accessible_displacements.least_potential;
    if (left < kReuseRatio * energy || left * kReuseRatio > energy) {
      accessible_displacements = flow_.accessible_displacements(at.state);
      energy = flow_.mechanical_energy(at.state) - accessible_displacements.least_potential;
    }
    double span = flow_.max_time_step(at.state, accessible_displacements);
    PhaseState end = flow_.advance_state(at.state, span);
    const auto hit = flow_.wall_passed_by_displacement(end.y);
    if (hit) {
      span = flow_.impact_time(at.state, span, *hit);
      end = {flow_.wall(*hit)->position, flow_.advance_state(at.state, span).v};
      // At an impact, rounding errors may give the velocity the wrong sign.
      end.v = *hit == WallSide::left ? std::min(0.0, end.v) : std::max(0.0, end.v);
    }
    const HermiteCubicInterpolant path(flow_, at.state, end, span);
    for (int chord = 1; chord < kChords; ++chord) {
      record_cell_visits(at, path(static_cast<double>(chord) / kChords), span / kChords, part);
    }
    record_cell_visits(at, end, span / kChords, part);
    time += span;
    if (hit) {
      set_characteristic_end_at_wall(*hit, std::abs(end.v), track.characteristic_end);
      break;
    }
  }
  track.last = part.visits.size();
  visit_count += own_visits();
  part.tracks.push_back(track);
}

// Motion that leaves a wall within the innermost cells of a rest point comes to rest.
void Characteristics::set_characteristic_end_at_wall(WallSide side, double speed,
                                                     CharacteristicEnd& characteristic_end) const {
  characteristic_end.wall = side;
  characteristic_end.speed = speed;
  const problem::Wall& wall = *flow_.wall(side);
  const double slow = grid_.x2.face_position(grid_.v_cell_count() / 2 + 1),
               left = wall.restitution * speed;
  if (left > slow) return;
  for (std::size_t n = 0; n < rest_.size(); ++n) {
    if (rest_[n].y != wall.position) continue;
    characteristic_end.rest = static_cast<int>(n);
    if (!rest_[n].contact) continue;
    characteristic_end.cascade =
        impact_cascade(left, std::abs(flow_.static_force(wall.position)), wall.restitution, rate_);
  }
}

// Records the grid cells that a straight chord of a characteristic visits.
void Characteristics::record_cell_visits(TracingState& at, const PhaseState& to, double time,
                                         TracedPart& part) const {
  std::vector<CharacteristicCellVisit>& visits = part.visits;
  const PhaseState from = at.state;
  const double dy = to.y - from.y, dv = to.v - from.v;
  // Over one chord of a characteristic the flow contracts areas by the factor exp(-x), on average
  // by (1 - exp(-x)) / x (Liouville).
  const double x = flow_.contraction_rate({(from.y + to.y) / 2, (from.v + to.v) / 2}) * time;
  const double mean = mean_of_decay(x);
  const double flux = std::max(kLeastFlux, at.flux * mean);
  at.flux = std::max(kLeastFlux, at.flux * (1 - x * mean));
  at.state = to;
  double done = 0;
  while (true) {
    // Positions of the next cell faces in y and in v along a chord, as fractions of the chord
    // length; above 1 for faces beyond the end of the chord
    double y_face = 2, v_face = 2;
    if (dy > 0 && at.i + 1 < grid_.nx()) y_face = (grid_.x1.faces()[at.i + 1] - from.y) / dy;
    if (dy < 0 && at.i > 0) y_face = (grid_.x1.faces()[at.i] - from.y) / dy;
    if (dv > 0 && at.j + 1 < grid_.v_cell_count())
      v_face = (grid_.x2.faces()[at.j + 1] - from.v) / dv;
    if (dv < 0 && at.j > 0) v_face = (grid_.x2.faces()[at.j] - from.v) / dv;
    const double next = std::max(done, std::min({y_face, v_face, 1.0}));
    if (next > done) {
      const int cell = at.i * grid_.v_cell_count() + at.j;
      const double duration = (next - done) * time, area = flux * duration;
      const double middle = (done + next) / 2;
      const double y = from.y + middle * dy - grid_.x1.cell_centre(at.i);
      const double v = from.v + middle * dv - grid_.x2.cell_centre(at.j);
      if (visits.size() > at.first && visits.back().cell == cell) {
        CharacteristicCellVisit& visit = visits.back();
        const double fraction = area / (visit.share + area);
        visit.y += fraction * (y - visit.y);
        visit.v += fraction * (v - visit.v);
        visit.share += area;
        part.durations.back() += duration;
      } else {
        visits.push_back({.cell = cell,
                          .ended = 0,
                          .mean_impulse_probability = 0,
                          .share = area,
                          .y = y,
                          .v = v});
        part.durations.push_back(duration);
      }
    }
    done = next;
    if (done >= 1) return;
    if (y_face <= v_face) {
      at.i += dy > 0 ? 1 : -1;
    } else {
      at.j += dv > 0 ? 1 : -1;
    }
  }
}

// Converts the area of each cell visit to a fraction of the cell area, and the position of each
// cell visit from the distance to the cell centre to the distance to the mean position of all
// visits to the cell.
void Characteristics::normalise_characteristic_areas() {
  struct Cover {
    double area = 0, y = 0, v = 0;
  };
  std::vector<Cover> covers(grid_.size());
  for (const CharacteristicCellVisit& visit : visits_) {
    Cover& cover = covers[visit.cell];
    cover.area += visit.share;
    cover.y += visit.share * visit.y;
    cover.v += visit.share * visit.v;
  }
  const auto normalise = [&](CharacteristicCellVisit& visit, double duration) {
    const Cover& cover = covers[visit.cell];
    const double expected = rate_ * duration;
    const double ended = expected * mean_of_decay(expected);
    visit.ended = static_cast<float>(ended);
    visit.mean_impulse_probability =
        static_cast<float>(expected > 1e-4 ? 1 - ended / expected : expected / 2);
    // Mass that starts in the innermost cells of a rest point remains at rest.
    visit.share = at_rest_[visit.cell] ? 0 : visit.share / cover.area;
    visit.y -= cover.y / cover.area;
    visit.v -= cover.v / cover.area;
  };
  constexpr std::size_t kParts = 16;
  base::parallel_for(kParts, base::kOneThreadPerProcessor, [&](std::size_t k) {
    const std::size_t last = visits_.size() * (k + 1) / kParts;
    for (std::size_t n = visits_.size() * k / kParts; n < last; ++n) {
      normalise(visits_[n], durations_[n]);
    }
  });
  durations_ = {};
}

void Characteristics::find_characteristics_after_impacts(
    std::vector<Characteristic>& tracks) const {
  for (Characteristic& track : tracks) {
    CharacteristicEnd& characteristic_end = track.characteristic_end;
    if (!characteristic_end.wall || characteristic_end.rest) continue;
    const WallCharacteristics& wall_characteristics =
        this->wall_characteristics(*characteristic_end.wall);
    const auto count = static_cast<int>(wall_characteristics.speeds.size());
    const double speed =
        flow_.wall(*characteristic_end.wall)->restitution * characteristic_end.speed;
    const auto next = std::lower_bound(wall_characteristics.speeds.begin(),
                                       wall_characteristics.speeds.end(), speed, std::greater<>());
    const int slower =
        std::min(static_cast<int>(next - wall_characteristics.speeds.begin()), count - 1);
    const int faster = std::max(0, slower - 1);
    const double slow = wall_characteristics.speeds[slower],
                 fast = wall_characteristics.speeds[faster];
    characteristic_end.slower = wall_characteristics.tracks[slower];
    characteristic_end.faster = wall_characteristics.tracks[faster];
    characteristic_end.faster_fraction =
        fast > slow
            ? std::clamp((speed * speed - slow * slow) / (fast * fast - slow * slow), 0.0, 1.0)
            : 0;
  }
}

std::vector<RestMassDistributionAfterImpulse>
Characteristics::rest_mass_distributions_after_impulse(const problem::ImpulseLaw& law) const {
  using Quadrature = boost::math::quadrature::gauss_kronrod<double, 61>;
  std::vector<RestMassDistributionAfterImpulse> all;
  for (const int contact : contacts_) {
    const WallSide side = *rest_[contact].contact;
    const double r = flow_.wall(side)->restitution;
    // Probability that an impulse off the wall gives a speed below u, and probability that an
    // impulse into the wall gives a speed above u
    const auto slower_off = [&](double u) {
      return side == WallSide::left ? law.cumulative_probability(u)
                                    : 1 - law.cumulative_probability(-u);
    };
    const auto faster_into = [&](double u) {
      return side == WallSide::left ? law.cumulative_probability(-u)
                                    : 1 - law.cumulative_probability(u);
    };
    // Probability that an impulse on mass at rest gives a speed between 0 and u
    const auto slower = [&](double u) {
      return std::isinf(u) ? 1.0 : slower_off(u) - faster_into(u / r);
    };
    const WallCharacteristics& wall_characteristics = this->wall_characteristics(side);
    RestMassDistributionAfterImpulse departures{.shares =
                                                    std::vector<double>(from_walls_.size(), 0.0)};
    for (std::size_t k = 0; k < wall_characteristics.speeds.size(); ++k) {
      const double above =
          k == 0 ? std::numeric_limits<double>::infinity() : wall_characteristics.below[k - 1];
      departures.shares[wall_characteristics.tracks[k]] =
          slower(above) - slower(wall_characteristics.below[k]);
    }
    departures.rest_fraction = slower(wall_characteristics.below.back());
    // The means E[Y^-] and E[(Y^-)^2], with Y^- = max(-Y, 0) and the impulse amplitude Y, are
    // integrated by parts between the breakpoints of the law of Y, and summed over its atoms.
    const double into = side == WallSide::left ? -1 : 1;
    std::vector<double> ends{0};
    for (const double end : law.amplitude_density_breakpoints()) {
      if (into * end > 0) ends.push_back(into * end);
    }
    std::ranges::sort(ends);
    for (std::size_t n = 0; n + 1 < ends.size(); ++n) {
      departures.momentum += Quadrature::integrate(faster_into, ends[n], ends[n + 1], 5, 1e-9);
      departures.energy += Quadrature::integrate([&](double u) { return 2 * u * faster_into(u); },
                                                 ends[n], ends[n + 1], 5, 1e-9);
    }
    for (const auto& [amplitude, probability] : law.amplitude_atoms()) {
      if (into * amplitude <= 0) continue;
      departures.momentum += probability * std::abs(amplitude);
      departures.energy += probability * amplitude * amplitude;
    }
    all.push_back(std::move(departures));
  }
  return all;
}

}  // namespace fpkcheck::fd_fpk
