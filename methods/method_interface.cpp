#include "methods/method_interface.hpp"

#include "problem/walls.hpp"
#include "transform/coordinate_transformation.hpp"

namespace fpkcheck::methods {

problem::Problem to_wall_coordinates(const problem::Problem& problem) {
  return problem::to_wall_coordinates(problem::wall_frame(problem.system), problem);
}

transform::Solution solve_in_wall_coordinates(
    const problem::Problem& problem, const SolverInputContext& context,
    const std::function<std::string(const problem::Problem&)>& unsupported_reason,
    const std::function<transform::Solution(const problem::Problem&, const SolverInputContext&)>&
        solve) {
  const problem::WallFrame frame = problem::wall_frame(problem.system);
  const problem::Problem transformed = problem::to_wall_coordinates(frame, problem);
  if (const std::string reason = unsupported_reason(transformed); !reason.empty()) {
    transform::Solution solution;
    solution.status = transform::Status::not_offered;
    solution.reason = reason;
    return solution;
  }
  if (frame.is_identity()) return solve(transformed, context);
  const compare::ComparisonBins axes{transform::wall_coordinate_edges(frame, context.axes.y_edges),
                                     transform::transform_v_edges(frame, context.axes.v_edges),
                                     context.axes.divisions};
  return transform::to_physical_coordinates(
      frame,
      solve(transformed, {axes, context.progress, context.error_estimator, context.estimate_error}),
      context.axes.y_edges);
}

void set_closure_error_estimate(const SolverInputContext& context, const problem::Problem& problem,
                                double accuracy, transform::Solution& solution) {
  if (!solution.density || !context.estimate_error) return;
  if (context.error_estimator != nullptr) {
    set_residual_error_estimate(*context.error_estimator, accuracy, solution, problem.frame);
  } else {
    set_residual_error_estimate(ResidualErrorEstimator(problem), accuracy, solution, problem.frame);
  }
}

}  // namespace fpkcheck::methods
