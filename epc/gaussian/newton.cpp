#include "epc/gaussian/newton.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/linear_algebra/dense.hpp"

namespace fpkcheck::epc::gaussian {
namespace {

using Eigen::VectorXd;

constexpr double kLeastShare = 1e-4;
constexpr double kArmijo = 0.1;

// Interface of equations (23) for numerics::newton.
struct NewtonEquations {
  struct Iterate {
    VectorXd a, residual;
    double size;
  };
  struct Step {
    VectorXd change;
  };

  Iterate at(const VectorXd& a) const {
    const VectorXd residual = projection.residual(f, a);
    return {a, residual, residual.lpNorm<Eigen::Infinity>() / unit};
  }
  Step step(const Iterate& here) const {
    return {-numerics::Factors(projection.jacobian(f, here.a)).solve(here.residual)};
  }
  double share(const Iterate& here, const Step& step) const {
    const double before = here.residual.norm();
    return numerics::halved_until(1, kLeastShare, [&](double share) {
      const double after = projection.residual(f, here.a + share * step.change).norm();
      return after < (1 - kArmijo * share) * before;
    });
  }

  const Projection& projection;
  const ResidualCoefficients& f;
  double unit;
};

}  // namespace

double residual_unit(const Projection& projection, const ResidualCoefficients& f) {
  constexpr double kRounding = 1e-4;
  const Deviations& sigma = projection.basis().sigma();
  return std::max(std::abs(f.damping), kRounding * sigma.x2 / sigma.x1);
}

numerics::NewtonResult newton(const Projection& projection, const ResidualCoefficients& f,
                              const VectorXd& start, const numerics::NewtonOptions& options) {
  return numerics::newton(NewtonEquations{projection, f, residual_unit(projection, f)}, start,
                          options);
}

}  // namespace fpkcheck::epc::gaussian
