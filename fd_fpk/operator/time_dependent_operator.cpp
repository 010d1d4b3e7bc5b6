#include "fd_fpk/operator/time_dependent_operator.hpp"

#include <utility>

namespace fpkcheck::fd_fpk {
TimeDependentOperator::TimeDependentOperator(const problem::Problem& problem,
                                             const FiniteVolumeOptions& options,
                                             const PlaneDiscretisation& discretisation) {
  const auto operator_of = [&](const DiscretisedExcitation& excitation) {
    return fokker_planck_operator(problem.system, excitation, options.impact, discretisation.grid,
                                  transport_order(options));
  };
  const auto excitation_of = [&](const problem::Problem& part) {
    return discretise_excitation_on_same_grid(part, options, discretisation).excitation;
  };
  // The Fokker-Planck operator is linear in the coefficients of the excitation. Each time-dependent
  // term is therefore the difference of the operators with and without one part of the excitation.
  const problem::ExcitationTimeDependence& time = problem.time;
  problem::Problem constant = problem;
  if (time.has_rate_factor()) constant = without_impulses(std::move(constant));
  if (time.has_intensity_factor()) constant = without_noise(std::move(constant));
  constant_ = operator_of(excitation_of(constant));
  if (!time.is_acting()) return;
  const FokkerPlanckOperator motion = operator_of({});
  const auto add = [&](std::function<double(double)> factor,
                       const DiscretisedExcitation& excitation) {
    FokkerPlanckOperator part = operator_of(excitation);
    part.local = SparseColumnMatrix(part.local - motion.local).pruned();
    terms_.push_back({std::move(factor), std::move(part)});
  };
  if (time.has_rate_factor()) {
    add([time](double t) { return time.rate_factor(t); }, excitation_of(without_noise(problem)));
  }
  if (time.has_intensity_factor()) {
    add([time](double t) { return time.intensity_factor(t); },
        excitation_of(without_impulses(problem)));
  }
  if (time.has_external_force()) {
    add([time](double t) { return time.external_force(t); },
        DiscretisedExcitation{.drift = 1, .exchange = {}});
  }
}

Eigen::VectorXd TimeDependentOperator::apply_at_time(double t,
                                                     const Eigen::VectorXd& cell_averages) const {
  Eigen::VectorXd change = constant_ * cell_averages;
  for (const Term& term : terms_) {
    const double factor = term.factor(t);
    if (factor != 0) change += factor * (term.part * cell_averages);
  }
  return change;
}

DiscretisedExcitation excitation_at_time(const problem::Problem& problem,
                                         const FiniteVolumeOptions& options,
                                         const PlaneDiscretisation& discretisation, double t) {
  if (!problem.time.is_acting()) return discretisation.excitation;
  DiscretisedExcitation excitation =
      discretise_excitation_on_same_grid(problem::with_excitation_at_time(problem, t), options,
                                         discretisation)
          .excitation;
  excitation.drift += problem.time.external_force(t);
  return excitation;
}

}  // namespace fpkcheck::fd_fpk
