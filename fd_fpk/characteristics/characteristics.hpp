#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fd_fpk/characteristics/flow.hpp"
#include "fd_fpk/characteristics/rest.hpp"
#include "fd_fpk/operator/grid.hpp"
#include "fd_fpk/stopwatch.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::fd_fpk {

/// A characteristic in a cell.
struct Visit {
  std::int32_t cell;
  float ended;        ///< probability that an impulse ends the visit: 1 - exp(-lambda duration)
  float ended_begun;  ///< the same on average over points of the visit at which it may begin
  double share;       ///< of the cell's area that is its strip's
  double y, v;        ///< its mean position, from that of all visits to the cell
};

/// Of all characteristics: they take 0.8 GB. Slow motions that wind about an equilibrium, at no wall,
/// visit cells without end.
inline constexpr std::size_t kMostVisits = 16000000;

/// Where a characteristic ends: at a wall, at rest, or, after so long that nothing is left of it, on
/// the way.
struct Landing {
  std::optional<Side> wall = {};
  double speed = 0;  ///< into the wall
  /// The characteristics from that wall whose speeds enclose r times that, and the share of the
  /// first, by which E[v^2] is kept.
  int faster = 0, slower = 0;
  double to_faster = 0;
  std::optional<int> rest = {};    ///< index of the place
  std::optional<Cascade> cascade;  ///< how it comes to rest in contact
};

/// A characteristic through the grid, from a wall or from the boundary of the box until it meets
/// a wall or is at rest.
struct Track {
  std::size_t first, last;  ///< its visits, [first, last)
  Landing landing = {};
  double energy = 0;  ///< at its start
};

/// Where an impulse takes the mass that rests in contact: onto the characteristics from that wall.
/// Y off the wall starts at Y, and Y into it rebounds at once.
struct Emission {
  std::vector<double> shares;  ///< of from_walls()
  double stays = 0;            ///< what is slower than all of them
  /// Of the impacts at once, per impulse.
  double momentum = 0, energy = 0;
};

/// The plane laid out with characteristics, close enough that every cell is crossed. Each stands
/// for the strip half way to its neighbours, whose area in a cell is its flux times the time spent
/// there (the method of characteristics of transport theory: J. R. Askew, AEEW-M 1108, 1972).
class Characteristics {
 public:
  /// @param rate of the impulses
  /// @param per_cell characteristics that start in each cell at the boundary
  /// @param given_up when no more are laid
  Characteristics(const problem::System& system, const Grid& grid, double rate, int per_cell,
                  const Deadline& given_up = Deadline::none());

  /// Those that come from the boundary of the box or begin in a cell that no other crosses; they
  /// land on those from the walls.
  const std::vector<Track>& from_outside() const { return from_outside_; }
  /// Those that leave a wall, by decreasing energy: but for the faster one of the two that share a
  /// landing, none lands on one before it.
  const std::vector<Track>& from_walls() const { return from_walls_; }
  const std::vector<Visit>& visits() const { return visits_; }
  /// Why the plane is not covered; empty where it is.
  std::string failure() const;
  const std::vector<RestPlace>& rest_places() const { return rest_; }
  /// The places in contact, as indices of rest_places().
  const std::vector<int>& contacts() const { return contacts_; }
  const std::optional<problem::Wall>& wall(Side side) const { return flow_.wall(side); }

  /// From each of contacts().
  std::vector<Emission> emissions(const problem::ImpulseLaw& law) const;

 private:
  struct Position;  // on the way
  // Of those that leave a wall: speeds, decreasing, with the characteristics' indices and the lower
  // ends of their strips, where the next strip begins.
  struct Fan {
    std::vector<double> speeds, below;
    std::vector<int> tracks;
  };

  Fan& fan(Side side) { return side == Side::left ? from_left_ : from_right_; }
  const Fan& fan(Side side) const { return side == Side::left ? from_left_ : from_right_; }
  void lay_from_box(int per_cell);
  void lay_from_wall(Side side, int per_cell);
  void sort_from_walls();
  void lay_through_gaps();
  Track follow(const State& from, double flux);
  bool ended() const { return out_of_time_ || visits_.size() > kMostVisits; }
  std::optional<int> rest_within(const State& at) const;
  void cross(Position& at, const State& to, double time);
  void land(Side side, double speed, Landing& landing) const;
  void share_areas();
  void find_landings(std::vector<Track>& tracks) const;

  const Grid& grid_;
  Deadline given_up_;
  bool out_of_time_ = false;
  Flow flow_;
  double rate_;
  std::vector<RestPlace> rest_;
  std::vector<int> contacts_;
  std::vector<bool> at_rest_;  // by cell
  std::vector<Visit> visits_;
  std::vector<double> durations_;  // of the visits, while they are laid
  std::vector<Track> from_outside_, from_walls_;
  Fan from_left_, from_right_;
};

}  // namespace fpkcheck::fd_fpk
