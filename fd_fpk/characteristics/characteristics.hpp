#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/process/stopwatch.hpp"
#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/characteristics/deterministic_motion.hpp"
#include "fd_fpk/characteristics/rest_points.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::fd_fpk {

/// Part of a characteristic inside one grid cell.
struct CharacteristicCellVisit {
  std::int32_t cell;
  float ended;  ///< probability of an impulse during the visit, 1 - exp(-lambda duration)
  /// Probability of an impulse before the end of the visit (`ended`), averaged over mass that
  /// starts anywhere along the visit
  float mean_impulse_probability;
  double share;  ///< fraction of the cell area that the strip of the visit covers
  /// Mean displacement and velocity along a cell visit, relative to the mean of all visits of
  /// characteristics to the cell
  double y, v;
};

/// Maximum number of cell visits of all characteristics; this number of visits takes 0.8 GB of
/// memory. The number of visits is limited, since slow motion around an equilibrium without impacts
/// would visit cells indefinitely.
inline constexpr std::size_t kMaxCharacteristicCellVisits = 16000000;

/// End of a characteristic at a wall, at a rest point, or where an impulse is almost certain.
struct CharacteristicEnd {
  std::optional<WallSide> wall = {};
  double speed = 0;
  /// Indices of the two characteristics that start at the wall and carry the mass of a
  /// characteristic after its impact. The start speeds of these two characteristics enclose the
  /// rebound speed, the restitution coefficient r times the impact speed.
  int faster = 0, slower = 0;
  double faster_fraction = 0;
  std::optional<int> rest = {};          ///< index in Characteristics::rest_points()
  std::optional<ImpactCascade> cascade;  ///< cascade of impacts to rest in contact
};

/// Characteristic of the motion, from a wall or an edge of the computational box to the next impact
/// or to a rest point.
struct Characteristic {
  std::size_t first, last;  ///< indices [first, last) of the cell visits of the characteristic
  CharacteristicEnd characteristic_end = {};
  double energy = 0;
};

/// Fractions in which an impulse distributes the mass at rest in contact over the characteristics
/// that start at the wall. An impulse of amplitude Y away from the wall starts the motion of a mass
/// at rest in contact at the speed Y. An impulse towards the wall causes an immediate impact of a
/// mass at rest in contact.
struct RestMassDistributionAfterImpulse {
  std::vector<double>
      shares;  ///< fraction of the mass on each characteristic of characteristics_from_walls()
  /// Fraction of the mass at rest in contact to which an impulse gives a speed below the start
  /// speed of every characteristic
  double rest_fraction = 0;
  /// Momentum and energy that an impulse on mass at rest in contact transfers to the wall in the
  /// immediate impact, on average
  double momentum = 0, energy = 0;
};

/// Characteristics that cover the phase plane so densely that at least one characteristic crosses
/// each cell. Each characteristic represents a strip of the phase plane up to half way to the
/// neighbouring characteristics. The area of the strip of a characteristic in a cell is the flux of
/// the strip times the time that the characteristic spends in the cell (J. R. Askew, AEEW-M 1108,
/// 1972).
class Characteristics {
 public:
  /// @param impulse_rate arrival rate of impulses, per unit time
  /// @param characteristics_per_cell number of characteristics that start in each cell along the
  /// boundary of the phase plane
  /// @param deadline time at which the construction stops with a failure_reason()
  Characteristics(const problem::System& system, const PhasePlaneGrid& grid, double impulse_rate,
                  int characteristics_per_cell,
                  const base::Deadline& deadline = base::Deadline::without_time_limit());

  /// Returns the characteristics that start at an edge of the computational box, or in a cell that
  /// no other characteristic crosses. After an impact, the mass of a characteristic from the
  /// boundary continues on characteristics that start at walls.
  const std::vector<Characteristic>& characteristics_from_boundary() const { return from_outside_; }
  /// Returns the characteristics that start at a wall, by decreasing energy. After an impact the
  /// mass of a characteristic continues on two characteristics with neighbouring start speeds. The
  /// slower of the two characteristics that continue an impact always follows the incoming
  /// characteristic in the list, but the faster of the two may precede it.
  const std::vector<Characteristic>& characteristics_from_walls() const { return from_walls_; }
  const std::vector<CharacteristicCellVisit>& characteristic_cell_visits() const { return visits_; }
  /// Returns the reason why the characteristics do not cover the phase plane; empty if the
  /// characteristics cover the phase plane.
  std::string failure_reason() const;
  const std::vector<RestPoint>& rest_points() const { return rest_; }
  /// Returns the indices in rest_points() of the rest points in contact with a wall.
  const std::vector<int>& indices_of_rest_points_in_contact() const { return contacts_; }
  const std::optional<problem::Wall>& wall(WallSide side) const { return flow_.wall(side); }

  /// Returns the distribution of mass after an impulse, for each rest point of
  /// indices_of_rest_points_in_contact().
  std::vector<RestMassDistributionAfterImpulse> rest_mass_distributions_after_impulse(
      const problem::ImpulseLaw& law) const;

 private:
  struct TracingState;  // current state of the tracing of a characteristic
  struct TraceStart {
    PhaseState state;
    double flux;  // flux of area through the strip
  };
  // Characteristics that one call of parallel_for() traces. The characteristics in `tracks` refer
  // to their cell visits by indices in `visits`.
  struct TracedPart {
    std::vector<Characteristic> tracks;
    std::vector<CharacteristicCellVisit> visits;
    std::vector<double> durations;  // durations of the visits
    bool out_of_time = false;
  };
  // Characteristics that start at one wall, by decreasing start speed. The array `below` contains
  // the lowest start speed of the strip of each characteristic, at which the strip of the next
  // characteristic begins.
  struct WallCharacteristics {
    std::vector<double> speeds, below;
    std::vector<int> tracks;
  };

  WallCharacteristics& wall_characteristics(WallSide side) {
    return side == WallSide::left ? from_left_ : from_right_;
  }
  const WallCharacteristics& wall_characteristics(WallSide side) const {
    return side == WallSide::left ? from_left_ : from_right_;
  }
  void trace_characteristics_from_box_edges(int characteristics_per_cell);
  void trace_characteristics_from_wall(WallSide side, int characteristics_per_cell);
  void sort_wall_characteristics();
  void trace_characteristics_from_uncovered();
  void trace_through_uncrossed_cells();
  std::vector<Characteristic> trace_characteristics(const std::vector<TraceStart>& starts);
  Characteristic trace_characteristic(const PhaseState& from, double flux) {
    return trace_characteristics({{from, flux}}).front();
  }
  // Traces a characteristic and appends the characteristic and its cell visits to `part`. The
  // argument `visit_count` counts the cell visits of all characteristics in all threads.
  void trace_characteristic(const TraceStart& start, std::atomic<std::size_t>& visit_count,
                            TracedPart& part) const;
  std::optional<int> equilibrium_with_cells_containing(const PhaseState& at) const;
  void record_cell_visits(TracingState& at, const PhaseState& to, double time,
                          TracedPart& part) const;
  void set_characteristic_end_at_wall(WallSide side, double speed,
                                      CharacteristicEnd& characteristic_end) const;
  void normalise_characteristic_areas();
  void find_characteristics_after_impacts(std::vector<Characteristic>& tracks) const;

  const PhasePlaneGrid& grid_;
  base::Deadline deadline_;
  bool out_of_time_ = false;
  DeterministicFlow flow_;
  double rate_;
  std::vector<RestPoint> rest_;
  std::vector<int> contacts_;
  std::vector<bool> at_rest_;  // whether each cell belongs to a rest point
  std::vector<CharacteristicCellVisit> visits_;
  std::vector<double> durations_;  // durations of the cell visits; used only during construction
  std::vector<Characteristic> from_outside_, from_walls_;
  WallCharacteristics from_left_, from_right_;
};

}  // namespace fpkcheck::fd_fpk
