#include "epc/solve.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "epc/continuation.hpp"
#include "epc/newton.hpp"
#include "epc/projection.hpp"
#include "problem/energy_balance.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "problem/input_error.hpp"
#include "transform/zhuravlev.hpp"

namespace fpkcheck::epc {
namespace {

using transform::Status;

// Q_2 of the Gaussian with the deviations of the weights.
std::vector<Term> linearised(const Deviations& sigma) {
  return {{2, 0, -1 / (2 * sigma.x1 * sigma.x1)}, {0, 2, -1 / (2 * sigma.x2 * sigma.x2)}};
}

struct Search {
  NewtonResult root;
  std::string failure;  // one sentence when no root was found
};

Search find_root(const Projection& projection, const ResidualCoefficients& f,
                 const Options& options) {
  const Eigen::VectorXd start = projection.basis().scaled(linearised(projection.basis().sigma()));
  Search search{newton(projection, f, start,
                       {.tolerance = options.tolerance, .max_iterations = options.max_iterations}),
                ""};
  if (search.root.converged) return search;
  const int plain_iterations = search.root.iterations;
  const Branch branch = follow_branch(projection, f, options.tolerance);
  search.root.iterations += branch.iterations;
  if (branch.reached == 1) {
    search.root.a = branch.a;
    search.root.residual = branch.residual;
    search.root.converged = true;
    return search;
  }
  search.failure = fmt::format(
      "plain Newton steps from equivalent linearisation found no root in {} iterations (least "
      "residual {:.1e}, asked for {:.1e}), and the branch of solutions that starts from white "
      "noise at an impact without loss ends at {:.0f} % of the way to the full problem",
      plain_iterations, search.root.residual, options.tolerance, 100 * branch.reached);
  return search;
}

transform::SmoothDensity density_of(const Polynomial& q, const Support& support) {
  const double constant = std::exp(-support.peak()) / support.integral();  // C of paper (17)
  return transform::physical_density({.value =
                                          [q, support, constant](double x1, double x2) {
                                            return support.contains(x1, x2)
                                                       ? constant * std::exp(q(x1, x2))
                                                       : 0;
                                          },
                                      .x1_max = support.x1_max(),
                                      .x2_max = support.x2_max()});
}

// Why a root is no density of the kind asked for; empty when it is.
std::string objection(const Support& support, const LeadingForm& form, double energy_residual) {
  if (!(support.edge_ratio() < Support::kEdgeAllowed)) {
    const std::string rise =
        form.negative ? std::string("though Q_n falls in the end")
                      : fmt::format(
                            "and Q_n rises in the end along {:.0f} % of all directions, along "
                            "(x1/sigma1, x2/sigma2) = ({:.2f}, {:.2f}) from radius {:.2f} on",
                            100 * form.rising_share, form.worst.x1, form.worst.x2, form.rises_from);
    return fmt::format(
        "the density is {:.1e} of its peak on the edge of its support (allowed {:.0e}), {}",
        support.edge_ratio(), Support::kEdgeAllowed, rise);
  }
  if (!(std::abs(energy_residual) <= kEnergyAllowed)) {
    return fmt::format(
        "the root misses the stationary balance of power by {:.0f} % of the input (allowed "
        "{:.0f} %), so it is near no stationary density",
        100 * std::abs(energy_residual), 100 * kEnergyAllowed);
  }
  return "";
}

void judge(const problem::Problem& problem, const Polynomial& q, const Deviations& sigma,
           Result& result) {
  const Support support(q, sigma);
  const LeadingForm form = leading_form(q, sigma);
  auto& [solution, summary] = result;
  summary.coefficients = q.terms();
  summary.leading_form = form;
  summary.support = {.least_radius = support.least_radius(),
                     .greatest_radius = support.greatest_radius(),
                     .y_max = support.x1_max(),
                     .v_max = support.x2_max(),
                     .edge_density = support.edge_ratio(),
                     .cut_off = support.cut_off()};

  const transform::SmoothDensity density = density_of(q, support);
  solution.mass = transform::expectation(density, [](double, double) { return 1.0; });
  solution.moments = transform::moments(density);
  solution.energy_residual =
      problem::energy_residual(problem, problem::Impact::delta,
                               {.mean_velocity = solution.moments.v1,
                                .mean_square_velocity = solution.moments.v2,
                                .impact_energy_flux = transform::impact_flux(density, 3)});
  solution.density = density;
  solution.reason = objection(support, form, solution.energy_residual);
  solution.status = solution.reason.empty() ? Status::ok : Status::inadmissible;
}

transform::Solution labelled(const Options& options) {
  const bool white = options.equation == Equation::white;
  transform::Solution solution;
  solution.id = fmt::format("epc-gaussian{}-n{}", white ? "-white" : "", options.order);
  solution.method = "epc";
  solution.equation = white ? "white" : "km4";
  solution.impact = problem::Impact::delta;
  return solution;
}

}  // namespace

void validate(const Options& options) {
  if (options.order < 2 || options.order > kMaxOrder || options.order % 2 != 0) {
    throw InputError(
        fmt::format("epc order = {} (must be an even number from 2 to {}: an odd one cannot fall "
                    "in every direction, and rounding shows in higher ones)",
                    options.order, kMaxOrder));
  }
  if (!(options.tolerance > 0) || !std::isfinite(options.tolerance)) {
    throw InputError(fmt::format("epc tolerance = {} (no iteration can end) use a positive number",
                                 options.tolerance));
  }
  if (options.max_iterations < 1) {
    throw InputError(fmt::format("epc max_iterations = {} (no step would be taken) use 1 or more",
                                 options.max_iterations));
  }
}

Result solve(const problem::Problem& problem, const Options& options) {
  validate(options);
  const auto start = std::chrono::steady_clock::now();
  const Deviations sigma = deviations(problem::equivalent_linearisation(problem));
  const Projection projection(Basis(options.order, options.monomials, sigma));
  const Search search =
      find_root(projection, residual_coefficients(problem, options.equation), options);

  Result result;
  result.solution = labelled(options);
  result.summary.order = options.order;
  result.summary.formulation = options.formulation;
  result.summary.iterations = search.root.iterations;
  result.summary.residual = search.root.residual;
  if (search.root.converged) {
    judge(problem, projection.basis().polynomial(search.root.a), sigma, result);
  } else {
    result.solution.status = Status::not_converged;
    result.solution.reason = search.failure;
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  result.solution.seconds = elapsed.count();
  return result;
}

}  // namespace fpkcheck::epc
