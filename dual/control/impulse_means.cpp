#include "dual/control/impulse_means.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <vector>

namespace fpkcheck::dual {
namespace {

void add(const KnotSplines& splines, double at, double probability,
         Eigen::Ref<Eigen::RowVectorXd> row) {
  const auto functions = splines.at(at);
  for (int l = 0; l <= KnotSplines::kDegree; ++l) {
    row(functions.first + l) += probability * functions.value[l];
  }
}

/// The ends of the parts of one smooth piece, seen from v.
std::vector<double> parts(const KnotSplines& splines, double from, double to, double longest) {
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

Eigen::MatrixXd impulse_means(const KnotSplines& splines, const problem::ImpulseLaw& law,
                              std::span<const double> v) {
  using Gauss = boost::math::quadrature::gauss<double, 8>;
  Eigen::MatrixXd means =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(v.size()), splines.size());
  const auto atoms = law.atoms();
  const auto pieces = law.smooth_pieces();
  Eigen::RowVectorXd row(splines.size());
  for (std::size_t i = 0; i < v.size(); ++i) {
    row.setZero();
    for (const auto& atom : atoms) add(splines, v[i] + atom.amplitude, atom.probability, row);
    for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
      const auto ends = parts(splines, v[i] + pieces[k], v[i] + pieces[k + 1], law.deviation());
      for (std::size_t part = 0; part + 1 < ends.size(); ++part) {
        const double centre = (ends[part] + ends[part + 1]) / 2;
        const double half = (ends[part + 1] - ends[part]) / 2;
        for (std::size_t n = 0; n < Gauss::abscissa().size(); ++n) {
          for (const double sign : {-1.0, 1.0}) {
            const double z = centre + sign * half * Gauss::abscissa()[n];
            add(splines, z, half * Gauss::weights()[n] * law.density(z - v[i]), row);
          }
        }
      }
    }
    means.row(static_cast<Eigen::Index>(i)) = row;
  }
  return means;
}

}  // namespace fpkcheck::dual
