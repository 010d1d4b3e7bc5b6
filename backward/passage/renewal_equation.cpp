#include "backward/passage/renewal_equation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "base/process/parallel_for.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "numerics/roots/bracketed_root.hpp"

namespace fpkcheck::backward {
namespace {

// Motions end at the weight exp(-kLongestExponent) = 1.5e-8.
constexpr double kLongestExponent = 18;

}  // namespace

// Chebyshev nodes of the first kind on [low, high], increasing, with the weights of the barycentric
// formula (Berrut and Trefethen, SIAM Review 46 (2004) 501, equation 5.3).
ChebyshevPlane::Interpolation::Interpolation(double low, double high, int count)
    : nodes(count), weights(count) {
  for (int k = 0; k < count; ++k) {
    const double angle = std::numbers::pi * (k + 0.5) / count;
    nodes(k) = (low + high) / 2 - (high - low) / 2 * std::cos(angle);
    weights(k) = (k % 2 == 0 ? 1 : -1) * std::sin(angle);
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
      motion_(problem.system, plane.domain().barrier, problem.impulses.law().deviation(),
              refinement),
      longest_(kLongestExponent / slowest_rate) {
  assert(problem.impulses.law().atoms().empty() && !problem.impulse_factor);
  const auto [low, high] = amplitude_range(problem.impulses.law());
  lowest_change_ = low;
  highest_change_ = high;
}

// Returns the velocities at which a functional of the motion from (y, v) is not smooth in v: the
// motions that graze the barrier or the wall.
std::vector<double> RenewalEquation::singular_velocities(double y) const {
  const double fastest = plane_.domain().v_max + std::max(-lowest_change_, highest_change_);
  std::vector<double> velocities{0};  // on the wall the motions from v and from -v / r agree
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

RenewalEquation::VelocityRule RenewalEquation::velocity_rule(double y) const {
  constexpr unsigned kPoints = 10, kSubPoints = 12;
  // Width of the panels in deviations of the impulses
  constexpr double kWidth = 1.5, kLargestSlope = 1.5;  // slope of x^2 (3 - 2 x)
  const problem::ImpulseLaw& law = problem_.impulses.law();
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

  const auto breakpoints = law.density_breakpoints();
  VelocityRule rule;
  std::vector<Eigen::VectorXd> columns;
  const auto reference = numerics::composite_gauss_points<kPoints>(0, 1, 1);
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    // v = a + h phi(x), where phi' vanishes at the ends at which functionals are not smooth.
    const double a = ends[k], h = ends[k + 1] - a;
    const bool first = k == 0, last = k + 2 == ends.size();
    const auto v_at = [&](double x) {
      if (first && last) return a + h * x;
      if (first) return a + h * x * (2 - x);
      return last ? a + h * x * x : a + h * x * x * (3 - 2 * x);
    };
    const auto slope_at = [&](double x) {
      if (first && last) return h;
      if (first) return h * 2 * (1 - x);
      return last ? h * 2 * x : h * 6 * x * (1 - x);
    };
    const int panels = std::max(1, static_cast<int>(std::ceil(kLargestSlope * h * refinement_ /
                                                              (kWidth * law.deviation()))));
    for (int panel = 0; panel < panels; ++panel) {
      const double x0 = static_cast<double>(panel) / panels, width = 1.0 / panels;
      const auto lagrange = [&](std::size_t q, double x) {
        double product = 1;
        for (std::size_t m = 0; m < kPoints; ++m) {
          if (m != q)
            product *= ((x - x0) / width - reference[m].at) / (reference[q].at - reference[m].at);
        }
        return product;
      };
      const std::size_t begin = columns.size();
      for (const auto& [at, weight] : reference) {
        rule.points.push_back(v_at(x0 + width * at));
        columns.emplace_back(Eigen::VectorXd::Zero(plane_.n_v()));
      }
      for (int j = 0; j < plane_.n_v(); ++j) {
        // Ends of the parts of the panel in which the density of the amplitude is smooth
        std::vector<double> parts{x0, x0 + width};
        for (const double amplitude : breakpoints) {
          const double v = plane_.v_node(j) + amplitude;
          if (v > v_at(x0) && v < v_at(x0 + width)) {
            parts.push_back(numerics::bracketed_root([&](double x) { return v_at(x) - v; }, x0,
                                                     x0 + width, 48));
          }
        }
        std::ranges::sort(parts);
        if (parts.size() == 2) {
          for (std::size_t q = 0; q < kPoints; ++q) {
            const double x = x0 + width * reference[q].at;
            columns[begin + q](j) =
                width * reference[q].weight * slope_at(x) * law.density(v_at(x) - plane_.v_node(j));
          }
          continue;
        }
        for (std::size_t part = 0; part + 1 < parts.size(); ++part) {
          for (const auto& [x, weight] :
               numerics::composite_gauss_points<kSubPoints>(parts[part], parts[part + 1], 1)) {
            const double density = weight * slope_at(x) * law.density(v_at(x) - plane_.v_node(j));
            if (density == 0) continue;
            for (std::size_t q = 0; q < kPoints; ++q)
              columns[begin + q](j) += density * lagrange(q, x);
          }
        }
      }
    }
  }
  rule.weights.resize(plane_.n_v(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t q = 0; q < columns.size(); ++q) {
    rule.weights.col(static_cast<Eigen::Index>(q)) = columns[q];
  }
  return rule;
}

// Integrates along a motion. After its end a motion that has not left stays at its last state.
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
