#include "backward/passage/stationary_crossings.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "base/process/parallel_for.hpp"
#include "numerics/chebyshev_interpolation.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "numerics/roots/bracketed_root.hpp"

namespace fpkcheck::backward {
namespace {

using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Interpolation nodes in panels of velocities
class VelocityInterpolationNodes {
 public:
  explicit VelocityInterpolationNodes(std::vector<VelocityQuadraturePanel> panels)
      : panels_(std::move(panels)) {}

  Eigen::Index size() const {
    return static_cast<Eigen::Index>(panels_.size() * VelocityQuadraturePanel::kPoints);
  }
  std::vector<double> velocities() const {
    std::vector<double> all;
    for (const VelocityQuadraturePanel& panel : panels_) {
      for (const double x : panel.nodes) all.push_back(panel.map.value(x));
    }
    return all;
  }
  // Adds weight g(v), where g is the interpolated function, to a linear form of the values of g at
  // the nodes. Velocities outside the panels are moved to the nearest end of the panels.
  void add_value(double v, double weight, Eigen::Ref<Eigen::RowVectorXd> form) const {
    const auto above = std::ranges::find_if(panels_, [v](const VelocityQuadraturePanel& panel) {
      return v < panel.map.value(panel.end);
    });
    const auto panel = above == panels_.end() ? above - 1 : above;
    double x = v <= panel->map.value(panel->begin) ? panel->begin : panel->end;
    if (v > panel->map.value(panel->begin) && v < panel->map.value(panel->end)) {
      x = numerics::bracketed_root([&](double at) { return panel->map.value(at) - v; },
                                   panel->begin, panel->end);
    }
    const std::vector<double> lagrange = numerics::lagrange_weights(panel->nodes, x);
    const auto first =
        static_cast<Eigen::Index>((panel - panels_.begin()) * VelocityQuadraturePanel::kPoints);
    for (std::size_t k = 0; k < lagrange.size(); ++k) {
      form(first + static_cast<Eigen::Index>(k)) += weight * lagrange[k];
    }
  }

 private:
  std::vector<VelocityQuadraturePanel> panels_;
};

// Returns the Gauss rule of displacements for functions that are not smooth at the barrier and at
// the turning points of the trajectory that grazes the barrier. On both sides of these
// displacements the functions are smooth in the square root of the distance.
numerics::QuadratureRule make_displacement_rule(const ChebyshevGrid& grid, double barrier,
                                                std::vector<double> turning_points) {
  constexpr unsigned kPointsPerPanel = 10;
  constexpr double kPanelsPerNode = 0.4;
  const auto& [y_low, y_high, v_max, ends_at_barrier] = grid.phase_plane_domain();
  std::vector<double> ends{y_low, barrier, y_high};
  for (const double y : turning_points) {
    if (y > y_low && y < y_high) ends.push_back(y);
  }
  std::ranges::sort(ends);
  numerics::QuadratureRule rule;
  std::vector<double> weights;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const IntervalMap map{ends[k], ends[k + 1] - ends[k], k == 0, k + 2 == ends.size()};
    const double share = map.length / (y_high - y_low);
    const int panels = static_cast<int>(std::ceil(kPanelsPerNode * grid.y_node_count() * share));
    for (const auto& [at, weight] :
         numerics::composite_gauss_points<kPointsPerPanel>(0, 1, panels)) {
      rule.points.push_back(map.value(at));
      weights.push_back(weight * map.slope(at));
    }
  }
  rule.weights =
      Eigen::Map<const Eigen::VectorXd>(weights.data(), static_cast<Eigen::Index>(weights.size()));
  return rule;
}

// Returns the values at the nodes of a grid of the projections of functions to polynomials in y.
// The projection is orthogonal in L2 on the domain of the grid.
// @param rule quadrature rule of displacements
// @param values values of one function in each column, at the velocity nodes for the first
// displacement, then at those for the next one
Eigen::MatrixXd project_to_nodes(const ChebyshevGrid& grid, const numerics::QuadratureRule& rule,
                                 const Eigen::MatrixXd& values) {
  const Eigen::VectorXd root = rule.weights.cwiseSqrt();
  Eigen::MatrixXd polynomials(rule.size(), grid.y_node_count());
  Eigen::VectorXd at_y(grid.y_node_count());
  for (Eigen::Index l = 0; l < rule.size(); ++l) {
    grid.evaluate_y_polynomials(rule.points[static_cast<std::size_t>(l)], at_y);
    polynomials.row(l) = root(l) * at_y;
  }
  const Eigen::MatrixXd projection =
      polynomials.householderQr().solve(Eigen::MatrixXd(root.asDiagonal()));
  const Eigen::Index n_v = grid.v_node_count();
  Eigen::MatrixXd projected = Eigen::MatrixXd::Zero(grid.node_count(), values.cols());
  for (int i = 0; i < grid.y_node_count(); ++i) {
    for (Eigen::Index l = 0; l < rule.size(); ++l) {
      projected.middleRows(grid.node_index(i, 0), n_v) +=
          projection(i, l) * values.middleRows(l * n_v, n_v);
    }
  }
  return projected;
}

}  // namespace

std::optional<StationaryCrossings> compute_stationary_crossings(const problem::Problem& problem,
                                                                const ChebyshevGrid& grid,
                                                                double barrier,
                                                                double panel_refinement,
                                                                const base::Deadline& deadline) {
  assert(!problem.system.right_wall() && !grid.phase_plane_domain().ends_at_barrier);
  assert(grid.phase_plane_domain().y_low < barrier && barrier < grid.phase_plane_domain().y_high);
  const double rate = problem.impulses.arrival_rate();
  // The operator is projected to polynomials in y (Galerkin method). The law has a smooth density
  // in y, and the error of the mean of a function is the integral of the remainder of this density
  // times the remainder of the solution of a Poisson equation. The second remainder decreases
  // slowly if the function jumps. With collocation in y the error is the second remainder alone.
  constexpr int kSamplesPerNode = 2;
  const numerics::QuadratureRule operator_rule = numerics::gauss_legendre_rule(
      kSamplesPerNode * grid.y_node_count(), grid.phase_plane_domain().y_low,
      grid.phase_plane_domain().y_high);
  const auto operators =
      RenewalEquation(problem, grid, rate, panel_refinement,
                      std::numeric_limits<double>::infinity(), BarrierKind::permeable)
          .compute_operators_at(operator_rule.points, {{rate}}, deadline);
  if (operators.empty()) return std::nullopt;
  Eigen::MatrixXd matrix = project_to_nodes(grid, operator_rule, operators[0].matrix);

  const RenewalEquation equation(problem, grid, rate, panel_refinement, barrier,
                                 BarrierKind::permeable);
  const UnforcedMotionSolver& motion = equation.motion_solver();
  const double max_duration = equation.max_duration();
  const auto [low, high] = equation.velocity_range();
  // The panels for a displacement just below the barrier; the trajectories that graze the barrier
  // end at the barrier itself.
  constexpr double kOffset = 1e-9;
  const auto& domain = grid.phase_plane_domain();
  const VelocityInterpolationNodes crossing_nodes(
      RenewalEquation(problem, grid, rate, panel_refinement, barrier, BarrierKind::absorbing)
          .divide_velocities_into_panels(barrier - kOffset * (barrier - domain.y_low), low, 0));
  // Linear forms of a trajectory: rates of downcrossings at the nodes, the number of upcrossings,
  // and the time below the barrier. They jump across the trajectories that graze the barrier. As
  // functions of y their means over an impulse are therefore not smooth at the turning points of
  // these trajectories.
  const Eigen::Index crossing_count = crossing_nodes.size(), form_count = crossing_count + 2;
  std::vector<double> turning_points;
  if (motion.acceleration({barrier, 0}) < 0) {
    turning_points =
        motion.find_backward_turning_points({barrier, 0}, max_duration, std::max(-low, high));
  }
  const numerics::QuadratureRule samples =
      make_displacement_rule(grid, barrier, std::move(turning_points));
  const Eigen::Index n_v = grid.v_node_count();
  Eigen::MatrixXd forms_at(samples.size() * n_v, form_count);
  const auto compute_forms = [&](std::size_t l) {
    const double y = samples.points[l];
    const auto rule = equation.make_velocity_quadrature(y);
    const auto velocity_count = static_cast<Eigen::Index>(rule.velocities.size());
    RowMajorMatrix form_values = RowMajorMatrix::Zero(velocity_count, form_count);
    for (Eigen::Index q = 0; q < velocity_count && !deadline.has_deadline_passed(); ++q) {
      PhaseState state{y, rule.velocities[static_cast<std::size_t>(q)]};
      double time = 0;
      bool is_below = y < barrier;
      // The parts of the trajectory on one side of the barrier
      while (time < max_duration) {
        const UnforcedTrajectory part = motion.compute_trajectory(
            state, max_duration - time, TrajectoryNodeSelection::end_only);
        const double end = time + part.duration;
        if (is_below) {
          const double until = part.passed_barrier ? std::exp(-rate * end) : 0;
          form_values(q, crossing_count + 1) += (std::exp(-rate * time) - until) / rate;
        }
        if (!part.passed_barrier) break;
        if (is_below) {
          form_values(q, crossing_count) += std::exp(-rate * end);
        } else {
          crossing_nodes.add_value(part.end_state.v, std::exp(-rate * end),
                                   form_values.row(q).head(crossing_count));
        }
        time = end;
        state = part.end_state;
        is_below = !is_below;
      }
    }
    forms_at.middleRows(static_cast<Eigen::Index>(l) * n_v, n_v).noalias() =
        rule.weights * form_values;
  };
  base::parallel_for(samples.points.size(), base::kOneThreadPerProcessor, compute_forms);
  if (deadline.has_deadline_passed()) return std::nullopt;
  const Eigen::MatrixXd forms = project_to_nodes(grid, samples, forms_at);

  // The law p satisfies p (I - rate A) = 0 and p 1 = 1. With any row w for which w 1 = 1 these are
  // the equations p (I - rate A + 1 w) = w.
  const Eigen::Index size = grid.node_count();
  const Eigen::RowVectorXd w = Eigen::RowVectorXd::Constant(size, 1.0 / static_cast<double>(size));
  matrix *= -rate;
  matrix.diagonal().array() += 1;
  matrix.rowwise() += w;
  const Eigen::RowVectorXd law = matrix.transpose().partialPivLu().solve(w.transpose()).transpose();
  const Eigen::RowVectorXd means = rate * law * forms;
  return StationaryCrossings{.velocities = crossing_nodes.velocities(),
                             .rates = means.head(crossing_count),
                             .upcrossing_rate = means(crossing_count),
                             .probability_below = means(crossing_count + 1)};
}

}  // namespace fpkcheck::backward
