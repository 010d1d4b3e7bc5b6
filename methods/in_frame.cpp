#include "methods/in_frame.hpp"

#include <fmt/format.h>

#include "problem/frame.hpp"
#include "transform/change_of_frame.hpp"

namespace fpkcheck::methods {

transform::Solution solve_in_frame(
    const problem::Problem& problem, const Setting& setting,
    const std::function<std::string(const problem::Problem&)>& objection,
    const std::function<transform::Solution(const problem::Problem&, const Setting&)>& solve) {
  const problem::Frame frame = problem::wall_frame(problem.system);
  const problem::Problem seen = problem::to_wall_coordinates(frame, problem);
  if (const std::string why = objection(seen); !why.empty()) {
    transform::Solution solution;
    solution.status = transform::Status::not_offered;
    solution.reason = why;
    return solution;
  }
  if (frame.is_identity()) return solve(seen, setting);
  const compare::ComparisonAxes axes{transform::to_x_edges(frame, setting.axes.y_edges),
                                     transform::transform_v_edges(frame, setting.axes.v_edges),
                                     setting.axes.divisions};
  return transform::to_physical_coordinates(
      frame, solve(seen, {axes, setting.progress, setting.residuals, setting.measure_error}),
      setting.axes.y_edges);
}

}  // namespace fpkcheck::methods
