#include "mcs/stream.hpp"

#include <cmath>

#include "mcs/flight.hpp"
#include "mcs/impulse_source.hpp"
#include "mcs/trajectory.hpp"

namespace fpkcheck::mcs {
namespace {

/// Watches a trajectory: samples at even times, impacts and impulses as they come.
class Recorder {
 public:
  Recorder(const Plan& plan, StreamRecord& record)
      : record_(record), interval_(plan.sampling_interval), until_sample_(interval_ / 2) {}

  void flight(const Flight& flight, double duration) {
    for (; until_sample_ < duration; until_sample_ += interval_) sample(flight.at(until_sample_));
    until_sample_ -= duration;
  }

  void impact(double velocity) {
    ++record_.impacts;
    record_.impact_energy_flux += velocity * velocity;
  }

  void impulse(double velocity, double amplitude) {
    ++record_.impulses;
    work_ += amplitude * (velocity + amplitude / 2);  // (v + Y)^2/2 - v^2/2
  }

  /// Work that the impulses have done.
  double work() const { return work_; }

  /// From sums to averages.
  void finish(double time) {
    auto& [y1, y2, y4, v1, v2, v4] = record_.moments;
    for (double* sum : {&y1, &y2, &y4, &v1, &v2, &v4}) *sum /= static_cast<double>(samples_);
    record_.impact_energy_flux /= time;
  }

 private:
  void sample(const State& state) {
    const auto& [y, v] = state;
    const double y2 = y * y, v2 = v * v;
    record_.moments.y1 += y;
    record_.moments.y2 += y2;
    record_.moments.y4 += y2 * y2;
    record_.moments.v1 += v;
    record_.moments.v2 += v2;
    record_.moments.v4 += v2 * v2;
    // A sample within rounding of an impact may lie beyond the wall by as much.
    record_.histogram.add(std::max(y, 0.0), v);
    ++samples_;
  }

  StreamRecord& record_;
  double interval_;
  double until_sample_;
  double work_ = 0;
  std::uint64_t samples_ = 0;
};

/// The Gaussian of (z, z') folded by paper (5): y = |z|, y' = z' sgn z.
State initial_state(const Plan& plan, ImpulseSource& source) {
  const double z = plan.displacement_deviation * source.standard_normal();
  const double z_dot = plan.velocity_deviation * source.standard_normal();
  return {std::abs(z), std::copysign(1.0, z) * z_dot};
}

}  // namespace

StreamRecord run_stream(const problem::Problem& problem, const Plan& plan, std::uint32_t index) {
  ImpulseSource source(problem.impulses, plan.seed, index);
  const State start = initial_state(plan, source);
  Trajectory trajectory(problem.system, source, start, plan.step);
  NoWitness no_witness;
  trajectory.advance(plan.burn_in, no_witness);

  StreamRecord record{.histogram = Histogram(plan.y_bins, plan.v_bins), .moments = {}};
  Recorder recorder(plan, record);
  const double time = plan.stream_time();
  trajectory.advance(time, recorder);
  recorder.finish(time);

  // Impulses come independently of the motion before them, so that their work sum (v Y + Y^2/2) has
  // the expectation lambda int (E[Y] E[v] + E[Y^2]/2) dt; and E[v] = 0, since int v dt is the
  // change of y, which impacts leave alone.
  const double expected = problem.impulses.intensity() / 2 * time;
  record.excess_power = (recorder.work() - expected) / time;
  return record;
}

}  // namespace fpkcheck::mcs
