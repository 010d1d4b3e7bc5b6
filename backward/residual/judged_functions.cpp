#include "backward/residual/judged_functions.hpp"

#include <cmath>
#include <memory>
#include <utility>

#include "backward/control/general_control.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "problem/features.hpp"

namespace fpkcheck::backward {
namespace {

constexpr int kShrinking = 12;     // cells that shrink towards the wall and towards v = 0
constexpr double kOffTheWall = 4;  // static deflection off the wall, in deviations

double one_everywhere(double) { return 1; }

/// The B-splines on every second break of the splines.
std::shared_ptr<const numerics::KnotSplines> wider(const numerics::KnotSplines& splines) {
  const auto& breaks = splines.breaks();
  std::vector<double> knots(numerics::KnotSplines::kDegree + 1, splines.begin());
  for (std::size_t k = 2; k + 2 < breaks.size(); k += 2) knots.push_back(breaks[k]);
  knots.insert(knots.end(), numerics::KnotSplines::kDegree + 1, splines.end());
  return std::make_shared<const numerics::KnotSplines>(std::move(knots));
}

std::vector<std::function<double(double)>> bins_of(const numerics::KnotSplines& splines) {
  const auto bins = wider(splines);
  std::vector<std::function<double(double)>> functions;
  for (int b = 0; b < bins->size(); ++b) {
    functions.push_back([bins, b](double x) {
      const auto at = bins->at(x);
      const int place = b - at.first;
      return 0 <= place && place <= numerics::KnotSplines::kDegree ? at.value[place] : 0;
    });
  }
  return functions;
}

}  // namespace

ControlSplines residual_splines(const problem::Problem& problem, const ControlCells& cells) {
  if (!problem::of_the_paper(problem)) return general_splines(problem, cells);
  const double deviation = problem::equivalent_linearisation(problem).displacement_deviation;
  const bool off_the_wall = problem::static_deflection(problem) > kOffTheWall * deviation;
  return usual_splines(problem, cells, off_the_wall ? 0 : kShrinking);
}

JudgedFunctions judged_functions(const numerics::KnotSplines& y, const numerics::KnotSplines& v,
                                 const problem::Frame& frame) {
  JudgedFunctions judged;
  for (const int n : {1, 2, 4}) {
    judged.all.push_back({[=](double x) { return std::pow(frame.y(x), n); }, one_everywhere});
  }
  for (const int n : {1, 2, 4}) {
    judged.all.push_back({one_everywhere, [=](double x) { return std::pow(frame.v(x), n); }});
  }
  judged.moments = static_cast<int>(judged.all.size());
  for (auto& bin : bins_of(y)) judged.all.push_back({std::move(bin), one_everywhere});
  judged.y_bins = static_cast<int>(judged.all.size()) - judged.moments;
  for (auto& bin : bins_of(v)) judged.all.push_back({one_everywhere, std::move(bin)});
  judged.v_bins = static_cast<int>(judged.all.size()) - judged.moments - judged.y_bins;
  return judged;
}

}  // namespace fpkcheck::backward
