#include "workflows/sweep/execution/cost_model.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace fpkcheck::sweep {
namespace {

constexpr double kMinSeconds = 1e-6;  // lower bound, so that the logarithm exists

/// The values of the basis functions of the quadratic polynomial for a point.
class BasisFunctions {
 public:
  explicit BasisFunctions(const Plan& plan) : plan_(plan) {
    for (std::size_t a = 0; a < plan.axes.size(); ++a) {
      Range range{std::numeric_limits<double>::infinity(),
                  -std::numeric_limits<double>::infinity()};
      for (const auto& point : plan.points) {
        if (const auto* number = std::get_if<double>(&point[a])) {
          const double at = scaled(a, *number);
          range = {std::min(range.least, at), std::max(range.greatest, at)};
        }
      }
      ranges_.push_back(range);
    }
  }

  Eigen::VectorXd at(std::size_t point) const {
    std::vector<double> linear;
    std::vector<double> terms{1};
    for (std::size_t a = 0; a < plan_.axes.size(); ++a) {
      const auto& value = plan_.points[point][a];
      if (const auto* number = std::get_if<double>(&value)) {
        const auto [least, greatest] = ranges_[a];
        linear.push_back(
            greatest > least ? 2 * (scaled(a, *number) - least) / (greatest - least) - 1 : 0.0);
      } else {
        // Each value of a categorical key has an indicator function.
        for (const auto& word : plan_.axes[a].values) terms.push_back(word == value ? 1 : 0);
      }
    }
    for (std::size_t i = 0; i < linear.size(); ++i) {
      terms.push_back(linear[i]);
      for (std::size_t j = i; j < linear.size(); ++j) terms.push_back(linear[i] * linear[j]);
    }
    return Eigen::Map<Eigen::VectorXd>(terms.data(), static_cast<Eigen::Index>(terms.size()));
  }

 private:
  struct Range {
    double least, greatest;
  };

  double scaled(std::size_t axis, double value) const {
    return plan_.axes[axis].spacing == Spacing::logarithmic ? std::log(value) : value;
  }

  const Plan& plan_;
  std::vector<Range> ranges_;
};

}  // namespace

CostModel::CostModel(const Plan& plan, std::span<const Measurement> measured)
    : expected_(plan.points.size(), 1.0) {
  if (measured.empty()) return;
  const BasisFunctions terms(plan);
  const Eigen::Index unknowns = terms.at(0).size();
  // The fit is a ridge regression, so that all coefficients are determined even if few points are
  // measured.
  constexpr double kRidge = 0.03;
  Eigen::MatrixXd normal = kRidge * Eigen::MatrixXd::Identity(unknowns, unknowns);
  normal(0, 0) = 0;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
  for (const auto& [point, seconds] : measured) {
    const Eigen::VectorXd row = terms.at(point);
    normal += row * row.transpose();
    right += row * std::log(std::max(seconds, kMinSeconds));
  }
  const Eigen::VectorXd coefficients = normal.ldlt().solve(right);
  // The exponential of the fitted mean logarithm underestimates the mean: the expected times are
  // scaled to the sum of the measured times.
  double sum = 0, fitted = 0;
  for (const auto& [point, seconds] : measured) {
    sum += seconds;
    fitted += std::exp(coefficients.dot(terms.at(point)));
  }
  for (std::size_t p = 0; p < expected_.size(); ++p) {
    expected_[p] = sum / fitted * std::exp(coefficients.dot(terms.at(p)));
  }
  for (const auto& [point, seconds] : measured) expected_[point] = seconds;
}

std::vector<std::size_t> evenly_spread_sample(const std::vector<std::size_t>& candidates,
                                              std::size_t count) {
  // The golden ratio as step avoids resonance with the periods of a Cartesian product of axes.
  constexpr double kGolden = 0.6180339887498949;
  std::vector<std::size_t> chosen;
  const std::size_t most = std::min(count, candidates.size());
  for (std::size_t k = 0; chosen.size() < most && k < 4 * candidates.size(); ++k) {
    const double fraction = std::fmod(0.5 + static_cast<double>(k) * kGolden, 1.0);
    const auto at =
        candidates[static_cast<std::size_t>(fraction * static_cast<double>(candidates.size()))];
    if (std::ranges::find(chosen, at) == chosen.end()) chosen.push_back(at);
  }
  return chosen;
}

}  // namespace fpkcheck::sweep
