#include "backward/residual/goal_functions.hpp"

#include <cmath>
#include <memory>
#include <utility>

namespace fpkcheck::backward {
namespace {

double constant_one(double) { return 1; }

std::shared_ptr<const numerics::QuinticBSplines> coarsened_splines(
    const numerics::QuinticBSplines& splines) {
  const auto& breaks = splines.breaks();
  std::vector<double> knots(numerics::QuinticBSplines::kDegree + 1, splines.begin());
  for (std::size_t k = 2; k + 2 < breaks.size(); k += 2) knots.push_back(breaks[k]);
  knots.insert(knots.end(), numerics::QuinticBSplines::kDegree + 1, splines.end());
  return std::make_shared<const numerics::QuinticBSplines>(std::move(knots));
}

std::vector<std::function<double(double)>> bin_functions(const numerics::QuinticBSplines& splines) {
  const auto bins = coarsened_splines(splines);
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

GoalFunctions goal_functions(const numerics::QuinticBSplines& y, const numerics::QuinticBSplines& v,
                             const problem::WallFrame& frame) {
  GoalFunctions goal;
  for (const int n : {1, 2, 4}) {
    goal.all.push_back({[=](double x) { return std::pow(frame.physical_y(x), n); }, constant_one});
  }
  for (const int n : {1, 2, 4}) {
    goal.all.push_back(
        {constant_one, [=](double x) { return std::pow(frame.physical_velocity(x), n); }});
  }
  goal.moments = static_cast<int>(goal.all.size());
  for (auto& bin : bin_functions(y)) goal.all.push_back({std::move(bin), constant_one});
  goal.y_bins = static_cast<int>(goal.all.size()) - goal.moments;
  for (auto& bin : bin_functions(v)) goal.all.push_back({constant_one, std::move(bin)});
  goal.v_bins = static_cast<int>(goal.all.size()) - goal.moments - goal.y_bins;
  return goal;
}

}  // namespace fpkcheck::backward
