#include "problem/expression/state_function.hpp"

#include <algorithm>
#include <cassert>

namespace fpkcheck::problem {

StateFunction::PhysicalStates StateFunction::physical_states(std::size_t count, const double* x,
                                                             const double* v) const {
  assert(count <= Expression::kBatchPoints);
  PhysicalStates states;
  for (std::size_t k = 0; k < count; ++k) {
    states.y[k] = frame_.physical_y(x[k]);
    states.v[k] = frame_.physical_velocity(v[k]);
  }
  return states;
}

void StateFunction::evaluate_batch(std::size_t count, const double* x, const double* v,
                                   double* values) const {
  if (frame_.is_identity()) return formula_->evaluate_batch(count, x, v, values);
  const PhysicalStates states = physical_states(count, x, v);
  formula_->evaluate_batch(count, states.y.data(), states.v.data(), values);
}

void StateFunction::evaluate_batch_with_velocity_slopes(std::size_t count, const double* x,
                                                        const double* v, double* values,
                                                        double* slopes) const {
  const PhysicalStates states = physical_states(count, x, v);
  formula_->evaluate_batch_with_velocity_slopes(count, states.y.data(), states.v.data(), values,
                                                slopes);
  for (std::size_t k = 0; k < count; ++k) slopes[k] *= frame_.velocity_sign();
}

std::vector<double> StateFunction::kinks_in_x(double low, double high) const {
  const double first = frame_.physical_y(low), last = frame_.physical_y(high);
  std::vector<double> kinks = formula_->kinks_in_y(std::min(first, last), std::max(first, last));
  for (double& kink : kinks) kink = frame_.wall_coordinate(kink);
  std::ranges::sort(kinks);
  return kinks;
}

std::vector<double> StateFunction::kinks_in_v(double low, double high) const {
  const double first = frame_.physical_velocity(low), last = frame_.physical_velocity(high);
  std::vector<double> kinks = formula_->kinks_in_v(std::min(first, last), std::max(first, last));
  for (double& kink : kinks) kink *= frame_.velocity_sign();
  std::ranges::sort(kinks);
  return kinks;
}

StateFunction StateFunction::to_wall_coordinates(const WallFrame& frame) const {
  assert(frame_.is_identity());
  StateFunction transformed = *this;
  transformed.frame_ = frame;
  return transformed;
}

}  // namespace fpkcheck::problem
