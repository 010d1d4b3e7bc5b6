#include "epc/gaussian/root_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "epc/gaussian/continuation.hpp"
#include "epc/gaussian/density_support.hpp"
#include "epc/selection_policy.hpp"
#include "epc/summary.hpp"
#include "numerics/linear_algebra/factorisations.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::gaussian {
namespace {

using numerics::NewtonResult;
using problem::DensityEquation;

// Largest accepted relative change of the coefficients of Q_n when the jump integral's remainder is
// integrated over a smaller disc. For roots that are insensitive to the disc of the jump integral's
// remainder, the relative change of the coefficients is below 0.01.
constexpr double kDiscSensitivityLimit = 0.05;

std::vector<ExponentMonomial> gaussian_exponent(const StandardDeviations& sigma) {
  return {{2, 0, -1 / (2 * sigma.x1 * sigma.x1)}, {0, 2, -1 / (2 * sigma.x2 * sigma.x2)}};
}

bool is_force_odd(const problem::System& system) {
  if (!system.has_polynomial_force())
    return system.force_formula().parity() == problem::FunctionParity::odd;
  const numerics::Polynomial& force = system.restoring_force();
  return force.coefficient(0) == 0 && force.coefficient(2) == 0;
}

// Without a wall, asymmetric forces, noise or impulses need all monomials in the exponent Q_n.
MonomialSet required_monomials(const problem::Problem& problem, const ClosureOptions& options) {
  if (problem.system.left_wall()) return options.monomials;
  const bool symmetric =
      is_force_odd(problem.system) &&
      (!problem.noise_factor || problem.noise_factor->parity() == problem::FunctionParity::even) &&
      problem.impulses.rate_times_moment(1) == 0 && problem.impulses.amplitude_law().is_symmetric();
  return symmetric ? options.monomials : MonomialSet::general;
}

}  // namespace

ProjectedEquations make_projected_equations(const problem::Problem& problem,
                                            const ClosureOptions& options,
                                            const DensityEquationCoefficients& coefficients,
                                            const StandardDeviations& sigma) {
  const GaussianWeightedBasis basis(options.order, required_monomials(problem, options), sigma);
  std::optional<ProjectedFormulaTerms> formulas;
  if (has_formulas(problem)) {
    formulas.emplace(basis, problem, coefficients.damping, coefficients.odd_force.coefficient(1));
  }
  if (closure_density_equation(options) == DensityEquation::kf) {
    return ProjectedEquations(basis, problem.impulses, JumpIntegralRemainder::kRadius,
                              std::move(formulas));
  }
  return ProjectedEquations(basis, std::move(formulas));
}

std::string unresolved_formulas_reason(const ProjectedEquations& projection) {
  const auto& formulas = projection.formulas();
  if (!formulas ||
      formulas->projection_quadrature_error() <= ProjectedFormulaTerms::kQuadratureTolerance) {
    return "";
  }
  return fmt::format(
      "narrower panels change the weighted moments of the formulas by {:.1e} of the largest "
      "moment (limit {:.0e}): the formulas are too steep; use fd or mcs",
      formulas->projection_quadrature_error(), ProjectedFormulaTerms::kQuadratureTolerance);
}

namespace {

std::string describe_branch_end(const SolutionBranch& branch) {
  switch (branch.end) {
    case SolutionBranchEndReason::white_noise:
      return "turns back to another root of the white-noise equations";
    case SolutionBranchEndReason::far_away:
      return "diverges after a fold";
    default:
      break;
  }
  const bool turned = std::ranges::any_of(branch.points, &SolutionBranchPoint::fold);
  return turned ? "is lost after a fold" : "ends there";
}

class GaussianRootSearch {
 public:
  GaussianRootSearch(const problem::Problem& problem, const ClosureOptions& options,
                     const StandardDeviations& sigma)
      : problem_(problem),
        options_(options),
        coefficients_(residual_coefficients(problem, closure_density_equation(options), sigma)),
        projection_(make_projected_equations(problem, options, coefficients_, sigma)),
        gaussian_coefficients_(projection_.basis().scaled_coefficients(
            gaussian_exponent(projection_.basis().weight_standard_deviations()))) {}

  ClosureRootSearchResult find_closure_root() {
    search_.sigma = projection_.basis().weight_standard_deviations();
    search_.failure = unresolved_formulas_reason(projection_);
    if (!search_.failure.empty()) return search_;
    if (options_.order > 2) search_.previous = find_previous_root();
    const NewtonResult plain = newton_from(gaussian_coefficients_, false);
    search_.plain_newton_converges = plain.converged;
    record_attempt(plain) || record_attempt(newton_from(gaussian_coefficients_, true)) ||
        (search_.previous && record_attempt(newton_from(previous_coefficients(), true))) ||
        try_branch() ||
        (search_.previous &&
         record_attempt(follow_newton_homotopy(projection_, coefficients_, previous_coefficients(),
                                               options_.tolerance)));
    if (!search_.root) {
      search_.failure = failure_message();
      return search_;
    }
    search_.condition = condition_number_at_root();
    if (closure_density_equation(options_) == DensityEquation::kf) check_disc_sensitivity();
    return search_;
  }

 private:
  std::optional<ExponentPolynomial> find_previous_root() const {
    ClosureOptions lower = options_;
    lower.order -= 2;
    return GaussianRootSearch(problem_, lower, projection_.basis().weight_standard_deviations())
        .find_closure_root()
        .root;
  }
  Eigen::VectorXd previous_coefficients() const {
    return projection_.basis().scaled_coefficients(search_.previous->terms());
  }

  NewtonResult newton_from(const Eigen::VectorXd& start, bool damped) const {
    return solve_by_newton(projection_, coefficients_, start,
                           {.tolerance = options_.tolerance,
                            .max_iterations = options_.max_iterations,
                            .damped = damped});
  }

  // Records a root of the projected equations and returns whether the search ends. Up to closure
  // order 6 any root of the projected equations ends the search, as in the paper. Above closure
  // order 6 only a root whose density decays on the edge of its support ends the search.
  bool record_attempt(const NewtonResult& result) {
    search_.iterations += result.iterations;
    if (attempts_++ == 0 || result.residual < search_.residual) search_.residual = result.residual;
    if (!result.converged) return false;
    const ExponentPolynomial root = projection_.basis().exponent_polynomial(result.a);
    const bool settled = options_.order <= 6 ||
                         DensitySupport(root, projection_.basis().weight_standard_deviations())
                                 .support_edge_to_peak_density_ratio() < kMaxSupportEdgeDensity;
    if (settled || !search_.root) search_.root = root;
    return settled;
  }

  bool try_branch() {
    const SolutionBranchAndRoot followed =
        follow_solution_branch(projection_, coefficients_, options_.tolerance);
    search_.branch = followed.branch;
    NewtonResult root = followed.root;
    if (!root.converged) root.residual = std::numeric_limits<double>::infinity();
    return record_attempt(root);
  }

  void check_disc_sensitivity() {
    const Eigen::VectorXd a = projection_.basis().scaled_coefficients(search_.root->terms());
    const ProjectedEquations smaller(projection_.basis(), problem_.impulses,
                                     JumpIntegralRemainder::kRadius - 1, projection_.formulas());
    const NewtonResult there = solve_by_newton(smaller, coefficients_, a,
                                               {.tolerance = options_.tolerance,
                                                .max_iterations = options_.max_iterations,
                                                .damped = false});
    search_.iterations += there.iterations;
    if (there.converged) search_.disc_sensitivity = (there.a - a).norm() / a.norm();
    if (search_.disc_sensitivity && *search_.disc_sensitivity <= kDiscSensitivityLimit) return;
    search_.root.reset();
    search_.failure = fmt::format(
        "the root depends on the disc of the jump integral: between radii of {} and {} deviations "
        "{} (limit {}); the equations with the full integral are ill-defined",
        JumpIntegralRemainder::kRadius - 1, JumpIntegralRemainder::kRadius,
        search_.disc_sensitivity ? fmt::format("its coefficients change by {:.3f} of their norm",
                                               *search_.disc_sensitivity)
                                 : "Newton's method failed",
        kDiscSensitivityLimit);
  }

  double condition_number_at_root() const {
    const Eigen::VectorXd a = projection_.basis().scaled_coefficients(search_.root->terms());
    const Eigen::VectorXd values =
        numerics::singular_values(projection_.jacobian(coefficients_, a));
    return values[0] / values[values.size() - 1];
  }

  std::string failure_message() const {
    return fmt::format(
        "Newton's method from equivalent linearisation{}, plain and damped, found no root in {} "
        "iterations (least residual {:.1e}, tolerance {:.1e}); the branch from white noise with "
        "elastic impacts reaches {:.1f} % of the way and {}",
        search_.previous ? fmt::format(" and from n = {}", options_.order - 2) : "",
        search_.iterations, search_.residual, options_.tolerance, 100 * search_.branch.furthest,
        describe_branch_end(search_.branch));
  }

  const problem::Problem& problem_;
  const ClosureOptions& options_;
  DensityEquationCoefficients coefficients_;
  ProjectedEquations projection_;
  Eigen::VectorXd gaussian_coefficients_;
  ClosureRootSearchResult search_;
  int attempts_ = 0;
};

}  // namespace

ClosureRootSearchResult find_closure_root(const problem::Problem& problem,
                                          const ClosureOptions& options) {
  return GaussianRootSearch(problem, options, gaussian_weight_deviations(problem))
      .find_closure_root();
}

}  // namespace fpkcheck::epc::gaussian
