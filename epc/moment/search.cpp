#include "epc/moment/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "epc/moment/first_decayed.hpp"
#include "epc/moment/homotopy.hpp"
#include "epc/moment/tail.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::epc::moment {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// The level in deviations of v, if the density fell like exp(-h/T) with T = E[v^2]: what is tried,
// in this order.
constexpr std::array kLevelDeviations{6.5, 5.2, 8.0};
// Where Q_n falls by this much without ever rising, the level lies there, and it does not matter.
constexpr double kWholeDepth = 42;
constexpr double kFarthestDeviations = 16;
// Largest density at the level, relative to the peak, that needs no other level on the way.
constexpr double kLevelAllowed = 1e-2;
constexpr double kRoughTolerance = 1e-4;
constexpr double kQuadratureTolerance = 1e-9;
constexpr int kMostRefinements = 4;
constexpr double kFurther = 1.05;  // of a level, to be worth another solve

// Enough for a start of the next order.
QuadratureSize rough_quadrature(int order) {
  return {16 + 2 * order, 20 + 2 * order, 20 + 2 * order};
}
// A first try; the wider the domain, the more points, though not in proportion: the farther out the
// level, the less is there.
QuadratureSize quadrature(int order, double level_in_temperatures) {
  const double deviations = std::sqrt(2 * level_in_temperatures);
  const double width = std::pow(deviations / kLevelDeviations[0], 0.75);
  const int y = static_cast<int>((24 + 2 * order) * width);
  const int v = static_cast<int>((32 + 2 * order) * width);
  return {y, v, v};
}
// More than twice as many in all.
QuadratureSize refined(const QuadratureSize& size) {
  return {size.y * 3 / 2, size.v * 3 / 2, size.wall * 3 / 2};
}

double level_of(const Shape& shape, double deviations) {
  return shape.temperature * deviations * deviations / 2;
}

std::vector<double> usual_levels(const Shape& shape) {
  std::vector<double> levels;
  for (const double deviations : kLevelDeviations) levels.push_back(level_of(shape, deviations));
  return levels;
}

// The Gaussian to start from.
Shape linearised(const problem::Problem& problem) {
  const auto linear = problem::equivalent_linearisation(problem);
  const double s1 = linear.displacement_deviation, s2 = linear.velocity_deviation;
  const double centre = problem::static_deflection(problem);
  return {.q = Polynomial(
              {{1, 0, centre / (s1 * s1)}, {2, 0, -1 / (2 * s1 * s1)}, {0, 2, -1 / (2 * s2 * s2)}}),
          .temperature = s2 * s2};
}

class Search {
 public:
  Search(const problem::Problem& problem, const SearchOptions& options)
      : problem_(problem), options_(options) {}

  Root run() {
    Shape guess = linearised(problem_);
    for (int n = 2; n <= options_.order; n += 2) {
      if (n == options_.order && n > 2) root_.previous = guess;
      if (!advance(guess, n)) return root_;
      // At strong impact losses the linearised deviations are far too large.
      if (n == 2 && !advance(guess, n)) return root_;
    }
    finish(guess);
    return root_;
  }

 private:
  // Equations and where to start from.
  struct Start {
    Equations equations;
    VectorXd a;
  };

  EnergyDomain domain_of(double level) const {
    return {problem_, options_.tail == Tail::confined ? level * Confinement::reach() : level};
  }
  Confinement confinement_of(double level) const {
    return options_.tail == Tail::confined ? Confinement{level} : Confinement{};
  }
  Equations equations_of(const Basis& basis, double level, const QuadratureSize& size) const {
    return {problem_, options_.rate_moment, domain_of(level), confinement_of(level), basis, size};
  }

  // The equations of order n in a basis made for the guess, and the guess in it.
  Start start_of(const Shape& guess, int n, double level, const QuadratureSize& size) const {
    const EnergyDomain domain = domain_of(level);
    const Confinement confinement = confinement_of(level);
    const Points points = domain.rule(size.y, size.v);
    VectorXd exponent(points.y.size()), mass(points.y.size());
    for (Eigen::Index i = 0; i < exponent.size(); ++i) {
      exponent[i] = guess.q(points.y[i], points.v[i]);
      mass[i] = exponent[i] + confinement(domain.energy(points.y[i], points.v[i]));
    }
    mass = points.weight.array() * (mass.array() - mass.maxCoeff()).exp();
    mass /= mass.sum();
    Equations equations = equations_of(Basis(n, points, mass), level, size);
    VectorXd a = equations.fit(exponent, mass);
    return {std::move(equations), std::move(a)};
  }

  // Newton's method, and where it is lost the homotopy before it.
  NewtonResult solve(const Start& start, const NewtonOptions& newton_options) {
    const double unit = rate_unit(problem_);
    NewtonResult result = newton(start.equations, start.a, unit, newton_options);
    iterations_ += result.iterations;
    if (result.converged) return result;
    const HomotopyResult rescue = follow_homotopy(start.equations, start.a);
    ++root_.homotopies;
    iterations_ += rescue.steps;
    if (rescue.reached == 1) {
      result = newton(start.equations, rescue.a, unit, newton_options);
      iterations_ += result.iterations;
    }
    if (!result.converged) {
      root_.newton = result;
      root_.newton.iterations = iterations_;
      root_.failure = fmt::format(
          "Newton's method was lost at order {} after {} iterations (least residual {:.1e}), and a "
          "homotopy {}",
          start.equations.basis().order(), result.iterations, result.residual,
          rescue.reached == 1
              ? std::string("led to no root")
              : fmt::format("got {:.0f} % of the way", 100 * std::max(0.0, rescue.reached)));
    }
    return result;
  }

  Shape shape_of(const Equations& equations, const VectorXd& a, const Equations::Density& density,
                 double level) const {
    const auto& [y, v, weight] = equations.points();
    Shape shape{.q = equations.basis().polynomial(a),
                .temperature = density.mass.dot(v.cwiseAbs2()),
                .level = level,
                .support = domain_of(level).level()};
    // The constant of Q_n differs between the basis and the monomials.
    const double constant =
        shape.q(y[0], v[0]) - equations.basis().values(y.head(1), v.head(1)).row(0).dot(a);
    shape.log_normalisation = density.log_normalisation + constant;
    shape.peak = density.peak + constant;
    return shape;
  }

  // Order n from the guess, well enough to start the next, in its place: by the first level at
  // which the density has decayed, else by that at which it has most.
  bool advance(Shape& guess, int n) {
    const auto attempt = [&](double level) -> std::optional<std::pair<Shape, double>> {
      const Start start = start_of(guess, n, level, rough_quadrature(n));
      const NewtonResult result =
          solve(start, {.tolerance = kRoughTolerance, .max_iterations = options_.max_iterations});
      if (!result.converged) return std::nullopt;
      const Shape found =
          shape_of(start.equations, result.a, start.equations.density(result.a), level);
      return std::pair{found, std::exp(largest_on_contour(found.q, problem_, level) - found.peak)};
    };
    const auto best = first_decayed<Shape>(usual_levels(guess), kLevelAllowed, attempt);
    if (best) guess = *best;
    return best.has_value();
  }

  // The order asked for, to the tolerance: the level as far out as Q_n falls, else the first at
  // which the density has decayed at the edge.
  void finish(const Shape& guess) {
    const double farthest = level_of(guess, kFarthestDeviations);
    std::vector<double> levels = usual_levels(guess);
    const Fall fall = fall_of(guess.q, problem_, levels.front(), farthest, kWholeDepth);
    if (fall.reached) levels.insert(levels.begin(), *fall.reached);
    const auto attempt = [&](double level) -> std::optional<std::pair<Root, double>> {
      if (!refine(guess, level)) return std::nullopt;
      // What the rough guess still hid.
      const Root rooted = root_;
      const Fall now = fall_of(rooted.shape.q, problem_, level, farthest, kWholeDepth);
      if (now.reached && *now.reached > kFurther * level && !refine(rooted.shape, *now.reached)) {
        root_ = rooted;
      }
      return std::pair{root_, root_.edge_density};
    };
    if (const auto best = first_decayed<Root>(levels, options_.edge_allowed, attempt)) {
      root_ = *best;
      root_.newton.iterations = iterations_;
    }
  }

  // The answer at a level, on as many points as it takes.
  bool refine(const Shape& guess, double level) {
    QuadratureSize size = quadrature(options_.order, level / guess.temperature);
    Start start = start_of(guess, options_.order, level, size);
    for (int i = 0;; ++i) {
      const NewtonResult result = solve(start, {.tolerance = options_.tolerance,
                                                .max_iterations = options_.max_iterations,
                                                .polish = true});
      if (!result.converged) return false;
      const QuadratureSize finer = refined(size);
      Equations fine = equations_of(start.equations.basis(), level, finer);
      accept(start.equations, fine, result, level);
      root_.quadrature = size;
      if (root_.quadrature_change < kQuadratureTolerance || i == kMostRefinements) return true;
      start = {std::move(fine), result.a};
      size = finer;
    }
  }

  void accept(const Equations& equations, const Equations& fine, const NewtonResult& result,
              double level) {
    root_.newton = result;
    root_.newton.iterations = iterations_;
    root_.failure.clear();
    const auto density = equations.density(result.a);
    root_.shape = shape_of(equations, result.a, density, level);
    const Shape& shape = root_.shape;
    root_.edge_density = std::exp(largest_on_contour(shape.q, problem_, shape.support) -
                                  shape.peak + confinement_of(level)(shape.support));
    const MatrixXd jacobian = equations.jacobian(density);
    const MatrixXd covariance = equations.covariance(density);
    // On more points, is it still a root?
    const VectorXd step = jacobian.partialPivLu().solve(fine.residual(fine.density(result.a)));
    root_.quadrature_change = length(step, covariance);
    root_.condition = condition_of(jacobian, covariance);
  }

  const problem::Problem& problem_;
  const SearchOptions& options_;
  Root root_;
  int iterations_ = 0;
};

}  // namespace

Root find_root(const problem::Problem& problem, const SearchOptions& options) {
  return Search(problem, options).run();
}

}  // namespace fpkcheck::epc::moment
