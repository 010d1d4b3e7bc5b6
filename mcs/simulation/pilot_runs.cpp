#include "mcs/simulation/pilot_runs.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "mcs/simulation/simulation.hpp"
#include "problem/problem.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr double kRarest = 1e-10;
constexpr double kFewestVisits = 1000;  // number of visits of branches that define a threshold
constexpr int kMostPilots = 30;
constexpr double kPilotTime = 0.5;                    // least pilot time, in burn-ins
constexpr double kPilotImpulses = 8 * kFewestVisits;  // least number of impulses in all streams
constexpr double kLargestEnergy = 1e4;                // in units of sigma_2^2

// Potential of the energy whose thresholds split branches, with the minimum 0. At the wall of a
// Duffing oscillator this is the potential of the spring. For other oscillators the mean force of
// the impulses contributes, since without this force the potential may have no lower bound.
numerics::Polynomial splitting_potential(const problem::Problem& problem,
                                         const SimulationPlan& plan) {
  if (plan.oscillator.is_duffing_at_wall()) return problem.system.potential();
  const problem::UndampedOrbits orbits(problem);
  auto coefficients = orbits.potential().coefficients();
  coefficients[0] -= orbits.lowest_potential();
  return numerics::Polynomial(coefficients);
}

}  // namespace

ImportanceSplitting choose_splitting_thresholds(const problem::Problem& problem,
                                                const SimulationPlan& plan) {
  const double largest = kLargestEnergy * plan.velocity_deviation * plan.velocity_deviation;
  const numerics::Polynomial potential = splitting_potential(problem, plan);
  SimulationPlan pilot = plan;
  pilot.seed = ~plan.seed;  // gives random numbers that a simulation with plan.seed does not use
  pilot.samples_per_round =
      static_cast<std::uint64_t>(std::max(kPilotTime * plan.burn_in, kPilotImpulses / plan.streams *
                                                                         plan.excitation.interval) /
                                 plan.sampling_interval) +
      1;
  Simulation simulation(problem, pilot);
  simulation.burn_in();
  std::vector<double> thresholds;
  for (int n = 0; n < kMostPilots; ++n) {
    const ImportanceSplitting splitting(potential, thresholds, largest);
    simulation.set_splitting(splitting);
    simulation.run_round();
    std::vector<double> energies(splitting.energy_bins().bin_count() + 2);
    for (const Stream& stream : simulation.streams()) {
      std::ranges::transform(energies, stream.record.energies, energies.begin(), std::plus{});
    }
    auto next = choose_thresholds(
        splitting.energy_bins(), energies,
        kFewestVisits * std::pow(ImportanceSplitting::kCopies, -splitting.threshold_count()),
        kRarest);
    const bool further = next.size() > thresholds.size();
    if (further || n == 0) thresholds = std::move(next);
    if (!further) break;
  }
  return {potential, thresholds, largest};
}

}  // namespace fpkcheck::mcs
