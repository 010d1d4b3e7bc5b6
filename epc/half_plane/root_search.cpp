#include "epc/half_plane/root_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/process/stopwatch.hpp"
#include "epc/half_plane/newton.hpp"
#include "numerics/linear_algebra/factorisations.hpp"

namespace fpkcheck::epc::half_plane {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using numerics::NewtonOptions;
using numerics::NewtonResult;

constexpr double kRoughTolerance = 1e-4;
constexpr int kMaxRefinements = 4;
// Largest number of homotopy paths in one pass over the candidates for the confinement level of the
// density. For systems of at most kFewEquations equations the number of homotopy paths is
// unlimited, since each path takes tenths of a second.
constexpr int kMostHomotopies = 2, kFewEquations = 50;

// Factor for the number of quadrature points in each coordinate; their product more than doubles.
QuadraturePointCounts refined_point_counts(const QuadraturePointCounts& size) {
  return {size.s * 3 / 2, size.t * 3 / 2, size.wall * 3 / 2};
}

// Attempts a solution at each candidate for the confinement level in turn, except at levels close
// to a level with a solution. Returns the first solution whose decay ratio is below the limit, or
// else the solution with the smallest decay ratio. If the attempts at all confinement levels fail,
// the return value is empty.
template <class ClosureResult, class Attempt>
std::optional<ClosureResult> try_confinement_levels(const std::vector<double>& levels,
                                                    double max_decay_ratio,
                                                    const Attempt& attempt) {
  constexpr double kClose = 0.01;
  std::optional<ClosureResult> best;
  std::vector<double> solved_levels;
  double least = std::numeric_limits<double>::infinity();
  for (const double level : levels) {
    const auto is_close = [&](double solved) { return std::abs(level / solved - 1) < kClose; };
    if (std::ranges::any_of(solved_levels, is_close)) continue;
    std::optional<std::pair<ClosureResult, double>> outcome = attempt(level);
    if (!outcome) continue;
    solved_levels.push_back(level);
    auto& [result, density] = *outcome;
    if (!best || density < least) {
      best = std::move(result);
      least = density;
    }
    if (least < max_decay_ratio) break;
  }
  return best;
}

class HalfPlaneRootSearch {
 public:
  HalfPlaneRootSearch(const ClosureFormulation& formulation, const ClosureOptions& options)
      : formulation_(formulation),
        options_(options),
        unit_(formulation.relaxation_rate_unit()),
        deadline_(options.max_seconds) {}

  ClosureRootSearchResult find_root_at_requested_order() {
    solve_orders();
    root_.newton.iterations = iterations_;
    root_.homotopies = homotopies_;
    return std::move(root_);
  }

 private:
  struct StartingPoint {
    ClosureEquations equations;
    VectorXd a;
  };

  void solve_orders() {
    ClosureDensity guess = formulation_.initial_density();
    const int first = formulation_.lowest_searched_order(options_.order);
    for (int n = first; n <= options_.order; n += 2) {
      if (n == options_.order && n > first) root_.previous = guess;
      std::optional<ClosureDensity> next = solve_order(guess, n);
      if (!next && n > first && formulation_.can_start_at_any_order()) {
        next = solve_order(formulation_.initial_density(), n);
      }
      // Closure order 2 is solved twice. Under strong impact losses, equivalent linearisation
      // overestimates the standard deviations, which set the domain of the first solution.
      if (next && n == 2) next = solve_order(*next, n);
      if (!next) return;
      guess = *next;
    }
    solve_requested_order(guess);
  }

  // Returns whether the deadline of the root search has passed; the first call after the deadline
  // stores the reason of failure.
  bool is_past_deadline() {
    if (!deadline_.has_deadline_passed()) return false;
    if (std::exchange(deadline_reported_, true)) return true;
    root_.failure = fmt::format("no root was found in {:g} s (max_seconds){}", options_.max_seconds,
                                root_.failure.empty() ? "" : "; last failure: " + root_.failure);
    return true;
  }

  // At the confinement level of the initial guess, Newton's method starts from the exponent Q_n of
  // the initial guess without a fit.
  std::vector<double> candidate_confinement_energies(const ClosureDensity& guess,
                                                     ClosureRootSearchStage stage) const {
    std::vector<double> candidate_confinement_energies =
        formulation_.candidate_confinement_energies(guess, stage);
    if (guess.level > 0) candidate_confinement_energies.push_back(guess.level);
    return candidate_confinement_energies;
  }

  std::optional<ClosureDensity> solve_order(const ClosureDensity& guess, int n) {
    reset_homotopy_limit();
    const auto attempt = [&](double level) -> std::optional<std::pair<ClosureDensity, double>> {
      if (is_past_deadline()) return std::nullopt;
      const StartingPoint start = make_starting_point(
          guess, n, level, initial_point_counts(guess, n, level, ClosureRootSearchStage::rough));
      const NewtonResult result = solve_from(start, ClosureRootSearchStage::rough);
      if (!result.converged) return std::nullopt;
      homotopies_left_ = 0;
      const ClosureDensity closure = closure_with_decay_end(start.equations, result.a, level);
      return std::pair{closure, formulation_.decay_ratio(closure, ClosureRootSearchStage::rough)};
    };
    return try_confinement_levels<ClosureDensity>(
        candidate_confinement_energies(guess, ClosureRootSearchStage::rough),
        formulation_.max_decay_ratio(ClosureRootSearchStage::rough), attempt);
  }

  void solve_requested_order(const ClosureDensity& guess) {
    reset_homotopy_limit();
    const auto attempt =
        [&](double level) -> std::optional<std::pair<ClosureRootSearchResult, double>> {
      if (is_past_deadline() || !solve_at_level(guess, level)) return std::nullopt;
      homotopies_left_ = 0;
      // The density of the root may allow a better confinement level than the initial guess.
      const ClosureRootSearchResult first_root = root_;
      const auto improved_confinement_level =
          formulation_.improved_confinement_level(guess, first_root.closure);
      if (improved_confinement_level &&
          !solve_at_level(first_root.closure, *improved_confinement_level))
        root_ = first_root;
      return std::pair{root_, root_.decay_ratio};
    };
    const auto best = try_confinement_levels<ClosureRootSearchResult>(
        candidate_confinement_energies(guess, ClosureRootSearchStage::last),
        formulation_.max_decay_ratio(ClosureRootSearchStage::last), attempt);
    if (best) root_ = *best;
  }

  // Increases the number of quadrature points until more points hardly change the exponent. If the
  // density has by far not decayed, no quadrature points are added, since the root is inadmissible.
  bool solve_at_level(const ClosureDensity& guess, double level) {
    const QuadratureRefinementCriterion refinement = formulation_.quadrature_refinement_criterion();
    const bool estimated =
        refinement.rule == QuadratureRefinementCriterion::ChangeMeasure::estimated;
    QuadraturePointCounts size =
        initial_point_counts(guess, options_.order, level, ClosureRootSearchStage::last);
    StartingPoint at = make_starting_point(guess, options_.order, level, size);
    NewtonResult result = solve_from(at, ClosureRootSearchStage::last);
    const auto is_far_from_decayed = [&](const ClosureEquations& equations) {
      constexpr double kFarAboveLimit = 100;
      return formulation_.decay_ratio(closure_with_decay_end(equations, result.a, level),
                                      ClosureRootSearchStage::last) >
             kFarAboveLimit * formulation_.max_decay_ratio(ClosureRootSearchStage::last);
    };
    for (int left = kMaxRefinements; result.converged; --left) {
      const QuadraturePointCounts finer = refined_point_counts(size);
      StartingPoint fine{make_equations(at.equations.basis(), level, finer), result.a};
      if (estimated) {
        const double change =
            exponent_change_on_finer_points(fine.equations, at.equations, result.a);
        const bool is_final = change < refinement.tolerance || left == 0;
        root_.is_refinement_omitted = !is_final && is_far_from_decayed(at.equations);
        if (is_final || root_.is_refinement_omitted) {
          return store_root(at.equations, result, level, size, change);
        }
      }
      result = solve_from(fine, ClosureRootSearchStage::last);
      if (!estimated && result.converged) {
        const double change = step_norm(result.a - fine.a, covariance_at(fine.equations, result.a));
        if (change < refinement.tolerance || left == 1) {
          return store_root(fine.equations, result, level, finer, change);
        }
      }
      at = std::move(fine);
      size = finer;
    }
    return false;
  }

  QuadraturePointCounts initial_point_counts(const ClosureDensity& guess, int n, double level,
                                             ClosureRootSearchStage stage) const {
    return formulation_.quadrature_point_counts(n, level / guess.temperature, stage);
  }

  ClosureEquations make_equations(const OrthonormalBasis& basis, double level,
                                  const QuadraturePointCounts& size) const {
    const double support = support_energy(level, options_.tail);
    return formulation_.closure_equations(
        support, make_exponent_confinement(level, options_.tail), basis,
        formulation_.quadrature_points_below_energy(support, size), size);
  }

  // Returns the equations of closure order n, and the coefficients of the fit of the polynomial Q_n
  // to the initial guess of the density. The basis functions of the exponent are orthonormal under
  // the density of the initial guess.
  StartingPoint make_starting_point(const ClosureDensity& guess, int n, double level,
                                    const QuadraturePointCounts& size) const {
    const double support = support_energy(level, options_.tail);
    const ExponentConfinementTerm confinement = make_exponent_confinement(level, options_.tail);
    const QuadraturePoints points = formulation_.quadrature_points_below_energy(support, size);
    VectorXd exponent(points.size()), mass(points.size());
    for (Index i = 0; i < points.size(); ++i) {
      exponent[i] = level == guess.level
                        ? guess.q(points.s[i], points.t[i])
                        : formulation_.exponent_of_initial_guess(guess, points.s[i], points.t[i]);
      mass[i] = exponent[i] + confinement(points.energy[i]);
    }
    mass = points.weight.array() * (mass.array() - mass.maxCoeff()).exp();
    mass /= mass.sum();
    ClosureEquations equations = formulation_.closure_equations(
        support, confinement, OrthonormalBasis(n, points, mass), points, size);
    VectorXd a = equations.fit_exponent_coefficients(
        exponent, formulation_.weights_of_exponent_fit(guess, support, points, exponent, mass));
    return {std::move(equations), std::move(a)};
  }

  NewtonOptions newton_options(ClosureRootSearchStage stage) const {
    const bool last = stage == ClosureRootSearchStage::last;
    return {.tolerance = last ? options_.tolerance : kRoughTolerance,
            .max_iterations = options_.max_iterations,
            .polish = last};
  }

  // If Newton's method fails, the end of a homotopy path is a second starting point for Newton's
  // method. For large systems no homotopy path is followed if another confinement level has a root,
  // or after kMostHomotopies failed paths.
  NewtonResult solve_from(const StartingPoint& start, ClosureRootSearchStage stage) {
    const NewtonOptions options = newton_options(stage);
    NewtonResult result = solve_by_newton(start.equations, start.a, unit_, options);
    iterations_ += result.iterations;
    if (result.converged) return result;
    if (homotopies_left_ <= 0 && start.equations.size() > kFewEquations) {
      store_failure(start, result);
      return result;
    }
    --homotopies_left_;
    const numerics::SolutionCurve homotopy_curve = follow_homotopy(
        start.equations, start.a, [this] { return deadline_.has_deadline_passed(); });
    const bool end_reached = homotopy_curve.end == numerics::ContinuationTermination::end_reached;
    ++homotopies_;
    iterations_ += homotopy_curve.iterations;
    if (end_reached) {
      result = solve_by_newton(start.equations, homotopy_curve.points.back().a, unit_, options);
      iterations_ += result.iterations;
    }
    if (!result.converged) {
      last_homotopy_ =
          end_reached ? ": a homotopy led to no root"
                      : fmt::format(": a homotopy ended at {:.0f} % of its path",
                                    100 * homotopy_curve.curve_point_with_largest_parameter().t);
      store_failure(start, result);
    }
    return result;
  }

  void store_failure(const StartingPoint& start, const NewtonResult& result) {
    root_.newton = result;
    root_.failure = fmt::format(
        "Newton's method failed at order {} after {} iterations (least residual {:.1e}){}",
        start.equations.basis().order(), result.iterations, result.residual, last_homotopy_);
  }

  void reset_homotopy_limit() {
    homotopies_left_ = kMostHomotopies;
    last_homotopy_.clear();
  }

  ClosureDensity closure_with_decay_end(const ClosureEquations& equations, const VectorXd& a,
                                        double level) const {
    ClosureDensity closure = make_closure_density(equations, a, level, options_.tail);
    closure.end_of_exponent_decay =
        formulation_.end_of_exponent_decay(closure.q, closure.temperature);
    return closure;
  }

  static Eigen::MatrixXd covariance_at(const ClosureEquations& equations, const VectorXd& a) {
    return equations.covariance(equations.evaluate_density(a));
  }

  // Returns the norm of the first Newton step after quadrature points have been added.
  static double exponent_change_on_finer_points(const ClosureEquations& fine,
                                                const ClosureEquations& coarse, const VectorXd& a) {
    const GalerkinSystem::DensityAtPoints density = coarse.evaluate_density(a);
    const numerics::LuFactors factors(coarse.jacobian(density));
    const VectorXd step = factors.solve(fine.residual(fine.evaluate_density(a)));
    return step_norm(step, coarse.covariance(density));
  }

  bool store_root(const ClosureEquations& equations, const NewtonResult& result, double level,
                  const QuadraturePointCounts& size, double quadrature_change) {
    const GalerkinSystem::DensityAtPoints density = equations.evaluate_density(result.a);
    root_.newton = result;
    root_.failure.clear();
    root_.closure = closure_with_decay_end(equations, result.a, level);
    root_.decay_ratio = formulation_.decay_ratio(root_.closure, ClosureRootSearchStage::last);
    root_.quadrature = size;
    root_.quadrature_change = quadrature_change;
    const Eigen::MatrixXd jacobian = equations.jacobian(density);
    const Eigen::MatrixXd covariance = equations.covariance(density);
    root_.condition = condition_number(jacobian, covariance);
    root_.rightmost_eigenvalue = rightmost_eigenvalue(jacobian, covariance);
    root_.relaxation_rate_unit = unit_;
    return true;
  }

  const ClosureFormulation& formulation_;
  const ClosureOptions& options_;
  double unit_;
  base::Deadline deadline_;
  ClosureRootSearchResult root_;
  int iterations_ = 0, homotopies_ = 0, homotopies_left_ = 0;
  std::string last_homotopy_;  // outcome of the last homotopy, for the reason of failure
  bool deadline_reported_ = false;
};

}  // namespace

ClosureRootSearchResult find_closure_root(const ClosureFormulation& formulation,
                                          const ClosureOptions& options) {
  return HalfPlaneRootSearch(formulation, options).find_root_at_requested_order();
}

}  // namespace fpkcheck::epc::half_plane
