#include "fd_fpk/characteristics/transport_operator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/process/parallel_for.hpp"

namespace fpkcheck::fd_fpk {

// Returns the weights of the cell masses m_i in the density slope of each cell. The slope in the
// middle of three cells is the derivative of the parabola through the densities m_i / h_i of three
// cells, times the cell width h.
std::vector<DensitySlopeReconstruction::Weights>
DensitySlopeReconstruction::slope_difference_weights(const GridAxis& axis) {
  std::vector<Weights> weights(axis.cell_count(), Weights{0, 0, 0});
  for (int i = 0; i < axis.cell_count(); ++i) {
    const double h = axis.cell_width(i);
    if (i > 0 && i + 1 < axis.cell_count()) {
      const double before = axis.cell_centre(i) - axis.cell_centre(i - 1);
      const double after = axis.cell_centre(i + 1) - axis.cell_centre(i);
      const double below = -after / (before * (before + after));
      const double above = before / (after * (before + after));
      weights[i] = {h * below / axis.cell_width(i - 1), -(below + above),
                    h * above / axis.cell_width(i + 1)};
    } else if (i == 0 && axis.left_end_condition() == AxisEndCondition::boundary &&
               axis.cell_count() > 1) {
      const double slope = 1 / (axis.cell_centre(1) - axis.cell_centre(0));
      weights[i] = {0, -slope, h * slope / axis.cell_width(1)};
    } else if (i > 0 && axis.right_end_condition() == AxisEndCondition::boundary) {
      const double slope = 1 / (axis.cell_centre(i) - axis.cell_centre(i - 1));
      weights[i] = {-h * slope / axis.cell_width(i - 1), slope, 0};
    }
  }
  return weights;
}

DensitySlopeReconstruction::DensitySlopeReconstruction(const PhasePlaneGrid& grid,
                                                       const std::vector<RestPoint>& points)
    : grid_(grid),
      of_y_(slope_difference_weights(grid.x1)),
      of_v_(slope_difference_weights(grid.x2)),
      at_rest_(static_cast<std::size_t>(grid.size()), false),
      limits_y_(Eigen::VectorXd::Ones(grid.size())),
      limits_v_(Eigen::VectorXd::Ones(grid.size())) {
  for (const RestPoint& point : points) {
    for (const auto& [cell, share] : point.cells) at_rest_[cell] = true;
  }
}

Eigen::VectorXd DensitySlopeReconstruction::density_velocity_slopes(
    const Eigen::VectorXd& masses) const {
  const int nv = grid_.v_cell_count();
  Eigen::VectorXd slopes(grid_.size());
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int j = 0; j < nv; ++j) {
      const int cell = i * nv + j;
      const auto& [below, centre, above] = of_v_[j];
      double slope = centre * masses(cell);
      if (j > 0) slope += below * masses(cell - 1);
      if (j + 1 < nv) slope += above * masses(cell + 1);
      slopes(cell) = at_rest_[cell] ? 0 : limits_v_(cell) * slope;
    }
  }
  return slopes;
}

DensitySlopesInCells DensitySlopeReconstruction::operator()(const Eigen::VectorXd& masses) const {
  const int nx = grid_.nx(), nv = grid_.v_cell_count();
  DensitySlopesInCells slopes{.y = Eigen::VectorXd(grid_.size()),
                              .v = density_velocity_slopes(masses)};
  for (int i = 0; i < nx; ++i) {
    const auto& [below, centre, above] = of_y_[i];
    for (int j = 0; j < nv; ++j) {
      const int cell = i * nv + j;
      double slope = centre * masses(cell);
      if (i > 0) slope += below * masses(cell - nv);
      if (i + 1 < nx) slope += above * masses(cell + nv);
      slopes.y(cell) = at_rest_[cell] ? 0 : limits_y_(cell) * slope;
    }
  }
  return slopes;
}

void DensitySlopeReconstruction::set_slope_limiter(const Eigen::VectorXd& masses) {
  limits_y_.setOnes();
  limits_v_.setOnes();
  const auto [y, v] = (*this)(masses);
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int j = 0; j < grid_.v_cell_count(); ++j) {
      const int cell = i * grid_.v_cell_count() + j;
      // Largest decrease of the density from the centre to a corner, times the cell area
      const double dip = (std::abs(y(cell)) * grid_.x1.cell_width(i) +
                          std::abs(v(cell)) * grid_.x2.cell_width(j)) /
                         2;
      const double mass = std::max(masses(cell), 0.0);
      if (dip > mass) limits_y_(cell) = limits_v_(cell) = mass / dip;
    }
  }
}

namespace {

// Data of one grid cell, contiguous in memory, since characteristics access cells irregularly.
struct CellMassAndSlopes {
  double mass, slope_y, slope_v;
  double ended = 0;
};

// Sums of the masses of p = T q, and of the impacts, over a set of characteristics. Sums over
// disjoint sets of characteristics can be added. Each TransportedMassSums object has its own array
// of cells, since several threads add masses at the same time.
class TransportedMassSums {
 public:
  TransportedMassSums(const Characteristics& characteristics, const Eigen::VectorXd& masses,
                      const DensitySlopesInCells& slopes)
      : characteristics_(characteristics),
        continuing_(Eigen::VectorXd::Zero(masses.size())),
        at_rest_(characteristics.rest_points().size(), 0.0),
        entering_(characteristics.characteristics_from_walls().size(), 0.0) {
    const auto contacts =
        static_cast<Eigen::Index>(characteristics.indices_of_rest_points_in_contact().size());
    const Eigen::Index count = masses.size() - contacts;
    cells_.reserve(static_cast<std::size_t>(count));
    for (Eigen::Index n = 0; n < count; ++n) {
      cells_.push_back({.mass = masses(n), .slope_y = slopes.y(n), .slope_v = slopes.v(n)});
    }
  }

  // Adds the masses in the innermost cells of rest points, which remain at rest.
  void add_masses_at_rest() {
    const auto& rest = characteristics_.rest_points();
    for (std::size_t k = 0; k < rest.size(); ++k) {
      for (const auto& [cell, share] : rest[k].cells) at_rest_[k] += cells_[cell].mass;
    }
  }

  // Adds a mass that was at rest in contact until an impulse and starts along characteristics.
  void add_mass_from_contact(int point, const RestMassDistributionAfterImpulse& departures,
                             double mass) {
    for (std::size_t n = 0; n < entering_.size(); ++n) entering_[n] += departures.shares[n] * mass;
    at_rest_[point] += departures.rest_fraction * mass;
    add_impacts(*characteristics_.rest_points()[point].contact, 0, departures.momentum * mass,
                departures.energy * mass);
  }

  // Adds the masses that start along characteristics from the boundary of the phase plane.
  void add_characteristics_from_boundary(std::size_t first, std::size_t last) {
    const auto& from_boundary = characteristics_.characteristics_from_boundary();
    for (std::size_t n = first; n < last; ++n) {
      distribute_mass_at_end(from_boundary[n],
                             mass_at_track_end(from_boundary[n], 0, kIncludeSources));
    }
  }

  // Adds the masses that start along characteristics from walls, and all masses that enter
  // characteristics from walls after impacts.
  void add_characteristics_from_walls(double total_mass) {
    transport_masses_from_walls(kIncludeSources);
    // In a problem with two walls, mass may continue after an impact on a characteristic that the
    // current pass over the characteristics has already processed.
    constexpr int kMostRounds = 1000;
    constexpr double kNothing = 1e-15;
    for (int round = 0; round < kMostRounds; ++round) {
      double left = 0;
      for (const double mass : entering_) left += std::abs(mass);
      if (left <= kNothing * total_mass) break;
      transport_masses_from_walls(kExcludeSources);
    }
  }

  void add_sums(const TransportedMassSums& other) {
    for (std::size_t n = 0; n < cells_.size(); ++n) cells_[n].ended += other.cells_[n].ended;
    continuing_ += other.continuing_;
    for (std::size_t k = 0; k < at_rest_.size(); ++k) at_rest_[k] += other.at_rest_[k];
    for (std::size_t n = 0; n < entering_.size(); ++n) entering_[n] += other.entering_[n];
    for (const WallSide side : {WallSide::left, WallSide::right}) {
      const WallImpactSums& sums = other.impacts_.impact_sums_at_wall(side);
      add_impacts(side, sums.number, sums.momentum, sums.energy);
    }
  }

  // Returns the masses of the density p in the cells and at rest in contact, and the masses that
  // reach the end of a characteristic.
  TransportOperator::TransportedMasses transported_masses() && {
    const auto& rest = characteristics_.rest_points();
    const auto& contacts = characteristics_.indices_of_rest_points_in_contact();
    const auto count = static_cast<Eigen::Index>(cells_.size());
    Eigen::VectorXd ended(count + static_cast<Eigen::Index>(contacts.size()));
    for (Eigen::Index n = 0; n < count; ++n) ended(n) = cells_[static_cast<std::size_t>(n)].ended;
    for (std::size_t k = 0; k < rest.size(); ++k) {
      if (rest[k].contact) continue;
      for (const auto& [cell, share] : rest[k].cells) ended(cell) += share * at_rest_[k];
    }
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      ended(count + static_cast<Eigen::Index>(k)) = at_rest_[contacts[k]];
    }
    return {.ended = std::move(ended), .continuing = std::move(continuing_)};
  }

  const ImpactSumsOfBothWalls& impacts() const { return impacts_; }

 private:
  static constexpr std::true_type kIncludeSources{};
  // Tag of all passes over the characteristics after the first pass, which do not add the masses
  // that start in the cells
  static constexpr std::false_type kExcludeSources{};

  void add_impacts(WallSide side, double number, double momentum, double energy) {
    WallImpactSums& sums = impacts_.impact_sums_at_wall(side);
    sums.number += number;
    sums.momentum += momentum;
    sums.energy += energy;
  }

  double mass_starting_in_visit(const CharacteristicCellVisit& visit) const {
    const CellMassAndSlopes& cell = cells_[visit.cell];
    return visit.share * (cell.mass + cell.slope_y * visit.y + cell.slope_v * visit.v);
  }

  template <bool with_sources>
  double mass_at_track_end(const Characteristic& track, double mass,
                           std::bool_constant<with_sources>) {
    const auto& visits = characteristics_.characteristic_cell_visits();
    for (std::size_t n = track.first; n < track.last; ++n) {
      const CharacteristicCellVisit& visit = visits[n];
      const double begins = with_sources ? mass_starting_in_visit(visit) : 0;
      // The two updates can run in parallel: the recurrence of `mass` needs only the previous
      // `mass`.
      cells_[visit.cell].ended += visit.ended * mass + visit.mean_impulse_probability * begins;
      mass = (1.0 - visit.ended) * mass + (1.0 - visit.mean_impulse_probability) * begins;
    }
    return mass;
  }

  void add_mass_coming_to_rest(const CharacteristicEnd& characteristic_end, double mass) {
    const int point = *characteristic_end.rest;
    if (!characteristic_end.cascade) {
      at_rest_[point] += mass;
      return;
    }
    // Mass that receives an impulse during a cascade of impacts is distributed over cells on both
    // sides of v = 0.
    const ImpactCascade& cascade = *characteristic_end.cascade;
    at_rest_[point] += cascade.rest_probability * mass;
    for (const auto& [cell, share] : characteristics_.rest_points()[point].cells) {
      cells_[cell].ended += (1 - cascade.rest_probability) * share * mass;
    }
    add_impacts(*characteristic_end.wall, mass,
                (characteristic_end.speed + cascade.momentum) * mass,
                (characteristic_end.speed * characteristic_end.speed + cascade.energy) * mass);
  }

  void distribute_mass_at_end(const Characteristic& track, double mass) {
    const CharacteristicEnd& characteristic_end = track.characteristic_end;
    if (characteristic_end.rest) {
      add_mass_coming_to_rest(characteristic_end, mass);
    } else if (characteristic_end.wall) {
      entering_[characteristic_end.faster] += characteristic_end.faster_fraction * mass;
      entering_[characteristic_end.slower] += (1 - characteristic_end.faster_fraction) * mass;
      add_impacts(*characteristic_end.wall, mass, characteristic_end.speed * mass,
                  characteristic_end.speed * characteristic_end.speed * mass);
    } else if (track.last > track.first) {
      continuing_(characteristics_.characteristic_cell_visits()[track.last - 1].cell) += mass;
    }
  }

  template <bool with_sources>
  void transport_masses_from_walls(std::bool_constant<with_sources> sources) {
    const auto& from_walls = characteristics_.characteristics_from_walls();
    const auto& visits = characteristics_.characteristic_cell_visits();
    for (std::size_t n = 0; n < from_walls.size(); ++n) {
      const Characteristic& track = from_walls[n];
      const CharacteristicEnd& characteristic_end = track.characteristic_end;
      double mass = std::exchange(entering_[n], 0.0);
      if (!with_sources && mass == 0) continue;
      // If a part of the mass returns to the same characteristic after an impact, the masses of all
      // returns form a geometric series.
      double again = 0;
      if (characteristic_end.wall && !characteristic_end.rest) {
        if (characteristic_end.faster == static_cast<int>(n))
          again += characteristic_end.faster_fraction;
        if (characteristic_end.slower == static_cast<int>(n))
          again += 1 - characteristic_end.faster_fraction;
      }
      if (again > 0) {
        double lost = 0, left = 0;
        for (std::size_t m = track.first; m < track.last; ++m) {
          const CharacteristicCellVisit& visit = visits[m];
          const double begins = with_sources ? mass_starting_in_visit(visit) : 0;
          left = (1.0 - visit.ended) * left + (1.0 - visit.mean_impulse_probability) * begins;
          lost += (1 - lost) * visit.ended;
        }
        mass = (mass + again * left) / (1 - again + again * lost);
      }
      const double left = mass_at_track_end(track, mass, sources);
      distribute_mass_at_end(track, left);
      // The variable `left` includes all mass that returns to the characteristic after an impact.
      entering_[n] -= again * left;
    }
  }

  const Characteristics& characteristics_;
  std::vector<CellMassAndSlopes> cells_;
  Eigen::VectorXd continuing_;
  std::vector<double> at_rest_, entering_;
  ImpactSumsOfBothWalls impacts_;
};

}  // namespace

TransportOperator::TransportOperator(const Characteristics& characteristics,
                                     const problem::ImpulseLaw& law)
    : characteristics_(characteristics),
      contact_impulse_distributions_(characteristics.rest_mass_distributions_after_impulse(law)) {
  const auto& from_boundary = characteristics.characteristics_from_boundary();
  std::vector<std::size_t> visit_counts{0};
  for (const Characteristic& track : from_boundary) {
    visit_counts.push_back(visit_counts.back() + track.last - track.first);
  }
  for (std::size_t part = 0; part < kParts; ++part) {
    const auto at = std::ranges::lower_bound(visit_counts, part * visit_counts.back() / kParts);
    part_bounds_[part] = static_cast<std::size_t>(at - visit_counts.begin());
  }
  part_bounds_[kParts] = from_boundary.size();
}

TransportOperator::TransportedMasses TransportOperator::operator()(
    const Eigen::VectorXd& masses, const DensitySlopesInCells& slopes,
    ImpactSumsOfBothWalls* impacts) const {
  std::array<std::optional<TransportedMassSums>, kParts> parts;
  base::parallel_for(kParts, base::kOneThreadPerProcessor, [&](std::size_t part) {
    parts[part].emplace(characteristics_, masses, slopes);
    parts[part]->add_characteristics_from_boundary(part_bounds_[part], part_bounds_[part + 1]);
  });
  TransportedMassSums& sums = *parts[0];
  for (std::size_t part = 1; part < kParts; ++part) sums.add_sums(*parts[part]);
  sums.add_masses_at_rest();
  const auto& contacts = characteristics_.indices_of_rest_points_in_contact();
  const Eigen::Index count = masses.size() - static_cast<Eigen::Index>(contacts.size());
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    sums.add_mass_from_contact(contacts[k], contact_impulse_distributions_[k],
                               masses(count + static_cast<Eigen::Index>(k)));
  }
  sums.add_characteristics_from_walls(masses.cwiseAbs().sum());
  if (impacts) *impacts = sums.impacts();
  return std::move(sums).transported_masses();
}

}  // namespace fpkcheck::fd_fpk
