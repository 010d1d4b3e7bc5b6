#include "numerics/roots/fixed_point.hpp"

#include <Eigen/QR>
#include <deque>
#include <utility>

namespace fpkcheck::numerics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct FixedPointMapEvaluation {
  VectorXd value;   // f(x)
  VectorXd change;  // f(x) - x
};

VectorXd next_anderson_argument(const std::deque<FixedPointMapEvaluation>& last) {
  const auto terms = static_cast<Index>(last.size()) - 1;
  const FixedPointMapEvaluation& newest = last.back();
  if (terms == 0) return newest.value;
  MatrixXd values(newest.value.size(), terms), changes(newest.value.size(), terms);
  for (Index j = 0; j < terms; ++j) {
    const FixedPointMapEvaluation &a = last[static_cast<std::size_t>(j)],
                                  &b = last[static_cast<std::size_t>(j) + 1];
    values.col(j) = b.value - a.value;
    changes.col(j) = b.change - a.change;
  }
  return newest.value - values * changes.colPivHouseholderQr().solve(newest.change);
}

}  // namespace

FixedPointResult solve_fixed_point(const VectorMap& f, const VectorXd& start,
                                   const FixedPointOptions& options) {
  constexpr std::size_t kMostEvaluations = 8;  // evaluations that determine the next argument
  FixedPointResult result{.x = start};
  std::deque<FixedPointMapEvaluation> last;
  VectorXd x = start;
  while (result.evaluations < options.max_evaluations) {
    std::optional<VectorXd> value = f(x);
    ++result.evaluations;
    if (!value) {
      if (last.size() < 2) return result;  // x is the start or a value of f
      x = result.x;
      last.clear();
      continue;
    }
    last.push_back({*value, *value - x});
    if (last.size() > kMostEvaluations) last.pop_front();
    result.x = std::move(*value);
    result.change = options.size(last.back().change);
    if (result.change < options.tolerance) {
      result.converged = true;
      return result;
    }
    x = next_anderson_argument(last);
  }
  return result;
}

}  // namespace fpkcheck::numerics
