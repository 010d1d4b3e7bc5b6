#include "backward/passage/stationary_crossings.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "base/process/parallel_for.hpp"
#include "numerics/chebyshev_interpolation.hpp"
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
      for (const double x : panel.nodes) all.push_back(panel.map.velocity(x));
    }
    return all;
  }
  // Adds weight g(v), where g is the interpolated function, to a linear form of the values of g at
  // the nodes. Velocities outside the panels are moved to the nearest end of the panels.
  void add_value(double v, double weight, Eigen::Ref<Eigen::RowVectorXd> form) const {
    const auto above = std::ranges::find_if(panels_, [v](const VelocityQuadraturePanel& panel) {
      return v < panel.map.velocity(panel.end);
    });
    const auto panel = above == panels_.end() ? above - 1 : above;
    double x = v <= panel->map.velocity(panel->begin) ? panel->begin : panel->end;
    if (v > panel->map.velocity(panel->begin) && v < panel->map.velocity(panel->end)) {
      x = numerics::bracketed_root([&](double at) { return panel->map.velocity(at) - v; },
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

}  // namespace

std::optional<StationaryCrossings> compute_stationary_crossings(const problem::Problem& problem,
                                                                const ChebyshevGrid& lower,
                                                                const ChebyshevGrid& upper,
                                                                double panel_refinement,
                                                                const base::Deadline& deadline) {
  assert(!problem.system.right_wall());
  const double rate = problem.impulses.arrival_rate();
  const auto make_equation = [&](const ChebyshevGrid& grid) {
    return RenewalEquation(problem, grid, rate, panel_refinement, BarrierKind::permeable);
  };
  const std::array equations{make_equation(lower), make_equation(upper)};
  const UnforcedMotionSolver& motion = equations[0].motion_solver();
  const double max_duration = equations[0].max_duration();
  const std::array<Eigen::Index, 2> first_node{0, lower.node_count()};
  const Eigen::Index size = lower.node_count() + upper.node_count();

  // Calls visit(trajectory, side, time) for the parts of a trajectory on one side of the barrier,
  // which begin at the given times. Side 0 is below the barrier.
  const auto visit_parts = [&](PhaseState state, std::size_t side, TrajectoryNodeSelection content,
                               const auto& visit) {
    double time = 0;
    while (time < max_duration) {
      const UnforcedTrajectory trajectory =
          motion.compute_trajectory(state, max_duration - time, content);
      visit(trajectory, side, time);
      if (!trajectory.passed_barrier) return;
      time += trajectory.duration;
      state = trajectory.end_state;
      side = 1 - side;
    }
  };
  Eigen::MatrixXd matrix(size, size);
  const auto compute_rows = [&](std::size_t y_node) {
    const std::size_t side = static_cast<int>(y_node) < lower.y_node_count() ? 0 : 1;
    const ChebyshevGrid& grid = equations[side].grid();
    const int i = static_cast<int>(y_node) - (side == 0 ? 0 : lower.y_node_count());
    const auto rule = equations[side].make_velocity_quadrature(grid.y_node(i));
    const auto velocity_count = static_cast<Eigen::Index>(rule.velocities.size());
    RowMajorMatrix integrals = RowMajorMatrix::Zero(velocity_count, size);
    std::array<Eigen::MatrixXd, 2> along;
    for (const std::size_t k : {0, 1}) {
      along[k].resize(equations[k].grid().y_node_count(), equations[k].grid().v_node_count());
    }
    Eigen::VectorXd one(1);
    for (Eigen::Index q = 0; q < velocity_count && !deadline.has_deadline_passed(); ++q) {
      visit_parts({grid.y_node(i), rule.velocities[static_cast<std::size_t>(q)]}, side,
                  TrajectoryNodeSelection::quadrature_nodes,
                  [&](const UnforcedTrajectory& trajectory, std::size_t k, double time) {
                    equations[k].integrate_along_trajectory(trajectory, {{rate}}, along[k], one);
                    integrals.row(q).segment(first_node[k], along[k].size()) +=
                        std::exp(-rate * time) * along[k].transpose().reshaped().transpose();
                  });
    }
    matrix.middleRows(first_node[side] + grid.node_index(i, 0), rule.weights.rows()).noalias() =
        rule.weights * integrals;
  };
  base::parallel_for(static_cast<std::size_t>(lower.y_node_count() + upper.y_node_count()),
                     base::kOneThreadPerProcessor, compute_rows);

  // The panels for a displacement just below the barrier; the trajectories that graze the barrier
  // end at the barrier itself.
  constexpr double kOffset = 1e-9;
  const auto& domain = lower.phase_plane_domain();
  const VelocityInterpolationNodes crossing_nodes(
      RenewalEquation(problem, lower, rate, panel_refinement)
          .divide_velocities_into_panels(domain.barrier - kOffset * (domain.barrier - domain.y_end),
                                         equations[0].velocity_range()[0], 0));
  // Linear forms of a trajectory: rates of downcrossings at the nodes, the number of upcrossings,
  // and the time below the barrier. They jump across the trajectories that graze the barrier. As
  // functions of y their means over an impulse are therefore not smooth at the turning points of
  // these trajectories. The forms are computed at more displacements than the matrix and projected
  // to polynomials by least squares.
  constexpr int kSamplesPerNode = 4;
  const Eigen::Index crossing_count = crossing_nodes.size(), form_count = crossing_count + 2;
  Eigen::MatrixXd forms = Eigen::MatrixXd::Zero(size, form_count);
  for (const std::size_t side : {0, 1}) {
    const ChebyshevGrid& grid = equations[side].grid();
    const ChebyshevGrid samples(grid.phase_plane_domain(), kSamplesPerNode * grid.y_node_count(),
                                grid.v_node_count());
    const RenewalEquation equation = make_equation(samples);
    std::vector<Eigen::MatrixXd> forms_at(static_cast<std::size_t>(samples.y_node_count()));
    Eigen::MatrixXd polynomials(samples.y_node_count(), grid.y_node_count());
    const auto compute_forms = [&](std::size_t l) {
      const double y = samples.y_node(static_cast<int>(l));
      Eigen::VectorXd values(grid.y_node_count());
      grid.evaluate_y_polynomials(y, values);
      polynomials.row(static_cast<Eigen::Index>(l)) = values;
      const auto rule = equation.make_velocity_quadrature(y);
      const auto velocity_count = static_cast<Eigen::Index>(rule.velocities.size());
      RowMajorMatrix form_values = RowMajorMatrix::Zero(velocity_count, form_count);
      for (Eigen::Index q = 0; q < velocity_count && !deadline.has_deadline_passed(); ++q) {
        visit_parts({y, rule.velocities[static_cast<std::size_t>(q)]}, side,
                    TrajectoryNodeSelection::end_only,
                    [&](const UnforcedTrajectory& trajectory, std::size_t k, double time) {
                      const double end = time + trajectory.duration;
                      if (k == 0) {
                        const double until = trajectory.passed_barrier ? std::exp(-rate * end) : 0;
                        form_values(q, crossing_count + 1) +=
                            (std::exp(-rate * time) - until) / rate;
                      }
                      if (!trajectory.passed_barrier) return;
                      if (k == 0) {
                        form_values(q, crossing_count) += std::exp(-rate * end);
                      } else {
                        crossing_nodes.add_value(trajectory.end_state.v, std::exp(-rate * end),
                                                 form_values.row(q).head(crossing_count));
                      }
                    });
      }
      forms_at[l].noalias() = rule.weights * form_values;
    };
    base::parallel_for(forms_at.size(), base::kOneThreadPerProcessor, compute_forms);
    const Eigen::MatrixXd projection = polynomials.householderQr().solve(
        Eigen::MatrixXd::Identity(samples.y_node_count(), samples.y_node_count()));
    for (int i = 0; i < grid.y_node_count(); ++i) {
      auto rows = forms.middleRows(first_node[side] + grid.node_index(i, 0), grid.v_node_count());
      for (std::size_t l = 0; l < forms_at.size(); ++l) {
        rows += projection(i, static_cast<Eigen::Index>(l)) * forms_at[l];
      }
    }
  }
  if (deadline.has_deadline_passed()) return std::nullopt;

  // The law p satisfies p (I - rate A) = 0 and p 1 = 1. With any row w for which w 1 = 1 these are
  // the equations p (I - rate A + 1 w) = w.
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
