#include "fd_fpk/summary.hpp"

#include <nlohmann/json.hpp>

#include "problem/saved_fields.hpp"

namespace fpkcheck::fd_fpk {
namespace {

template <class T>
nlohmann::ordered_json or_null(const std::optional<T>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

nlohmann::ordered_json to_json(const transform::Moments& m) {
  return {{"y1", m.y1}, {"y2", m.y2}, {"y4", m.y4}, {"v1", m.v1}, {"v2", m.v2}, {"v4", m.v4}};
}

nlohmann::ordered_json to_json(const ErrorEstimate& error) {
  return {{"y_l1", error.y_l1},
          {"ydot_l1", error.ydot_l1},
          {"moments", to_json(error.moments)},
          {"observed_order", error.observed_order},
          {"extrapolated", to_json(error.extrapolated)}};
}

}  // namespace

nlohmann::ordered_json to_json(const Summary& summary) {
  return {{"nx", summary.nx},
          {"nv", summary.nv},
          {"refinement", summary.refinement},
          {"origin_refinement", summary.origin_refinement},
          {"x1_max", summary.x1_max},
          {"x2_max", summary.x2_max},
          {"nonzeros", summary.nonzeros},
          {"leak", summary.leak},
          {"steps", summary.steps},
          {"factorisations", summary.factorisations},
          {"rhs_evaluations", summary.rhs_evaluations},
          {"krylov_iterations", summary.krylov_iterations},
          {"factor_entries", summary.factor_entries},
          {"factor_seconds", summary.factor_seconds},
          {"krylov_seconds", summary.krylov_seconds},
          {"residual", summary.residual},
          {"stepped_against_direct", summary.stepped_against_direct},
          {"regularisation_length", summary.regularisation_length},
          {"growth_rate", summary.growth_rate},
          {"growth_wavenumber", summary.growth_wavenumber},
          {"wall_density", {{"y", summary.wall.x1}, {"ydot", summary.wall.x2}}},
          {"impact_rate", summary.impact_rate},
          {"error", summary.error ? to_json(*summary.error) : nlohmann::ordered_json()}};
}

nlohmann::ordered_json to_json(const Options& options) {
  return {{"equation", name(options.equation)},
          {"impact", problem::name(options.impact)},
          {"stepper", name(options.stepper)},
          {"order", options.order},
          {"refinement", options.refinement},
          {"origin_refinement", or_null(options.origin_refinement)},
          {"nx", or_null(options.nx)},
          {"nv", or_null(options.nv)},
          {"x1_max", or_null(options.x1_max)},
          {"x2_max", or_null(options.x2_max)},
          {"regularisation_length", or_null(options.regularisation_length)},
          {"wall_density", options.wall_density},
          {"refine_unresolved", options.refine_unresolved},
          {"error_estimate", options.error_estimate},
          {"tolerance", or_null(options.tolerance)},
          {"residual_tolerance", options.residual_tolerance}};
}

Options options_from_json(const nlohmann::ordered_json& json) {
  problem::SavedFields saved(json, "options");
  const Options options{
      .equation = saved.choice("equation",
                               {Equation::white, Equation::km4, Equation::km4_pade, Equation::kf}),
      .impact = saved.choice("impact", {problem::Impact::map, problem::Impact::delta}),
      .stepper = saved.choice("stepper", {Stepper::cvode, Stepper::direct}),
      .order = saved.integer("order"),
      .refinement = saved.number("refinement"),
      .origin_refinement = saved.number_or_null("origin_refinement"),
      .nx = saved.integer_or_null("nx"),
      .nv = saved.integer_or_null("nv"),
      .x1_max = saved.number_or_null("x1_max"),
      .x2_max = saved.number_or_null("x2_max"),
      .regularisation_length = saved.number_or_null("regularisation_length"),
      .wall_density = saved.number("wall_density"),
      .refine_unresolved = saved.flag("refine_unresolved"),
      .error_estimate = saved.flag("error_estimate"),
      .tolerance = saved.number_or_null("tolerance"),
      .residual_tolerance = saved.number("residual_tolerance")};
  saved.require_all_read();
  return options;
}

}  // namespace fpkcheck::fd_fpk
