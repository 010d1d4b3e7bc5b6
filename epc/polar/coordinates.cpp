#include "epc/polar/coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "epc/moment/energy_domain.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::epc::polar {
namespace {

// Least share of the linearised stiffness in K.
constexpr double kLeastShare = 0.1;

// Gauss-Legendre panels on [0, end] between the breaks: points in proportion, and some for the
// ends.
moment::Line panels(double end, const std::vector<double>& breaks, int points) {
  if (breaks.empty()) return moment::legendre_rule(points, 0, end);
  moment::Line all;
  double from = 0;
  const auto add = [&](double to) {
    const int own = static_cast<int>(points * (0.2 + (to - from) / end)) + 2;
    const moment::Line panel = moment::legendre_rule(own, from, to);
    const Eigen::Index before = all.at.size();
    for (auto [whole, part] : {std::pair{&all.at, &panel.at}, {&all.weight, &panel.weight}}) {
      whole->conservativeResize(before + own);
      whole->tail(own) = *part;
    }
    from = to;
  };
  for (const double at : breaks) add(at);
  add(end);
  return all;
}

}  // namespace

Coordinates::Coordinates(const problem::Problem& problem)
    : stiffness_(problem.system.stiffness()),
      cubic_(problem.system.cubic()),
      own_stiffness_(std::max(
          stiffness_, kLeastShare * problem::equivalent_linearisation(problem).stiffness)) {}

double Coordinates::w(double y) const { return y * std::sqrt(own_stiffness_ + cubic_ * y * y / 2); }

double Coordinates::slope(double y) const {
  return (own_stiffness_ + cubic_ * y * y) / std::sqrt(own_stiffness_ + cubic_ * y * y / 2);
}

double Coordinates::y(double w) const {
  // K y^2 + mu y^4 / 2 = w^2, without cancellation
  return w * std::sqrt(2 / (own_stiffness_ +
                            std::sqrt(own_stiffness_ * own_stiffness_ + 2 * cubic_ * w * w)));
}

double Coordinates::rho(double y, double v) const { return std::hypot(w(y), v); }

double Coordinates::theta(double y, double v) const { return std::atan2(v, w(y)); }

double Coordinates::force_by_w(double y) const {
  return (stiffness_ + cubic_ * y * y) / std::sqrt(own_stiffness_ + cubic_ * y * y / 2);
}

Points rule(const Coordinates& coordinates, double rho_max, const std::vector<double>& breaks,
            const QuadratureSize& size) {
  const moment::Line rho = panels(rho_max, breaks, size.rho);
  const moment::Line theta =
      moment::legendre_rule(size.theta, -std::numbers::pi / 2, std::numbers::pi / 2);
  const Eigen::Index count = rho.at.size() * theta.at.size();
  Points points;
  for (auto* column : {&points.rho, &points.theta, &points.y, &points.v, &points.weight}) {
    column->resize(count);
  }
  Eigen::Index t = 0;
  for (Eigen::Index i = 0; i < rho.at.size(); ++i) {
    for (Eigen::Index j = 0; j < theta.at.size(); ++j, ++t) {
      points.rho[t] = rho.at[i];
      points.theta[t] = theta.at[j];
      points.y[t] = coordinates.y(rho.at[i] * std::cos(theta.at[j]));
      points.v[t] = rho.at[i] * std::sin(theta.at[j]);
      // dy dv = dw dv / w'(y) = rho drho dtheta / w'(y)
      points.weight[t] =
          rho.weight[i] * theta.weight[j] * rho.at[i] / coordinates.slope(points.y[t]);
    }
  }
  return points;
}

}  // namespace fpkcheck::epc::polar
