#include "fd_fpk/characteristics/passage.hpp"

#include <cmath>
#include <vector>

namespace fpkcheck::fd_fpk {
namespace {

// What a visit needs of its cell, side by side in memory: visits go through the plane at random.
struct CellMass {
  double mass, tilt_y, tilt_v;
  double ended = 0;
};

}  // namespace

Eigen::VectorXd Passage::operator()(const Eigen::VectorXd& masses, const Tilts& tilts,
                                    ImpactSums* impacts) const {
  const auto& visits = characteristics_.visits();
  const auto& from_wall = characteristics_.from_wall();
  const RestCells& rest = characteristics_.rest();
  std::vector<CellMass> cells;
  cells.reserve(static_cast<std::size_t>(masses.size()));
  for (Eigen::Index n = 0; n < masses.size(); ++n) {
    cells.push_back({.mass = masses(n), .tilt_y = tilts.y(n), .tilt_v = tilts.v(n)});
  }
  double at_rest = masses(rest.below) + masses(rest.above);
  std::vector<double> entering(from_wall.size(), 0.0);

  const auto source = [&](const Visit& visit) {
    const CellMass& cell = cells[visit.cell];
    return visit.share * (cell.mass + cell.tilt_y * visit.y + cell.tilt_v * visit.v);
  };
  // What is left at the end of a track.
  const auto follow = [&](const Track& track, double mass) {
    for (std::size_t n = track.first; n < track.last; ++n) {
      const Visit& visit = visits[n];
      const double begins = source(visit);
      const double left = visit.survival * mass + visit.kept * begins;
      cells[visit.cell].ended += mass + begins - left;
      mass = left;
    }
    return mass;
  };
  const auto land = [&](const Landing& landing, double mass) {
    if (landing.speed == 0) {
      at_rest += mass;
      return;
    }
    entering[landing.faster] += landing.to_faster * mass;
    entering[landing.slower] += (1 - landing.to_faster) * mass;
    if (impacts) {
      impacts->number += mass;
      impacts->momentum += landing.speed * mass;
      impacts->energy += landing.speed * landing.speed * mass;
    }
  };

  for (const Track& track : characteristics_.from_outside()) {
    land(track.landing, follow(track, 0));
  }
  for (std::size_t n = 0; n < from_wall.size(); ++n) {
    const Track& track = from_wall[n];
    const Landing& landing = track.landing;
    double mass = entering[n];
    // Part of what leaves here may land here again: the mass is then that of all rounds.
    double again = 0;
    if (landing.speed > 0) {
      if (landing.faster == static_cast<int>(n)) again += landing.to_faster;
      if (landing.slower == static_cast<int>(n)) again += 1 - landing.to_faster;
    }
    if (again > 0) {
      double survival = 1, left = 0;
      for (std::size_t m = track.first; m < track.last; ++m) {
        const Visit& visit = visits[m];
        left = visit.survival * left + visit.kept * source(visit);
        survival *= visit.survival;
      }
      mass = (mass + again * left) / (1 - again * survival);
    }
    land(landing, follow(track, mass));
  }
  Eigen::VectorXd ended(masses.size());
  for (Eigen::Index n = 0; n < masses.size(); ++n) {
    ended(n) = cells[static_cast<std::size_t>(n)].ended;
  }
  ended(rest.below) += rest.share_below * at_rest;
  ended(rest.above) += (1 - rest.share_below) * at_rest;
  return ended;
}

}  // namespace fpkcheck::fd_fpk
