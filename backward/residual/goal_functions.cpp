#include "backward/residual/goal_functions.hpp"

#include <cmath>
#include <memory>
#include <utility>

namespace fpkcheck::backward {
namespace {

double constant_one(double) { return 1; }

/// Returns splines each of whose cells consists of two cells of the given splines.
std::shared_ptr<const numerics::QuinticBSplines> make_coarse_splines(
    const numerics::QuinticBSplines& splines) {
  const auto& breaks = splines.breaks();
  std::vector<double> knots(numerics::QuinticBSplines::kDegree + 1, splines.begin());
  for (std::size_t k = 2; k + 2 < breaks.size(); k += 2) knots.push_back(breaks[k]);
  knots.insert(knots.end(), numerics::QuinticBSplines::kDegree + 1, splines.end());
  return std::make_shared<const numerics::QuinticBSplines>(std::move(knots));
}

/// Returns the smooth bins of an axis as functions of y or v.
std::vector<std::function<double(double)>> make_bin_functions(
    const numerics::QuinticBSplines& splines) {
  const auto bins = make_coarse_splines(splines);
  std::vector<std::function<double(double)>> functions;
  for (int b = 0; b < bins->size(); ++b) {
    functions.push_back([bins, b](double x) {
      const auto at = bins->values_and_slopes(x);
      const int place = b - at.first;
      return 0 <= place && place <= numerics::QuinticBSplines::kDegree ? at.value[place] : 0;
    });
  }
  return functions;
}

}  // namespace

GoalFunctions make_goal_functions(const numerics::QuinticBSplines& y_splines,
                                  const numerics::QuinticBSplines& v_splines,
                                  const problem::WallFrame& frame) {
  GoalFunctions goal;
  for (const int n : {1, 2, 4}) {
    goal.functions.push_back(
        {[=](double x) { return std::pow(frame.physical_y(x), n); }, constant_one});
  }
  for (const int n : {1, 2, 4}) {
    goal.functions.push_back(
        {constant_one, [=](double x) { return std::pow(frame.physical_velocity(x), n); }});
  }
  goal.moment_count = static_cast<int>(goal.functions.size());
  for (auto& bin : make_bin_functions(y_splines))
    goal.functions.push_back({std::move(bin), constant_one});
  goal.y_bin_count = static_cast<int>(goal.functions.size()) - goal.moment_count;
  for (auto& bin : make_bin_functions(v_splines))
    goal.functions.push_back({constant_one, std::move(bin)});
  goal.v_bin_count = static_cast<int>(goal.functions.size()) - goal.moment_count - goal.y_bin_count;
  return goal;
}

}  // namespace fpkcheck::backward
