#include "workflows/study/reference/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/comparison_bins.hpp"
#include "fd_fpk/solve.hpp"
#include "mcs/simulation/simulation_plan.hpp"
#include "mcs/solve.hpp"
#include "problem/motion_scales.hpp"
#include "transform/richardson.hpp"

namespace fpkcheck::study {
namespace {

using transform::Moments;
using transform::Solution;
using transform::StateVariable;

fd_fpk::FiniteVolumeOptions fd_options(int order, double refinement) {
  return {.equation = problem::DensityEquation::kf,
          .stepper = fd_fpk::StationarySolver::direct,
          .order = order,
          .refinement = refinement,
          .origin_refinement = 16,
          .wall_density = 1e-9,
          .error_estimate = true,
          .residual_tolerance = 1e-9};
}

fd_fpk::FiniteVolumeOptions seventh_order_options(const ReferenceOptions& options) {
  return fd_options(7, options.refinement);
}

fd_fpk::FiniteVolumeOptions fifth_order_options(const ReferenceOptions& options) {
  return fd_options(5, options.refinement * std::sqrt(2.0));
}

mcs::SimulationOptions long_simulation_options(const problem::Problem& problem,
                                               const ReferenceOptions& options) {
  constexpr double kTime = 1e7;  // default simulated time, in decay times of the slowest mode
  const auto axes = compare::comparison_bins(problem);
  mcs::SimulationOptions simulation;
  simulation.time =
      options.simulation_time.value_or(kTime / problem::motion_scales(problem).slowest_decay_rate);
  simulation.seed = options.seed;
  simulation.y_edges = axes.y_edges;
  simulation.v_edges = axes.v_edges;
  return simulation;
}

// Returns the average of the density p over a narrow bin around x, which differs from p(x) by less
// than 1e-6.
double density_at(const Solution& solution, StateVariable variable, double x, double deviation) {
  const double half = 1e-3 * deviation;
  const double edges[] = {x - half, x + half};
  return transform::marginal(*solution.density, variable, edges).density.front();
}

double round_to_two_digits(double x) {
  const double unit = std::pow(10, std::floor(std::log10(x)) - 1);
  return std::round(x / unit) * unit;
}

std::vector<ReferenceDensityPoint> reference_points(const Solution& seventh, const Solution& fifth,
                                                    StateVariable variable) {
  const bool is_y = variable == StateVariable::y;
  const double deviation = std::sqrt(is_y ? seventh.moments.y2 : seventh.moments.v2);
  const double step = round_to_two_digits(deviation * (is_y ? 0.15 : 0.3));
  std::vector<ReferenceDensityPoint> result;
  for (int k = is_y ? 1 : -10; k <= (is_y ? 20 : 10); ++k) {
    if (k == 0) continue;
    const double x = k * step;
    result.push_back(
        {x,
         {density_at(seventh, variable, x, deviation), density_at(fifth, variable, x, deviation)}});
  }
  return result;
}

double covered_fraction(const Solution& exact, const transform::Marginal& simulated,
                        StateVariable variable) {
  const auto reference = transform::marginal(*exact.density, variable, simulated.edges);
  int within = 0, counted = 0;
  for (std::size_t b = 0; b < simulated.size(); ++b) {
    if (!(simulated.upper[b] > simulated.lower[b])) continue;  // an empty bin has no interval
    ++counted;
    within +=
        reference.density[b] >= simulated.lower[b] && reference.density[b] <= simulated.upper[b];
  }
  return counted == 0 ? 0 : static_cast<double>(within) / counted;
}

constexpr int kMomentDigits = 7;
constexpr int kDensityDigits = 5;

// Returns the text of a number with trailing zeros, which count as significant digits.
std::string significant_digits_text(double x, int significant) {
  if (x == 0) return "0";
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(x))));
  return exponent < -3 ? fmt::format("{:.{}e}", x, significant - 1)
                       : fmt::format("{:.{}f}", x, std::max(0, significant - 1 - exponent));
}

void append_moment_table(const CaseReferenceValues& r, std::string& text) {
  text +=
      "| | value | difference of the orders | simulation | deviation in standard errors |\n"
      "|---|---|---|---|---|\n";
  for (const auto& [name, symbol, value, simulated, error] : r.moments) {
    text += fmt::format("| `{}` | {} | {:.0e} | {:.6g} +- {:.1g} | {:+.1f} |\n", symbol,
                        significant_digits_text(value.value_of_order_seven,
                                                value.agreed_significant_digits(kMomentDigits)),
                        std::abs(value.value_of_order_seven - value.value_of_order_five), simulated,
                        error, (simulated - value.value_of_order_seven) / error);
  }
}

void append_density_table(const CaseReferenceValues& r, std::string& text) {
  text += "| y | p(y) | y' | p(y') |\n|---|---|---|---|\n";
  for (std::size_t k = 0; k < r.y.size(); ++k) {
    const auto& [y, p] = r.y[k];
    const auto& [v, q] = r.ydot[k];
    text += fmt::format("| {:.6g} | {} | {:.6g} | {} |\n", y,
                        significant_digits_text(p.value_of_order_seven,
                                                p.agreed_significant_digits(kDensityDigits)),
                        v,
                        significant_digits_text(q.value_of_order_seven,
                                                q.agreed_significant_digits(kDensityDigits)));
  }
}

}  // namespace

int ValueInTwoSchemeOrders::agreed_significant_digits(int most) const {
  const double difference =
      std::abs(value_of_order_seven - value_of_order_five) / std::abs(value_of_order_seven);
  const double digits = std::floor(-std::log10(std::max(difference, 1e-16) * 2)) + 1;
  // The number of agreed digits is clamped as a double, since log10 of a difference may be
  // infinite, or NaN for 0/0.
  return digits > 1 ? static_cast<int>(std::min<double>(digits, most)) : 1;
}

void validate(const problem::Problem& problem, const ReferenceOptions& options) {
  fd_fpk::validate(seventh_order_options(options));
  fd_fpk::validate(fifth_order_options(options));
  mcs::make_simulation_plan(problem, long_simulation_options(problem, options));
}

CaseReferenceValues compute_reference(const problem::Problem& problem,
                                      const ReferenceOptions& options) {
  CaseReferenceValues result{.problem = problem, .failure = {}, .moments = {}, .y = {}, .ydot = {}};
  const auto seventh = fd_fpk::solve_stationary_density(problem, seventh_order_options(options));
  const auto fifth = fd_fpk::solve_stationary_density(problem, fifth_order_options(options));
  for (const auto* run : {&seventh, &fifth}) {
    if (run->solution.has_status_ok() && run->summary.error) continue;
    result.failure = run->solution.reason.empty() ? "no error estimate" : run->solution.reason;
    return result;
  }
  const auto simulated =
      mcs::simulate_stationary_density(problem, long_simulation_options(problem, options));

  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    if (moment == &Moments::v1) continue;  // E[y'] = 0 for every stationary density
    result.moments.push_back(
        {name,
         symbol,
         {seventh.summary.error->extrapolated.*moment, fifth.summary.error->extrapolated.*moment},
         simulated.solution.moments.*moment,
         simulated.solution.standard_errors->moments.*moment});
  }
  result.y = reference_points(seventh.solution, fifth.solution, StateVariable::y);
  result.ydot = reference_points(seventh.solution, fifth.solution, StateVariable::ydot);
  result.energy_residual = seventh.solution.energy_residual;
  result.simulated_time = simulated.summary.time;
  for (const auto& [variable, marginal] : simulated.solution.estimated_marginals) {
    (variable == StateVariable::y ? result.y_coverage : result.ydot_coverage) =
        covered_fraction(seventh.solution, marginal, variable);
  }
  return result;
}

std::string reference_markdown(const std::vector<CaseReferenceValues>& references,
                               const std::string& command) {
  std::string text = fmt::format(R"(# Reference values

Stationary moments and marginal densities of the vibro-impact Duffing oscillator under Poisson
impulses: the Kolmogorov-Feller equation (`kf`) with the exact impact (`map`). This file and
`reference.csv` are the output of

    {}

Finite volumes of the orders seven and five on grids graded to the origin (`theory.md`, section 4)
give two values of each quantity. Values of moments are Richardson limits of three grids; values of
densities are from the finest grid. The tables have the digits that agree between the two orders.
The last two columns of each table of moments compare the values with an independent simulation.

)",
                                 command);
  for (const auto& r : references) {
    text += fmt::format("## {}\n\n{}\n\n", r.problem.name,
                        problem::non_default_parameters_text(r.problem));
    if (!r.failure.empty()) {
      text += fmt::format("No reference: {}.\n\n", r.failure);
      continue;
    }
    append_moment_table(r, text);
    text += '\n';
    append_density_table(r, text);
    text += fmt::format(
        "\nEnergy residual {:.0e}. Simulated time {:.2g}; the 95 % intervals of its histogram "
        "contain the reference in {:.1f} % of the bins of p(y) and {:.1f} % of the bins of "
        "p(y').\n\n",
        r.energy_residual, r.simulated_time, 100 * r.y_coverage, 100 * r.ydot_coverage);
  }
  return text;
}

std::string reference_csv(const std::vector<CaseReferenceValues>& references) {
  std::string text = "case,quantity,abscissa,value,uncertainty\n";
  for (const auto& r : references) {
    const auto add = [&](const std::string& quantity, const std::string& abscissa,
                         const ValueInTwoSchemeOrders& value) {
      text += fmt::format("{},{},{},{:.10g},{:.1e}\n", r.problem.name, quantity, abscissa,
                          value.value_of_order_seven,
                          std::abs(value.value_of_order_seven - value.value_of_order_five));
    };
    for (const auto& moment : r.moments) add(moment.name, "", moment.value);
    for (const auto& [x, p] : r.y) add("p_y", fmt::format("{:.10g}", x), p);
    for (const auto& [x, p] : r.ydot) add("p_ydot", fmt::format("{:.10g}", x), p);
  }
  return text;
}

}  // namespace fpkcheck::study
