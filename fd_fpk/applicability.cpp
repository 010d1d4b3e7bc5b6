#include "fd_fpk/applicability.hpp"

#include <cmath>

#include "fd_fpk/characteristics/rest_points.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Returns whether the density equation has a diffusion term, from white noise or from the impulses.
bool has_diffusion(const problem::ProblemFeatures& features, const FiniteVolumeOptions& options) {
  return features.noise || options.equation == DensityEquation::white ||
         options.equation == DensityEquation::km4;
}

// Returns why finite volumes do not resolve a discontinuity of the force in the velocity v; empty
// for supported forces. Without diffusion the oscillator can stick where the force jumps, and the
// stationary law has atoms at such points. With diffusion the density has a kink where the force
// jumps. Finite-volume stencils for a kink of the density exist only on the line v = 0. For 0.1*v +
// 0.3*sign(v - 0.5) + y under white noise of intensity 0.2 the residual of the power balance is 2 %
// after 13 s (`fpkcheck fd`).
std::string unresolved_jump_reason(const problem::Problem& problem, bool has_diffusion) {
  if (!problem.system.has_force_jumps_in_v()) return "";
  if (!has_diffusion) {
    return "the mass can stick where the force jumps in v (sign); smooth it: tanh(v/eps)";
  }
  if (problem.system.has_force_jumps_at_nonzero_v(problem::motion_scales(problem).v_high)) {
    return "finite volumes resolve a jump of the force in v (sign) only at v = 0; use mcs, or smooth "
           "the jump: tanh((v - a)/eps)";
  }
  return "";
}

}  // namespace

std::string unsupported_reason(const problem::Problem& problem,
                               const FiniteVolumeOptions& options) {
  if (problem.impulse_factor && options.equation != DensityEquation::kf &&
      options.equation != DensityEquation::white) {
    return "km4 and km4-pade do not support impulse.factor; use kf or white";
  }
  const auto features = problem::problem_features(problem);
  const bool noise = has_diffusion(features, options);
  // The truncated Kramers-Moyal equation `km4` and the impact condition `delta` act like white
  // noise at the wall. For the paper's oscillator the solver accepts `km4` and `delta`, as in the
  // paper. For the white-noise equation `white` with the exact impact, the discretisation reports
  // an inelastic collapse.
  if (noise && !has_linearised_scales(problem)) {
    std::string collapse = problem::inelastic_collapse_reason(problem, DensityEquation::white);
    if (!collapse.empty()) return collapse;
  }
  if (std::string jump = unresolved_jump_reason(problem, noise); !jump.empty()) return jump;
  if (options.impact != ImpactCondition::map &&
      (features.no_wall || features.two_walls || features.rests_in_contact)) {
    return "impact delta (first order in 1-r): requires one wall without rest in contact; use map";
  }
  // Under white noise every contact with a wall ends at once, so that the stationary law has no
  // atom.
  const bool rests = features.rests_in_contact && !noise;
  if (rests && !can_use_characteristics(options)) {
    return "the mass comes to rest in contact with a wall: only characteristics treat this atom; "
           "use kf and leave out transport, order, nx, nv and origin-refinement";
  }
  if (rests && problem.impulse_factor) {
    return "the mass comes to rest in contact with a wall: finite volumes represent this atom only "
           "for impulses without the factor impulse.factor; use mcs";
  }
  if (rests && !problem.system.has_constant_restitution()) {
    return "the mass comes to rest in contact with a wall: finite volumes represent this atom only "
           "for constant restitution coefficients; use mcs";
  }
  if (rests || options.transport == TransportScheme::characteristics) {
    return noise ? "characteristics: the motion between impulses must be deterministic; use "
                   "transport upwind"
                 : characteristics_unsupported_reason(problem);
  }
  return "";
}

std::optional<FiniteVolumeOptions> options_of_identical_equation(
    const problem::Problem& problem, const FiniteVolumeOptions& options) {
  if (!unsupported_reason(problem, options).empty()) return std::nullopt;
  const auto is_elastic = [](const std::optional<problem::Wall>& wall) {
    return !wall || (wall->has_constant_restitution() && wall->restitution == 1);
  };
  FiniteVolumeOptions identical = options;
  if (!problem.impulses.is_acting()) identical.equation = DensityEquation::kf;
  if (is_elastic(problem.system.left_wall()) && is_elastic(problem.system.right_wall())) {
    identical.impact = ImpactCondition::map;
  }
  return identical;
}

std::string transient_unsupported_reason(const problem::Problem& problem,
                                         const FiniteVolumeOptions& options) {
  const auto features = problem::problem_features(problem);
  if (features.rests_in_contact && !has_diffusion(features, options)) {
    return "the mass comes to rest in contact with a wall: finite volumes over time do not "
           "represent this atom; compute the stationary density, or use mcs";
  }
  // The finite-volume stencils at a jump of the force in v depend on the excitation. The
  // Fokker-Planck operator is therefore not linear in the time-dependent factors of the excitation.
  if (problem.time.is_acting() && problem.system.has_force_jumps_in_v()) {
    return "the force jumps in v (sign) and the excitation changes in time; smooth the jump: "
           "tanh(v/eps)";
  }
  return unsupported_reason(problem, options);
}

bool can_use_characteristics(const FiniteVolumeOptions& options) {
  return options.equation == DensityEquation::kf && options.impact == ImpactCondition::map &&
         options.transport != TransportScheme::upwind && !options.nx && !options.nv &&
         !options.origin_refinement && transport_order(options) == kDefaultOrder;
}

namespace {

// Returns whether the damping force supplies energy to the motion at some point of the phase plane.
// If a formula gives the damping force, the sign of the damping force is tested at points of the
// phase plane.
bool has_negative_damping(const problem::Problem& problem) {
  const problem::System& system = problem.system;
  if (system.has_polynomial_force()) return problem::problem_features(problem).negative_damping;
  constexpr int kIntervals = 60;
  const problem::MotionScales scales = problem::motion_scales(problem);
  for (int i = 0; i <= kIntervals; ++i) {
    const double y = scales.y_low + (scales.y_high - scales.y_low) * i / kIntervals;
    for (int j = -kIntervals; j <= kIntervals; ++j) {
      const double v = scales.v_high * j / kIntervals;
      // Relative rounding error of the static force, which damping_force() subtracts
      constexpr double kRounding = 1e-12;
      const double rounding = kRounding * std::abs(v * system.force(y, 0));
      if (v * system.damping_force(y, v) < -rounding) return true;
    }
  }
  return false;
}

// Returns the reason why transport along characteristics is unsuitable for motion without a wall.
// Without a wall, the motion circles a rest point or a limit cycle until an impulse arrives; only
// strong contraction of the flow limits the number of characteristics that circle at different
// amplitudes.
std::string unsupported_circling_reason(const problem::Problem& problem,
                                        const DeterministicFlow& flow) {
  if (!find_rest_points(flow).empty()) {
    return "characteristics start at walls: the problem has no wall; use transport upwind";
  }
  if (contraction_rate_of_attractors(flow) <= problem.impulses.arrival_rate()) {
    return "characteristics without a wall: impulses are too frequent for the contraction along the "
           "limit cycle; use transport upwind";
  }
  return "";
}

}  // namespace

std::string characteristics_unsupported_reason(const problem::Problem& problem) {
  if (!problem.system.has_constant_restitution()) {
    return "characteristics need constant restitution coefficients; use transport upwind";
  }
  if (problem.impulse_factor) {
    return "characteristics do not support impulse.factor; use transport upwind";
  }
  const auto features = problem::problem_features(problem);
  if (features.noise || !features.impulses) {
    return "characteristics: impulses alone must excite the oscillator; use transport upwind";
  }
  const DeterministicFlow flow(problem.system);
  if (features.no_wall) return unsupported_circling_reason(problem, flow);
  if (has_negative_damping(problem)) {
    return "characteristics must end at rest points: the damping of the problem increases "
           "the energy";
  }
  const auto points = find_rest_points(flow);
  if (points.empty())
    return "characteristics must end at rest points: the problem has no rest point";
  for (const RestPoint& point : points) {
    if (!point.contact && flow.contraction_rate({point.y, 0}) <= 0) {
      return "characteristics must end at rest points: an equilibrium of the problem is undamped";
    }
  }
  return "";
}

bool has_rest_in_contact(const problem::Problem& problem, const FiniteVolumeOptions& options) {
  return problem::problem_features(problem).rests_in_contact &&
         options.equation == DensityEquation::kf;
}

}  // namespace fpkcheck::fd_fpk
