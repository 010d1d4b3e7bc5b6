// fpkcheck with an additional method: the Gaussian density of equivalent linearisation. The method
// has a command and appears in all tables.
#include <cmath>
#include <fpkcheck/cli/program.hpp>
#include <fpkcheck/methods/builtin_solvers.hpp>
#include <fpkcheck/problem/equivalent_linearisation.hpp>
#include <fpkcheck/transform/marginal_density.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

namespace methods = fpkcheck::methods;
namespace base = fpkcheck::base;
namespace problem = fpkcheck::problem;
namespace transform = fpkcheck::transform;

struct Options {
  double widths = 8;  ///< half-width of the box in standard deviations
};

const base::OptionsDescription<Options>& description() {
  static const auto description = base::OptionsDescription<Options>("linear ").add(
      "widths", &Options::widths, {"N", "half-width of the box in standard deviations"},
      base::closed_interval(5, 20));
  return description;
}

void validate(const Options& options) { description().validate(options); }

transform::SolutionIdentity identity(const Options&) {
  return {.id = "linear",
          .method = "linear",
          .equation = problem::DensityEquation::white,
          .impact = problem::ImpactCondition::map};
}

std::optional<Options> options_of(std::string_view id) {
  return id == "linear" ? std::optional(Options{}) : std::nullopt;
}

transform::Solution solve(const problem::Problem& problem, const Options& options) {
  const auto linear = problem::equivalent_linearisation(problem);
  const double a = linear.displacement_deviation, b = linear.velocity_deviation;
  const transform::SmoothDensity density{
      [=](double y, double v) {
        return std::exp(-y * y / (2 * a * a) - v * v / (2 * b * b)) / (std::numbers::pi * a * b);
      },
      options.widths * a, options.widths * b};
  const auto marginals =
      transform::marginals_at_quadrature_points(density, density.y_max, density.v_max);
  transform::Solution solution{.identity = identity(options)};
  solution.status = transform::Status::ok;
  solution.density = density;
  solution.mass = marginals.mass;
  solution.moments = marginals.moments;
  return solution;
}

methods::Solver linear_solver() {
  methods::Solver entry{.name = "linear",
                        .summary = "the Gaussian density of equivalent linearisation",
                        .usage = "usage: own_method linear CASE ... [options]\n",
                        .families = {{.name = "linear",
                                      .role = transform::SolutionRole::closure,
                                      .meaning = "Gaussian density of equivalent linearisation.",
                                      .default_ids = {"linear"},
                                      .plot_style = [](const transform::SolutionIdentity&) {
                                        return transform::PlotStyle{.colour = "#808000"};
                                      }}}};
  return methods::registry_entry_with_solver_traits<Options>(
      std::move(entry),
      {.description = description(),
       .validate = validate,
       .identity = identity,
       .options_of = options_of,
       .solve = [](const problem::Problem& problem, const Options& options,
                   const methods::SolverInputContext&) { return solve(problem, options); }});
}

}  // namespace

int main(int argc, char** argv) {
  auto registry = methods::builtin_registry();
  registry.add_solver(linear_solver());
  return fpkcheck::cli::run_program(std::vector<std::string>(argv + 1, argv + argc), registry);
}
