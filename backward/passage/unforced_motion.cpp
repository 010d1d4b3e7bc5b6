#include "backward/passage/unforced_motion.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <limits>

#include "numerics/quadrature/gauss_rule.hpp"
#include "numerics/roots/bracketed_root.hpp"

namespace fpkcheck::backward {
namespace {

constexpr unsigned kPoints = 8;  // number of points of the Gauss rule of a panel

const std::vector<numerics::QuadraturePoint>& unit_gauss_points() {
  static const auto points = numerics::composite_gauss_points<kPoints>(0, 1, 1);
  return points;
}

// Returns the times at which a parabola is 0, the time nearest to t = 0 first. The parabola is
// given by its value and its derivatives at t = 0.
std::array<std::complex<double>, 2> roots_of_parabola(double value, double slope,
                                                      double second_derivative) {
  const std::complex<double> root =
      std::sqrt(std::complex(slope * slope - 2 * second_derivative * value));
  const std::complex<double> sum = -slope - (slope >= 0 ? root : -root);
  const std::complex<double> a = second_derivative == 0 ? HUGE_VAL : sum / second_derivative;
  const std::complex<double> b = sum == 0.0 ? std::complex(HUGE_VAL) : 2 * value / sum;
  return std::abs(a) < std::abs(b) ? std::array{a, b} : std::array{b, a};
}

}  // namespace

UnforcedMotionSolver::UnforcedMotionSolver(const problem::System& system, double barrier,
                                           double displacement_scale, double velocity_scale,
                                           double panel_refinement, BarrierKind barrier_kind)
    : system_(system),
      barrier_(barrier),
      barrier_kind_(barrier_kind),
      displacement_scale_(displacement_scale),
      velocity_scale_(velocity_scale),
      panel_refinement_(panel_refinement) {
  assert(!system.left_wall() || system.left_wall()->position < barrier);
  assert(system.has_polynomial_force() && velocity_scale > 0 && panel_refinement > 0);
}

PhaseState UnforcedMotionSolver::TaylorPanel::state_at(double time) const {
  PhaseState state{y_coefficients[kTaylorOrder], 0};
  for (int k = kTaylorOrder - 1; k >= 0; --k) {
    state.v = state.v * time + state.y;
    state.y = state.y * time + y_coefficients[static_cast<std::size_t>(k)];
  }
  return state;
}

// Returns the coefficients y_k of y(t) = sum y_k t^k. The equation of motion gives y_(k+2) from the
// coefficients up to k + 1 of the powers of y and of v.
std::array<double, UnforcedMotionSolver::kTaylorOrder + 1>
UnforcedMotionSolver::taylor_coefficients(const PhaseState& start) const {
  constexpr std::size_t kMostPowers = 6;
  using Series = std::array<double, kTaylorOrder + 1>;
  const numerics::Polynomial& force = system_.restoring_force();
  const numerics::Polynomial& damping = system_.damping_polynomial();
  const double rayleigh = system_.rayleigh_coefficient();
  const auto powers = static_cast<std::size_t>(std::max(force.degree(), damping.degree()));
  assert(powers < kMostPowers);
  std::array<Series, kMostPowers> power{};  // power[n]: series of y^n
  Series v{}, v_squared{}, v_cubed{}, damping_series{};
  power[0][0] = 1;
  Series& y = power[1];
  y[0] = start.y;
  y[1] = start.v;
  const auto product = [](const Series& a, const Series& b, std::size_t k) {
    double even = 0, odd = 0;  // two sums have shorter chains of dependent additions than one
    std::size_t m = 0;
    for (; m < k; m += 2) {
      even += a[m] * b[k - m];
      odd += a[m + 1] * b[k - m - 1];
    }
    return m == k ? even + odd + a[k] * b[0] : even + odd;
  };
  for (std::size_t k = 0; k + 2 <= kTaylorOrder; ++k) {
    v[k] = static_cast<double>(k + 1) * y[k + 1];
    double acceleration = -force.coefficient(0) * power[0][k] - force.coefficient(1) * y[k];
    damping_series[k] = damping.coefficient(0) * power[0][k] + damping.coefficient(1) * y[k];
    for (std::size_t n = 2; n <= powers; ++n) {
      power[n][k] = product(power[n - 1], y, k);
      acceleration -= force.coefficient(n) * power[n][k];
      damping_series[k] += damping.coefficient(n) * power[n][k];
    }
    acceleration -=
        damping.degree() == 0 ? damping_series[0] * v[k] : product(damping_series, v, k);
    if (rayleigh != 0) {
      v_squared[k] = product(v, v, k);
      v_cubed[k] = product(v_squared, v, k);
      acceleration -= rayleigh * v_cubed[k];
    }
    y[k + 2] = acceleration / static_cast<double>((k + 1) * (k + 2));
  }
  return y;
}

// Returns the longest duration of a panel in which states and integrands are smooth functions of
// time.
UnforcedMotionSolver::PanelLimit UnforcedMotionSolver::find_taylor_panel_limit(
    const PhaseState& start, int direction) const {
  // A Gauss rule with 8 points has an error of about (w h / 4)^16 for the frequency w.
  constexpr double kMaxPhase = 0.8, kMaxVelocityChange = 1.5, kMaxDisplacement = 0.5,
                   kTiny = 1e-300;
  const double a = acceleration(start);
  const double frequency = std::sqrt(std::abs(system_.force_slope_in_y(start.y, start.v))) +
                           std::abs(system_.force_slope_in_v(start.y, start.v));
  double longest = std::min(kMaxPhase / (frequency + kTiny),
                            kMaxVelocityChange * velocity_scale_ / (std::abs(a) + kTiny));
  longest = std::min(longest, kMaxDisplacement * displacement_scale_ / (std::abs(start.v) + kTiny));
  longest /= panel_refinement_;
  const double refinement = std::max(1.0, panel_refinement_);
  // Backward in time only the state is used, which is a smooth function of time everywhere. Only
  // integrands contain sqrt(barrier - y).
  if (direction < 0 || std::isinf(barrier_)) return {longest, false};
  // A parabola approximates barrier - y as a function of time. Its roots are approximate passages
  // of the barrier, in the past or in the future.
  constexpr double kDistanceFraction = 0.7, kTurningTimeFraction = 0.5, kSeparationRatio = 4,
                   kMinFraction = 1e-5;
  const auto [near, far] = roots_of_parabola(barrier_ - start.y, -start.v, -a);
  const bool is_separated = near.imag() == 0 && std::abs(far) > kSeparationRatio * std::abs(near);
  // As a function of sqrt(barrier - y) the velocity is not smooth at the turning point between the
  // roots.
  const double smooth = (is_separated ? kTurningTimeFraction * std::abs(near + far) / 2
                                      : kDistanceFraction * std::abs(near)) /
                        refinement;
  return {std::min(longest, std::max(smooth, kMinFraction * longest)), is_separated};
}

UnforcedMotionSolver::TaylorPanel UnforcedMotionSolver::compute_next_taylor_panel(
    const PhaseState& start, double max_duration, int direction) const {
  TaylorPanel panel;
  panel.y_coefficients = taylor_coefficients(start);
  const PanelLimit limit = find_taylor_panel_limit(start, direction);
  panel.is_smooth_in_square_root = limit.is_smooth_in_square_root;
  // The last two terms of the series of v estimate its truncation error.
  constexpr double kTruncation = 1e-14;
  double duration = std::min(max_duration, limit.max_duration);
  for (const int k : {kTaylorOrder - 1, kTaylorOrder}) {
    const double coefficient = k * std::abs(panel.y_coefficients[static_cast<std::size_t>(k)]);
    duration = std::min(duration, std::pow(kTruncation * (std::abs(start.v) + velocity_scale_) /
                                               (coefficient + std::numeric_limits<double>::min()),
                                           1.0 / (k - 1)));
  }
  const auto end_at = [&](double time, PanelEnd kind) {
    panel.duration = time;
    panel.end_state = panel.state_at(time);
    panel.end_kind = kind;
  };
  end_at(direction * duration, PanelEnd::interior);
  const auto end_at_root = [&](const auto& function, PanelEnd kind) {
    // The function may also be 0 at the start of the panel, as the velocity after a turning point.
    constexpr double kFirst = 1e-9;
    const double first = function(start) != 0 ? 0 : kFirst * panel.duration;
    const double last = panel.duration;
    const auto of_time = [&](double time) { return function(panel.state_at(time)); };
    end_at(numerics::bracketed_root(of_time, std::min(first, last), std::max(first, last)), kind);
  };
  // The sign of the acceleration follows from the series. The acceleration computed from the force
  // may have the opposite sign by rounding.
  const double heading = start.v != 0 ? start.v : direction * 2 * panel.y_coefficients[2];
  if (panel.end_state.v * heading < 0) {
    end_at_root([](const PhaseState& at) { return at.v; }, PanelEnd::turning_point);
    panel.end_state.v = 0;
  }
  const auto end_at_displacement = [&](double y, PanelEnd kind) {
    end_at_root([&](const PhaseState& at) { return at.y - y; }, kind);
    panel.end_state.y = y;
  };
  if (start.y != barrier_ && (start.y - barrier_) * (panel.end_state.y - barrier_) <= 0) {
    end_at_displacement(barrier_, PanelEnd::barrier_exit);
  }
  const auto& wall = system_.left_wall();
  if (wall && panel.end_state.y <= wall->position && start.y > wall->position) {
    end_at_displacement(wall->position, PanelEnd::impact);
  }
  return panel;
}

// Returns whether integrands are constant from this state on: at rest, or in impacts of negligible
// speed.
bool UnforcedMotionSolver::is_at_rest(const PhaseState& state) const {
  // Negligible speeds, in units of the velocity scale. The limit for impacts under a force towards
  // the wall is larger, since slow impacts follow one another in short intervals.
  constexpr double kNegligibleSpeed = 1e-7, kNegligibleImpactSpeed = 1e-4;
  const auto& wall = system_.left_wall();
  const double a = acceleration(state);
  const bool is_on_wall = wall && state.y <= wall->position;
  const double speed =
      velocity_scale_ * (is_on_wall && a < 0 ? kNegligibleImpactSpeed : kNegligibleSpeed);
  if (std::abs(state.v) > speed) return false;
  if (is_on_wall && a <= 0) return true;
  // In a stable equilibrium the exact acceleration is 0, but the computed acceleration contains a
  // rounding error.
  const double stiffness = system_.force_slope_in_y(state.y, state.v);
  return stiffness > 0 && system_.force_slope_in_v(state.y, state.v) >= 0
             ? std::abs(a) <= speed * std::sqrt(stiffness)
             : a == 0;
}

// Returns the time in a panel at which the displacement is y, by Newton's method.
// @param guess approximate time, as a fraction of the duration of the panel
// @pre y is monotone in the panel and takes the value y
double UnforcedMotionSolver::find_time_at_displacement(const TaylorPanel& panel, double y,
                                                       double guess) {
  constexpr int kMaxSteps = 8;
  constexpr double kTolerance = 1e-14;
  double time = guess * panel.duration;
  for (int n = 0; n < kMaxSteps; ++n) {
    const PhaseState state = panel.state_at(time);
    const double step = (y - state.y) / state.v;
    time += step;
    if (!(time >= 0 && time <= panel.duration)) break;
    if (std::abs(step) <= kTolerance * panel.duration) return time;
  }
  return numerics::bracketed_root([&](double part) { return panel.state_at(part).y - y; }, 0,
                                  panel.duration);
}

// Appends the quadrature nodes of a panel that begins at the given time. Near the barrier the
// integrands are smooth functions of s = sqrt(barrier - y), and the nodes are those of a Gauss
// rule in s.
// @pre the panel is below the barrier
void UnforcedMotionSolver::append_quadrature_nodes(
    const PhaseState& start, const TaylorPanel& panel, double time,
    std::vector<TrajectoryQuadratureNode>& nodes) const {
  const double s0 = std::sqrt(barrier_ - start.y);
  const double s1 = std::sqrt(barrier_ - panel.end_state.y);
  // While s changes little, a Gauss rule in time has the same accuracy.
  constexpr double kSmallChange = 1.2;
  if (!panel.is_smooth_in_square_root || std::max(s0, s1) < kSmallChange * std::min(s0, s1)) {
    for (const auto& [at, weight] : unit_gauss_points()) {
      nodes.push_back({time + panel.duration * at, panel.duration * weight,
                       panel.state_at(panel.duration * at)});
    }
    return;
  }
  for (const auto& [at, weight] : unit_gauss_points()) {
    const double s = s0 + (s1 - s0) * at;
    const double y = barrier_ - s * s;
    const double t = find_time_at_displacement(panel, y, at);
    const PhaseState state = panel.state_at(t);
    nodes.push_back({time + t, std::abs(2 * s * (s1 - s0) * weight / state.v), state});
  }
}

UnforcedTrajectory UnforcedMotionSolver::compute_trajectory(PhaseState start, double max_duration,
                                                            TrajectoryNodeSelection content) const {
  UnforcedTrajectory trajectory;
  PhaseState state = start;
  double time = 0;
  const auto& wall = system_.left_wall();
  const auto rebound = [&] { state.v = -state.v * wall->restitution_at_speed(-state.v); };
  if (wall && state.y <= wall->position && state.v < 0) rebound();
  while (time < max_duration && !is_at_rest(state)) {
    const TaylorPanel panel = compute_next_taylor_panel(state, max_duration - time, 1);
    if (content == TrajectoryNodeSelection::quadrature_nodes) {
      append_quadrature_nodes(state, panel, time, trajectory.nodes);
    }
    time += panel.duration;
    state = panel.end_state;
    if (panel.end_kind == PanelEnd::barrier_exit) {
      trajectory.passed_barrier = true;
      break;
    }
    if (panel.end_kind == PanelEnd::impact) rebound();
  }
  trajectory.end_state = state;
  trajectory.duration = time;
  return trajectory;
}

// Traces the trajectory that ends in the state `end` backward in time, and calls visit(state,
// panel) for each panel, where the panel begins in the state and extends backward in time.
template <class Visitor>
void UnforcedMotionSolver::visit_taylor_panels_backward(PhaseState end, double max_duration,
                                                        double max_speed,
                                                        const Visitor& visit) const {
  double time = 0;
  const auto& wall = system_.left_wall();
  while (time < max_duration && std::abs(end.v) < max_speed) {
    if (end.v == 0 && acceleration(end) == 0) return;
    if (wall && end.y <= wall->position && end.v >= 0) {
      if (end.v == 0 && acceleration(end) <= 0) return;
      if (end.v > 0) end.v = -problem::speed_before_impact(*wall, end.v);
      if (std::abs(end.v) >= max_speed) return;
    }
    const TaylorPanel panel = compute_next_taylor_panel(end, max_duration - time, -1);
    if (panel.duration == 0) return;
    visit(end, panel);
    time -= panel.duration;
    end = panel.end_state;
    if (panel.end_kind == PanelEnd::barrier_exit && barrier_kind_ == BarrierKind::absorbing) return;
  }
}

std::vector<double> UnforcedMotionSolver::find_backward_crossing_velocities(
    PhaseState end, double y, double max_duration, double max_speed) const {
  std::vector<double> velocities;
  visit_taylor_panels_backward(
      end, max_duration, max_speed, [&](const PhaseState& start, const TaylorPanel& panel) {
        if ((start.y - y) * (panel.end_state.y - y) >= 0) return;
        const double time =
            numerics::bracketed_root([&](double at) { return panel.state_at(at).y - y; },
                                     std::min(0.0, panel.duration), std::max(0.0, panel.duration));
        velocities.push_back(panel.state_at(time).v);
      });
  return velocities;
}

std::vector<double> UnforcedMotionSolver::find_backward_turning_points(PhaseState end,
                                                                       double max_duration,
                                                                       double max_speed) const {
  std::vector<double> displacements;
  visit_taylor_panels_backward(end, max_duration, max_speed,
                               [&](const PhaseState&, const TaylorPanel& panel) {
                                 if (panel.end_kind == PanelEnd::turning_point)
                                   displacements.push_back(panel.end_state.y);
                               });
  return displacements;
}

double UnforcedMotionSolver::find_largest_backward_speed(PhaseState end, double max_duration,
                                                         double max_speed) const {
  double largest = 0;
  visit_taylor_panels_backward(
      end, max_duration, max_speed, [&](const PhaseState& start, const TaylorPanel& panel) {
        largest = std::max({largest, std::abs(start.v), std::abs(panel.end_state.v)});
      });
  return largest;
}

}  // namespace fpkcheck::backward
