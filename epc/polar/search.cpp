#include "epc/polar/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "epc/moment/first_decayed.hpp"
#include "epc/moment/homotopy.hpp"
#include "epc/polar/tail.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::epc::polar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using moment::Confinement;

// The confinement's level is where Q_n lies this far below its peak: what is tried, in this order.
constexpr std::array kDepths{24.0, 18.0, 32.0};
// Where Q_n rises before that: amplitudes in those at which it does, and in deviations of v.
constexpr std::array kBeyondTrusted{1.2, 1.0};
constexpr std::array kLevelDeviations{8.0, 6.5, 11.0};
constexpr double kFarthestDeviations = 30;
constexpr double kFlatter = 0.5;
// Largest density at the level, relative to the peak, that needs no other level.
constexpr double kLevelAllowed = 1e-6;
constexpr double kRoughTolerance = 1e-4;
constexpr double kQuadratureTolerance = 1e-5;
constexpr int kMostRefinements = 4;

// Enough for a start of the next order; the wider the domain, the more points.
QuadratureSize quadrature(int order, double deviations, int least) {
  const double width = std::max(1.0, deviations / kLevelDeviations[0]);
  return {static_cast<int>((least + 2 * order) * width), least + 2 * order};
}
QuadratureSize refined(const QuadratureSize& size) {
  return {size.rho * 3 / 2, size.theta * 3 / 2};
}

// A density to start from: exp(Q_n) as far as it falls, a Gaussian beyond.
struct Guess {
  Guess(Polynomial exponent, double mean_square_velocity)
      : q(std::move(exponent)),
        temperature(mean_square_velocity),
        trusted(fall_of(q, kDepths.back(), farthest()).turning) {}

  double farthest() const { return kFarthestDeviations * std::sqrt(temperature); }
  double operator()(double rho, double theta) const {
    const double inside = std::min(rho, trusted);
    return q(inside, theta) - (rho * rho - inside * inside) / (2 * temperature);
  }

  Polynomial q;
  double temperature;  // E[v^2]
  double trusted;      // amplitude from which Q_n rises again
};

Guess linearised(const problem::Problem& problem, const Coordinates& coordinates) {
  const double sigma = problem::equivalent_linearisation(problem).velocity_deviation;
  const double centre = coordinates.w(problem::static_deflection(problem));
  const double temperature = sigma * sigma + centre * centre / 2;
  return {Polynomial({{2, 0, -1 / (2 * temperature)}}), temperature};
}

// Energies where the confinement may begin.
std::vector<double> levels_of(const Guess& guess) {
  std::vector<double> amplitudes;
  for (const double depth : kDepths) {
    const Fall fall = fall_of(guess.q, depth, guess.farthest());
    if (fall.reached) amplitudes.push_back(*fall.reached);
  }
  if (guess.trusted < guess.farthest()) {
    for (const double factor : kBeyondTrusted) amplitudes.push_back(factor * guess.trusted);
  }
  for (const double deviations : kLevelDeviations) {
    amplitudes.push_back(deviations * std::sqrt(guess.temperature));
  }
  std::vector<double> levels;
  for (const double rho : amplitudes) levels.push_back(rho * rho / 2);
  return levels;
}

class Search {
 public:
  Search(const problem::Problem& problem, const Coordinates& coordinates,
         const SearchOptions& options)
      : problem_(problem), coordinates_(coordinates), options_(options) {}

  Root run() {
    Guess guess = linearised(problem_, coordinates_);
    bool solved = true;
    for (int n = 2; solved && n <= options_.order; n += 2) {
      if (n == options_.order && n > 2) root_.previous = guess;
      solved = advance(guess, n);
      // At strong impact losses the linearised deviations are far too large.
      if (n == 2) solved = solved && advance(guess, n);
    }
    if (solved) finish(guess);
    root_.newton.iterations = iterations_;
    return root_;
  }

 private:
  // Order n, well enough to start the next: the first level at which the density has decayed, else
  // the one at which it has most.
  bool advance(Guess& guess, int n) {
    constexpr int kLeastPoints = 16;
    const auto attempt = [&](double level) -> std::optional<std::pair<Guess, double>> {
      const Equations equations = equations_of(guess, n, level, kLeastPoints);
      const auto result = solve(guess, equations, level, kRoughTolerance, false);
      if (!result) return std::nullopt;
      const Guess found = guess_of(equations, result->a);
      return std::pair{found, level_density(found.q, level)};
    };
    const auto best = moment::first_decayed<Guess>(levels_of(guess), kLevelAllowed, attempt);
    if (best) guess = *best;
    return best.has_value();
  }

  // The order asked for, to the tolerance, likewise.
  void finish(const Guess& start) {
    constexpr int kLeastPoints = 20;
    const auto attempt = [&](double level) -> std::optional<std::pair<Root, double>> {
      if (!refine(start, level, equations_of(start, options_.order, level, kLeastPoints))) {
        return std::nullopt;
      }
      return std::pair{root_, root_.level_density};
    };
    const auto best = moment::first_decayed<Root>(levels_of(start), kLevelAllowed, attempt);
    if (!best) return;
    const int homotopies = root_.homotopies;
    root_ = *best;
    root_.homotopies = homotopies;
  }

  // The answer at a level, on as many points as it takes.
  bool refine(const Guess& start, double level, Equations equations) {
    auto result = solve(start, equations, level, options_.tolerance, true);
    for (int i = 0; result && i < kMostRefinements; ++i) {
      const Equations fine(problem_, coordinates_, reach(level), Confinement{level},
                           equations.basis(), refined(size_));
      size_ = refined(size_);
      const auto next = newton(fine, result->a, options_.tolerance, true);
      if (!next.converged) return fail(next, options_.order);
      const VectorXd change = next.a - result->a;
      equations = fine;
      result = next;
      root_.quadrature_change = moment::length(change, fine.covariance(fine.density(next.a)));
      if (root_.quadrature_change < kQuadratureTolerance) break;
    }
    if (result) accept(equations, *result, level);
    return result.has_value();
  }

  static double reach(double level) { return std::sqrt(2 * level * Confinement::reach()); }

  // The largest density from the level outwards, relative to the peak.
  static double level_density(const Polynomial& q, double level) {
    constexpr int kInside = 50, kOutside = 12;
    const double rho = std::sqrt(2 * level);
    double peak = largest_at(q, 0), outside = -std::numeric_limits<double>::infinity();
    for (int i = 1; i <= kInside; ++i) peak = std::max(peak, largest_at(q, rho * i / kInside));
    for (int i = 0; i <= kOutside; ++i) {
      const double at = rho + (reach(level) - rho) * i / kOutside;
      outside = std::max(outside, largest_at(q, at) + confined(Confinement{level}, at));
    }
    return std::exp(outside - peak);
  }

  // In a basis that belongs to the guess.
  Equations equations_of(const Guess& guess, int n, double level, int least_points) {
    size_ = quadrature(n, std::sqrt(2 * level / guess.temperature), least_points);
    const Confinement confinement{level};
    const Points points =
        rule(coordinates_, reach(level), breaks_of(problem_.impulses.law(), reach(level)), size_);
    VectorXd mass(points.rho.size());
    for (Index i = 0; i < mass.size(); ++i) {
      mass[i] = guess(points.rho[i], points.theta[i]) + confined(confinement, points.rho[i]);
    }
    mass = points.weight.array() * (mass.array() - mass.maxCoeff()).exp();
    mass /= mass.sum();
    return {problem_, coordinates_, reach(level), confinement, basis_of(n, points, mass), size_};
  }

  VectorXd fit(const Guess& guess, const Equations& equations, double level) const {
    const auto& points = equations.points();
    VectorXd exponent(points.rho.size());
    for (Index i = 0; i < exponent.size(); ++i) {
      exponent[i] = guess(points.rho[i], points.theta[i]);
    }
    // What lies beyond the trusted part counts too, or the fit would be Q_n itself.
    const double power = reach(level) > guess.trusted ? kFlatter : 1;
    VectorXd mass =
        points.weight.array() * (power * (exponent.array() - exponent.maxCoeff())).exp();
    return equations.fit(exponent, mass / mass.sum());
  }

  moment::NewtonResult newton(const Equations& equations, const VectorXd& start, double tolerance,
                              bool polish) {
    const moment::NewtonResult result = moment::newton(
        equations, start, moment::rate_unit(problem_),
        {.tolerance = tolerance, .max_iterations = options_.max_iterations, .polish = polish});
    iterations_ += result.iterations;
    return result;
  }

  std::optional<moment::NewtonResult> solve(const Guess& guess, const Equations& equations,
                                            double level, double tolerance, bool polish) {
    const VectorXd start = fit(guess, equations, level);
    moment::NewtonResult result = newton(equations, start, tolerance, polish);
    if (!result.converged) {
      const moment::HomotopyResult rescue = moment::follow_homotopy(equations, start);
      ++root_.homotopies;
      iterations_ += rescue.steps;
      if (rescue.reached == 1) result = newton(equations, rescue.a, tolerance, polish);
    }
    if (!result.converged) {
      fail(result, equations.basis().order());
      return std::nullopt;
    }
    return result;
  }

  bool fail(const moment::NewtonResult& result, int order) {
    root_.newton = result;
    root_.failure = fmt::format(
        "Newton's method was lost at order {} after {} iterations (least residual {:.1e})", order,
        result.iterations, result.residual);
    return false;
  }

  Guess guess_of(const Equations& equations, const VectorXd& a) const {
    const auto density = equations.density(a);
    return {equations.basis().polynomial(a), density.mass.dot(equations.points().v.cwiseAbs2())};
  }

  void accept(const Equations& equations, const moment::NewtonResult& result, double level) {
    const auto density = equations.density(result.a);
    const Guess found = guess_of(equations, result.a);
    root_.newton = result;
    root_.failure.clear();
    root_.q = found.q;
    root_.temperature = found.temperature;
    root_.level = level;
    root_.level_density = level_density(found.q, level);
    root_.support = reach(level);
    root_.quadrature = size_;
    // The constant of Q_n differs between the basis and the monomials.
    const auto& points = equations.points();
    const double constant =
        found.q(points.rho[0], points.theta[0]) -
        equations.basis().values(points.rho.head(1), points.theta.head(1)).row(0).dot(result.a);
    root_.log_normalisation = density.log_normalisation + constant;
    root_.peak = density.peak + constant;
    root_.condition =
        moment::condition_of(equations.jacobian(density), equations.covariance(density));
  }

  const problem::Problem& problem_;
  const Coordinates& coordinates_;
  const SearchOptions& options_;
  QuadratureSize size_{};
  Root root_;
  int iterations_ = 0;
};

}  // namespace

Root find_root(const problem::Problem& problem, const Coordinates& coordinates,
               const SearchOptions& options) {
  return Search(problem, coordinates, options).run();
}

}  // namespace fpkcheck::epc::polar
