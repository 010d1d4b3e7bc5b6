#include "fd_fpk/operator/time_dependent_operator.hpp"

#include <utility>

namespace fpkcheck::fd_fpk {
TimeDependentOperator::TimeDependentOperator(const problem::Problem& problem,
                                             const Options& options, const Discretisation& on) {
  const auto operator_of = [&](const Excitation& excitation) {
    return fokker_planck_operator(problem.system, excitation, options.impact, on.grid,
                                  transport_order(options));
  };
  const auto excitation_of = [&](const problem::Problem& part) {
    return with_excitation_of(part, options, on).excitation;
  };
  // Every term is linear in the coefficients of the excitation, so that differences to the operator
  // without excitation are the terms.
  const problem::TimeDependence& time = problem.time;
  problem::Problem constant = problem;
  if (time.has_rate()) constant = without_impulses(std::move(constant));
  if (time.has_intensity()) constant = without_noise(std::move(constant));
  constant_ = operator_of(excitation_of(constant));
  if (!time.is_present()) return;
  const FokkerPlanckOperator motion = operator_of({});
  const auto add = [&](std::function<double(double)> factor, const Excitation& excitation) {
    FokkerPlanckOperator part = operator_of(excitation);
    part.local = SparseColumnMatrix(part.local - motion.local).pruned();
    terms_.push_back({std::move(factor), std::move(part)});
  };
  if (time.has_rate()) {
    add([time](double t) { return time.rate_factor(t); }, excitation_of(without_noise(problem)));
  }
  if (time.has_intensity()) {
    add([time](double t) { return time.intensity_factor(t); },
        excitation_of(without_impulses(problem)));
  }
  if (time.has_force()) {
    add([time](double t) { return time.force(t); }, Excitation{.drift = 1, .exchange = {}});
  }
}

Eigen::VectorXd TimeDependentOperator::product(double t, const Eigen::VectorXd& averages) const {
  Eigen::VectorXd change = constant_ * averages;
  for (const Term& term : terms_) {
    const double factor = term.factor(t);
    if (factor != 0) change += factor * (term.part * averages);
  }
  return change;
}

Excitation excitation_at_time(const problem::Problem& problem, const Options& options,
                              const Discretisation& on, double t) {
  if (!problem.time.is_present()) return on.excitation;
  Excitation excitation =
      with_excitation_of(problem::with_excitation_at_time(problem, t), options, on).excitation;
  excitation.drift += problem.time.force(t);
  return excitation;
}

}  // namespace fpkcheck::fd_fpk
