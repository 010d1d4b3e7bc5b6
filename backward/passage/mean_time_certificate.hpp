#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "base/process/stopwatch.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// The oscillator y'' + c y' + k y + mu y^3 = 0 with a wall at y = 0, the barrier b, and Gaussian
/// impulses with mean 0.
struct ImpactOscillator {
  double damping, stiffness, cubic, restitution;
  double arrival_rate, deviation;  ///< rate and standard deviation of the impulses
  double barrier;

  double spring_force(double y) const { return y * (stiffness + cubic * y * y); }
  double potential(double y) const { return y * y * (stiffness / 2 + cubic * y * y / 4); }
};

/// Squared speed z(s) along the trajectory that grazes the barrier, as a function of s = sqrt(b -
/// y). The outgoing arc (v > 0) ends at the barrier at rest; the incoming arc (v < 0) precedes the
/// impact before the outgoing arc. With the sign sigma = 1 on the outgoing arc and -1 on the
/// incoming arc, z' = 4 s (g(b - s^2) + sigma c sqrt(z)).
class GrazingArc {
 public:
  /// Integrates from the barrier, z(0) = 0.
  static GrazingArc outgoing(const ImpactOscillator& oscillator);
  /// Integrates from the wall, where the speed is that of the outgoing arc divided by r.
  static GrazingArc incoming(const ImpactOscillator& oscillator, const GrazingArc& outgoing);

  /// Returns the speed sqrt(z(s)) for 0 <= s <= sqrt(b).
  double speed(double s) const;
  double smallest_speed() const;
  double largest_speed() const;

 private:
  GrazingArc(const ImpactOscillator& oscillator, int sign);
  double slope(double s, double z) const;
  double runge_kutta_step(double s, double z, double step) const;

  static constexpr int kIntervals = 20000;  // of equal length in s
  ImpactOscillator oscillator_;
  int sign_;
  double s_max_;
  std::vector<double> z_, slopes_;  // at the ends of the intervals
};

/// The two arcs of the grazing trajectory.
struct GrazingTrajectory {
  explicit GrazingTrajectory(const ImpactOscillator& oscillator)
      : outgoing(GrazingArc::outgoing(oscillator)),
        incoming(GrazingArc::incoming(oscillator, outgoing)) {}
  GrazingArc outgoing, incoming;
};

/// Parts of the phase plane below the barrier. A motion without impulses passes the barrier from
/// the exit regions, and never from the trapped regions. Each region has the coordinates s = sqrt(b
/// - y) and eta, where a(s) is the speed on the outgoing and A(s) on the incoming grazing arc:
///
///     trapped_down  v = -eta A(s),  0 <= eta <= 1        trapped_up  v = eta a(s),  0 <= eta <= 1
///     exit_down     v = -sqrt((eta / r)^2 + A(s)^2)      exit_up     v = sqrt(eta^2 + a(s)^2)
///
/// The impact at y = 0 preserves eta.
enum Region { trapped_down, trapped_up, exit_down, exit_up };
inline constexpr std::array kRegions = {trapped_down, trapped_up, exit_down, exit_up};
inline bool is_trapped_region(Region region) {
  return region == trapped_down || region == trapped_up;
}
inline bool is_incoming_region(Region region) {
  return region == trapped_down || region == exit_down;
}

/// Returns the velocity at the coordinates (s, eta) of a region.
double region_velocity(const ImpactOscillator& oscillator, const GrazingTrajectory& grazing,
                       Region region, double s, double eta);

/// Piecewise bicubic function of (s, eta) with continuous first derivatives (Hermite form).
struct PiecewiseBicubicFunction {
  std::vector<double> s_knots, eta_knots;
  /// Value, d/ds, d/deta and d^2/(ds deta) at the knots, shape (s knots, eta knots)
  Eigen::MatrixXd value, s_slope, eta_slope, mixed_slope;
};

/// Function V on the phase plane below the barrier, with V(0, r u) = V(0, -u), V continuous at v =
/// 0, and V = 0 at the barrier for v > 0. V is an approximate mean time to the passage, plus or
/// minus a small allowance for the errors of the approximation.
struct MeanPassageTimeCertificate {
  bool is_upper;
  std::array<PiecewiseBicubicFunction, 4> regions;  ///< in the order of Region
};

/// Computes the certificates of the upper and the lower bound. The result is empty if the deadline
/// passes.
std::optional<std::array<MeanPassageTimeCertificate, 2>> compute_mean_time_certificates(
    const problem::Problem& problem, const ImpactOscillator& oscillator,
    const base::Deadline& deadline);

/// Result of the verification of a certificate.
struct VerifiedPassageTimeBound {
  bool is_proved = false;
  double bound = 0;  ///< bound of the mean passage time from rest
};

/// Verifies the inequality of docs/functionals.md for a certificate and the generator of an
/// oscillator, and computes the bound that follows. The bound is not proved if the inequality fails
/// on at least one rectangle or if the deadline passes.
/// @param refinement factor by which the rectangles are smaller than with the factor 1
VerifiedPassageTimeBound verify_certificate(const MeanPassageTimeCertificate& certificate,
                                            const ImpactOscillator& oscillator, double refinement,
                                            const base::Deadline& deadline);

}  // namespace fpkcheck::backward
