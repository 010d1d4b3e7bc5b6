#include "epc/gaussian/newton.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/linear_algebra/dense_decompositions.hpp"

namespace fpkcheck::epc::gaussian {
namespace {

using Eigen::VectorXd;

constexpr double kLeastStepFraction = 1e-4;
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
    return {-numerics::LuFactors(projection.jacobian(f, here.a)).solve(here.residual)};
  }
  double step_fraction(const Iterate& here, const Step& step) const {
    const double before = here.residual.norm();
    return numerics::backtrack(1, kLeastStepFraction, [&](double step_fraction) {
      const double after = projection.residual(f, here.a + step_fraction * step.change).norm();
      return after < (1 - kArmijo * step_fraction) * before;
    });
  }

  const ProjectedEquations& projection;
  const ResidualCoefficients& f;
  double unit;
};

}  // namespace

double residual_unit(const ProjectedEquations& projection, const ResidualCoefficients& f) {
  constexpr double kRounding = 1e-4;
  const StandardDeviations& sigma = projection.basis().sigma();
  return std::max(std::abs(f.damping), kRounding * sigma.x2 / sigma.x1);
}

numerics::NewtonResult solve_by_newton(const ProjectedEquations& projection,
                                       const ResidualCoefficients& f, const VectorXd& start,
                                       const numerics::NewtonOptions& options) {
  return numerics::solve_by_newton(NewtonEquations{projection, f, residual_unit(projection, f)},
                                   start, options);
}

}  // namespace fpkcheck::epc::gaussian
