#include "backward/control/impulse_means.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "numerics/quadrature/gauss_rule.hpp"

namespace fpkcheck::backward {
namespace {

constexpr unsigned kPointsPerPart = 8;

void add(const numerics::QuinticBSplines& splines, double at, double probability,
         Eigen::Ref<Eigen::RowVectorXd> row) {
  const auto functions = splines.values_and_slopes(at);
  for (int l = 0; l <= numerics::QuinticBSplines::kDegree; ++l) {
    row(functions.first + l) += probability * functions.value[l];
  }
}

/// The ends of the subintervals of a smooth piece of the density, shifted by v.
std::vector<double> part_ends(const numerics::QuinticBSplines& splines, double from, double to,
                              double longest) {
  std::vector<double> ends{from};
  const auto up_to = [&](double next) {
    const double begin = ends.back();
    const int count = std::max(1, static_cast<int>(std::ceil((next - begin) / longest - 1e-9)));
    for (int k = 1; k < count; ++k) ends.push_back(begin + (next - begin) * k / count);
    ends.push_back(next);
  };
  const auto& breaks = splines.breaks();
  auto next = std::upper_bound(breaks.begin(), breaks.end(), from);
  for (; next != breaks.end() && *next < to; ++next) up_to(*next);
  up_to(to);
  return ends;
}

}  // namespace

Eigen::MatrixXd impulse_means(const numerics::QuinticBSplines& splines,
                              const problem::ImpulseLaw& law, std::span<const double> v) {
  Eigen::MatrixXd means =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(v.size()), splines.size());
  const auto atoms = law.atoms();
  const auto pieces = law.density_breakpoints();
  Eigen::RowVectorXd row(splines.size());
  for (std::size_t i = 0; i < v.size(); ++i) {
    row.setZero();
    for (const auto& atom : atoms) add(splines, v[i] + atom.amplitude, atom.probability, row);
    for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
      const auto ends = part_ends(splines, v[i] + pieces[k], v[i] + pieces[k + 1], law.deviation());
      const auto [points, weights] = numerics::composite_gauss_rule<kPointsPerPart>(ends);
      for (std::size_t n = 0; n < points.size(); ++n) {
        const double z = points[n];
        add(splines, z, weights(static_cast<Eigen::Index>(n)) * law.density(z - v[i]), row);
      }
    }
    means.row(static_cast<Eigen::Index>(i)) = row;
  }
  return means;
}

Eigen::MatrixXd impulse_means(const numerics::QuinticBSplines& splines,
                              const problem::ImpulseTrain& impulses, std::span<const double> v) {
  if (!impulses.is_present()) return {};
  return impulse_means(splines, impulses.law(), v);
}

}  // namespace fpkcheck::backward
