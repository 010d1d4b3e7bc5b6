#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "fd_fpk/characteristics/flow.hpp"
#include "fd_fpk/operator/grid.hpp"

namespace fpkcheck::fd_fpk {

/// A characteristic in a cell.
struct Visit {
  std::int32_t cell;
  float survival;  ///< probability that no impulse ends the visit: exp(-lambda times its duration)
  float kept;      ///< the same on average over points of the visit at which it may begin
  double share;    ///< of the cell's area that is its strip's
  double y, v;     ///< its mean position, from that of all visits to the cell
};

/// Where a characteristic ends.
struct Landing {
  double speed = 0;  ///< into the wall; 0 where it comes to rest
  /// The characteristics from the wall whose speeds enclose r times that, and the share of the
  /// first, by which E[v^2] is kept.
  int faster = 0, slower = 0;
  double to_faster = 0;
};

/// A characteristic through the grid, from the wall or from the boundary of the box until it meets
/// the wall or is at rest.
struct Track {
  std::size_t first, last;  ///< its visits, [first, last)
  Landing landing = {};
};

/// The cells at rest: the two in the corner of the origin, on either side of v = 0.
struct RestCells {
  int below, above;
  /// Of the mass at rest, that of v < 0: the oscillator turns on for ever, whatever is left of it.
  double share_below;
  /// Impacts per unit time of the mass at rest.
  double impact_rate;
};

/// The plane laid out with characteristics, close enough that every cell is crossed. Each stands
/// for the strip half way to its neighbours, whose area in a cell is its flux times the time spent
/// there (the method of characteristics of transport theory: J. R. Askew, AEEW-M 1108, 1972).
class Characteristics {
 public:
  /// @param rate of the impulses
  /// @param per_cell characteristics that start in each cell at the boundary
  Characteristics(const problem::System& system, const Grid& grid, double rate, int per_cell);

  /// Those that come from the boundary of the box or begin in a cell that no other crosses; they
  /// land on those from the wall.
  const std::vector<Track>& from_outside() const { return from_outside_; }
  /// Those that leave the wall, by decreasing speed: none lands on one that is faster.
  const std::vector<Track>& from_wall() const { return from_wall_; }
  const std::vector<Visit>& visits() const { return visits_; }
  const RestCells& rest() const { return rest_; }

 private:
  struct Position;  // on the way

  void lay_from_box(int per_cell);
  void lay_from_wall(int per_cell);
  void lay_through_gaps();
  Track follow(const State& from, double flux);
  void cross(Position& at, const State& to, double time);
  RestCells rest_cells() const;
  void share_areas();
  void find_landings(std::vector<Track>& tracks) const;

  const Grid& grid_;
  Flow flow_;
  double rate_;
  RestCells rest_;
  std::vector<Visit> visits_;
  std::vector<double> durations_;  // of the visits, while they are laid
  std::vector<Track> from_outside_, from_wall_;
  std::vector<double> speeds_;  // at which those from the wall leave it
};

}  // namespace fpkcheck::fd_fpk
