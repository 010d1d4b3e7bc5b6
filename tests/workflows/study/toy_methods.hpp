#pragma once

#include <fmt/format.h>

#include <string>

#include "base/options/parameter_value.hpp"
#include "made_up_solutions.hpp"
#include "methods/registry.hpp"

/// Methods from outside the tree, without a solver: registration alone makes them available.
namespace fpkcheck::tests {

struct ToyOptions {
  int order = 2;
  problem::DensityEquation equation = problem::DensityEquation::kf;
};

inline const base::OptionsDescription<ToyOptions>& toy_description() {
  static const auto description =
      base::OptionsDescription<ToyOptions>("toy ")
          .add("order", &ToyOptions::order, {"N", "degree"}, base::even_integers_between(2, 6))
          .add("equation", &ToyOptions::equation, {"E", "white or kf"})
          .with_choices({"white", "kf"});
  return description;
}

/// Properties of a toy solver. Its ids are FAMILY and FAMILY-white, with -nN where it has an order.
struct Toy {
  std::string solver, family;
  transform::SolutionRole role;
  bool with_order = false;
  problem::ImpactCondition impact = problem::ImpactCondition::map;

  transform::SolutionIdentity identity(const ToyOptions& options) const {
    const bool white = options.equation == problem::DensityEquation::white;
    const std::string stem = family + (white ? "-white" : "");
    transform::SolutionIdentity who{
        .id = with_order ? fmt::format("{}-n{}", stem, options.order) : stem,
        .method = solver,
        .equation = options.equation,
        .impact = impact,
        .role = role};
    if (with_order) who.order = options.order;
    return who;
  }
};

/// The density of a closure approaches that of the other methods with increasing order.
inline methods::Solver toy_solver(const Toy& toy) {
  methods::Solver solver{.name = toy.solver,
                         .summary = "",
                         .usage = "",
                         .families = {},
                         .option_descriptions = &toy_description(),
                         .default_options = {},
                         .options_of = {},
                         .method = {}};
  solver.families.push_back(
      {toy.family,
       toy.role,
       "A toy.",
       {toy.identity({}).id},
       [](const transform::SolutionIdentity&) { return transform::PlotStyle{}; }});
  solver.options_of = [toy](std::string_view id) -> std::optional<base::Values> {
    for (const auto equation : {problem::DensityEquation::kf, problem::DensityEquation::white}) {
      for (int order = 2; order < 20; ++order) {
        const ToyOptions options{order, equation};
        if (toy.identity(options).id == id) return toy_description().values(options);
      }
    }
    return std::nullopt;
  };
  solver.method = [toy](const base::Values& values) {
    const auto options = toy_description().read(values, "options");
    toy_description().validate(options);
    return methods::Method{
        toy.identity(options), values, false,
        [=](const problem::Problem&, const methods::SolverInputContext& context) {
          const double off = toy.role == transform::SolutionRole::closure ? 0.5 / options.order : 0;
          return solution(toy.identity(options),
                          smooth_density({2.3 + off, 0.06, 2.4, 0}, context.axes.y_edges.back(),
                                         context.axes.v_edges.back()));
        }};
  };
  return solver;
}

inline methods::SolverRegistry toy_registry() {
  using transform::SolutionRole;
  methods::SolverRegistry registry;
  registry.add_solver(toy_solver({"toy", "toy-flat", SolutionRole::closure, true}));
  registry.add_solver(toy_solver(
      {"other", "other-flat", SolutionRole::closure, true, problem::ImpactCondition::delta}));
  registry.add_solver(toy_solver({"plain", "plain", SolutionRole::closure}));
  registry.add_solver(toy_solver({"cells", "cells", SolutionRole::equation}));
  registry.add_solver(toy_solver(
      {"dice", "dice", SolutionRole::simulation, false, problem::ImpactCondition::exact}));
  return registry;
}

}  // namespace fpkcheck::tests
