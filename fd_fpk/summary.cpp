#include "fd_fpk/summary.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "transform/richardson.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::counted;
using transform::Observer;

// Densities relative to the peak: differences below this level are insignificant.
constexpr double kFaint = 1e-6;

void observe_faint(Observer& observer, const std::string& path, double density) {
  observer.add({.path = path, .value = density, .least_scale = kFaint});
}

void observe(Observer& observer, const ErrorEstimate& error) {
  // The error of the impact rate may differ in a repeated run, which must reproduce the rate only.
  if (std::isfinite(error.impact_rate)) observer.work("error.impact_rate", error.impact_rate);
  // The logarithm of a quotient of small differences: sensitive to rounding.
  observer.add({.path = "error.observed_order", .value = error.observed_order, .delicate = true});
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    // The scale of rounding errors in a limit is that of the moment; for E[y'] that of the
    // velocities.
    observer.add({.path = std::string("error.extrapolated.") + name,
                  .value = error.extrapolated.*moment,
                  .least_scale = std::max(0.1, std::abs(error.extrapolated.*size))});
  }
}

}  // namespace

transform::Observations observations(const Summary& summary) {
  Observer observer;
  observer.result("nx", counted(summary.nx))
      .result("nv", counted(summary.nv))
      .result("refinement", summary.refinement)
      .result("origin_refinement", summary.origin_refinement)
      .result("x1_max", summary.x1_max)
      .result("x2_max", summary.x2_max)
      .work("nonzeros", counted(summary.nonzeros))
      .work("leak", summary.leak)
      .work("steps", counted(summary.steps))
      .work("factorisations", counted(summary.factorisations))
      .work("rhs_evaluations", counted(summary.rhs_evaluations))
      .work("krylov_iterations", counted(summary.krylov_iterations))
      .work("factor_entries", counted(summary.factor_entries))
      .work("factor_seconds", summary.factor_seconds)
      .work("krylov_seconds", summary.krylov_seconds)
      .work("residual", summary.residual)
      .work("stepped_against_direct", summary.stepped_against_direct)
      .result("regularisation_length", summary.regularisation_length)
      .result("growth_rate", summary.growth_rate)
      .result("growth_wavenumber", summary.growth_wavenumber);
  observe_faint(observer, "wall_density.y", summary.wall.x1);
  observe_faint(observer, "wall_density.ydot", summary.wall.x2);
  if (std::isfinite(summary.impact_rate)) observer.result("impact_rate", summary.impact_rate);
  observe(observer, summary.balances);
  if (summary.transport == Transport::characteristics) {
    observer.result("transport", std::string(name(summary.transport)))
        .work("visits", counted(summary.visits))
        .result("rest_mass", summary.rest_mass);
  } else {
    observer.result("order", counted(summary.order));
  }
  if (summary.error) observe(observer, *summary.error);
  return std::move(observer).take();
}

}  // namespace fpkcheck::fd_fpk
