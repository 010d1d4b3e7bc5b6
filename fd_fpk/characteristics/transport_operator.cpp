#include "fd_fpk/characteristics/transport_operator.hpp"

#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

namespace fpkcheck::fd_fpk {
namespace {

// The data of a cell that a visit uses. The data are contiguous in memory, since visits access the
// cells in no regular order.
struct CellMass {
  double mass, slope_y, slope_v;
  double ended = 0;
};

}  // namespace

Eigen::VectorXd TransportOperator::operator()(const Eigen::VectorXd& masses,
                                              const CellSlopes& slopes,
                                              WallImpacts* impacts) const {
  const auto& visits = characteristics_.visits();
  const auto& from_walls = characteristics_.tracks_from_walls();
  const auto& rest = characteristics_.rest_points();
  const auto& contacts = characteristics_.contact_indices();
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
    const ContactDepartures& departures = departures_from_contacts_[static_cast<std::size_t>(k)];
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
  // Mass that arrives at the end of a track.
  constexpr std::true_type kIncludeSources;
  // tag: the masses that start in the cells were added in an earlier pass
  constexpr std::false_type kExcludeSources;
  const auto mass_at_track_end = [&](const Track& track, double mass, auto with_sources) {
    for (std::size_t n = track.first; n < track.last; ++n) {
      const CellVisit& visit = visits[n];
      const double begins = with_sources ? source(visit) : 0;
      // The two updates are independent, so that the recurrence of `mass` depends only on the
      // previous value of `mass`.
      cells[visit.cell].ended += visit.ended * mass + visit.mean_end_probability * begins;
      mass = (1.0 - visit.ended) * mass + (1.0 - visit.mean_end_probability) * begins;
    }
    return mass;
  };
  const auto come_to_rest = [&](const TrackEnd& track_end, double mass) {
    const int point = *track_end.rest;
    if (!track_end.cascade) {
      at_rest[point] += mass;
      return;
    }
    // If an impulse occurs during the cascade, the mass is distributed on both sides of v = 0.
    const ImpactCascade& cascade = *track_end.cascade;
    at_rest[point] += cascade.rest_probability * mass;
    for (const auto& [cell, share] : rest[point].cells) {
      cells[cell].ended += (1 - cascade.rest_probability) * share * mass;
    }
    hit(*track_end.wall, mass, (track_end.speed + cascade.momentum) * mass,
        (track_end.speed * track_end.speed + cascade.energy) * mass);
  };
  const auto distribute_at_end = [&](const Track& track, double mass) {
    const TrackEnd& track_end = track.track_end;
    if (track_end.rest) {
      come_to_rest(track_end, mass);
    } else if (track_end.wall) {
      entering[track_end.faster] += track_end.faster_fraction * mass;
      entering[track_end.slower] += (1 - track_end.faster_fraction) * mass;
      hit(*track_end.wall, mass, track_end.speed * mass, track_end.speed * track_end.speed * mass);
    } else if (track.last > track.first) {
      cells[visits[track.last - 1].cell].ended += mass;
    }
  };

  for (const Track& track : characteristics_.tracks_from_outside()) {
    distribute_at_end(track, mass_at_track_end(track, 0, kIncludeSources));
  }
  const auto leave_walls = [&](auto with_sources) {
    for (std::size_t n = 0; n < from_walls.size(); ++n) {
      const Track& track = from_walls[n];
      const TrackEnd& track_end = track.track_end;
      double mass = std::exchange(entering[n], 0.0);
      if (!with_sources && mass == 0) continue;
      // Part of the mass may return to the same characteristic after its impact: the masses of all
      // returns are added as a geometric series.
      double again = 0;
      if (track_end.wall && !track_end.rest) {
        if (track_end.faster == static_cast<int>(n)) again += track_end.faster_fraction;
        if (track_end.slower == static_cast<int>(n)) again += 1 - track_end.faster_fraction;
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
      // The variable `left` already includes the mass of all returns.
      entering[n] -= again * left;
    }
  };
  leave_walls(kIncludeSources);
  // With two walls, mass may continue on a characteristic that was processed earlier in this pass.
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
