#pragma once

#include <functional>
#include <vector>

#include "fd_fpk/operator/fokker_planck_operator.hpp"
#include "fd_fpk/operator/phase_plane_discretisation.hpp"
#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Operator L(t) of the semi-discrete equation dP/dt = L(t) P under an excitation that changes in
/// time,
///
///     L(t) = L_0 + a(t) L_impulses + b(t) L_noise - F(t) d/dv,
///
/// with the factors a(t) and b(t) of the excitation and the force F(t) of
/// problem::ExcitationTimeDependence. For a constant excitation the operator L(t) is the operator
/// of fokker_planck_operator().
class TimeDependentOperator {
 public:
  TimeDependentOperator(const problem::Problem& problem, const FiniteVolumeOptions& options,
                        const PlaneDiscretisation& discretisation);

  /// Returns L(t) P for cell averages P.
  Eigen::VectorXd apply_at_time(double t, const Eigen::VectorXd& cell_averages) const;
  double total_mass(const Eigen::VectorXd& cell_averages) const {
    return constant_.total_mass(cell_averages);
  }

 private:
  struct Term {
    std::function<double(double t)> factor;
    FokkerPlanckOperator part;
  };

  FokkerPlanckOperator constant_;
  std::vector<Term> terms_;
};

/// Returns the discretised excitation at the time t, including the drift due to the force F(t).
DiscretisedExcitation excitation_at_time(const problem::Problem& problem,
                                         const FiniteVolumeOptions& options,
                                         const PlaneDiscretisation& discretisation, double t);

}  // namespace fpkcheck::fd_fpk
