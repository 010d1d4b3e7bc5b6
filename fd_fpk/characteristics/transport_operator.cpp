#include "fd_fpk/characteristics/transport_operator.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

namespace fpkcheck::fd_fpk {

// Returns the weights of the masses m_i in the slope of each cell. The slope of the middle cell is
// the derivative of the parabola through the densities m_i / h_i of three cells, times the cell
// width h.
std::vector<SlopeReconstruction::Weights> SlopeReconstruction::weights(const Axis& axis) {
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

SlopeReconstruction::SlopeReconstruction(const Grid& grid, const std::vector<RestPoint>& points)
    : grid_(grid),
      of_y_(weights(grid.x1)),
      of_v_(weights(grid.x2)),
      at_rest_(static_cast<std::size_t>(grid.size()), false),
      limits_y_(Eigen::VectorXd::Ones(grid.size())),
      limits_v_(Eigen::VectorXd::Ones(grid.size())) {
  for (const RestPoint& point : points) {
    for (const auto& [cell, share] : point.cells) at_rest_[cell] = true;
  }
}

Eigen::VectorXd SlopeReconstruction::velocity_slopes(const Eigen::VectorXd& masses) const {
  const int nv = grid_.nv();
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

CellSlopes SlopeReconstruction::operator()(const Eigen::VectorXd& masses) const {
  const int nx = grid_.nx(), nv = grid_.nv();
  CellSlopes slopes{.y = Eigen::VectorXd(grid_.size()), .v = velocity_slopes(masses)};
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

void SlopeReconstruction::set_slope_limiter(const Eigen::VectorXd& masses) {
  limits_y_.setOnes();
  limits_v_.setOnes();
  const auto [y, v] = (*this)(masses);
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int j = 0; j < grid_.nv(); ++j) {
      const int cell = i * grid_.nv() + j;
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

// Data of a cell, contiguous in memory, since visits access the cells in no regular order.
struct CellMass {
  double mass, slope_y, slope_v;
  double ended = 0;
};

}  // namespace

Eigen::VectorXd TransportOperator::operator()(const Eigen::VectorXd& masses,
                                              const CellSlopes& slopes,
                                              WallImpacts* impacts) const {
  const auto& visits = characteristics_.visits();
  const auto& from_walls = characteristics_.characteristics_from_walls();
  const auto& rest = characteristics_.rest_points();
  const auto& contacts = characteristics_.contact_rest_point_indices();
  const auto atoms = static_cast<Eigen::Index>(contacts.size());
  const Eigen::Index count = masses.size() - atoms;
  std::vector<CellMass> cells;
  cells.reserve(static_cast<std::size_t>(count));
  for (Eigen::Index n = 0; n < count; ++n) {
    cells.push_back({.mass = masses(n), .slope_y = slopes.y(n), .slope_v = slopes.v(n)});
  }
  std::vector<double> at_rest(rest.size(), 0.0), entering(from_walls.size(), 0.0);
  for (std::size_t k = 0; k < rest.size(); ++k) {
    for (const auto& [cell, share] : rest[k].cells) at_rest[k] += masses(cell);
  }
  const auto hit = [&](WallSide side, double number, double momentum, double energy) {
    if (!impacts) return;
    ImpactSums& sums = impacts->sums_at(side);
    sums.number += number;
    sums.momentum += momentum;
    sums.energy += energy;
  };
  for (Eigen::Index k = 0; k < atoms; ++k) {
    const ContactImpulseDistribution& departures =
        contact_impulse_distributions_[static_cast<std::size_t>(k)];
    const int point = contacts[static_cast<std::size_t>(k)];
    const double mass = masses(count + k);
    for (std::size_t n = 0; n < entering.size(); ++n) entering[n] += departures.shares[n] * mass;
    at_rest[point] += departures.rest_fraction * mass;
    hit(*rest[point].contact, 0, departures.momentum * mass, departures.energy * mass);
  }

  const auto source = [&](const CellVisit& visit) {
    const CellMass& cell = cells[visit.cell];
    return visit.share * (cell.mass + cell.slope_y * visit.y + cell.slope_v * visit.v);
  };
  constexpr std::true_type kIncludeSources;
  // tag of later passes, which do not add the masses that start in the cells again
  constexpr std::false_type kExcludeSources;
  const auto mass_at_track_end = [&](const Characteristic& track, double mass, auto with_sources) {
    for (std::size_t n = track.first; n < track.last; ++n) {
      const CellVisit& visit = visits[n];
      const double begins = with_sources ? source(visit) : 0;
      // The two updates are independent: the recurrence of `mass` needs only the previous `mass`.
      cells[visit.cell].ended += visit.ended * mass + visit.mean_end_probability * begins;
      mass = (1.0 - visit.ended) * mass + (1.0 - visit.mean_end_probability) * begins;
    }
    return mass;
  };
  const auto come_to_rest = [&](const CharacteristicEnd& characteristic_end, double mass) {
    const int point = *characteristic_end.rest;
    if (!characteristic_end.cascade) {
      at_rest[point] += mass;
      return;
    }
    // Mass that receives an impulse during the cascade of impacts is distributed on both sides of v
    // = 0.
    const ImpactCascade& cascade = *characteristic_end.cascade;
    at_rest[point] += cascade.rest_probability * mass;
    for (const auto& [cell, share] : rest[point].cells) {
      cells[cell].ended += (1 - cascade.rest_probability) * share * mass;
    }
    hit(*characteristic_end.wall, mass, (characteristic_end.speed + cascade.momentum) * mass,
        (characteristic_end.speed * characteristic_end.speed + cascade.energy) * mass);
  };
  const auto distribute_at_end = [&](const Characteristic& track, double mass) {
    const CharacteristicEnd& characteristic_end = track.characteristic_end;
    if (characteristic_end.rest) {
      come_to_rest(characteristic_end, mass);
    } else if (characteristic_end.wall) {
      entering[characteristic_end.faster] += characteristic_end.faster_fraction * mass;
      entering[characteristic_end.slower] += (1 - characteristic_end.faster_fraction) * mass;
      hit(*characteristic_end.wall, mass, characteristic_end.speed * mass,
          characteristic_end.speed * characteristic_end.speed * mass);
    } else if (track.last > track.first) {
      cells[visits[track.last - 1].cell].ended += mass;
    }
  };

  for (const Characteristic& track : characteristics_.characteristics_from_boundary()) {
    distribute_at_end(track, mass_at_track_end(track, 0, kIncludeSources));
  }
  const auto leave_walls = [&](auto with_sources) {
    for (std::size_t n = 0; n < from_walls.size(); ++n) {
      const Characteristic& track = from_walls[n];
      const CharacteristicEnd& characteristic_end = track.characteristic_end;
      double mass = std::exchange(entering[n], 0.0);
      if (!with_sources && mass == 0) continue;
      // If mass returns to a characteristic after an impact, the masses of all returns form a
      // geometric series.
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
          const CellVisit& visit = visits[m];
          const double begins = with_sources ? source(visit) : 0;
          left = (1.0 - visit.ended) * left + (1.0 - visit.mean_end_probability) * begins;
          lost += (1 - lost) * visit.ended;
        }
        mass = (mass + again * left) / (1 - again + again * lost);
      }
      const double left = mass_at_track_end(track, mass, with_sources);
      distribute_at_end(track, left);
      // The variable `left` already includes the mass of all returns to the characteristic.
      entering[n] -= again * left;
    }
  };
  leave_walls(kIncludeSources);
  // With two walls, mass may continue on a characteristic that the pass has already processed.
  constexpr int kMostRounds = 1000;
  constexpr double kNothing = 1e-15;
  for (int round = 0; round < kMostRounds; ++round) {
    double left = 0;
    for (const double mass : entering) left += std::abs(mass);
    if (left <= kNothing * masses.cwiseAbs().sum()) break;
    leave_walls(kExcludeSources);
  }
  Eigen::VectorXd ended(masses.size());
  for (Eigen::Index n = 0; n < count; ++n) ended(n) = cells[static_cast<std::size_t>(n)].ended;
  for (std::size_t k = 0; k < rest.size(); ++k) {
    if (rest[k].contact) continue;
    for (const auto& [cell, share] : rest[k].cells) ended(cell) += share * at_rest[k];
  }
  for (Eigen::Index k = 0; k < atoms; ++k) {
    ended(count + k) = at_rest[contacts[static_cast<std::size_t>(k)]];
  }
  return ended;
}

}  // namespace fpkcheck::fd_fpk
