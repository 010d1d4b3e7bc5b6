#include "fd_fpk/characteristics/characteristics.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace fpkcheck::fd_fpk {
namespace {

// A step of the motion is crossed in this many chords.
constexpr int kChords = 5;
// Decay times of the impulses after which nothing is left that could be followed.
constexpr double kLongest = 40;
constexpr long kMostSteps = 20000;
// What creeps to rest for a long time has no area left, and still is in some cell.
constexpr double kLeastFlux = 1e-200;

int cell_of(const Line& line, double x) {
  const auto& faces = line.faces();
  const auto above = std::upper_bound(faces.begin(), faces.end(), x);
  return std::clamp(static_cast<int>(above - faces.begin()) - 1, 0, line.cells() - 1);
}

// Hermite's cubic over a step.
class Cubic {
 public:
  Cubic(const Flow& flow, const State& from, const State& to, double time)
      : from_(from),
        to_(to),
        a_{time * from.v, time * flow.acceleration(from)},
        b_{time * to.v, time * flow.acceleration(to)} {}

  State operator()(double s) const {
    const double t = 1 - s;
    const double p = t * t * (1 + 2 * s), q = s * s * (1 + 2 * t), m = s * t * t, n = -s * s * t;
    return {p * from_.y + q * to_.y + m * a_.y + n * b_.y,
            p * from_.v + q * to_.v + m * a_.v + n * b_.v};
  }

 private:
  State from_, to_, a_, b_;
};

}  // namespace

struct Characteristics::Position {
  State state;
  int i, j;           // its cell
  double flux;        // of area, now
  std::size_t first;  // visit of the track
};

Characteristics::Characteristics(const problem::System& system, const Grid& grid, double rate,
                                 int per_cell)
    : grid_(grid), flow_(system), rate_(rate), rest_(rest_cells()) {
  lay_from_box(per_cell);
  lay_from_wall(per_cell);
  lay_through_gaps();
  share_areas();
  find_landings(from_outside_);
  find_landings(from_wall_);
}

// Follows one small motion from impact to impact, or until it creeps.
RestCells Characteristics::rest_cells() const {
  constexpr double kSmall = 0.1, kAtRest = 1e-6;
  constexpr int kFiner = 10;  // steps
  const int middle = grid_.nv() / 2;
  const double speed = kSmall * grid_.x2.face(middle + 1);
  const RestCells creeping{
      .below = middle - 1, .above = middle, .share_below = 1, .impact_rate = 0};
  State state{0, speed};
  double below = 0, time = 0;
  for (long step = 0; step < kMostSteps; ++step) {
    const double frequency = flow_.frequency(state);
    if (std::hypot(frequency * state.y, state.v) < kAtRest * speed) return creeping;
    double span = flow_.longest_step(state, frequency) / kFiner;
    State end = flow_.after(state, span);
    const bool impact = end.y < 0;
    if (impact) {
      span = flow_.impact_time(state, span);
      end = {0, flow_.after(state, span).v};
    }
    if (state.v + end.v < 0) {
      below += std::exp(-rate_ * time) * -std::expm1(-rate_ * span);
    }
    time += span;
    if (impact) {
      return {.below = middle - 1,
              .above = middle,
              .share_below = below / -std::expm1(-rate_ * time),
              .impact_rate = 1 / time};
    }
    state = end;
  }
  return creeping;
}

// Through the three outer sides of the box, where the flow enters it: everything inside came from
// there or from the wall.
void Characteristics::lay_from_box(int per_cell) {
  constexpr double kInside = 1 - 1e-12;
  const double y_max = kInside * grid_.x1_max(), v_max = kInside * grid_.x2_max();
  const auto lay = [&](const State& from, double flux) {
    if (flux > 0) from_outside_.push_back(follow(from, flux));
  };
  const auto at_each = [&](const Line& line, int first, int last, const auto& start) {
    for (int i = first; i < last; ++i) {
      const double width = line.width(i) / per_cell;
      for (int k = 0; k < per_cell; ++k) start(line.face(i) + (k + 0.5) * width, width);
    }
  };
  at_each(grid_.x1, 0, grid_.nx(), [&](double y, double width) {
    lay({y, v_max}, -flow_.acceleration({y, v_max}) * width);
    lay({y, -v_max}, flow_.acceleration({y, -v_max}) * width);
  });
  at_each(grid_.x2, 0, grid_.nv() / 2, [&](double v, double width) {
    lay({y_max, v}, -v * width);
  });
}

void Characteristics::lay_from_wall(int per_cell) {
  const int middle = grid_.nv() / 2;
  for (int j = grid_.nv() - 1; j > middle; --j) {
    const double width = grid_.x2.width(j) / per_cell;
    for (int k = per_cell - 1; k >= 0; --k) {
      const double v = grid_.x2.face(j) + (k + 0.5) * width;
      speeds_.push_back(v);
      from_wall_.push_back(follow({0, v}, v * width));
    }
  }
}

// A cell that none has crossed, where the flow converges strongly, gets one of its own. Its strip
// is so narrow that it takes nothing from cells that have others.
void Characteristics::lay_through_gaps() {
  constexpr double kNarrow = 1e-9;
  std::vector<bool> crossed(grid_.size(), false);
  const auto mark = [&](std::size_t first) {
    for (std::size_t n = first; n < visits_.size(); ++n) crossed[visits_[n].cell] = true;
  };
  mark(0);
  crossed[rest_.below] = crossed[rest_.above] = true;
  for (int i = grid_.nx() - 1; i >= 0; --i) {
    for (int j = 0; j < grid_.nv(); ++j) {
      if (crossed[i * grid_.nv() + j]) continue;
      const std::size_t first = visits_.size();
      from_outside_.push_back(follow({grid_.x1.centre(i), grid_.x2.centre(j)},
                                     kNarrow * grid_.x1.width(i) * grid_.x2.width(j)));
      mark(first);
    }
  }
}

Track Characteristics::follow(const State& from, double flux) {
  Position at{.state = from,
              .i = cell_of(grid_.x1, from.y),
              .j = cell_of(grid_.x2, from.v),
              .flux = flux,
              .first = visits_.size()};
  constexpr double kNothing = 1e-3;
  Track track{.first = at.first, .last = 0};
  const double y_rest = grid_.x1.face(1), v_rest = grid_.x2.face(grid_.nv() / 2 + 1);
  double frequency = flow_.frequency(from), energy = flow_.energy(from), time = 0;
  for (long step = 0;; ++step) {
    // At rest it goes on to the wall, on whichever side of v = 0; or it creeps.
    if (at.state.y < kNothing * y_rest && std::abs(at.state.v) < kNothing * v_rest) break;
    if (step > kMostSteps && rate_ * time > kLongest) break;
    if (const double now = flow_.energy(at.state); now < energy / 4) {
      energy = now;
      frequency = flow_.frequency(at.state);
    }
    double span = flow_.longest_step(at.state, frequency);
    State end = flow_.after(at.state, span);
    const bool impact = end.y < 0;
    if (impact) {
      span = flow_.impact_time(at.state, span);
      end = {0, std::min(0.0, flow_.after(at.state, span).v)};
    }
    const Cubic path(flow_, at.state, end, span);
    for (int chord = 1; chord < kChords; ++chord) {
      cross(at, path(static_cast<double>(chord) / kChords), span / kChords);
    }
    cross(at, end, span / kChords);
    time += span;
    if (impact) {
      // Slower ones come to rest.
      if (-flow_.restitution() * end.v > v_rest) track.landing.speed = -end.v;
      break;
    }
  }
  track.last = visits_.size();
  return track;
}

// Along a straight line, from face to face.
void Characteristics::cross(Position& at, const State& to, double time) {
  const State from = at.state;
  const double dy = to.y - from.y, dv = to.v - from.v;
  // Areas shrink as exp(-c t) (Liouville).
  const double shrinking = flow_.damping() * time;
  const double flux = std::max(kLeastFlux, at.flux * -std::expm1(-shrinking) / shrinking);
  at.flux = std::max(kLeastFlux, at.flux * std::exp(-shrinking));
  at.state = to;
  double done = 0;
  while (true) {
    double y_face = 2, v_face = 2;  // beyond the end
    if (dy > 0 && at.i + 1 < grid_.nx()) y_face = (grid_.x1.faces()[at.i + 1] - from.y) / dy;
    if (dy < 0 && at.i > 0) y_face = (grid_.x1.faces()[at.i] - from.y) / dy;
    if (dv > 0 && at.j + 1 < grid_.nv()) v_face = (grid_.x2.faces()[at.j + 1] - from.v) / dv;
    if (dv < 0 && at.j > 0) v_face = (grid_.x2.faces()[at.j] - from.v) / dv;
    const double next = std::max(done, std::min({y_face, v_face, 1.0}));
    if (next > done) {
      const int cell = at.i * grid_.nv() + at.j;
      const double duration = (next - done) * time, area = flux * duration;
      const double middle = (done + next) / 2;
      const double y = from.y + middle * dy - grid_.x1.centre(at.i);
      const double v = from.v + middle * dv - grid_.x2.centre(at.j);
      if (visits_.size() > at.first && visits_.back().cell == cell) {
        Visit& visit = visits_.back();
        const double part = area / (visit.share + area);
        visit.y += part * (y - visit.y);
        visit.v += part * (v - visit.v);
        visit.share += area;
        durations_.back() += duration;
      } else {
        visits_.push_back({.cell = cell, .survival = 0, .kept = 0, .share = area, .y = y, .v = v});
        durations_.push_back(duration);
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

// Until here the shares are areas, and positions are from the centre of the cell.
void Characteristics::share_areas() {
  struct Cover {
    double area = 0, y = 0, v = 0;
  };
  std::vector<Cover> covers(grid_.size());
  for (const Visit& visit : visits_) {
    Cover& cover = covers[visit.cell];
    cover.area += visit.share;
    cover.y += visit.share * visit.y;
    cover.v += visit.share * visit.v;
  }
  for (std::size_t n = 0; n < visits_.size(); ++n) {
    Visit& visit = visits_[n];
    const Cover& cover = covers[visit.cell];
    const double expected = rate_ * durations_[n];  // impulses
    visit.survival = static_cast<float>(std::exp(-expected));
    visit.kept =
        static_cast<float>(expected > 1e-4 ? -std::expm1(-expected) / expected : 1 - expected / 2);
    // What begins at rest stays there.
    const bool at_rest = visit.cell == rest_.below || visit.cell == rest_.above;
    visit.share = at_rest ? 0 : visit.share / cover.area;
    visit.y -= cover.y / cover.area;
    visit.v -= cover.v / cover.area;
  }
  durations_ = {};
}

void Characteristics::find_landings(std::vector<Track>& tracks) const {
  const int count = static_cast<int>(speeds_.size());
  for (Track& track : tracks) {
    Landing& landing = track.landing;
    if (landing.speed == 0) continue;
    const double speed = flow_.restitution() * landing.speed;
    const auto next = std::lower_bound(speeds_.begin(), speeds_.end(), speed, std::greater<>());
    landing.slower = std::min(static_cast<int>(next - speeds_.begin()), count - 1);
    landing.faster = std::max(0, landing.slower - 1);
    const double slow = speeds_[landing.slower], fast = speeds_[landing.faster];
    landing.to_faster =
        fast > slow
            ? std::clamp((speed * speed - slow * slow) / (fast * fast - slow * slow), 0.0, 1.0)
            : 0;
  }
}

}  // namespace fpkcheck::fd_fpk
