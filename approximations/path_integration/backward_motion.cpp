#include "approximations/path_integration/backward_motion.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "numerics/roots/bracketed_root.hpp"

namespace fpkcheck::path_integration {
namespace {

struct MotionState {
  double y, v;
  double log_growth;
};

MotionState advance_linearly(const MotionState& state, const MotionState& rate, double time) {
  return {state.y + time * rate.y, state.v + time * rate.v,
          state.log_growth + time * rate.log_growth};
}

// Rates with respect to the reversed time s = -t: y_s = -v, v_s = f(y, v), and the density
// p(x(0), 0) exp(int df/dv ds) is constant.
MotionState reversed_rate(const problem::System& system, const MotionState& state) {
  return {-state.v, system.force(state.y, state.v), system.force_slope_in_v(state.y, state.v)};
}

MotionState runge_kutta_step(const problem::System& system, const MotionState& state, double step) {
  const MotionState a = reversed_rate(system, state);
  const MotionState b = reversed_rate(system, advance_linearly(state, a, step / 2));
  const MotionState c = reversed_rate(system, advance_linearly(state, b, step / 2));
  const MotionState d = reversed_rate(system, advance_linearly(state, c, step));
  const auto mean = [](double p, double q, double r, double s) {
    return (p + 2 * q + 2 * r + s) / 6;
  };
  return advance_linearly(state,
                          {mean(a.y, b.y, c.y, d.y), mean(a.v, b.v, c.v, d.v),
                           mean(a.log_growth, b.log_growth, c.log_growth, d.log_growth)},
                          step);
}

// Replaces the state after an impact by the state before. With the speeds u before and w = u r(u)
// after an impact, the flux u p(u) du = w p(w) dw gives p(w) = p(u) u / (w dw/du).
void reverse_impact(const problem::Wall& wall, MotionState& state) {
  const double after = std::abs(state.v);
  const double before = problem::speed_before_impact(wall, after);
  double slope = wall.restitution;
  if (!wall.has_constant_restitution()) {
    constexpr double kRelativeStep = 1e-6;
    const auto speed_after = [&](double u) { return u * wall.restitution_at_speed(u); };
    slope =
        (speed_after(before * (1 + kRelativeStep)) - speed_after(before * (1 - kRelativeStep))) /
        (2 * kRelativeStep * before);
  }
  state = {wall.position, std::copysign(before, -state.v),
           state.log_growth + std::log(before / (after * slope))};
}

}  // namespace

EarlierState earlier_state(const problem::System& system, double y, double v, double duration,
                           double max_step) {
  assert(duration > 0 && max_step > 0);
  MotionState state{y, v, 0};
  double remaining = duration;
  // Near a state of rest at a wall, the number of impacts in a finite time is not bounded. The
  // remaining motion is then shorter than a rounding error.
  constexpr int kMaxImpacts = 1000;
  for (int impacts = 0; remaining > 0 && impacts < kMaxImpacts;) {
    const double step =
        remaining / std::ceil(remaining / max_step * (1 - 1e-12));  // equal steps to the end
    const MotionState next = runge_kutta_step(system, state, step);
    const auto& [left, right] = system.walls();
    const bool hits_left = left && next.y < left->position;
    if (!hits_left && !(right && next.y > right->position)) {
      state = next;
      remaining -= step;
      continue;
    }
    ++impacts;
    const problem::Wall& wall = hits_left ? *left : *right;
    const double inward = hits_left ? 1 : -1;
    const double gap = inward * (state.y - wall.position);
    const double leaving_speed = -inward * state.v;
    if (gap > 0 || leaving_speed > 0) {
      // The distance from the wall, divided by the time if the motion starts at the wall.
      const auto distance = [&](double time) {
        if (time == 0) return gap > 0 ? gap : leaving_speed;
        const double at_time = inward * (runge_kutta_step(system, state, time).y - wall.position);
        return gap > 0 ? at_time : at_time / time;
      };
      const double time = numerics::bracketed_root(distance, 0.0, step);
      state = runge_kutta_step(system, state, time);
      remaining -= time;
    }
    if (inward * state.v <= 0) break;  // rest at the wall
    reverse_impact(wall, state);
  }
  return {state.y, state.v, std::exp(state.log_growth)};
}

}  // namespace fpkcheck::path_integration
