#include "epc/half_plane/transient.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/process/stopwatch.hpp"
#include "numerics/ode/bdf_integrator.hpp"
#include "numerics/roots/fixed_point.hpp"
#include "problem/motion_scales.hpp"

namespace fpkcheck::epc::half_plane {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using transform::Status;

// Returns the tolerance of CVODE for the moments of a closure over time. The basis functions of the
// moments have a variance of about 1. At the tolerance 1e-6 the errors of the moments of order 8
// cause an L1 error of the density of 0.05 (case 1, t = 1). At the tolerance 1e-7 the L1 error of
// the density is 6e-5 at order 8 and up to 7e-4 at order 10.
double time_tolerance(int order) { return order <= 8 ? 1e-7 : 1e-8; }
// Largest accepted distance between the computed moments and the moments of the periodic state, for
// basis functions with a variance of about 1
constexpr double kPeriodicDistance = 1e-5;
// Largest confinement level, as a velocity in standard deviations of v of the stationary density.
// At a confinement level of 9 standard deviations, basis functions of order 8 have values of 1e4 at
// the level, and case 1 needs a tolerance of 1e-10.
constexpr double kLevelDeviations = 6.5;
// Probability above kEdgeOfLevel times the confinement level (an energy) at which a density is
// inadmissible. In case 1 the probability near the confinement level is below 3e-6 for densities
// that do not depend on the level, and at least 2e-5 for densities that depend on the level.
constexpr double kEdgeOfLevel = 0.8, kBeyondEdgeLimit = 1e-5;
// If the initial density has a larger probability above kEdgeOfLevel times the confinement level,
// this level is increased.
constexpr double kStartBeyondEdge = 1e-8;
constexpr double kLevelIncrease = 1.25;
constexpr int kMostIncreases = 12;
// Largest accepted change of the exponent Q_n, and of the rates of change of the moments, when
// quadrature points are added.
constexpr double kQuadratureTolerance = 1e-3;
constexpr int kMostRefinements = 2;

/// Coefficients a(m) of Q_n of the closure density whose basis functions have the means m. The
/// search for the coefficients of given moments starts from the last density that was found.
class CoefficientsFromMoments {
 public:
  struct State {
    VectorXd a;
    VectorXd moments;
    GalerkinSystem::DensityAtPoints density;
  };

  CoefficientsFromMoments(const ClosureEquations& equations, const VectorXd& a)
      : equations_(equations) {
    if (auto state = state_at(a)) last_ = std::move(*state);
  }

  const State& last_state() const { return last_; }
  /// Returns the Cholesky factors of the covariance matrix M of the basis functions under
  /// last_state(); null if M is not numerically positive definite.
  const Eigen::LLT<MatrixXd>* covariance_factors() {
    return factorise_covariance(last_) ? &factors_ : nullptr;
  }

  /// Finds the coefficients of Q_n for given moments m by damped Newton steps, and stores the
  /// density as last_state(). Newton's method keeps the covariance matrix of an earlier density
  /// while each step is at most kFastContraction times as long as the previous step.
  /// @return false if the search finds no density with these moments
  bool find_coefficients(const VectorXd& m) {
    constexpr double kTolerance = 1e-9, kFastContraction = 0.2;
    constexpr int kMostIterations = 60;
    if (last_.a.size() == 0 || !m.allFinite()) return false;
    State state = last_;
    if (factorised_at_.size() == 0 && !factorise_covariance(state)) return false;
    double before = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < kMostIterations; ++iteration) {
      VectorXd step = factors_.solve(m - state.moments);
      double length = length_in_fisher_metric(step, m - state.moments);
      if (!std::isfinite(length)) return false;
      if (length < kTolerance) {
        last_ = std::move(state);
        return true;
      }
      if (length > kFastContraction * before && !is_covariance_factorised(state)) {
        if (!factorise_covariance(state)) return false;
        step = factors_.solve(m - state.moments);
        length = length_in_fisher_metric(step, m - state.moments);
        if (!std::isfinite(length)) return false;
      }
      before = length;
      std::optional<State> next = shortened_step(state, step, length, m);
      if (next) {
        state = std::move(*next);
      } else if (is_covariance_factorised(state)) {
        return false;
      } else {
        before = 0;  // the next iteration computes the covariance matrix
      }
    }
    return false;
  }

 private:
  std::optional<State> state_at(const VectorXd& a) const {
    State state{a, {}, equations_.evaluate_density(a)};
    if (!state.density.finite) return std::nullopt;
    state.moments = equations_.basis_function_means(state.density.mass);
    return state;
  }

  // Returns the length of a step of the coefficients in Fisher's metric, which is the standard
  // deviation of the change of Q_n; NaN if it is not finite.
  static double length_in_fisher_metric(const VectorXd& step, const VectorXd& moment_change) {
    const double square = step.dot(moment_change);
    return square < 0 ? 0 : std::sqrt(square);
  }

  bool is_covariance_factorised(const State& state) const {
    return factorised_at_.size() == state.a.size() && factorised_at_ == state.a;
  }
  bool factorise_covariance(const State& state) {
    if (is_covariance_factorised(state)) return true;
    factors_.compute(equations_.covariance(state.density));
    const bool is_positive_definite = factors_.info() == Eigen::Success;
    factorised_at_ = is_positive_definite ? state.a : VectorXd();
    return is_positive_definite;
  }

  // Returns the state after the longest part of a Newton step, of a length of at most 1 in Fisher's
  // metric, that decreases ln Z(a) - a^T m.
  std::optional<State> shortened_step(const State& from, const VectorXd& step, double length,
                                      const VectorXd& m) const {
    constexpr double kLongestStep = 1, kLeastFraction = 1e-3, kRounding = 1e-12;
    const double before = from.density.log_normalisation - from.a.dot(m);
    const double longest = std::min(1.0, kLongestStep / length);
    for (double fraction = longest; fraction > kLeastFraction * longest; fraction /= 2) {
      std::optional<State> to = state_at(from.a + fraction * step);
      if (!to) continue;
      const double after = to->density.log_normalisation - to->a.dot(m);
      if (after <= before + kRounding * (1 + std::abs(before))) return to;
    }
    return std::nullopt;
  }

  const ClosureEquations& equations_;
  State last_;
  Eigen::LLT<MatrixXd> factors_;
  VectorXd factorised_at_;  // coefficients of the density whose covariance matrix is factorised
};

double probability_above_energy(const QuadraturePoints& points, const VectorXd& mass,
                                double energy) {
  return (points.energy.array() > energy).select(mass, 0).sum();
}

QuadraturePointCounts scale_point_counts(const QuadraturePointCounts& size, double factor) {
  const auto times = [factor](int count) { return static_cast<int>(std::ceil(count * factor)); };
  return {times(size.s), times(size.t), times(size.wall)};
}

class ClosureMomentEvolution {
 public:
  ClosureMomentEvolution(const ClosureFormulation& formulation, const problem::Problem& problem,
                         const ClosureOptions& options, const EvolutionRequest& request)
      : formulation_(formulation),
        problem_(problem),
        options_(options),
        start_(request.start),
        times_(request.times),
        is_periodic_(request.periodic),
        scales_(problem::motion_scales(problem)),
        deadline_(options.max_seconds),
        stationary_(stationary_density()),
        forced_amplitude_(
            problem::forced_motion_extent(problem, {request.times.back(), request.periodic})
                .amplitude) {}

  ClosureEvolution solve_with_refinement(const DensityOfClosure& density_of) {
    // A density narrower than the stationary density needs more quadrature points on the domain of
    // the stationary density.
    const double narrowness =
        std::max({1.0, scales_.displacement_deviation / start_.displacement_deviation,
                  scales_.velocity_deviation / start_.velocity_deviation});
    QuadraturePointCounts size =
        scale_point_counts(formulation_.quadrature_point_counts(
                               options_.order, stationary_level() / stationary_.temperature,
                               ClosureRootSearchStage::last),
                           std::sqrt(narrowness));
    for (int left = kMostRefinements;; --left) {
      ClosureEvolution evolution = integrate_moments(size, density_of, left > 0);
      const bool is_resolved = evolution.quadrature_change < kQuadratureTolerance;
      if (evolution.status != Status::ok || is_resolved) return evolution;
      if (left == 0) {
        evolution.status = Status::not_converged;
        evolution.reason = fmt::format(
            "more quadrature points change Q_n by {:.1e} standard deviations (limit {:.0e}): {} x "
            "{} points do not resolve the density; widen the initial density",
            evolution.quadrature_change, kQuadratureTolerance, size.s, size.t);
        return evolution;
      }
      size = scale_point_counts(size, 1.5);
    }
  }

 private:
  // Returns the density of the stationary closure, or the initial guess if no root was found.
  ClosureDensity stationary_density() const {
    const ClosureRootSearchResult root = find_closure_root(formulation_, options_);
    ClosureDensity density = root.failure.empty() ? root.closure : formulation_.initial_density();
    if (!(density.level > 0)) {
      density.level =
          formulation_.candidate_confinement_energies(density, ClosureRootSearchStage::last)
              .front();
    }
    return density;
  }

  VectorXd exponent_of_initial_density(const QuadraturePoints& points) const {
    const auto squared = [](const VectorXd& x, double mean, double deviation) -> Eigen::ArrayXd {
      return ((x.array() - mean) / deviation).square();
    };
    return -0.5 * (squared(points.y, start_.mean_displacement, start_.displacement_deviation) +
                   squared(points.v, start_.mean_velocity, start_.velocity_deviation));
  }

  VectorXd exponent_of_stationary_density(const QuadraturePoints& points) const {
    return VectorXd::NullaryExpr(points.size(), [&](Index i) {
      return formulation_.exponent_of_initial_guess(stationary_, points.s[i], points.t[i]);
    });
  }

  static VectorXd normalised_mass(const QuadraturePoints& points, const VectorXd& exponent) {
    const VectorXd mass = points.weight.array() * (exponent.array() - exponent.maxCoeff()).exp();
    return mass / mass.sum();
  }

  // Returns the confinement level of the stationary density, extended by the motion under the
  // external force F(t).
  double stationary_level() const {
    const double level = std::min(
        stationary_.level, kLevelDeviations * kLevelDeviations / 2 * stationary_.temperature);
    const double speed = std::sqrt(2 * level) + forced_amplitude_;
    return speed * speed / 2;
  }

  // Returns stationary_level(), or a larger confinement level that contains the initial density.
  double level_containing_start(const QuadraturePointCounts& size) const {
    double level = stationary_level();
    for (int k = 0; k < kMostIncreases; ++k) {
      const QuadraturePoints points =
          formulation_.quadrature_points_below_energy(support_energy(level, options_.tail), size);
      const double beyond = probability_above_energy(
          points, normalised_mass(points, exponent_of_initial_density(points)),
          kEdgeOfLevel * level);
      if (beyond < kStartBeyondEdge) break;
      level *= kLevelIncrease;
    }
    return level;
  }

  ClosureEquations make_equations(OrthonormalBasis basis, double level,
                                  const QuadraturePointCounts& size,
                                  QuadraturePoints points) const {
    return formulation_.closure_equations(support_energy(level, options_.tail),
                                          make_exponent_confinement(level, options_.tail),
                                          std::move(basis), std::move(points), size);
  }

  // Returns the integrator of the moment equations in time. The coefficients hold the last density.
  numerics::BdfIntegrator moment_integrator(const ClosureEquations& equations,
                                            CoefficientsFromMoments& coefficients,
                                            const VectorXd& start) const {
    // Even an accurate integrator without step limit may step over a short pulse of the excitation.
    constexpr double kLongestStep = 1e-2;
    const double tolerance = time_tolerance(options_.order);
    std::optional<double> max_step;
    if (problem_.time.is_acting()) max_step = kLongestStep * times_.back();
    return {
        {.rate =
             [&](double t, const VectorXd& m, Eigen::Ref<VectorXd> rate) {
               if (deadline_.has_deadline_passed() || !coefficients.find_coefficients(m))
                 return false;
               rate = equations.residual(coefficients.last_state().density, t);
               return true;
             },
         .jacobian =
             [&](double t, const VectorXd& m, Eigen::Ref<MatrixXd> jacobian) {
               if (!coefficients.find_coefficients(m)) return false;
               const auto* const covariance = coefficients.covariance_factors();
               if (covariance == nullptr) return false;
               jacobian =
                   covariance
                       ->solve(equations.jacobian(coefficients.last_state().density, t).transpose())
                       .transpose();
               return true;
             }},
        start,
        {.relative_tolerance = tolerance,
         .absolute_tolerance = tolerance,
         .max_step = max_step,
         .stop_time = times_.back()}};
  }

  // Replaces the argument `moments` by the moments of the periodic state. If the search for the
  // periodic state fails, the function sets the status and returns false.
  bool find_periodic_state(const ClosureEquations& equations, CoefficientsFromMoments& coefficients,
                           VectorXd& moments, ClosureEvolution& evolution) const {
    // In one period the slowest mode loses the fraction decayed_fraction() of its distance to the
    // periodic state; this loss is the change per period.
    const double tolerance = kPeriodicDistance * problem::decayed_fraction(scales_, times_.back());
    const numerics::FixedPointResult found = numerics::solve_fixed_point(
        [&](const VectorXd& from) -> std::optional<VectorXd> {
          if (deadline_.has_deadline_passed() || !coefficients.find_coefficients(from))
            return std::nullopt;
          numerics::BdfIntegrator integrator = moment_integrator(equations, coefficients, from);
          const bool is_reached = integrator.advance_to_time(times_.back());
          evolution.steps += integrator.step_count();
          return is_reached ? std::optional(integrator.current_state()) : std::nullopt;
        },
        moments,
        {.size = [](const VectorXd& change) { return change.lpNorm<Eigen::Infinity>(); },
         .tolerance = tolerance});
    moments = found.x;
    if (found.converged && coefficients.find_coefficients(moments)) return true;
    evolution.status = Status::not_converged;
    evolution.reason =
        deadline_.has_deadline_passed()
            ? fmt::format("no periodic state in {:g} s (max_seconds)", options_.max_seconds)
            : fmt::format(
                  "no periodic state after {} periods: the moments change by {:.1e} per period "
                  "(limit {:.0e}); use fd or mcs, or give several periods as --until",
                  found.evaluations, found.change, tolerance);
    return false;
  }

  // Integrates the moments and stores the density at each output time.
  // @param stops_if_unresolved whether the integration stops before the first output if more
  //   quadrature points change the initial density by more than the tolerance
  ClosureEvolution integrate_moments(const QuadraturePointCounts& size,
                                     const DensityOfClosure& density_of,
                                     bool stops_if_unresolved) const {
    ClosureEvolution evolution;
    evolution.quadrature = fmt::format("{} x {}", size.s, size.t);
    const double level = level_containing_start(size);
    const double support = support_energy(level, options_.tail);
    QuadraturePoints points = formulation_.quadrature_points_below_energy(support, size);
    const VectorXd exponent = exponent_of_initial_density(points);
    const VectorXd start_mass = normalised_mass(points, exponent);
    // The basis functions are nearly orthonormal under the initial and stationary densities.
    const VectorXd mixture =
        0.5 * (start_mass + normalised_mass(points, exponent_of_stationary_density(points)));
    const ClosureEquations equations =
        make_equations(OrthonormalBasis(options_.order, points, mixture), level, size, points);
    const QuadraturePointCounts finer = scale_point_counts(size, 1.5);
    const ClosureEquations fine_equations =
        make_equations(equations.basis(), level, finer,
                       formulation_.quadrature_points_below_energy(support, finer));
    // As weight of the fit, a power below 1 of the density increases the influence of the tail.
    constexpr double kFlatter = 1.0 / 3;
    CoefficientsFromMoments coefficients(
        equations, equations.fit_exponent_coefficients(
                       exponent, normalised_mass(points, kFlatter * exponent)));
    const VectorXd start_moments = equations.basis_function_means(start_mass);
    if (!coefficients.find_coefficients(start_moments)) {
      evolution.status = Status::not_converged;
      evolution.reason =
          "no closure has the moments of the initial density; choose one closer to the stationary "
          "density";
      return evolution;
    }
    VectorXd moments_at_start = start_moments;
    if (is_periodic_ &&
        !find_periodic_state(equations, coefficients, moments_at_start, evolution)) {
      return evolution;
    }
    numerics::BdfIntegrator integrator =
        moment_integrator(equations, coefficients, moments_at_start);
    double& change = evolution.quadrature_change;
    for (const double time : times_) {
      if ((time > 0 && !integrator.advance_to_time(time)) ||
          !coefficients.find_coefficients(integrator.current_state())) {
        evolution.status = Status::not_converged;
        const double last = evolution.snapshots.empty() ? 0 : evolution.snapshots.back().time;
        evolution.reason =
            deadline_.has_deadline_passed()
                ? fmt::format("t = {:.4g} not reached in {:g} s (max_seconds)", time,
                              options_.max_seconds)
                : fmt::format(
                      "no closure has the moments after t = {:.4g}: they approach the moments of a "
                      "singular density",
                      last);
        break;
      }
      const CoefficientsFromMoments::State& state = coefficients.last_state();
      const double change_of_snapshot =
          change_on_finer_points(equations, fine_equations, coefficients, time);
      if (!(change_of_snapshot <= change)) change = change_of_snapshot;
      if (stops_if_unresolved && !(change < kQuadratureTolerance)) return evolution;
      evolution.snapshots.push_back(
          {.time = time,
           .density = density_of(make_closure_density(equations, state.a, level, options_.tail)),
           .moments = physical_moments(equations.points(), state.density.mass)});
      const double beyond =
          probability_above_energy(equations.points(), state.density.mass, kEdgeOfLevel * level);
      if (beyond > kBeyondEdgeLimit && evolution.status == Status::ok) {
        evolution.status = Status::inadmissible;
        evolution.reason = fmt::format(
            "at t = {:.4g} a probability of {:.1e} lies beyond {} of the confinement "
            "level (limit {:.0e}): the confinement determines the density",
            time, beyond, kEdgeOfLevel, kBeyondEdgeLimit);
      }
    }
    evolution.steps += integrator.step_count();
    return evolution;
  }

  // Returns the changes, when quadrature points are added, of the exponent Q_n in standard
  // deviations and of the rates of the moments in units of the rate of change.
  double change_on_finer_points(const ClosureEquations& equations,
                                const ClosureEquations& fine_equations,
                                CoefficientsFromMoments& coefficients, double t) const {
    const CoefficientsFromMoments::State& state = coefficients.last_state();
    const auto fine = fine_equations.evaluate_density(state.a);
    const auto* const covariance = coefficients.covariance_factors();
    if (!fine.finite || covariance == nullptr) return std::numeric_limits<double>::infinity();
    const auto norm = [&](const VectorXd& difference) {
      return covariance->matrixL().solve(difference).norm();
    };
    const double of_moments = norm(fine_equations.basis_function_means(fine.mass) - state.moments);
    const double of_rates =
        norm(fine_equations.residual(fine, t) - equations.residual(state.density, t));
    return std::max(of_moments, of_rates / scales_.frequency);
  }

  transform::Moments physical_moments(const QuadraturePoints& points, const VectorXd& mass) const {
    const auto mean = [&](const VectorXd& x, int power) {
      return mass.dot(x.array().pow(power).matrix());
    };
    const VectorXd y = points.y.unaryExpr([&](double x) { return problem_.frame.physical_y(x); });
    const VectorXd v =
        points.v.unaryExpr([&](double x) { return problem_.frame.physical_velocity(x); });
    return {.y1 = mean(y, 1),
            .y2 = mean(y, 2),
            .y4 = mean(y, 4),
            .v1 = mean(v, 1),
            .v2 = mean(v, 2),
            .v4 = mean(v, 4)};
  }

  const ClosureFormulation& formulation_;
  const problem::Problem& problem_;
  const ClosureOptions& options_;
  problem::InitialGaussian start_;
  std::vector<double> times_;
  bool is_periodic_;
  problem::MotionScales scales_;
  base::Deadline deadline_;
  ClosureDensity stationary_;
  double forced_amplitude_;
};

}  // namespace

ClosureEvolution solve_evolution(const ClosureFormulation& formulation,
                                 const problem::Problem& problem, const ClosureOptions& options,
                                 const EvolutionRequest& request,
                                 const DensityOfClosure& density_of) {
  return ClosureMomentEvolution(formulation, problem, options, request)
      .solve_with_refinement(density_of);
}

}  // namespace fpkcheck::epc::half_plane
