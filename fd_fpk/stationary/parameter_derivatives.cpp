#include "fd_fpk/stationary/parameter_derivatives.hpp"

#include <cassert>

namespace fpkcheck::fd_fpk {
namespace {

constexpr double kDerivativeTolerance = 1e-12;  // relative residual of GMRES

}  // namespace

Eigen::VectorXd generator_derivative_product(const problem::Problem& problem,
                                             const FiniteVolumeOptions& options,
                                             const problem::ParameterDifferenceQuotient& parameter,
                                             const DirectStationarySolution& stationary) {
  assert(stationary.averages);
  const Eigen::VectorXd& p = *stationary.averages;
  Eigen::VectorXd product = Eigen::VectorXd::Zero(p.size());
  for (const auto& [weight, changed] : parameter.terms) {
    const problem::Problem transformed = problem::to_wall_coordinates(problem.frame, changed);
    product +=
        weight * (fokker_planck_operator(transformed, options,
                                         discretise_excitation_on_same_grid(
                                             transformed, options, stationary.discretisation)) *
                  p);
  }
  return product;
}

GmresResult solve_density_derivative(const DirectStationarySolution& stationary,
                                     const Eigen::VectorXd& generator_derivative,
                                     const ApproximateLinearSolver& approximate_solve,
                                     const base::Deadline& deadline) {
  assert(stationary.averages);
  const FokkerPlanckOperator& op = stationary.op;
  GmresResult result =
      solve_by_gmres([&](const Eigen::VectorXd& x) { return op * x; }, approximate_solve,
                     -generator_derivative, op.areas, kDerivativeTolerance, deadline);
  if (result.solution) *result.solution -= op.total_mass(*result.solution) * *stationary.averages;
  return result;
}

}  // namespace fpkcheck::fd_fpk
