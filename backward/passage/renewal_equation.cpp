#include "backward/passage/renewal_equation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "base/process/parallel_for.hpp"
#include "numerics/interpolation.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "numerics/roots/bracketed_root.hpp"

namespace fpkcheck::backward {
namespace {

// Motions end at the weight exp(-kLongestExponent) = 1.5e-8.
constexpr double kLongestExponent = 18;

}  // namespace

// The barycentric weights of Chebyshev points are those of Berrut and Trefethen, SIAM Review 46
// (2004) 501, equation 5.3.
ChebyshevPlane::Interpolation::Interpolation(double low, double high, int count)
    : nodes(count), weights(count) {
  const std::vector<double> points = numerics::chebyshev_points(count);
  for (int k = 0; k < count; ++k) {
    nodes(k) = low + (high - low) * points[static_cast<std::size_t>(k)];
    weights(k) = (k % 2 == 0 ? 1 : -1) * std::sin(std::numbers::pi * (k + 0.5) / count);
  }
}

void ChebyshevPlane::Interpolation::lagrange_values(double x,
                                                    Eigen::Ref<Eigen::VectorXd> values) const {
  for (Eigen::Index k = 0; k < nodes.size(); ++k) {
    if (x == nodes(k)) {
      values.setZero();
      values(k) = 1;
      return;
    }
  }
  values = weights.array() / (x - nodes.array());
  values /= values.sum();
}

ChebyshevPlane::ChebyshevPlane(const Domain& domain, int n_y, int n_v)
    : domain_(domain),
      y_(0, std::sqrt(domain.barrier - domain.y_low), n_y),
      v_(-domain.v_max, domain.v_max, n_v) {
  assert(domain.y_low < domain.barrier && domain.v_max > 0 && n_y > 0 && n_v > 0);
}

void ChebyshevPlane::in_y(double y, Eigen::Ref<Eigen::VectorXd> values) const {
  const double inside = std::clamp(y, domain_.y_low, domain_.barrier);
  y_.lagrange_values(std::sqrt(domain_.barrier - inside), values);
}

void ChebyshevPlane::in_v(double v, Eigen::Ref<Eigen::VectorXd> values) const {
  v_.lagrange_values(std::clamp(v, -domain_.v_max, domain_.v_max), values);
}

std::array<double, 2> amplitude_range(const problem::ImpulseLaw& law) {
  constexpr double kOutside = 5e-10;
  const std::vector<double> breakpoints = law.density_breakpoints();
  const double low = breakpoints.front(), high = breakpoints.back();
  const auto quantile = [&](double probability) {
    const auto excess = [&](double y) { return law.cumulative_probability(y) - probability; };
    if (excess(low) >= 0) return low;
    if (excess(high) <= 0) return high;
    return numerics::bracketed_root(excess, low, high, 20);
  };
  return {quantile(kOutside), quantile(1 - kOutside)};
}

RenewalEquation::RenewalEquation(const problem::Problem& problem, const ChebyshevPlane& plane,
                                 double slowest_rate, double refinement)
    : problem_(problem),
      plane_(plane),
      refinement_(refinement),
      motion_(problem.system, plane.domain().barrier, problem.impulses.amplitude_law().deviation(),
              refinement),
      longest_(kLongestExponent / slowest_rate) {
  assert(problem.impulses.amplitude_law().atoms().empty() && !problem.impulse_factor);
  const auto [low, high] = amplitude_range(problem.impulses.amplitude_law());
  lowest_change_ = low;
  highest_change_ = high;
}

// Returns the velocities at which a functional of the motion from (y, v) is not smooth in v: the
// motions that graze the barrier or the wall.
std::vector<double> RenewalEquation::singular_velocities(double y) const {
  const double fastest = plane_.domain().v_max + std::max(-lowest_change_, highest_change_);
  std::vector<double> velocities{0};  // T(0, -u) = T(0, r u) at a wall has a kink at u = 0
  const auto add_grazing = [&](double at) {
    for (const double v : motion_.velocities_before({at, 0}, y, longest_, fastest)) {
      velocities.push_back(v);
    }
  };
  if (motion_.acceleration({plane_.domain().barrier, 0}) < 0) add_grazing(plane_.domain().barrier);
  const auto& wall = problem_.system.left_wall();
  if (wall && motion_.acceleration({wall->position, 0}) > 0) add_grazing(wall->position);
  return velocities;
}

namespace {

// Map of x in [0, 1] to an interval of velocities. Its slope vanishes at the ends at which
// functionals are not smooth.
struct VelocityMap {
  double begin, length;
  bool is_smooth_at_begin, is_smooth_at_end;

  double velocity(double x) const {
    if (is_smooth_at_begin && is_smooth_at_end) return begin + length * x;
    if (is_smooth_at_begin) return begin + length * x * (2 - x);
    if (is_smooth_at_end) return begin + length * x * x;
    return begin + length * x * x * (3 - 2 * x);
  }
  double slope(double x) const {
    if (is_smooth_at_begin && is_smooth_at_end) return length;
    if (is_smooth_at_begin) return length * 2 * (1 - x);
    if (is_smooth_at_end) return length * 2 * x;
    return length * 6 * x * (1 - x);
  }
};

// Returns the ends of the parts of [low, high] in which the density of the amplitude is smooth, for
// impulses from the velocity v.
std::vector<double> smooth_parts(const VelocityMap& map, double low, double high, double v,
                                 const std::vector<double>& density_breakpoints) {
  std::vector<double> ends{low, high};
  for (const double amplitude : density_breakpoints) {
    const double after = v + amplitude;
    if (after <= map.velocity(low) || after >= map.velocity(high)) continue;
    ends.push_back(
        numerics::bracketed_root([&](double x) { return map.velocity(x) - after; }, low, high, 48));
  }
  std::ranges::sort(ends);
  return ends;
}

}  // namespace

RenewalEquation::VelocityRule RenewalEquation::velocity_rule(double y) const {
  constexpr unsigned kPoints = 10, kSubPoints = 12;
  // Width of the panels in deviations of the impulses
  constexpr double kWidth = 1.5, kLargestSlope = 1.5;  // slope of x^2 (3 - 2 x)
  const problem::ImpulseLaw& law = problem_.impulses.amplitude_law();
  const double v_max = plane_.domain().v_max;
  const double low = -v_max + lowest_change_, high = v_max + highest_change_;
  std::vector<double> ends{low, high};
  for (const double v : singular_velocities(y)) {
    if (v > low && v < high) ends.push_back(v);
  }
  std::ranges::sort(ends);
  const double negligible = 1e-9 * law.deviation();
  // Clang 14 does not compile std::ranges::unique() of GCC 12's library.
  ends.erase(
      std::unique(ends.begin(), ends.end(), [&](double a, double b) { return b - a < negligible; }),
      ends.end());

  const std::vector<double> breakpoints = law.density_breakpoints();
  VelocityRule rule;
  std::vector<Eigen::MatrixXd> panel_weights;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const VelocityMap map{.begin = ends[k],
                          .length = ends[k + 1] - ends[k],
                          .is_smooth_at_begin = k == 0,
                          .is_smooth_at_end = k + 2 == ends.size()};
    const int panels =
        std::max(1, static_cast<int>(std::ceil(kLargestSlope * map.length * refinement_ /
                                               (kWidth * law.deviation()))));
    for (int panel = 0; panel < panels; ++panel) {
      const double begin = static_cast<double>(panel) / panels;
      const double end = static_cast<double>(panel + 1) / panels;
      const auto points = numerics::composite_gauss_points<kPoints>(begin, end, 1);
      std::vector<double> nodes;
      for (const auto& point : points) nodes.push_back(point.at);
      for (const double x : nodes) rule.points.push_back(map.velocity(x));
      Eigen::MatrixXd& weights =
          panel_weights.emplace_back(Eigen::MatrixXd::Zero(plane_.n_v(), kPoints));
      for (int j = 0; j < plane_.n_v(); ++j) {
        const double v = plane_.v_node(j);
        const auto density = [&](double x) {
          return map.slope(x) * law.density(map.velocity(x) - v);
        };
        const std::vector<double> parts = smooth_parts(map, begin, end, v, breakpoints);
        if (parts.size() == 2) {
          for (std::size_t q = 0; q < kPoints; ++q) {
            weights(j, static_cast<Eigen::Index>(q)) = points[q].weight * density(nodes[q]);
          }
          continue;
        }
        const numerics::QuadratureRule rule_of_parts =
            numerics::composite_gauss_rule<kSubPoints>(parts);
        for (Eigen::Index m = 0; m < rule_of_parts.size(); ++m) {
          const double x = rule_of_parts.points[static_cast<std::size_t>(m)];
          const std::vector<double> lagrange = numerics::lagrange_weights(nodes, x);
          weights.row(j) += rule_of_parts.weights(m) * density(x) *
                            Eigen::Map<const Eigen::RowVectorXd>(lagrange.data(), kPoints);
        }
      }
    }
  }
  rule.weights.resize(plane_.n_v(), static_cast<Eigen::Index>(rule.points.size()));
  for (std::size_t panel = 0; panel < panel_weights.size(); ++panel) {
    rule.weights.middleCols(static_cast<Eigen::Index>(panel * kPoints), kPoints) =
        panel_weights[panel];
  }
  return rule;
}

// Integrates along a motion. After its end a motion below the barrier stays at its last state.
// @param of_function shape (n_y, n_v weights.size()): side by side, a matrix for each weight
void RenewalEquation::integrate(const Motion& motion, const std::vector<TimeWeight>& weights,
                                Eigen::Ref<Eigen::MatrixXd> of_function,
                                Eigen::Ref<Eigen::VectorXd> of_one) const {
  const auto count =
      static_cast<Eigen::Index>(motion.nodes.size() + (motion.passed_barrier ? 0 : 1));
  const Eigen::Index n_v = plane_.n_v();
  const auto kinds = static_cast<Eigen::Index>(weights.size());
  Eigen::MatrixXd in_y(plane_.n_y(), count), in_v(n_v * kinds, count);
  of_one.setZero();
  Eigen::VectorXd values(n_v);
  for (Eigen::Index n = 0; n < count; ++n) {
    const bool is_end = n == static_cast<Eigen::Index>(motion.nodes.size());
    const PhaseState& at = is_end ? motion.end : motion.nodes[static_cast<std::size_t>(n)].at;
    plane_.in_y(at.y, in_y.col(n));
    plane_.in_v(at.v, values);
    for (Eigen::Index k = 0; k < kinds; ++k) {
      const auto& [rate, power] = weights[static_cast<std::size_t>(k)];
      double weight = 0;
      if (is_end) {
        const double t = motion.duration;
        weight = std::exp(-rate * t) / rate * (power == 0 ? 1 : t + 1 / rate);
      } else {
        const TimeNode& node = motion.nodes[static_cast<std::size_t>(n)];
        weight = node.weight * std::exp(-rate * node.time) * (power == 0 ? 1 : node.time);
      }
      in_v.col(n).segment(k * n_v, n_v) = weight * values;
      of_one(k) += weight;
    }
  }
  of_function.noalias() = in_y * in_v.transpose();
}

std::vector<RenewalEquation::Operator> RenewalEquation::operators(
    const std::vector<TimeWeight>& weights, const base::Deadline& deadline) const {
  const auto kinds = static_cast<Eigen::Index>(weights.size());
  const Eigen::Index n_v = plane_.n_v(), size = plane_.size();
  std::vector<Operator> operators(weights.size());
  for (Operator& one : operators) {
    one.of_function.resize(size, size);
    one.of_one.resize(size);
  }
  base::parallel_for(
      static_cast<std::size_t>(plane_.n_y()), base::kOneThreadPerProcessor, [&](std::size_t node) {
        const int i = static_cast<int>(node);
        const double y = plane_.y_node(i);
        const VelocityRule rule = velocity_rule(y);
        const auto points = static_cast<Eigen::Index>(rule.points.size());
        // Integrals along the motions: a row for each velocity, and the weights side by side
        Eigen::MatrixXd integrals(points, kinds * size), of_one(points, kinds);
        Eigen::MatrixXd along(plane_.n_y(), kinds * n_v);
        Eigen::VectorXd one(kinds);
        for (Eigen::Index q = 0; q < points && !deadline.has_passed(); ++q) {
          integrate(motion_.follow({y, rule.points[static_cast<std::size_t>(q)]}, longest_),
                    weights, along, one);
          of_one.row(q) = one;
          for (Eigen::Index k = 0; k < kinds; ++k) {
            for (int m = 0; m < plane_.n_y(); ++m) {
              integrals.row(q).segment(k * size + plane_.index(m, 0), n_v) =
                  along.row(m).segment(k * n_v, n_v);
            }
          }
        }
        for (Eigen::Index k = 0; k < kinds; ++k) {
          Operator& target = operators[static_cast<std::size_t>(k)];
          target.of_function.middleRows(plane_.index(i, 0), n_v).noalias() =
              rule.weights * integrals.middleCols(k * size, size);
          target.of_one.segment(plane_.index(i, 0), n_v).noalias() = rule.weights * of_one.col(k);
        }
      });
  if (deadline.has_passed()) return {};
  return operators;
}

RenewalEquation::Functional RenewalEquation::from_state(const PhaseState& from,
                                                        const TimeWeight& weight) const {
  // Row-major: the order of ChebyshevPlane::index()
  Eigen::MatrixXd along(plane_.n_y(), plane_.n_v());
  Eigen::VectorXd one(1);
  integrate(motion_.follow(from, longest_), {weight}, along, one);
  return {along.transpose().reshaped(), one(0)};
}

}  // namespace fpkcheck::backward
