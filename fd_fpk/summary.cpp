#include "fd_fpk/summary.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "transform/richardson.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::count_value;
using transform::MetricBuilder;

// Absolute tolerance for densities relative to the peak: smaller differences are insignificant.
constexpr double kInsignificant = 1e-6;

void observe_faint(MetricBuilder& builder, const std::string& path, double density) {
  builder.add({.path = path, .value = density, .min_scale = kInsignificant});
}

void add_metrics(MetricBuilder& builder, const ErrorEstimate& error) {
  // A repeated run must reproduce the impact rate, but not the error estimate of the impact rate.
  if (std::isfinite(error.impact_rate)) builder.work("error.impact_rate", error.impact_rate);
  // The observed order is the logarithm of a quotient of small differences, and therefore sensitive
  // to rounding errors.
  builder.add({.path = "error.observed_order",
               .value = error.observed_order,
               .is_rounding_sensitive = true});
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    // The scale of rounding errors in an extrapolated moment is the moment itself; for E[y'] the
    // scale is the root mean square velocity.
    builder.add({.path = std::string("error.extrapolated.") + name,
                 .value = error.extrapolated.*moment,
                 .min_scale = std::max(0.1, std::abs(error.extrapolated.*size))});
  }
}

}  // namespace

transform::Metrics metrics(const Summary& summary) {
  MetricBuilder builder;
  builder.result("nx", count_value(summary.nx))
      .result("nv", count_value(summary.nv))
      .result("refinement", summary.refinement)
      .result("origin_refinement", summary.origin_refinement)
      .result("x1_max", summary.x1_max)
      .result("x2_max", summary.x2_max)
      .work("nonzeros", count_value(summary.nonzeros))
      .work("leak", summary.leak)
      .work("steps", count_value(summary.steps))
      .work("factorisations", count_value(summary.factorisations))
      .work("rhs_evaluations", count_value(summary.rhs_evaluations))
      .work("krylov_iterations", count_value(summary.krylov_iterations))
      .work("factor_entries", count_value(summary.factor_entries))
      .work("factor_seconds", summary.factor_seconds)
      .work("krylov_seconds", summary.krylov_seconds)
      .work("residual", summary.residual)
      .work("stepped_against_direct", summary.stepped_against_direct)
      .result("regularisation_length", summary.regularisation_length)
      .result("growth_rate", summary.growth_rate)
      .result("growth_wavenumber", summary.growth_wavenumber);
  observe_faint(builder, "wall_density.y", summary.wall.x1);
  observe_faint(builder, "wall_density.ydot", summary.wall.x2);
  if (std::isfinite(summary.impact_rate)) builder.result("impact_rate", summary.impact_rate);
  add_metrics(builder, summary.balances);
  if (summary.transport == Transport::characteristics) {
    builder.result("transport", std::string(name(summary.transport)))
        .work("visits", count_value(summary.visits))
        .result("rest_mass", summary.rest_mass);
  } else {
    builder.result("order", count_value(summary.order));
  }
  if (summary.error) add_metrics(builder, *summary.error);
  return std::move(builder).take();
}

}  // namespace fpkcheck::fd_fpk
