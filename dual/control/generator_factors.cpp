#include "dual/control/generator_factors.hpp"

#include <vector>

namespace fpkcheck::dual {

SplineValues values_at(const KnotSplines& splines, std::span<const double> points) {
  const auto rows = static_cast<Eigen::Index>(points.size());
  SplineValues all{Eigen::MatrixXd::Zero(rows, splines.size()),
                   Eigen::MatrixXd::Zero(rows, splines.size())};
  for (Eigen::Index n = 0; n < rows; ++n) {
    const auto at = splines.at(points[static_cast<std::size_t>(n)]);
    for (int l = 0; l <= KnotSplines::kDegree; ++l) {
      all.value(n, at.first + l) = at.value[l];
      all.slope(n, at.first + l) = at.slope[l];
    }
  }
  return all;
}

Eigen::MatrixXd jumps_at(const KnotSplines& splines, double restitution,
                         std::span<const double> speeds) {
  std::vector<double> before, after;
  for (const double u : speeds) {
    before.push_back(-u);
    after.push_back(restitution * u);
  }
  return values_at(splines, after).value - values_at(splines, before).value;
}

GeneratorFactors factors_of_y(const problem::System& system, const KnotSplines& splines,
                              std::span<const double> points) {
  const SplineValues a = values_at(splines, points);
  Eigen::VectorXd force(a.value.rows());
  for (Eigen::Index n = 0; n < force.size(); ++n) {
    force(n) = system.force()(points[static_cast<std::size_t>(n)]);
  }
  return {a.slope, a.value, force.asDiagonal() * a.value};
}

GeneratorFactors factors_of_v(const problem::Problem& problem, const KnotSplines& splines,
                              std::span<const double> points, const Eigen::MatrixXd& means) {
  const SplineValues b = values_at(splines, points);
  const Eigen::Map<const Eigen::VectorXd> v(points.data(), b.value.rows());
  return {v.asDiagonal() * b.value,
          problem.impulses.arrival_rate() * (means - b.value) -
              problem.system.damping() * (v.asDiagonal() * b.slope),
          -b.slope};
}

}  // namespace fpkcheck::dual
