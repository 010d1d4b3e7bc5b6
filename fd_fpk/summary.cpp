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

// Densities relative to the peak: differences below this level are insignificant.
constexpr double kInsignificant = 1e-6;

void observe_faint(MetricBuilder& builder, const std::string& path, double density) {
  builder.add({.path = path, .value = density, .min_scale = kInsignificant});
}

void add_metrics(MetricBuilder& builder, const ErrorEstimate& error) {
  // The error of the impact rate may differ in a repeated run, which must reproduce the rate only.
  if (std::isfinite(error.impact_rate)) builder.work("error.impact_rate", error.impact_rate);
  // The logarithm of a quotient of small differences: sensitive to rounding.
  builder.add({.path = "error.observed_order",
               .value = error.observed_order,
               .is_rounding_sensitive = true});
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    // The scale of rounding errors in a limit is that of the moment; for E[y'] that of the
    // velocities.
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
