#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "base/process/stopwatch.hpp"
#include "epc/formulations.hpp"
#include "epc/gaussian/density_support.hpp"
#include "epc/gaussian/root_search.hpp"
#include "epc/selection_policy.hpp"
#include "numerics/ode/bdf_integrator.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "transform/smooth_density_results.hpp"

namespace fpkcheck::epc::gaussian {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using transform::Status;

// Tolerance of CVODE for the scaled coefficients of Q_n, which are of the order of 1 to 10.
constexpr double kTimeTolerance = 1e-9;

/// Means of the basis functions under the density C exp(Q_n), by quadrature along rays from the
/// origin of the scaled plane. The quadrature along a ray ends where Q_n rises again after exp(Q_n)
/// has fallen below kMaxSupportEdgeDensity of its peak, as in DensitySupport.
class ClosureDensityMeans {
 public:
  static constexpr int kDirections = 96, kRadialPanels = 10;
  static constexpr double kRadius = 8;  // in deviations of the weight and of the initial density

  ClosureDensityMeans(const GaussianWeightedBasis& basis, const problem::InitialGaussian& start) {
    const StandardDeviations& sigma = basis.weight_standard_deviations();
    const double extent = std::max(
        {1.0,
         start.displacement_deviation / sigma.x1 + std::abs(start.mean_displacement) / sigma.x1,
         start.velocity_deviation / sigma.x2 + std::abs(start.mean_velocity) / sigma.x2});
    auto radial = numerics::composite_gauss_points(0.0, kRadius * extent, kRadialPanels);
    std::ranges::sort(radial, {}, &numerics::QuadraturePoint::at);
    points_per_ray_ = static_cast<Index>(radial.size());
    const bool is_even = basis.monomial_set() == MonomialSet::point_symmetric;
    const int rays = is_even ? kDirections / 2 : kDirections;
    VectorXd x1(rays * points_per_ray_), x2(x1.size());
    weights_.resize(x1.size());
    for (int ray = 0; ray < rays; ++ray) {
      const double angle = 2 * std::numbers::pi * ray / kDirections;
      for (Index k = 0; k < points_per_ray_; ++k) {
        const auto& [radius, weight] = radial[static_cast<std::size_t>(k)];
        const Index i = ray * points_per_ray_ + k;
        x1[i] = sigma.x1 * radius * std::cos(angle);
        x2[i] = sigma.x2 * radius * std::sin(angle);
        weights_[i] = weight * radius;
        if (ray == 0 && radius < kCoreFraction * kRadius * extent) core_points_ = k + 1;
      }
    }
    values_ = basis.basis_values(x1, x2);
  }

  std::string point_counts_text() const {
    return fmt::format("{} x {}", weights_.size() / points_per_ray_, points_per_ray_);
  }

  /// Returns the probabilities of the quadrature points under the density C exp(Q_n).
  VectorXd probabilities(const VectorXd& a) const {
    const VectorXd q = values_ * a;
    double core_peak = -std::numeric_limits<double>::infinity();
    for (Index first = 0; first < q.size(); first += points_per_ray_)
      core_peak = std::max(core_peak, q.segment(first, core_points_).maxCoeff());
    VectorXd exponent = VectorXd::Constant(q.size(), -std::numeric_limits<double>::infinity());
    for (Index first = 0; first < q.size(); first += points_per_ray_) {
      double lowest = std::numeric_limits<double>::infinity();
      for (Index i = first; i < first + points_per_ray_; ++i) {
        if (q[i] > lowest && lowest < core_peak + std::log(kMaxSupportEdgeDensity)) break;
        lowest = std::min(lowest, q[i]);
        exponent[i] = q[i];
      }
    }
    const VectorXd mass = weights_.array() * (exponent.array() - exponent.maxCoeff()).exp();
    return mass / mass.sum();
  }
  VectorXd basis_function_means(const VectorXd& probabilities) const {
    return values_.transpose() * probabilities;
  }
  /// Returns the covariances of all basis functions with the function sum_k direction_k phi_k.
  VectorXd covariances(const VectorXd& probabilities, const VectorXd& direction) const {
    const VectorXd function = values_ * direction;
    return values_.transpose() * probabilities.cwiseProduct(function) -
           basis_function_means(probabilities) * probabilities.dot(function);
  }

 private:
  static constexpr double kCoreFraction = 0.25;  // DensitySupport: a radius of 2 deviations

  Index points_per_ray_ = 0, core_points_ = 0;
  VectorXd weights_;
  MatrixXd values_;
};

/// The equations M(a) da/dt = R(a) of solve_evolution() in formulations.hpp. The matrix M = G - m
/// E_p[phi]^T, with the Gram matrix G and the means m under the Gaussian weights, is a rank-one
/// change of G (formula of Sherman and Morrison).
class ClosureCoefficientRates {
 public:
  ClosureCoefficientRates(const ProjectedEquations& projection,
                          const DensityEquationCoefficients& coefficients,
                          const problem::InitialGaussian& start)
      : projection_(projection),
        coefficients_(coefficients),
        means_(projection.basis(), start),
        gram_(projection.basis().weighted_gram_matrix()),
        constant_(gram_.solve(projection.basis().basis_function_weighted_means())) {}

  const ClosureDensityMeans& means() const { return means_; }

  /// Returns the time derivative da/dt of the coefficients a of Q_n; empty if the matrix M is
  /// numerically singular.
  std::optional<VectorXd> rate(const VectorXd& a) const {
    return solve_with_mass_matrix(projection_.residual(coefficients_, a),
                                  means_.basis_function_means(means_.probabilities(a)));
  }

  /// Returns the derivative of da/dt with respect to the coefficients a of Q_n; empty if the matrix
  /// M is numerically singular.
  std::optional<MatrixXd> jacobian(const VectorXd& a) const {
    const VectorXd probabilities = means_.probabilities(a);
    const VectorXd density_means = means_.basis_function_means(probabilities);
    const auto rate = solve_with_mass_matrix(projection_.residual(coefficients_, a), density_means);
    if (!rate) return std::nullopt;
    // M da' = dR - dM a', and dM a' = -m (Cov_p(phi, phi . a') . da)
    const MatrixXd right_hand_side = projection_.jacobian(coefficients_, a) +
                                     projection_.basis().basis_function_weighted_means() *
                                         means_.covariances(probabilities, *rate).transpose();
    return solve_with_mass_matrix(right_hand_side, density_means);
  }

 private:
  // Smallest ratio det M / det G, with the Gram matrix G, for which the matrix M counts as regular.
  // The ratio det M / det G is 1 minus the mean, under the density, of the best approximation of
  // the constant 1 by basis functions.
  static constexpr double kLeastDeterminantRatio = 1e-3;

  template <class Matrix>
  std::optional<Matrix> solve_with_mass_matrix(const Matrix& right_hand_side,
                                               const VectorXd& density_means) const {
    const double ratio = 1 - density_means.dot(constant_);
    if (!(ratio > kLeastDeterminantRatio)) return std::nullopt;
    const Matrix solution = gram_.solve(right_hand_side);
    const Matrix change = constant_ * (density_means.transpose() * solution) / ratio;
    if (!solution.allFinite() || !change.allFinite()) return std::nullopt;
    return Matrix(solution + change);
  }

  const ProjectedEquations& projection_;
  const DensityEquationCoefficients& coefficients_;
  ClosureDensityMeans means_;
  Eigen::LLT<MatrixXd> gram_;
  VectorXd constant_;  // coefficients of the best approximation of the constant 1
};

std::vector<ExponentMonomial> exponent_of_initial_density(const problem::InitialGaussian& start) {
  const double y = start.displacement_deviation * start.displacement_deviation,
               v = start.velocity_deviation * start.velocity_deviation;
  return {{2, 0, -1 / (2 * y)},
          {0, 2, -1 / (2 * v)},
          {1, 0, start.mean_displacement / y},
          {0, 1, start.mean_velocity / v}};
}

// Stores the density with the exponent Q_n at one time, and the status if it is inadmissible.
void add_snapshot(const problem::Problem& problem, const ExponentPolynomial& q,
                  const StandardDeviations& sigma, double time, ClosureEvolution& evolution) {
  const DensitySupport support(q, sigma);
  const transform::SmoothDensity density =
      density_on_support(q, support, problem.system.left_wall().has_value());
  const auto marginals =
      transform::marginals_at_quadrature_points(density, density.y_max, density.v_max);
  evolution.snapshots.push_back({.time = time,
                                 .density = density,
                                 .moments = transform::physical_moments(problem.frame, marginals)});
  if (evolution.status != Status::ok) return;
  if (!(support.support_edge_to_peak_density_ratio() < kMaxSupportEdgeDensity)) {
    evolution.reason = fmt::format(
        "at t = {:.4g} the density is {:.1e} of its peak on the edge of its support (limit "
        "{:.0e}), {}",
        time, support.support_edge_to_peak_density_ratio(), kMaxSupportEdgeDensity,
        describe_exponent_at_infinity(leading_form(q, sigma), "(x1/sigma1, x2/sigma2)"));
  } else if (!(std::abs(marginals.mass - 1) <= kClosureMassTolerance)) {
    evolution.reason =
        fmt::format("at t = {:.4g} the mass of the density is {:.6f}, not 1", time, marginals.mass);
  }
  if (!evolution.reason.empty()) evolution.status = Status::inadmissible;
}

}  // namespace

ClosureEvolution solve_evolution(const problem::Problem& problem, const ClosureOptions& options,
                                 const EvolutionRequest& request) {
  const base::Deadline deadline(options.max_seconds);
  const StandardDeviations sigma = gaussian_weight_deviations(problem);
  const DensityEquationCoefficients coefficients =
      residual_coefficients(problem, closure_density_equation(options), sigma);
  ClosureOptions with_means = options;
  if (request.start.mean_displacement != 0 || request.start.mean_velocity != 0)
    with_means.monomials = MonomialSet::general;
  const ProjectedEquations projection =
      make_projected_equations(problem, with_means, coefficients, sigma);
  const ClosureCoefficientRates rates(projection, coefficients, request.start);
  ClosureEvolution evolution;
  evolution.quadrature = rates.means().point_counts_text();
  const auto fail = [&](const std::string& reason) {
    evolution.status = Status::not_converged;
    evolution.reason = reason;
  };
  if (const std::string reason = unresolved_formulas_reason(projection); !reason.empty()) {
    fail(reason);
    return evolution;
  }
  const VectorXd start =
      projection.basis().scaled_coefficients(exponent_of_initial_density(request.start));
  if (!rates.rate(start)) {
    fail(
        "the projected equations are singular for the initial density, which is wider than the "
        "Gaussian weights; reduce --start-y and --start-v");
    return evolution;
  }
  const auto store = [](const auto& value, auto target) {
    if (!value) return false;
    target = *value;
    return true;
  };
  numerics::BdfIntegrator integrator(
      {.rate =
           [&](double, const VectorXd& a, Eigen::Ref<VectorXd> rate) {
             return !deadline.has_deadline_passed() && a.allFinite() &&
                    store(rates.rate(a), Eigen::Ref<VectorXd>(rate));
           },
       .jacobian =
           [&](double, const VectorXd& a, Eigen::Ref<MatrixXd> jacobian) {
             return store(rates.jacobian(a), Eigen::Ref<MatrixXd>(jacobian));
           }},
      start,
      {.relative_tolerance = kTimeTolerance,
       .absolute_tolerance = kTimeTolerance,
       .stop_time = request.times.back()});
  for (const double time : request.times) {
    if (time > 0 && !integrator.advance_to_time(time)) {
      fail(deadline.has_deadline_passed()
               ? fmt::format("t = {:.4g} not reached in {:g} s (max_seconds)", time,
                             options.max_seconds)
               : fmt::format("the coefficients of Q_n diverge before t = {:.4g}", time));
      break;
    }
    add_snapshot(problem, projection.basis().exponent_polynomial(integrator.current_state()), sigma,
                 time, evolution);
  }
  evolution.steps = integrator.step_count();
  return evolution;
}

}  // namespace fpkcheck::epc::gaussian
