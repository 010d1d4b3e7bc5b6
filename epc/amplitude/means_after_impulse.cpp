#include "epc/amplitude/means_after_impulse.hpp"

#include <tuple>

#include "epc/amplitude/graded_impulse_quadrature.hpp"

namespace fpkcheck::epc::amplitude {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd means_after_impulse(const problem::ImpulseLaw& law, const half_plane::Basis& basis,
                             const VectorXd& w, const VectorXd& v,
                             const CoordinateMap& coordinates) {
  GradedImpulseQuadrature rule(law);
  MatrixXd result(v.size(), basis.size());
  for (Index i = 0; i < v.size(); ++i) {
    const PostImpulseVelocities& after = rule(v[i], w[i]);
    const auto count = static_cast<Index>(after.v.size());
    VectorXd s(count), t(count);
    for (Index k = 0; k < count; ++k) std::tie(s[k], t[k]) = coordinates(w[i], after.v[k]);
    const Eigen::Map<const VectorXd> probability(after.probability.data(), count);
    const MatrixXd means = basis.polynomials_in_s().polynomial_values(s).transpose() *
                           probability.asDiagonal() * basis.polynomials_in_t().polynomial_values(t);
    for (Index k = 0; k < basis.size(); ++k) {
      const auto& [p, q] = basis.members()[k];
      result(i, k) = means(p, q);
    }
  }
  return result;
}

}  // namespace fpkcheck::epc::amplitude
