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

constexpr unsigned kPoints = 8;  // of the Gauss rule of a panel

const std::vector<numerics::QuadraturePoint>& unit_gauss_points() {
  static const auto points = numerics::composite_gauss_points<kPoints>(0, 1, 1);
  return points;
}

// Times at which a parabola vanishes, with its value and derivatives at t = 0; the nearest first.
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

UnforcedMotion::UnforcedMotion(const problem::System& system, double barrier, double velocity_scale,
                               double refinement)
    : system_(system), barrier_(barrier), velocity_scale_(velocity_scale), refinement_(refinement) {
  assert(!system.left_wall() || system.left_wall()->position < barrier);
  assert(system.has_polynomial_force() && velocity_scale > 0 && refinement > 0);
}

PhaseState UnforcedMotion::Panel::at(double time) const {
  PhaseState state{y[kOrder], 0};
  for (int k = kOrder - 1; k >= 0; --k) {
    state.v = state.v * time + state.y;
    state.y = state.y * time + y[static_cast<std::size_t>(k)];
  }
  return state;
}

// Returns the coefficients y_k of y(t) = sum y_k t^k. The equation of motion gives y_(k+2) from the
// coefficients up to k + 1 of the powers of y and of v.
std::array<double, UnforcedMotion::kOrder + 1> UnforcedMotion::taylor_coefficients(
    const PhaseState& from) const {
  constexpr std::size_t kMostPowers = 6;
  using Series = std::array<double, kOrder + 1>;
  const numerics::Polynomial& force = system_.restoring_force();
  const numerics::Polynomial& damping = system_.damping_polynomial();
  const double rayleigh = system_.rayleigh_coefficient();
  const auto powers = static_cast<std::size_t>(std::max(force.degree(), damping.degree()));
  assert(powers < kMostPowers);
  std::array<Series, kMostPowers> power{};  // power[n]: series of y^n
  Series v{}, v_squared{}, v_cubed{}, damping_series{};
  power[0][0] = 1;
  Series& y = power[1];
  y[0] = from.y;
  y[1] = from.v;
  const auto product = [](const Series& a, const Series& b, std::size_t k) {
    double sum = 0;
    for (std::size_t m = 0; m <= k; ++m) sum += a[m] * b[k - m];
    return sum;
  };
  for (std::size_t k = 0; k + 2 <= kOrder; ++k) {
    v[k] = static_cast<double>(k + 1) * y[k + 1];
    double acceleration = -force.coefficient(0) * power[0][k] - force.coefficient(1) * y[k];
    damping_series[k] = damping.coefficient(0) * power[0][k] + damping.coefficient(1) * y[k];
    for (std::size_t n = 2; n <= powers; ++n) {
      power[n][k] = product(power[n - 1], y, k);
      acceleration -= force.coefficient(n) * power[n][k];
      damping_series[k] += damping.coefficient(n) * power[n][k];
    }
    acceleration -= product(damping_series, v, k);
    if (rayleigh != 0) {
      v_squared[k] = product(v, v, k);
      v_cubed[k] = product(v_squared, v, k);
      acceleration -= rayleigh * v_cubed[k];
    }
    y[k + 2] = acceleration / static_cast<double>((k + 1) * (k + 2));
  }
  return y;
}

// Returns the longest panel in which the states and integrands are smooth.
UnforcedMotion::PanelLimit UnforcedMotion::panel_limit(const PhaseState& from,
                                                       int direction) const {
  // A Gauss rule with 8 points has an error of about (w h / 4)^16 for the frequency w.
  constexpr double kPhase = 0.8, kOfVelocityScale = 1.5, kOfWidth = 0.5, kNone = 1e-300;
  const double a = acceleration(from);
  const double frequency = std::sqrt(std::abs(system_.force_slope_in_y(from.y, from.v))) +
                           std::abs(system_.force_slope_in_v(from.y, from.v));
  double longest = std::min(kPhase / (frequency + kNone),
                            kOfVelocityScale * velocity_scale_ / (std::abs(a) + kNone));
  if (const auto& wall = system_.left_wall()) {
    longest =
        std::min(longest, kOfWidth * (barrier_ - wall->position) / (std::abs(from.v) + kNone));
  }
  longest /= refinement_;
  const double refinement = std::max(1.0, refinement_);
  // The state is a smooth function of time everywhere; only integrands have a square root.
  if (direction < 0) return {longest, false};
  // Backward and forward in time, barrier - y vanishes about at the roots of a parabola.
  constexpr double kOfDistance = 0.7, kOfTurningTime = 0.5, kSeparated = 4, kShortest = 1e-5;
  const auto [near, far] = roots_of_parabola(barrier_ - from.y, -from.v, -a);
  const bool is_separated = near.imag() == 0 && std::abs(far) > kSeparated * std::abs(near);
  // In sqrt(barrier - y) the velocity has a square root at the turning point between the roots.
  const double smooth =
      (is_separated ? kOfTurningTime * std::abs(near + far) / 2 : kOfDistance * std::abs(near)) /
      refinement;
  return {std::min(longest, std::max(smooth, kShortest * longest)), is_separated};
}

UnforcedMotion::Panel UnforcedMotion::next_panel(const PhaseState& from, double longest,
                                                 int direction) const {
  Panel panel;
  panel.y = taylor_coefficients(from);
  const PanelLimit limit = panel_limit(from, direction);
  panel.in_square_root = limit.in_square_root;
  // The last two terms of the series of v estimate its truncation error.
  constexpr double kTruncation = 1e-14;
  double duration = std::min(longest, limit.duration);
  for (const int k : {kOrder - 1, kOrder}) {
    const double coefficient = k * std::abs(panel.y[static_cast<std::size_t>(k)]);
    duration = std::min(duration, std::pow(kTruncation * (std::abs(from.v) + velocity_scale_) /
                                               (coefficient + std::numeric_limits<double>::min()),
                                           1.0 / (k - 1)));
  }
  const auto end_at = [&](double time, End kind) {
    panel.duration = time;
    panel.end = panel.at(time);
    panel.kind = kind;
  };
  end_at(direction * duration, End::inside);
  const auto end_at_root = [&](const auto& function, End kind) {
    // The function may vanish at the start too, as the velocity does after a turning point.
    constexpr double kFirst = 1e-9;
    const double first = function(from) != 0 ? 0 : kFirst * panel.duration;
    const double last = panel.duration;
    const auto of_time = [&](double time) { return function(panel.at(time)); };
    end_at(numerics::bracketed_root(of_time, std::min(first, last), std::max(first, last)), kind);
  };
  // The acceleration of the series, since that of the force may have the other sign by rounding
  const double heading = from.v != 0 ? from.v : direction * 2 * panel.y[2];
  if (panel.end.v * heading < 0) {
    end_at_root([](const PhaseState& at) { return at.v; }, End::turning_point);
    panel.end.v = 0;
  }
  const auto end_at_displacement = [&](double y, End kind) {
    end_at_root([&](const PhaseState& at) { return at.y - y; }, kind);
    panel.end.y = y;
  };
  if (from.y != barrier_ && (from.y - barrier_) * (panel.end.y - barrier_) <= 0) {
    end_at_displacement(barrier_, End::exit);
  }
  const auto& wall = system_.left_wall();
  if (wall && panel.end.y <= wall->position && from.y > wall->position) {
    end_at_displacement(wall->position, End::impact);
  }
  return panel;
}

// Returns whether the integrands remain constant: at rest, or in impacts of negligible speed.
bool UnforcedMotion::is_at_rest(const PhaseState& at) const {
  // In units of velocity_scale. Slow impacts under a force towards the wall are so frequent that
  // they must end at a higher speed.
  constexpr double kSpeed = 1e-7, kSpeedOfImpacts = 1e-4;
  const auto& wall = system_.left_wall();
  const double a = acceleration(at);
  const bool is_on_wall = wall && at.y <= wall->position;
  const double speed = velocity_scale_ * (is_on_wall && a < 0 ? kSpeedOfImpacts : kSpeed);
  if (std::abs(at.v) > speed) return false;
  if (is_on_wall && a <= 0) return true;
  // In a stable equilibrium the acceleration is 0, and its rounding error is not.
  const double stiffness = system_.force_slope_in_y(at.y, at.v);
  return stiffness > 0 && system_.force_slope_in_v(at.y, at.v) >= 0
             ? std::abs(a) <= speed * std::sqrt(stiffness)
             : a == 0;
}

// Appends the quadrature points of a panel. Near the barrier the integrands are smooth in s =
// sqrt(barrier - y), and the points are those of a Gauss rule in s.
void UnforcedMotion::append_nodes(const PhaseState& from, const Panel& panel, double time,
                                  std::vector<TimeNode>& nodes) const {
  const double s0 = std::sqrt(barrier_ - from.y);
  const double s1 = std::sqrt(barrier_ - panel.end.y);
  // A rule in time is as accurate while s changes little.
  constexpr double kSmallChange = 1.2;
  if (!panel.in_square_root || std::max(s0, s1) < kSmallChange * std::min(s0, s1)) {
    for (const auto& [at, weight] : unit_gauss_points()) {
      nodes.push_back(
          {time + panel.duration * at, panel.duration * weight, panel.at(panel.duration * at)});
    }
    return;
  }
  for (const auto& [at, weight] : unit_gauss_points()) {
    const double s = s0 + (s1 - s0) * at;
    const double y = barrier_ - s * s;
    const double t = numerics::bracketed_root([&](double part) { return panel.at(part).y - y; }, 0,
                                              panel.duration);
    const PhaseState state = panel.at(t);
    nodes.push_back({time + t, std::abs(2 * s * (s1 - s0) * weight / state.v), state});
  }
}

Motion UnforcedMotion::follow(PhaseState from, double until) const {
  Motion motion;
  double time = 0;
  const auto& wall = system_.left_wall();
  const auto rebound = [&] { from.v = -from.v * wall->restitution_at_speed(-from.v); };
  if (wall && from.y <= wall->position && from.v < 0) rebound();
  while (time < until && !is_at_rest(from)) {
    const Panel panel = next_panel(from, until - time, 1);
    append_nodes(from, panel, time, motion.nodes);
    time += panel.duration;
    from = panel.end;
    if (panel.kind == End::exit) {
      motion.passed_barrier = true;
      break;
    }
    if (panel.kind == End::impact) rebound();
  }
  motion.end = from;
  motion.duration = time;
  return motion;
}

// Follows the motion that ends at a state backwards in time, and calls visit(start, panel) for each
// of its panels.
template <class Visitor>
void UnforcedMotion::trace_back(PhaseState end, double until, double fastest,
                                const Visitor& visit) const {
  double time = 0;
  const auto& wall = system_.left_wall();
  while (time < until && std::abs(end.v) < fastest) {
    if (end.v == 0 && acceleration(end) == 0) return;
    if (wall && end.y <= wall->position && end.v >= 0) {
      if (end.v == 0 && acceleration(end) <= 0) return;
      if (end.v > 0) end.v = -problem::speed_before_impact(*wall, end.v);
      if (std::abs(end.v) >= fastest) return;
    }
    const Panel panel = next_panel(end, until - time, -1);
    if (panel.duration == 0) return;
    visit(end, panel);
    time -= panel.duration;
    end = panel.end;
    if (panel.kind == End::exit) return;
  }
}

std::vector<double> UnforcedMotion::velocities_before(PhaseState end, double y, double until,
                                                      double fastest) const {
  std::vector<double> velocities;
  trace_back(end, until, fastest, [&](const PhaseState& start, const Panel& panel) {
    if ((start.y - y) * (panel.end.y - y) >= 0) return;
    const double time =
        numerics::bracketed_root([&](double at) { return panel.at(at).y - y; },
                                 std::min(0.0, panel.duration), std::max(0.0, panel.duration));
    velocities.push_back(panel.at(time).v);
  });
  return velocities;
}

double UnforcedMotion::largest_speed_before(PhaseState end, double until, double fastest) const {
  double largest = 0;
  trace_back(end, until, fastest, [&](const PhaseState& start, const Panel& panel) {
    largest = std::max({largest, std::abs(start.v), std::abs(panel.end.v)});
  });
  return largest;
}

}  // namespace fpkcheck::backward
