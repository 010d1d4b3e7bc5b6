#include "epc/half_plane/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "epc/half_plane/first_decayed.hpp"
#include "epc/half_plane/metric.hpp"
#include "epc/half_plane/newton.hpp"
#include "numerics/linear_algebra/dense.hpp"

namespace fpkcheck::epc::half_plane {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using numerics::NewtonOptions;
using numerics::NewtonResult;

constexpr double kRoughTolerance = 1e-4;
constexpr int kMostRefinements = 4;
constexpr double kEver = 1e9;  // seconds; the clock can represent this duration

// More than twice the number of points.
QuadratureSize refined(const QuadratureSize& size) {
  return {size.s * 3 / 2, size.t * 3 / 2, size.wall * 3 / 2};
}

class Search {
 public:
  Search(const Setting& setting, const Options& options)
      : setting_(setting),
        options_(options),
        unit_(setting.rate_unit()),
        end_(std::chrono::steady_clock::now() +
             std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                 std::chrono::duration<double>(std::min(options.max_seconds, kEver)))) {}

  Root run() {
    climb();
    root_.newton.iterations = iterations_;
    root_.homotopies = homotopies_;
    return std::move(root_);
  }

 private:
  // Equations and initial coefficients.
  struct Start {
    Equations equations;
    VectorXd a;
  };

  void climb() {
    Shape guess = setting_.start();
    const int first = setting_.first_order(options_.order);
    for (int n = first; n <= options_.order; n += 2) {
      if (n == options_.order && n > first) root_.previous = guess;
      std::optional<Shape> next = advanced(guess, n);
      if (!next && n > first && setting_.any_order_can_start()) {
        next = advanced(setting_.start(), n);
      }
      // Under strong impact losses equivalent linearisation overestimates the deviations.
      if (next && n == 2) next = advanced(*next, n);
      if (!next) return;
      guess = *next;
    }
    finish(guess);
  }

  // Whether the deadline has passed. If so, the reason of failure is recorded once.
  bool late() {
    if (std::chrono::steady_clock::now() < end_) return false;
    if (std::exchange(late_, true)) return true;
    root_.failure = fmt::format("no root was found in {:g} s (max_seconds){}", options_.max_seconds,
                                root_.failure.empty() ? "" : "; last failure: " + root_.failure);
    return true;
  }

  // Candidates for the confinement level: those of the formulation, then the level of the guess. At
  // its own level the guess is a start without a fit. At another level a Q_n that rises may have
  // all its mass on the edge.
  std::vector<double> levels(const Shape& guess, Stage stage) const {
    std::vector<double> levels = setting_.levels(guess, stage);
    if (guess.level > 0) levels.push_back(guess.level);
    return levels;
  }

  // Solves order n from the guess, accurately enough to start the next order.
  std::optional<Shape> advanced(const Shape& guess, int n) {
    const auto attempt = [&](double level) -> std::optional<std::pair<Shape, double>> {
      if (late()) return std::nullopt;
      const Start start = start_of(guess, n, level, first_size(guess, n, level, Stage::rough));
      const NewtonResult result = solve(start, Stage::rough);
      if (!result.converged) return std::nullopt;
      const Shape found = shape_of(start.equations, result.a, level);
      return std::pair{found, setting_.remains(found, Stage::rough)};
    };
    return first_decayed<Shape>(levels(guess, Stage::rough), setting_.remains_allowed(Stage::rough),
                                attempt);
  }

  // Solves the requested order to the tolerance.
  void finish(const Shape& guess) {
    const auto attempt = [&](double level) -> std::optional<std::pair<Root, double>> {
      if (late() || !refine(guess, level)) return std::nullopt;
      // The accurate root may allow a better level than the guess did.
      const Root rooted = root_;
      const auto further = setting_.further(guess, rooted.shape);
      if (further && !refine(rooted.shape, *further)) root_ = rooted;
      return std::pair{root_, root_.remains};
    };
    const auto best = first_decayed<Root>(levels(guess, Stage::last),
                                          setting_.remains_allowed(Stage::last), attempt);
    if (best) root_ = *best;
  }

  // Solves the requested order at a level, on more points until the quadrature error is small.
  bool refine(const Shape& guess, double level) {
    const Refinement refinement = setting_.refinement();
    const bool estimated = refinement.rule == Refinement::Rule::estimated;
    QuadratureSize size = first_size(guess, options_.order, level, Stage::last);
    Start at = start_of(guess, options_.order, level, size);
    NewtonResult result = solve(at, Stage::last);
    for (int left = kMostRefinements; result.converged; --left) {
      const QuadratureSize finer = refined(size);
      Start fine{equations_of(at.equations.basis(), level, finer), result.a};
      if (estimated) {
        const double change = change_on(fine.equations, at.equations, result.a);
        if (change < refinement.tolerance || left == 0) {
          return accept(at.equations, result, level, size, change);
        }
      }
      result = solve(fine, Stage::last);
      if (!estimated && result.converged) {
        const double change = length(result.a - fine.a, metric_of(fine.equations, result.a));
        if (change < refinement.tolerance || left == 1) {
          return accept(fine.equations, result, level, finer, change);
        }
      }
      at = std::move(fine);
      size = finer;
    }
    return false;
  }

  QuadratureSize first_size(const Shape& guess, int n, double level, Stage stage) const {
    return setting_.size(n, level / guess.temperature, stage);
  }

  Equations equations_of(const Basis& basis, double level, const QuadratureSize& size) const {
    const double support = support_of(level, options_.tail);
    return setting_.equations(support, confinement_of(level, options_.tail), basis,
                              setting_.points(support, size), size);
  }

  // Equations of order n in a basis orthonormal under the guess, with the fit of the guess.
  Start start_of(const Shape& guess, int n, double level, const QuadratureSize& size) const {
    const double support = support_of(level, options_.tail);
    const Confinement confinement = confinement_of(level, options_.tail);
    const Points points = setting_.points(support, size);
    VectorXd exponent(points.size()), mass(points.size());
    for (Index i = 0; i < points.size(); ++i) {
      exponent[i] = level == guess.level ? guess.q(points.s[i], points.t[i])
                                         : setting_.exponent(guess, points.s[i], points.t[i]);
      mass[i] = exponent[i] + confinement(points.energy[i]);
    }
    mass = points.weight.array() * (mass.array() - mass.maxCoeff()).exp();
    mass /= mass.sum();
    Equations equations =
        setting_.equations(support, confinement, Basis(n, points, mass), points, size);
    VectorXd a =
        equations.fit(exponent, setting_.fit_weights(guess, support, points, exponent, mass));
    return {std::move(equations), std::move(a)};
  }

  NewtonOptions newton_options(Stage stage) const {
    const bool last = stage == Stage::last;
    return {.tolerance = last ? options_.tolerance : kRoughTolerance,
            .max_iterations = options_.max_iterations,
            .polish = last};
  }

  // Newton's method. If that fails: a homotopy, then Newton's method from its end.
  NewtonResult solve(const Start& start, Stage stage) {
    const NewtonOptions options = newton_options(stage);
    NewtonResult result = newton(start.equations, start.a, unit_, options);
    iterations_ += result.iterations;
    if (result.converged) return result;
    const numerics::Curve rescue = follow_homotopy(
        start.equations, start.a, [this] { return std::chrono::steady_clock::now() >= end_; });
    const bool arrived = rescue.end == numerics::CurveEnd::arrived;
    ++homotopies_;
    iterations_ += rescue.iterations;
    if (arrived) {
      result = newton(start.equations, rescue.points.back().a, unit_, options);
      iterations_ += result.iterations;
    }
    if (!result.converged) {
      root_.newton = result;
      root_.failure = fmt::format(
          "Newton's method failed at order {} after {} iterations (least residual {:.1e}): a "
          "homotopy {}",
          start.equations.basis().order(), result.iterations, result.residual,
          arrived ? std::string("led to no root")
                  : fmt::format("ended at {:.0f} % of its path", 100 * rescue.furthest().t));
    }
    return result;
  }

  Shape shape_of(const Equations& equations, const VectorXd& a, double level) const {
    const Galerkin::Density density = equations.density(a);
    const Points& points = equations.points();
    Shape shape{.q = equations.basis().polynomial(a),
                .temperature = density.mass.dot(points.v.cwiseAbs2()),
                .level = level,
                .support = support_of(level, options_.tail)};
    // The constant term of Q_n differs between the basis and the monomials.
    const double constant =
        shape.q(points.s[0], points.t[0]) -
        equations.basis().values(points.s.head(1), points.t.head(1)).row(0).dot(a);
    shape.log_normalisation = density.log_normalisation + constant;
    shape.peak = density.peak + constant;
    shape.trusted = setting_.trusted(shape.q, shape.temperature);
    return shape;
  }

  static Eigen::MatrixXd metric_of(const Equations& equations, const VectorXd& a) {
    return equations.covariance(equations.density(a));
  }

  // Norm of the Newton step on more points, from a root on fewer points.
  static double change_on(const Equations& fine, const Equations& coarse, const VectorXd& a) {
    const Galerkin::Density density = coarse.density(a);
    const numerics::Factors factors(coarse.jacobian(density));
    const VectorXd step = factors.solve(fine.residual(fine.density(a)));
    return length(step, coarse.covariance(density));
  }

  bool accept(const Equations& equations, const NewtonResult& result, double level,
              const QuadratureSize& size, double quadrature_change) {
    const Galerkin::Density density = equations.density(result.a);
    root_.newton = result;
    root_.failure.clear();
    root_.shape = shape_of(equations, result.a, level);
    root_.remains = setting_.remains(root_.shape, Stage::last);
    root_.quadrature = size;
    root_.quadrature_change = quadrature_change;
    root_.condition = condition_of(equations.jacobian(density), equations.covariance(density));
    return true;
  }

  const Setting& setting_;
  const Options& options_;
  double unit_;
  std::chrono::steady_clock::time_point end_;
  Root root_;
  int iterations_ = 0, homotopies_ = 0;
  bool late_ = false;
};

}  // namespace

double support_of(double level, Tail tail) {
  return tail == Tail::confined ? level * Confinement::reach() : level;
}

Confinement confinement_of(double level, Tail tail) {
  return tail == Tail::confined ? Confinement{level} : Confinement{};
}

Root find_root(const Setting& setting, const Options& options) {
  return Search(setting, options).run();
}

}  // namespace fpkcheck::epc::half_plane
