#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "mcs/impulses/excitation.hpp"
#include "mcs/motion/oscillator.hpp"
#include "mcs/options.hpp"
#include "mcs/streams/histogram.hpp"
#include "problem/problem.hpp"
#include "transform/marginal_density.hpp"

namespace fpkcheck::mcs {

/// Default limit of the time step of Taylor series, in radians; the errors of the free flights are
/// smaller than with the classical Runge-Kutta method and a step of 0.05 (docs/simulation.md).
inline constexpr double kAutomaticStepInRadians = 0.9;

enum class ShortBurnInCause {
  none,      ///< the burn-in takes at least 5 decay times
  impulses,  ///< short burn-in because of frequent impulses
  wells,     ///< short burn-in because of rare transitions between wells
  decay      ///< short burn-in because of weak damping
};

struct SimulationPlan {
  int streams;
  int threads;
  std::uint64_t seed;
  problem::WallFrame frame;  ///< frame that maps the results to physical coordinates
  SimulatedOscillator oscillator;
  NoiseKicks kicks;
  double step;
  /// Expected number of impulses, noise kicks and free flights of a trajectory stream per unit time
  double expected_event_rate;
  double burn_in;
  ShortBurnInCause short_burn_in_cause;
  double sampling_interval;
  std::uint64_t samples_per_round;
  std::uint64_t rounds;
  double centre;  ///< centre of the motion, problem::MotionScales::centre
  /// Standard deviation sigma_1 of y, from equivalent linearisation or energy averaging
  double displacement_deviation;
  double velocity_deviation;  ///< standard deviation sigma_2 of y'
  bool has_contact_atoms;     ///< whether the stationary law has atoms at rest in contact
  ImpulseProcess excitation;
  BinFinder y_bins;
  BinFinder v_bins;
  std::optional<SampleDepositionPlan> deposit{};
  problem::ExcitationTimeDependence time{};  ///< changes of the excitation in time

  double simulated_time_per_round() const {
    return static_cast<double>(samples_per_round) * sampling_interval;
  }

  const BinFinder& bin_finder_of_variable(transform::StateVariable variable) const {
    return variable == transform::StateVariable::y ? y_bins : v_bins;
  }
};

/// @throws InputError for invalid options, and for options that the problem does not permit
SimulationPlan make_simulation_plan(const problem::Problem& problem,
                                    const SimulationOptions& options);

/// Returns why the burn-in is below 5 decay times, and what the user can do; an empty text for a
/// longer burn-in.
std::string short_burn_in_reason(const SimulationPlan& plan, const SimulationOptions& options);

}  // namespace fpkcheck::mcs
