#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fd_fpk/characteristics/flow.hpp"
#include "fd_fpk/characteristics/rest_points.hpp"
#include "fd_fpk/operator/grid.hpp"
#include "fd_fpk/stopwatch.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::fd_fpk {

/// The part of a characteristic inside a cell.
struct Visit {
  std::int32_t cell;
  float ended;  ///< probability that an impulse ends the visit: 1 - exp(-lambda duration)
  float mean_end_probability;  ///< its average over starting points along the visit
  double share;                ///< fraction of the cell's area covered by the strip of this visit
  double y, v;  ///< mean position of the visit, relative to the mean over all visits of the cell
};

/// Maximum number of visits of all characteristics, which take 0.8 GB. Slow motion that circles an
/// equilibrium without impacts visits cells indefinitely.
inline constexpr std::size_t kMostVisits = 16000000;

/// The end of a characteristic: at a wall, at rest, or on its way, when its remaining probability
/// is negligible.
struct Landing {
  std::optional<Side> wall = {};
  double speed = 0;  ///< speed of the impact
  /// The two characteristics from that wall whose speeds enclose r times the impact speed, and the
  /// fraction of the faster; the fractions conserve E[v^2].
  int faster = 0, slower = 0;
  double faster_fraction = 0;
  std::optional<int> rest = {};    ///< index of the rest point
  std::optional<Cascade> cascade;  ///< the impacts that lead to rest in contact
};

/// A characteristic through the grid: from a wall or from the boundary of the box to the next
/// impact or to rest.
struct Track {
  std::size_t first, last;  ///< its visits, [first, last)
  Landing landing = {};
  double energy = 0;  ///< energy at the start
};

/// Distribution of mass at rest in contact after an impulse, over the characteristics from that
/// wall. An impulse Y off the wall starts the motion at speed Y; an impulse into the wall rebounds
/// at once.
struct Emission {
  std::vector<double> shares;  ///< fractions for from_walls()
  double rest_fraction = 0;    ///< fraction with a speed below that of all characteristics
  /// Momentum and energy of the immediate impacts, per impulse.
  double momentum = 0, energy = 0;
};

/// Characteristics that cover the plane, so dense that each cell is crossed. Each represents the
/// strip half way to its neighbours. The strip's area in a cell is its flux times the time spent
/// there (the method of characteristics of transport theory: J. R. Askew, AEEW-M 1108, 1972).
class Characteristics {
 public:
  /// @param rate arrival rate of the impulses
  /// @param per_cell number of characteristics that start in each cell at the boundary
  /// @param deadline time at which the construction ends
  Characteristics(const problem::System& system, const Grid& grid, double rate, int per_cell,
                  const Deadline& deadline = Deadline::none());

  /// Characteristics that start at the boundary of the box, or in a cell that no other
  /// characteristic crosses. Their mass continues on characteristics from the walls.
  const std::vector<Track>& from_outside() const { return from_outside_; }
  /// Characteristics that start at a wall, by decreasing energy. None continues on a preceding
  /// characteristic, except for the faster of the two at an impact.
  const std::vector<Track>& from_walls() const { return from_walls_; }
  const std::vector<Visit>& visits() const { return visits_; }
  /// Reason why the plane is not covered; empty when it is.
  std::string failure() const;
  const std::vector<RestPoint>& rest_points() const { return rest_; }
  /// The rest points in contact, as indices of rest_points().
  const std::vector<int>& contacts() const { return contacts_; }
  const std::optional<problem::Wall>& wall(Side side) const { return flow_.wall(side); }

  /// The emissions from each of contacts().
  std::vector<Emission> emissions(const problem::ImpulseLaw& law) const;

 private:
  struct Position;  // state while a characteristic is traced
  // Characteristics from one wall: speeds, decreasing; the lower ends of their strips, where the
  // next strip begins; and the characteristics' indices.
  struct Fan {
    std::vector<double> speeds, below;
    std::vector<int> tracks;
  };

  Fan& fan(Side side) { return side == Side::left ? from_left_ : from_right_; }
  const Fan& fan(Side side) const { return side == Side::left ? from_left_ : from_right_; }
  void trace_from_box(int per_cell);
  void trace_from_wall(Side side, int per_cell);
  void sort_from_walls();
  void trace_through_gaps();
  Track follow(const State& from, double flux);
  bool ended() const { return out_of_time_ || visits_.size() > kMostVisits; }
  std::optional<int> equilibrium_containing(const State& at) const;
  void cross(Position& at, const State& to, double time);
  void land(Side side, double speed, Landing& landing) const;
  void normalise_areas();
  void find_landings(std::vector<Track>& tracks) const;

  const Grid& grid_;
  Deadline deadline_;
  bool out_of_time_ = false;
  Flow flow_;
  double rate_;
  std::vector<RestPoint> rest_;
  std::vector<int> contacts_;
  std::vector<bool> at_rest_;  // for each cell
  std::vector<Visit> visits_;
  std::vector<double> durations_;  // durations of the visits, during construction
  std::vector<Track> from_outside_, from_walls_;
  Fan from_left_, from_right_;
};

}  // namespace fpkcheck::fd_fpk
