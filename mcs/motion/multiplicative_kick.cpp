#include "mcs/motion/multiplicative_kick.hpp"

#include <algorithm>
#include <cmath>

#include "mcs/motion/dormand_prince.hpp"
#include "mcs/motion/scalar_events.hpp"
#include "problem/noise_factor.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr int kMostPoints = static_cast<int>(problem::Expression::kBatchPoints);
// Tolerance of the error of an integration step of the flow dv/ds = g(y, v), relative to the
// velocity v. The errors of the kicks have random signs, so that the sum of the errors over a decay
// time of 1000 kicks remains below 1e-5 of the velocity.
constexpr double kKickTolerance = 1e-7;
// Shortest integration step, relative to the duration of the flow dv/ds = g(y, v). The integration
// uses the shortest step only at jumps of the noise factor g or of the slope of g, and where g is
// not finite.
constexpr double kShortestPart = 1.0 / 1024;

}  // namespace

void advance_along_noise_flow(const problem::NoiseFactor& factor, int count, const double* y,
                              double* v, const double* s, double velocity_scale,
                              double* g_at_start) {
  using namespace dormand_prince;
  const auto points = static_cast<std::size_t>(count);
  factor.evaluate_batch(points, y, v, g_at_start);
  if (!factor.depends_on_v()) {
    for (int i = 0; i < count; ++i) v[i] += s[i] * g_at_start[i];
    return;
  }
  double step[kMostPoints]{}, done[kMostPoints]{}, k[kStages][kMostPoints]{}, at[kMostPoints]{};
  std::copy_n(s, count, step);
  std::copy_n(g_at_start, count, k[0]);
  for (bool open = true; open;) {
    for (int stage = 1; stage < kStages; ++stage) {
      for (int i = 0; i < count; ++i) {
        double slope = 0;
        for (int j = 0; j < stage; ++j) slope += kStage[stage][j] * k[j][i];
        at[i] = v[i] + step[i] * slope;
      }
      factor.evaluate_batch(points, y, at, k[stage]);
    }
    open = false;
    for (int i = 0; i < count; ++i) {
      double error = 0;
      for (int j = 0; j < kStages; ++j) error += kError[j] * k[j][i];
      const bool is_accurate =
          std::abs(step[i] * error) <= kKickTolerance * (velocity_scale + std::abs(v[i]));
      if (!is_accurate && std::abs(step[i]) > kShortestPart * std::abs(s[i])) {
        step[i] /= 2;
      } else {
        v[i] = at[i];
        k[0][i] = k[kStages - 1][i];
        done[i] += step[i];
        step[i] = std::isfinite(v[i]) ? s[i] - done[i] : 0;
      }
      open = open || step[i] != 0;
    }
  }
}

void evaluate_noise_factor(const NoiseKicks& kicks, int count, const double* y, const double* v,
                           double* g) {
  kicks.factor->evaluate_batch(static_cast<std::size_t>(count), y, v, g);
}

void apply_multiplicative_kicks(const StreamMotionParameters& motion,
                                TrajectoryStream* const* streams, int count) {
  const NoiseKicks& kicks = motion.kicks;
  double y[kMostPoints]{}, v[kMostPoints]{}, s[kMostPoints]{}, g[kMostPoints]{},
      next[kMostPoints]{}, variance[kMostPoints]{};
  for (int i = 0; i < count; ++i) {
    const TrajectoryBranch& b = streams[i]->branch;
    const double diffusion = kicks.diffusion * noise_intensity_factor(motion, b);
    next[i] = time_to_next_kick(motion, diffusion, b.y, b.v);
    variance[i] = 2 * diffusion * (b.kick_interval + next[i]) / 2;
    s[i] = std::sqrt(variance[i]) * streams[i]->noise.next_normal();
    y[i] = b.y;
    v[i] = b.v;
  }
  advance_along_noise_flow(*kicks.factor, count, y, v, s, kicks.velocity_scale, g);
  for (int i = 0; i < count; ++i) {
    TrajectoryStream& stream = *streams[i];
    TrajectoryBranch& b = stream.branch;
    const double before = b.v;
    b.v = v[i];
    b.time_to_rest = -1;
    count_turning_point(motion, stream, before, b.v);
    if (motion.records) {
      // The terms of first and second order in the work of a multiplicative kick have the
      // expectation 0 for any motion.
      stream.record.work += g[i] * before * s[i] + g[i] * g[i] * (s[i] * s[i] - variance[i]) / 2;
    }
    b.time_to_kick = next[i];
    b.kick_interval = next[i];
  }
}

}  // namespace fpkcheck::mcs
