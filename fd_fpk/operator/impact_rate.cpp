#include "fd_fpk/operator/impact_rate.hpp"

#include <array>
#include <cmath>
#include <optional>

#include "fd_fpk/axis/axis_operators.hpp"
#include "fd_fpk/operator/marginals_and_moments.hpp"
#include "fd_fpk/operator/phase_plane_discretisation.hpp"
#include "fd_fpk/operator/wall_test_function.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Gauss-Legendre rule with three points in a cell.
constexpr int kPoints = 3;
const double kOffset = std::sqrt(0.6) / 2;
const std::array<double, kPoints> kFractions{0.5 - kOffset, 0.5, 0.5 + kOffset};
constexpr std::array<double, kPoints> kWeights{5.0 / 18, 8.0 / 18, 5.0 / 18};

double quadrature_node(const GridAxis& axis, int cell, int point) {
  return axis.face_position(cell) + kFractions[point] * axis.cell_width(cell);
}

// Coordinates relative to a wall at `position`: the distance d = sign (x - position) >= 0 and the
// velocity w = sign v away from the wall, with sign = 1 at the left wall and -1 at the right wall.
struct WallCoordinates {
  double position;
  double sign;
  double distance(double x) const { return sign * (x - position); }
  double speed(double v) const { return sign * v; }
};

class ImpactRateTestFunctionBalance {
 public:
  ImpactRateTestFunctionBalance(const problem::System& system,
                                const DiscretisedExcitation& excitation,
                                problem::ImpactCondition impact, const PhasePlaneGrid& grid,
                                int scheme_order)
      : system_(system),
        excitation_(excitation),
        impact_(impact),
        grid_(grid),
        order_(scheme_order),
        of_x1_(point_value_operator(grid.x1, averaging_stencil_size(scheme_order), kFractions)),
        of_x2_(point_value_operator(grid.x2, averaging_stencil_size(scheme_order), kFractions)) {}

  double impact_rate_at_wall(AxisEnd end, const Eigen::VectorXd& cell_averages,
                             const Eigen::VectorXd& change) const {
    const bool left = end == AxisEnd::left;
    const problem::Wall& wall = left ? *system_.left_wall() : *system_.right_wall();
    const WallCoordinates from{wall.position, left ? 1.0 : -1.0};
    const WallTestFunction h(excitation_.diffusion, from.sign * force_minus_drift(wall.position, 0),
                             wall.restitution);
    double balance = integrate_weighted_density(cell_averages, [&](double x, double v) {
      return h.backward_equation_remainder(from.distance(x), from.speed(v),
                                           from.sign * force_minus_drift(x, v));
    });
    Eigen::VectorXd source = -change;
    if (excitation_.exchange.size() > 0) {
      velocity_columns(source).noalias() += excitation_.exchange * velocity_columns(cell_averages);
    }
    balance -= integrate_weighted_density(
        source, [&](double x, double v) { return h(from.distance(x), from.speed(v)); });
    if (const auto& other = left ? system_.right_wall() : system_.left_wall()) {
      balance -=
          mean_gain_at_wall(*other, left ? AxisEnd::right : AxisEnd::left, from, h, cell_averages);
    }
    const double log_of_loss = impact_ == problem::ImpactCondition::map ? std::log(wall.restitution)
                                                                        : wall.restitution - 1;
    return balance / (WallTestFunction::kStepAtWall + log_of_loss);
  }

 private:
  Eigen::Map<const Eigen::MatrixXd> velocity_columns(const Eigen::VectorXd& cell_averages) const {
    return {cell_averages.data(), grid_.v_cell_count(), grid_.nx()};
  }
  Eigen::Map<Eigen::MatrixXd> velocity_columns(Eigen::VectorXd& cell_averages) const {
    return {cell_averages.data(), grid_.v_cell_count(), grid_.nx()};
  }

  double force_minus_drift(double x, double v) const {
    return system_.force(x, v) - excitation_.drift;
  }

  // Returns the integral of `weight` times the density over the phase plane, from cell averages.
  template <class Weight>
  double integrate_weighted_density(const Eigen::VectorXd& cell_averages,
                                    const Weight& weight) const {
    const Eigen::MatrixXd p = of_x2_ * velocity_columns(cell_averages) * of_x1_.transpose();
    double sum = 0;
    for (int i = 0; i < grid_.nx(); ++i) {
      for (int a = 0; a < kPoints; ++a) {
        const double x = quadrature_node(grid_.x1, i, a);
        double of_column = 0;
        for (int j = 0; j < grid_.v_cell_count(); ++j) {
          double of_cell = 0;
          for (int b = 0; b < kPoints; ++b) {
            of_cell += kWeights[b] * p(j * kPoints + b, i * kPoints + a) *
                       weight(x, quadrature_node(grid_.x2, j, b));
          }
          of_column += grid_.x2.cell_width(j) * of_cell;
        }
        sum += grid_.x1.cell_width(i) * kWeights[a] * of_column;
      }
    }
    return sum;
  }

  // Returns the rate of change of the mean E[h] of the test function h by impacts at the second
  // wall.
  double mean_gain_at_wall(const problem::Wall& other, AxisEnd end, const WallCoordinates& from,
                           const WallTestFunction& h, const Eigen::VectorXd& cell_averages) const {
    const int half = grid_.v_cell_count() / 2;
    const AxisOperator to_wall = end_value_operator(grid_.x1, end, order_);
    const Eigen::VectorXd p =
        point_value_operator(grid_.x2, averaging_stencil_size(order_), kFractions, half) *
        (velocity_columns(cell_averages) * to_wall.transpose());
    const double distance = from.distance(other.position), r = other.restitution;
    // Under the impact condition to first order in 1-r, a probability flux f into the wall gives
    // the flux f(w) + (1-r) d(w f)/dw off the wall at the speed w. The integral of the flux off the
    // wall times the test function h is evaluated by integration by parts.
    const auto raise = [&](double u) {
      const double before = h(distance, u);
      return impact_ == problem::ImpactCondition::map
                 ? h(distance, -r * u) - before
                 : h(distance, -u) + (1 - r) * u * h.velocity_derivative(distance, -u) - before;
    };
    const int first = end == AxisEnd::left ? 0 : half;
    double sum = 0;
    for (int j = first; j < first + half; ++j) {
      for (int b = 0; b < kPoints; ++b) {
        const double v = quadrature_node(grid_.x2, j, b);
        sum += grid_.x2.cell_width(j) * kWeights[b] * std::abs(v) * p(j * kPoints + b) *
               raise(from.speed(v));
      }
    }
    return sum;
  }

  const problem::System& system_;
  const DiscretisedExcitation& excitation_;
  problem::ImpactCondition impact_;
  const PhasePlaneGrid& grid_;
  int order_;
  AxisOperator of_x1_, of_x2_;
};

}  // namespace

double impact_rate(const problem::System& system, const DiscretisedExcitation& excitation,
                   problem::ImpactCondition impact, const PhasePlaneGrid& grid,
                   const Eigen::VectorXd& cell_averages, const Eigen::VectorXd& change,
                   int scheme_order) {
  std::optional<ImpactRateTestFunctionBalance> balance;
  const auto of = [&](const std::optional<problem::Wall>& wall, AxisEnd end) {
    if (!wall) return 0.0;
    // The test function of the impact rate requires a state-independent excitation and a constant
    // restitution coefficient.
    const bool has_test_function =
        excitation.is_state_independent() && system.has_constant_restitution();
    if (excitation.diffusion == 0 || !has_dissipative_impacts(*wall) || !has_test_function)
      return wall_speed_moment(grid, cell_averages, scheme_order, 1, end);
    if (!balance) balance.emplace(system, excitation, impact, grid, scheme_order);
    return balance->impact_rate_at_wall(end, cell_averages, change);
  };
  return of(system.left_wall(), AxisEnd::left) + of(system.right_wall(), AxisEnd::right);
}

double flux_into_walls(const problem::System& system, const PhasePlaneGrid& grid,
                       const Eigen::VectorXd& cell_averages, int scheme_order) {
  return (system.left_wall() ? wall_speed_moment(grid, cell_averages, scheme_order, 1) : 0) +
         (system.right_wall()
              ? wall_speed_moment(grid, cell_averages, scheme_order, 1, AxisEnd::right)
              : 0);
}

}  // namespace fpkcheck::fd_fpk
