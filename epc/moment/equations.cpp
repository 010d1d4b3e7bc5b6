#include "epc/moment/equations.hpp"

#include <algorithm>
#include <boost/math/special_functions/factorials.hpp>
#include <cmath>

namespace fpkcheck::epc::moment {

using Eigen::ArrayXd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Equations::Equations(const problem::Problem& problem, const std::vector<double>& rate_moment,
                     const EnergyDomain& domain, const Confinement& confinement, Basis basis,
                     const QuadratureSize& size)
    : basis_(std::move(basis)),
      inside_(domain.rule(size.y, size.v)),
      wall_(domain.wall_rule(size.wall)) {
  const auto& system = problem.system;
  const int n = basis_.order();
  const auto& [y, v, weight] = inside_;
  const auto of_y = basis_.of_y().derivatives(y, 1);
  const auto of_v = basis_.of_v().derivatives(v, n);

  // L* on h_p(y) g_q(v) = v h_p' g_q + h_p [ -(c v + k y + mu y^3) g_q' + sum_j .. g_q^(j) ]
  MatrixXd impulses = MatrixXd::Zero(v.size(), n + 1);
  for (int j = 1; j <= n; ++j) {
    const double factor = rate_moment[j] / boost::math::factorial<double>(static_cast<unsigned>(j));
    if (factor != 0) impulses += factor * of_v[j];
  }
  const VectorXd force = system.damping() * v.array() + system.stiffness() * y.array() +
                         system.cubic() * y.array().cube();
  members_ = products(basis_.members(), of_y[0], of_v[0]);
  generated_ = products(basis_.members(), v.asDiagonal() * of_y[1], of_v[0]) +
               products(basis_.members(), of_y[0], impulses - force.asDiagonal() * of_v[1]);

  const VectorXd after = -system.restitution() * wall_.v;
  wall_members_ = basis_.values(wall_.y, wall_.v);
  rebounds_ = (-wall_.v).asDiagonal() * (basis_.values(wall_.y, after) - wall_members_);

  const auto confined = [&](const Points& points) {
    VectorXd term(points.y.size());
    for (Eigen::Index i = 0; i < term.size(); ++i) {
      term[i] = confinement(domain.energy(points.y[i], points.v[i]));
    }
    return term;
  };
  confined_ = confined(inside_);
  wall_confined_ = confined(wall_);
}

Equations::Density Equations::density(const VectorXd& a) const {
  const ArrayXd exponent = members_ * a + confined_;
  const ArrayXd wall_exponent = wall_members_ * a + wall_confined_;
  Density density;
  density.peak = exponent.maxCoeff();
  density.mass = inside_.weight.array() * (exponent - density.peak).exp();
  const double integral = density.mass.sum();
  density.log_normalisation = std::log(integral) + density.peak;
  density.mass /= integral;
  density.wall_mass = wall_.weight.array() * (wall_exponent - density.log_normalisation).exp();
  density.finite = std::isfinite(density.log_normalisation) && density.wall_mass.allFinite();
  return density;
}

VectorXd Equations::residual(const Density& density) const {
  return generated_.transpose() * density.mass + rebounds_.transpose() * density.wall_mass;
}

MatrixXd Equations::centred(const MatrixXd& members, const Density& density) const {
  const Eigen::RowVectorXd mean = density.mass.transpose() * members_;
  return members.rowwise() - mean;
}

MatrixXd Equations::jacobian(const Density& density) const {
  // d p / d a_k = p (phi_k - E[phi_k]), on the wall too
  const MatrixXd change = density.mass.asDiagonal() * centred(members_, density);
  const MatrixXd wall_change = density.wall_mass.asDiagonal() * centred(wall_members_, density);
  MatrixXd result(basis_.size(), basis_.size());
  result.noalias() = generated_.transpose() * change;
  result.noalias() += rebounds_.transpose() * wall_change;
  return result;
}

MatrixXd Equations::covariance(const Density& density) const {
  const MatrixXd members = density.mass.cwiseSqrt().asDiagonal() * centred(members_, density);
  MatrixXd result = MatrixXd::Zero(basis_.size(), basis_.size());
  result.selfadjointView<Eigen::Lower>().rankUpdate(members.transpose());
  return result.selfadjointView<Eigen::Lower>();
}

VectorXd Equations::fit(const VectorXd& exponent, const VectorXd& mass) const {
  // Q_n has no constant of its own: a column of ones takes it up.
  MatrixXd columns(members_.rows(), members_.cols() + 1);
  columns << VectorXd::Ones(members_.rows()), members_;
  const MatrixXd weighted = mass.asDiagonal() * columns;
  const VectorXd solution =
      (columns.transpose() * weighted).ldlt().solve(weighted.transpose() * exponent);
  return solution.tail(basis_.size());
}

}  // namespace fpkcheck::epc::moment
