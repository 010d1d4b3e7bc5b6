#include "problem/expression/state_function.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace fpkcheck::problem {

void StateFunction::evaluate(std::size_t count, const double* x, const double* v,
                             double* values) const {
  assert(count <= Expression::kBatch);
  std::array<double, Expression::kBatch> y{}, physical_v{};
  for (std::size_t k = 0; k < count; ++k) {
    y[k] = frame_.physical_y(x[k]);
    physical_v[k] = frame_.physical_velocity(v[k]);
  }
  formula_->evaluate_batch(count, y.data(), physical_v.data(), values);
}

std::vector<double> StateFunction::kinks_in_x(double low, double high) const {
  const double first = frame_.physical_y(low), last = frame_.physical_y(high);
  std::vector<double> kinks = formula_->kinks_in_y(std::min(first, last), std::max(first, last));
  for (double& kink : kinks) kink = frame_.wall_x(kink);
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
