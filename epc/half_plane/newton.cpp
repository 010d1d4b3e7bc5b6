#include "epc/half_plane/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "epc/half_plane/metric.hpp"
#include "numerics/linear_algebra/dense.hpp"

namespace fpkcheck::epc::half_plane {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kLongestStep = 2;
constexpr double kLeastShare = 1e-6;

// Interface of the Galerkin equations for numerics::newton.
struct NewtonEquations {
  struct Iterate {
    VectorXd a;
    Galerkin::Density density;
    VectorXd residual;
    MatrixXd metric;
    double size;
  };
  struct Step {
    VectorXd change;
    numerics::Factors factors;
  };

  Iterate at(const VectorXd& a) const {
    Iterate here{a, galerkin.density(a), {}, {}, std::numeric_limits<double>::infinity()};
    if (!here.density.finite) return here;
    here.residual = galerkin.residual(here.density);
    here.metric = galerkin.covariance(here.density);
    here.size = size_of(here.residual, here.metric, unit);
    return here;
  }

  Step step(const Iterate& here) const {
    numerics::Factors factors(galerkin.jacobian(here.density));
    VectorXd change = -factors.solve(here.residual);
    return {std::move(change), std::move(factors)};
  }

  double share(const Iterate& here, const Step& step) const {
    const double whole = length(step.change, here.metric);
    if (!std::isfinite(whole)) return 0;
    const auto shortens = [&](double share) {
      const Galerkin::Density trial = galerkin.density(here.a + share * step.change);
      if (!trial.finite) return false;
      const VectorXd next = step.factors.solve(galerkin.residual(trial));
      return length(next, here.metric) <= (1 - share / 4) * whole;
    };
    return numerics::halved_until(std::min(1.0, kLongestStep / whole), kLeastShare, shortens);
  }

  const Galerkin& galerkin;
  double unit;
};

}  // namespace

numerics::NewtonResult newton(const Galerkin& equations, const VectorXd& start, double unit,
                              const numerics::NewtonOptions& options) {
  return numerics::newton(NewtonEquations{equations, unit}, start, options);
}

numerics::Curve follow_homotopy(const Galerkin& equations, const VectorXd& start,
                                const std::function<bool()>& give_up) {
  const auto residual = [&](const VectorXd& a) -> VectorXd {
    const Galerkin::Density density = equations.density(a);
    if (density.finite) return equations.residual(density);
    return VectorXd::Constant(equations.size(), std::numeric_limits<double>::quiet_NaN());
  };
  const auto jacobian = [&](const VectorXd& a) -> MatrixXd {
    return equations.jacobian(equations.density(a));
  };
  // Coefficients of functions of about unit variance; the accuracy suffices to start Newton's
  // method.
  return numerics::follow(numerics::newton_homotopy(residual, jacobian, start), start,
                          {.tolerance = 0,
                           .short_correction = 1e-6,
                           .first_step = 0.2,
                           .greatest_step = 1,
                           .least_step = 1e-5,
                           .growth = 1.5,
                           .leash = 1,
                           .max_points = 120,
                           .greatest_norm = std::numeric_limits<double>::infinity(),
                           .least_t = -1,
                           .locate_folds = false,
                           .correct_end = false,
                           .give_up = give_up});
}

}  // namespace fpkcheck::epc::half_plane
