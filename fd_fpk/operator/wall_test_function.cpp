#include "fd_fpk/operator/wall_test_function.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace fpkcheck::fd_fpk {
namespace {

// Table of the functions phi, phi', theta and chi' of WallTestFunction at equidistant values of s,
// with cubic Hermite interpolation. The ordinary differential equations of phi and chi give the
// derivatives for the Hermite interpolation. The interpolation error, step^4 / 384 times a fourth
// derivative, is below 1e-10.
class WallTestFunctionTable {
 public:
  static const WallTestFunctionTable& table() {
    static const WallTestFunctionTable profiles;
    return profiles;
  }

  double phi(double s) const {
    if (std::abs(s) > kEnd) return asymptotics_.phi(s) + (s < 0 ? limit_below_.phi : 0);
    return interpolate(s, &Node::phi, [](double, const Node& n) { return n.phi_slope; });
  }
  double phi_slope(double s) const {
    if (std::abs(s) > kEnd) return asymptotics_.phi_slope(s);
    return interpolate(s, &Node::phi_slope, phi_curvature);
  }
  double theta(double s) const {
    if (std::abs(s) > kEnd) return asymptotics_.theta(s);
    return interpolate(s, &Node::theta, theta_slope);
  }
  double chi_slope(double s) const {
    if (std::abs(s) > kEnd) return asymptotics_.chi_slope(s) + (s < 0 ? limit_below_.chi_slope : 0);
    return interpolate(s, &Node::chi_slope, chi_curvature);
  }
  /// Returns the limit of the derivative chi'(s) for s -> -inf.
  double chi_slope_limit_below() const { return limit_below_.chi_slope; }

 private:
  static constexpr double kEnd = 14, kStep = 0.02;
  static constexpr std::size_t kLast = 1400;  // number of table intervals, 2 kEnd / kStep

  struct Node {
    double phi = 0, phi_slope = 0, theta = 0, chi_slope = 0;
  };
  static double phi_curvature(double s, const Node& n) { return s * (s * n.phi_slope - 1) / 3; }
  static double theta_slope(double s, const Node& n) { return s * (s * n.theta / 3 - n.phi_slope); }
  static double chi_curvature(double s, const Node& n) { return n.phi_slope - s * n.theta / 3; }
  static Node derivatives(double s, const Node& n) {
    return {n.phi_slope, phi_curvature(s, n), theta_slope(s, n), chi_curvature(s, n)};
  }
  static Node add_scaled(const Node& n, double h, const Node& d) {
    return {n.phi + h * d.phi, n.phi_slope + h * d.phi_slope, n.theta + h * d.theta,
            n.chi_slope + h * d.chi_slope};
  }

  // Asymptotic series for large |s| in powers of s^-3: phi' = sum a_n s^(-1-3n), theta = sum t_n
  // s^(-2-3n). The ordinary differential equations give recursions for the coefficients a_n and
  // t_n. At |s| = kEnd the truncation error of the asymptotic series is below 1e-11.
  class AsymptoticSeries {
   public:
    AsymptoticSeries() {
      a_[0] = 1;
      t_[0] = 3;
      for (int n = 0; n + 1 < kTerms; ++n) {
        a_[n + 1] = -3 * (3 * n + 1) * a_[n];
        t_[n + 1] = 3 * a_[n + 1] - 3 * (3 * n + 2) * t_[n];
      }
    }
    double phi(double s) const {
      return std::log(std::abs(s)) + series(s, 1, [&](int n) { return -a_[n] / (3 * n); });
    }
    double phi_slope(double s) const {
      return series(s, 0, [&](int n) { return a_[n]; }) / s;
    }
    double theta(double s) const {
      return series(s, 0, [&](int n) { return t_[n]; }) / (s * s);
    }
    double chi_slope(double s) const {
      return series(s, 1, [&](int n) { return (a_[n] - t_[n] / 3) / (-3 * n); });
    }

   private:
    static constexpr int kTerms = 6;
    template <class Coefficient>
    static double series(double s, int first, const Coefficient& coefficient) {
      const double x = 1 / (s * s * s);
      double sum = 0;
      for (int n = kTerms - 1; n >= first; --n) sum = sum * x + coefficient(n);
      return first == 0 ? sum : sum * x;
    }
    std::array<double, kTerms> a_{}, t_{};
  };

  static double node(std::size_t k) { return -kEnd + kStep * static_cast<double>(k); }

  template <class Slope>
  double interpolate(double s, double Node::*value, const Slope& slope) const {
    const double steps = (s + kEnd) / kStep;
    const auto k = static_cast<std::size_t>(std::clamp(std::floor(steps), 0.0, kLast - 1.0));
    const double x = steps - static_cast<double>(k), y = 1 - x;
    const Node &left = nodes_[k], &right = nodes_[k + 1];
    return y * y * ((1 + 2 * x) * left.*value + x * kStep * slope(node(k), left)) +
           x * x * ((1 + 2 * y) * right.*value - y * kStep * slope(node(k + 1), right));
  }

  WallTestFunctionTable() : nodes_(kLast + 1) {
    nodes_[kLast] = {asymptotics_.phi(kEnd), asymptotics_.phi_slope(kEnd), asymptotics_.theta(kEnd),
                     asymptotics_.chi_slope(kEnd)};
    // The Runge-Kutta steps decrease s, because homogeneous solutions decay with decreasing s.
    constexpr int kParts = 4;
    constexpr double h = -kStep / kParts;
    for (std::size_t k = kLast; k > 0; --k) {
      Node n = nodes_[k];
      for (int part = 0; part < kParts; ++part) {
        const double s = node(k) + part * h;
        const Node k1 = derivatives(s, n);
        const Node k2 = derivatives(s + h / 2, add_scaled(n, h / 2, k1));
        const Node k3 = derivatives(s + h / 2, add_scaled(n, h / 2, k2));
        const Node k4 = derivatives(s + h, add_scaled(n, h, k3));
        for (const auto& [weight, d] : {std::pair(1, k1), {2, k2}, {2, k3}, {1, k4}}) {
          n = add_scaled(n, weight * h / 6, d);
        }
      }
      nodes_[k - 1] = n;
    }
    limit_below_.phi = nodes_[0].phi - asymptotics_.phi(-kEnd);
    limit_below_.chi_slope = nodes_[0].chi_slope - asymptotics_.chi_slope(-kEnd);
  }

  AsymptoticSeries asymptotics_;
  std::vector<Node> nodes_;
  Node limit_below_;  ///< limits of phi, phi', theta and chi' for s -> -inf
};

}  // namespace

WallTestFunction::WallTestFunction(double diffusion, double force, double restitution)
    : diffusion_(diffusion),
      force_(force),
      v_coefficient_(-WallTestFunctionTable::table().chi_slope_limit_below() / (1 + restitution)) {}

double WallTestFunction::velocity_scale(double y) const { return std::cbrt(diffusion_ * y); }

double WallTestFunction::operator()(double y, double v) const {
  assert(y > 0);
  const auto& table = WallTestFunctionTable::table();
  const double l = velocity_scale(y), s = v / l;
  const double chi = table.theta(s) + s * (table.chi_slope(s) + v_coefficient_);
  return std::log(y) / 3 + table.phi(s) + force_ / diffusion_ * l * chi;
}

double WallTestFunction::velocity_derivative(double y, double v) const {
  const auto& table = WallTestFunctionTable::table();
  const double l = velocity_scale(y), s = v / l;
  return table.phi_slope(s) / l + force_ / diffusion_ * (table.chi_slope(s) + v_coefficient_);
}

double WallTestFunction::backward_equation_remainder(double y, double v, double force) const {
  const auto& table = WallTestFunctionTable::table();
  const double l = velocity_scale(y), s = v / l;
  return (force - force_) * table.phi_slope(s) / l +
         force * force_ / diffusion_ * (table.chi_slope(s) + v_coefficient_);
}

}  // namespace fpkcheck::fd_fpk
