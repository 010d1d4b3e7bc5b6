#include "fd_fpk/summary.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "transform/richardson.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::SolverMetricsBuilder;
using transform::value_from_count;

// Difference of two densities, relative to the peak density, that counts as insignificant.
constexpr double kInsignificant = 1e-6;

void add_density_metric(SolverMetricsBuilder& builder, const std::string& path, double density) {
  builder.add({.path = path, .value = density, .min_scale = kInsignificant});
}

void add_metrics(SolverMetricsBuilder& builder, const DiscretisationErrorEstimate& error) {
  // The error estimate of the impact rate is a diagnostic metric, which need not be reproducible.
  if (std::isfinite(error.impact_rate))
    builder.add_diagnostic_metric("error.impact_rate", error.impact_rate);
  // The observed order of convergence, a logarithm of small differences, is sensitive to rounding
  // errors.
  builder.add({.path = "error.observed_order",
               .value = error.observed_order,
               .is_rounding_sensitive = true});
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    // Rounding errors of an extrapolated moment are proportional to the moment itself, but rounding
    // errors of E[y'] are proportional to the root mean square velocity.
    builder.add({.path = std::string("error.extrapolated.") + name,
                 .value = error.extrapolated.*moment,
                 .min_scale = std::max(0.1, std::abs(error.extrapolated.*size))});
  }
}

}  // namespace

transform::Metrics solver_metrics(const FiniteVolumeSummary& summary) {
  SolverMetricsBuilder builder;
  builder.add_result_metric("nx", value_from_count(summary.nx))
      .add_result_metric("nv", value_from_count(summary.nv))
      .add_result_metric("refinement", summary.refinement)
      .add_result_metric("origin_refinement", summary.origin_refinement)
      .add_result_metric("x1_max", summary.x1_max)
      .add_result_metric("x2_max", summary.x2_max)
      .add_diagnostic_metric("nonzeros", value_from_count(summary.nonzeros))
      .add_diagnostic_metric("leak", summary.leak)
      .add_diagnostic_metric("steps", value_from_count(summary.steps))
      .add_diagnostic_metric("factorisations", value_from_count(summary.factorisations))
      .add_diagnostic_metric("rhs_evaluations", value_from_count(summary.rhs_evaluations))
      .add_diagnostic_metric("krylov_iterations", value_from_count(summary.krylov_iterations))
      .add_diagnostic_metric("factor_entries", value_from_count(summary.factor_entries))
      .add_diagnostic_metric("factor_seconds", summary.factor_seconds)
      .add_diagnostic_metric("krylov_seconds", summary.krylov_seconds)
      .add_diagnostic_metric("residual", summary.residual)
      .add_diagnostic_metric("stepped_against_direct", summary.stepped_against_direct)
      .add_result_metric("regularisation_length", summary.regularisation_length)
      .add_result_metric("growth_rate", summary.growth_rate)
      .add_result_metric("growth_wavenumber", summary.growth_wavenumber);
  add_density_metric(builder, "wall_density.y", summary.wall.x1);
  add_density_metric(builder, "wall_density.ydot", summary.wall.x2);
  if (std::isfinite(summary.impact_rate))
    builder.add_result_metric("impact_rate", summary.impact_rate);
  add_balance_metrics(builder, summary.balances);
  if (summary.transport == TransportScheme::characteristics) {
    builder.add_result_metric("transport", std::string(name(summary.transport)))
        .add_diagnostic_metric("visits", value_from_count(summary.visits))
        .add_result_metric("rest_mass", summary.rest_mass);
  } else {
    builder.add_result_metric("order", value_from_count(summary.order));
  }
  if (summary.error) add_metrics(builder, *summary.error);
  return std::move(builder).take_metrics();
}

}  // namespace fpkcheck::fd_fpk
