#include "epc/polar/search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "epc/half_plane/metric.hpp"
#include "epc/half_plane/search.hpp"
#include "epc/polar/equations.hpp"
#include "epc/polar/tail.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::epc::polar {
namespace {

using Eigen::VectorXd;
using half_plane::Basis;
using half_plane::Confinement;
using half_plane::Points;
using half_plane::QuadratureSize;
using half_plane::Refinement;
using half_plane::Shape;
using half_plane::Stage;

// The confinement's level is where Q_n lies this far below its peak: what is tried, in this order.
constexpr std::array kDepths{24.0, 18.0, 32.0};
// Where Q_n rises before that: amplitudes in those at which it does, and in deviations of v.
constexpr std::array kBeyondTrusted{1.2, 1.0};
constexpr std::array kLevelDeviations{8.0, 6.5, 11.0};
constexpr double kFarthestDeviations = 30;

double farthest(double temperature) { return kFarthestDeviations * std::sqrt(temperature); }

class Setting : public half_plane::Setting {
 public:
  Setting(const problem::Problem& problem, const Coordinates& coordinates, Tail tail)
      : problem_(problem), coordinates_(coordinates), tail_(tail) {}

  Shape start() const override {
    const double sigma = problem::equivalent_linearisation(problem_).velocity_deviation;
    const double centre = coordinates_.w(problem::static_deflection(problem_));
    const double temperature = sigma * sigma + centre * centre / 2;
    Shape shape{.q = Polynomial({{2, 0, -1 / (2 * temperature)}}), .temperature = temperature};
    shape.trusted = trusted(shape.q, temperature);
    return shape;
  }

  double rate_unit() const override { return half_plane::rate_unit(problem_); }

  std::vector<double> levels(const Shape& guess, Stage) const override {
    const double end = farthest(guess.temperature);
    std::vector<double> levels;
    const auto add = [&](double rho) { levels.push_back(energy_at(rho)); };
    for (const double depth : kDepths) {
      const Fall fall = fall_of(guess.q, depth, end);
      if (fall.reached) add(*fall.reached);
    }
    if (guess.trusted < end) {
      for (const double factor : kBeyondTrusted) add(factor * guess.trusted);
    }
    for (const double deviations : kLevelDeviations) add(deviations * std::sqrt(guess.temperature));
    return levels;
  }

  // The wider the domain, the more points.
  QuadratureSize size(int order, double level_in_temperatures, Stage stage) const override {
    const int least = stage == Stage::rough ? 16 : 20;
    const double width = std::max(1.0, std::sqrt(2 * level_in_temperatures) / kLevelDeviations[0]);
    const int rho = static_cast<int>((least + 2 * order) * width);
    return {rho, least + 2 * order, rho};
  }

  Refinement refinement() const override { return {Refinement::Rule::solved, 1e-5}; }

  Points points(double support, const QuadratureSize& size) const override {
    const double rho_max = amplitude_at(support);
    return rule(coordinates_, rho_max, breaks_of(problem_.impulses.law(), rho_max), size);
  }

  half_plane::Equations equations(double support, const Confinement& confinement, Basis basis,
                                  Points points, const QuadratureSize& size) const override {
    return polar::equations(problem_, coordinates_, amplitude_at(support), confinement,
                            std::move(basis), std::move(points), size.wall);
  }

  double exponent(const Shape& guess, double rho, double theta) const override {
    return polar::exponent(guess, rho, theta);
  }
  double trusted(const Polynomial& q, double temperature) const override {
    return fall_of(q, kDepths.back(), farthest(temperature)).turning;
  }
  // What lies beyond the trusted part counts too, or the fit would be Q_n itself.
  VectorXd fit_weights(const Shape& guess, double support, const Points& points,
                       const VectorXd& exponent, const VectorXd&) const override {
    constexpr double kFlatter = 0.5;
    const double power = amplitude_at(support) > guess.trusted ? kFlatter : 1;
    const VectorXd mass =
        points.weight.array() * (power * (exponent.array() - exponent.maxCoeff())).exp();
    return mass / mass.sum();
  }

  // From the level outwards.
  double remains(const Shape& found, Stage) const override {
    constexpr int kInside = 50, kOutside = 12;
    const Confinement confinement = half_plane::confinement_of(found.level, tail_);
    const double rho = amplitude_at(found.level), end = amplitude_at(found.support);
    double peak = largest_at(found.q, 0), outside = -std::numeric_limits<double>::infinity();
    for (int i = 1; i <= kInside; ++i) {
      peak = std::max(peak, largest_at(found.q, rho * i / kInside));
    }
    for (int i = 0; i <= kOutside; ++i) {
      const double at = rho + (end - rho) * i / kOutside;
      outside = std::max(outside, largest_at(found.q, at) + confinement(energy_at(at)));
    }
    return std::exp(outside - peak);
  }
  double remains_allowed(Stage) const override { return 1e-6; }

 private:
  const problem::Problem& problem_;
  const Coordinates& coordinates_;
  Tail tail_;
};

}  // namespace

half_plane::Root find_root(const problem::Problem& problem, const Coordinates& coordinates,
                           const Options& options) {
  return half_plane::find_root(Setting(problem, coordinates, options.tail), options);
}

double exponent(const Shape& shape, double rho, double theta) {
  const double inside = std::min(rho, shape.trusted);
  return shape.q(inside, theta) - (rho * rho - inside * inside) / (2 * shape.temperature);
}

}  // namespace fpkcheck::epc::polar
