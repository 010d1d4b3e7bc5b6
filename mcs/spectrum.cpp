#include "mcs/spectrum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <utility>

#include "base/process/parallel_for.hpp"
#include "base/process/stopwatch.hpp"
#include "mcs/applicability.hpp"
#include "mcs/estimate/kick_interval_error.hpp"
#include "mcs/estimate/stream_averages.hpp"
#include "mcs/estimate/stream_weights.hpp"
#include "mcs/simulation/simulation.hpp"
#include "mcs/simulation/simulation_plan.hpp"
#include "numerics/chebyshev_interpolation.hpp"
#include "problem/motion_scales.hpp"

namespace fpkcheck::mcs {
namespace {

using transform::Status;
constexpr double kPi = std::numbers::pi;

// Ratio of the Nyquist frequency of the samples to the largest requested frequency. If the spectral
// density decreases as w^-4 with the frequency w, the alias at the largest requested frequency is
// 3e-5 of the spectral density (alias_density()).
constexpr double kOversampling = 8;
// Length of the periodogram segments, in decay times of the slowest mode. At the spectral peak of a
// lightly damped oscillator, whose half-width is the decay rate, Hann's window with segments of
// kLength decay times lowers the spectral density by 4 pi^2/(3 kLength^2), 0.13 %.
constexpr double kLength = 100;
constexpr std::size_t kShortest = 256, kLongest = 1 << 18;  // samples of a segment
// Default simulated time in segment lengths, for standard errors of about 1.5 %
constexpr double kSegments = 2500;
constexpr int kFewestRounds = 4;  // a round has half of the samples of a segment
// Largest number of impulses, kicks and flights of the default simulation, about 8 s of computing.
// Recording a sample takes the computing time of kEventsPerSample events of the motion.
constexpr double kMostSpectrumEvents = 4e7, kEventsPerSample = 0.25;

// Periodogram of a segment of n samples: squared magnitudes of the windowed Fourier transform, as a
// one-sided spectral density at the frequencies 2 pi k / (segment length), k = 0 .. n/2.
class Periodogram {
 public:
  Periodogram(std::size_t samples, double interval) : samples_(samples), interval_(interval) {
    for (std::size_t k = 0; k < samples; ++k) {
      const double s =
          std::sin(kPi * (static_cast<double>(k) + 0.5) / static_cast<double>(samples));
      window_.push_back(s * s);
      window_power_ += window_.back() * window_.back();
    }
    factor_ = interval / (kPi * window_power_);
    fft_.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  }

  std::size_t sample_count() const { return samples_; }
  double sampling_interval() const { return interval_; }
  double frequency_step() const { return 2 * kPi / (static_cast<double>(samples_) * interval_); }

  /// Returns the Fourier transform of a spectral density at the frequencies of the periodogram: the
  /// autocovariance at the lags 0, 1 .. sample_count() - 1, in sampling intervals, times the
  /// autocorrelation of Hann's window.
  std::vector<double> windowed_covariance(const std::vector<double>& density) {
    std::vector<std::complex<double>> half(density.begin(), density.end());
    std::vector<double> covariance;
    fft_.inv(covariance, half, static_cast<Eigen::Index>(samples_));
    for (double& r : covariance) r *= kPi / interval_;
    return covariance;
  }
  /// Returns the autocorrelation of Hann's window at a lag in sampling intervals.
  double window_autocorrelation(std::size_t lag) const {
    double sum = 0;
    for (std::size_t k = 0; k + lag < samples_; ++k) sum += window_[k] * window_[k + lag];
    return sum / window_power_;
  }

  /// Returns the windowed spectral density of the constant signal 1 at the frequency with index k.
  double density_of_constant(std::size_t k) const {
    const auto n = static_cast<double>(samples_);
    return k == 0 ? factor_ * n * n / 4 : k == 1 ? factor_ * n * n / 16 : 0;
  }

  /// Adds the spectral density of a segment, after subtraction of `mean`, to `sums`.
  void add_segment(const double* segment, double mean, std::vector<double>& sums) {
    windowed_.resize(samples_);
    for (std::size_t k = 0; k < samples_; ++k) windowed_[k] = window_[k] * (segment[k] - mean);
    fft_.fwd(transformed_, windowed_);
    sums.resize(transformed_.size());
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += factor_ * std::norm(transformed_[k]);
  }

 private:
  std::size_t samples_;
  double interval_;
  double window_power_ = 0;  // sum of the squares of the window
  double factor_;
  std::vector<double> window_, windowed_;
  std::vector<std::complex<double>> transformed_;
  Eigen::FFT<double> fft_;
};

// Interpolates a spectral density linearly between the frequencies of a periodogram.
double interpolate_density(const std::vector<double>& density, double step, double frequency) {
  const auto k = std::min(static_cast<std::size_t>(frequency / step), density.size() - 2);
  const double weight = frequency / step - static_cast<double>(k);
  return (1 - weight) * density[k] + weight * density[k + 1];
}

struct StreamSpectrum {
  // Sums of periodograms over segments of the whole length, and of half the length
  std::vector<double> whole = {}, half = {};
  std::size_t segments = 0;
};

// Adds the periodograms of the complete segments of a time series to the sums, and removes the
// samples that no later segment needs. Each segment of a time series begins in the middle of the
// previous segment.
void add_complete_segments(std::size_t length, double centre, Periodogram& whole, Periodogram& half,
                           std::vector<double>& series, StreamSpectrum& spectrum) {
  std::size_t begin = 0;
  for (; begin + length <= series.size(); begin += length / 2) {
    whole.add_segment(&series[begin], centre, spectrum.whole);
    half.add_segment(&series[begin], centre, spectrum.half);
    half.add_segment(&series[begin + length / 2], centre, spectrum.half);
    ++spectrum.segments;
  }
  series.erase(series.begin(), series.begin() + static_cast<std::ptrdiff_t>(begin));
}

// Returns the alias, at the frequency w, of a signal with the spectral density C w^-4 and the
// Nyquist frequency n: the sum of the spectral densities at the frequencies 2 k n - w and 2 k n +
// w.
double alias_density(double c, double nyquist, double w) {
  double sum = 0;
  for (int k = 1; k <= 4; ++k) {
    sum += std::pow(2 * k * nyquist - w, -4) + std::pow(2 * k * nyquist + w, -4);
  }
  return c * sum;
}

double mean_of_series(Simulation& simulation) {
  double sum = 0, samples = 0;
  for (std::size_t s = 0; s < simulation.trajectory_streams().size(); ++s) {
    for (const double y : simulation.displacement_series(s)) sum += y;
    samples += static_cast<double>(simulation.displacement_series(s).size());
  }
  return sum / samples;
}

// Sets the autocovariance at lags up to a quarter of the segment length: the Fourier transform of
// the averaged periodograms, divided by the autocorrelation of Hann's window. Cubic polynomials
// interpolate the autocovariance between the sampled lags. The error of the autocovariance contains
// the part of the variance above the Nyquist frequency, from the decrease C w^-4 of the spectral
// density of y.
// @param constant function of k: spectral density of the constant E[y] - centre at frequency k
// @param tail constant C of the decrease C w^-4
template <class Constant>
void add_autocovariance(const std::vector<double>& lags, Periodogram& periodogram,
                        const std::vector<StreamSpectrum>& sums, const Constant& constant,
                        const TrajectoryStreamWeights& weights, double tail, double nyquist,
                        transform::SpectralDensity& spectrum) {
  constexpr std::size_t kNodes = 4;
  const bool of_y = spectrum.variable == transform::StateVariable::y;
  const double step = periodogram.frequency_step();
  std::vector<std::vector<double>> covariances;  // of each stream, with the window
  for (const StreamSpectrum& s : sums) {
    std::vector<double> density(s.whole.size());
    for (std::size_t k = 0; k < density.size(); ++k) {
      const double w = step * static_cast<double>(k);
      density[k] =
          (s.whole[k] / static_cast<double>(s.segments) - constant(k)) * (of_y ? 1 : w * w);
    }
    covariances.push_back(periodogram.windowed_covariance(density));
  }
  // The integral over w of C w^-2 cos(w t), or of C w^-4 cos(w t), above the Nyquist frequency is
  // at most its value at t = 0, and at most twice the first term of an integration by parts.
  const double at_nyquist = std::abs(tail) * std::pow(nyquist, of_y ? -4 : -2);
  const auto beyond_nyquist = [&](double t) {
    return at_nyquist * std::min(nyquist / (of_y ? 3 : 1), 2 / t);
  };
  for (const double lag : lags) {
    const double at = lag / periodogram.sampling_interval();
    if (at > static_cast<double>(periodogram.sample_count()) / 4) break;
    const auto first = static_cast<std::size_t>(std::max(0.0, std::floor(at) - 1));
    std::array<double, kNodes> nodes{}, correlations{};
    for (std::size_t a = 0; a < kNodes; ++a) {
      nodes[a] = static_cast<double>(first + a);
      correlations[a] = periodogram.window_autocorrelation(first + a);
    }
    const std::vector<double> interpolation = numerics::lagrange_weights(nodes, at);
    std::vector<double> of_streams;
    for (const auto& covariance : covariances) {
      double value = 0;
      for (std::size_t a = 0; a < kNodes; ++a) {
        value += interpolation[a] * covariance[first + a] / correlations[a];
      }
      of_streams.push_back(value);
    }
    const MeanEstimate e = weights.estimate_mean(of_streams);
    spectrum.lags.push_back(lag);
    spectrum.autocovariance.push_back(e.mean);
    spectrum.autocovariance_error.push_back(std::hypot(e.standard_error, beyond_nyquist(lag)));
  }
}

std::size_t choose_segment_length(double decay_rate, double interval) {
  std::size_t length = kShortest;
  while (length < kLongest && static_cast<double>(length) * interval * decay_rate < kLength) {
    length *= 2;
  }
  return length;
}

// Estimates the spectral density with the interval between noise kicks of a plan.
// @param length number of samples of a segment
// @param nyquist Nyquist frequency of the samples
transform::SpectralDensity estimate_spectrum_with_plan(const problem::Problem& transformed,
                                                       const SimulationPlan& plan,
                                                       const SimulationOptions& options,
                                                       transform::StateVariable variable,
                                                       const std::vector<double>& frequencies,
                                                       const std::vector<double>& lags,
                                                       std::size_t length, double nyquist) {
  transform::SpectralDensity spectrum{.id = solution_id(options), .variable = variable};
  spectrum.frequencies = frequencies;
  spectrum.has_standard_errors = true;
  Simulation simulation(transformed, plan);
  simulation.enable_displacement_recording();
  simulation.run_burn_in();
  const auto streams = static_cast<std::size_t>(plan.streams);
  std::vector<StreamSpectrum> sums(streams);
  double centre = 0;
  for (std::uint64_t round = 0; round < plan.rounds; ++round) {
    simulation.simulate_and_sample_one_round();
    if (round == 0) centre = mean_of_series(simulation);
    base::parallel_for(static_cast<std::size_t>(plan.threads), plan.threads, [&](std::size_t part) {
      Periodogram whole(length, plan.sampling_interval), half(length / 2, plan.sampling_interval);
      for (std::size_t s = part; s < streams; s += static_cast<std::size_t>(plan.threads)) {
        add_complete_segments(length, centre, whole, half, simulation.displacement_series(s),
                              sums[s]);
      }
    });
    if (options.progress) {
      options.progress({static_cast<double>(round + 1) / static_cast<double>(plan.rounds)});
    }
  }

  const TrajectoryStreamWeights weights(excess_impulse_power_per_stream(simulation));
  const auto moment = [&](int p, int q) {
    return weights.estimate_mean(statistic_of_each_stream(
        simulation.trajectory_streams(), [&](const TrajectoryStreamStatistics& record) {
          return moment_in_wall_coordinates(simulation, record, p, q);
        }));
  };
  const bool of_y = variable == transform::StateVariable::y;
  const MeanEstimate first = moment(of_y ? 1 : 0, of_y ? 0 : 1),
                     second = moment(of_y ? 2 : 0, of_y ? 0 : 2);
  spectrum.variance = second.mean - first.mean * first.mean;
  spectrum.variance_error =
      std::hypot(second.standard_error, 2 * first.mean * first.standard_error);

  // Returns the spectral density at a frequency, from periodogram segments of one length. The
  // spectral density of the constant E[y] - centre, which the segments contain, is subtracted.
  const double mean_y = moment(1, 0).mean;
  const auto estimate = [&](double w, const Periodogram& periodogram,
                            std::vector<double> StreamSpectrum::*of, double pieces) {
    const double step = periodogram.frequency_step();
    const std::vector<double> of_constant{periodogram.density_of_constant(0),
                                          periodogram.density_of_constant(1), 0, 0};
    const double subtracted = std::pow(mean_y - centre, 2) *
                              interpolate_density(of_constant, step, std::min(w, 2 * step));
    std::vector<double> values;
    for (const StreamSpectrum& s : sums) {
      const double count = pieces * static_cast<double>(s.segments);
      values.push_back(interpolate_density(s.*of, step, w) / count - subtracted);
    }
    return weights.estimate_mean(values);
  };
  Periodogram of_whole(length, plan.sampling_interval);
  const Periodogram of_half(length / 2, plan.sampling_interval);
  const auto whole = [&](double w) { return estimate(w, of_whole, &StreamSpectrum::whole, 1); };
  // Constant C of the decrease C w^-4, from the spectral density at half the Nyquist frequency
  const double tail = whole(nyquist / 2).mean * std::pow(nyquist / 2, 4);
  for (const double w : frequencies) {
    const MeanEstimate e = whole(w);
    const double of_window = (e.mean - estimate(w, of_half, &StreamSpectrum::half, 2).mean) / 3;
    const double factor = of_y ? 1 : w * w;
    spectrum.density.push_back(factor * e.mean);
    spectrum.error.push_back(
        factor * (std::hypot(e.standard_error, of_window) + alias_density(tail, nyquist, w)));
  }
  add_autocovariance(
      lags, of_whole, sums,
      [&](std::size_t k) { return std::pow(mean_y - centre, 2) * of_whole.density_of_constant(k); },
      weights, tail, nyquist, spectrum);
  const std::size_t segments = sums.front().segments * streams;
  spectrum.details = fmt::format("{} segments of {:.4g}", segments,
                                 static_cast<double>(length) * plan.sampling_interval);
  spectrum.peak = transform::find_spectral_peak(frequencies, spectrum.density);
  return spectrum;
}

// Adds the errors by the interval between noise kicks to the standard errors.
// @param doubled spectral density with twice the interval
// @param order order of the errors in the interval
void add_kick_interval_errors_of_spectrum(const transform::SpectralDensity& doubled, int order,
                                          transform::SpectralDensity& spectrum) {
  spectrum.has_kick_interval_errors = true;
  const auto add = [order](double value, double other, double other_error, double& error) {
    error += kick_interval_error(other - value, std::hypot(error, other_error), order);
  };
  for (std::size_t k = 0; k < spectrum.density.size(); ++k) {
    add(spectrum.density[k], doubled.density[k], doubled.error[k], spectrum.error[k]);
  }
  for (std::size_t k = 0; k < spectrum.autocovariance.size(); ++k) {
    add(spectrum.autocovariance[k], doubled.autocovariance[k], doubled.autocovariance_error[k],
        spectrum.autocovariance_error[k]);
  }
  add(spectrum.variance, doubled.variance, doubled.variance_error, spectrum.variance_error);
}

}  // namespace

transform::SpectralDensity estimate_spectrum(const problem::Problem& problem,
                                             const SimulationOptions& options,
                                             transform::StateVariable variable,
                                             const std::vector<double>& frequencies,
                                             const std::vector<double>& lags) {
  const base::Stopwatch stopwatch;
  transform::SpectralDensity spectrum{.id = solution_id(options), .variable = variable};
  const problem::Problem transformed =
      problem::to_wall_coordinates(problem::wall_frame(problem.system), problem);
  spectrum.reason = unsupported_functional_reason(transformed, options);
  if (!spectrum.reason.empty()) {
    spectrum.status = Status::not_offered;
    return spectrum;
  }
  const problem::MotionScales scales = problem::motion_scales(transformed);
  SimulationPlan plan = make_simulation_plan(transformed, options);
  const double nyquist = kOversampling * std::max(frequencies.back(), scales.frequency);
  plan.sampling_interval = kPi / nyquist;
  const std::size_t length =
      choose_segment_length(scales.slowest_decay_rate, plan.sampling_interval);
  plan.samples_per_round = length / 2;
  const double time = options.time.value_or(
      std::min(kSegments * static_cast<double>(length) * plan.sampling_interval,
               kMostSpectrumEvents /
                   (plan.expected_event_rate + kEventsPerSample / plan.sampling_interval)));
  plan.rounds = static_cast<std::uint64_t>(std::max(
      double{kFewestRounds}, std::ceil(time / (plan.streams * plan.simulated_time_per_round()))));

  spectrum = estimate_spectrum_with_plan(transformed, plan, options, variable, frequencies, lags,
                                         length, nyquist);
  if (auto doubled = plan_with_doubled_kick_interval(transformed, plan)) {
    doubled->rounds = std::max(std::uint64_t{kFewestRounds}, (plan.rounds + 1) / 2);
    add_kick_interval_errors_of_spectrum(
        estimate_spectrum_with_plan(transformed, *doubled, options, variable, frequencies, lags,
                                    length, nyquist),
        order_in_kick_interval(plan), spectrum);
  }
  spectrum.reason = short_burn_in_reason(plan, options);
  constexpr double kShortestLength = 20;  // in decay times
  const double decay_times =
      static_cast<double>(length) * plan.sampling_interval * scales.slowest_decay_rate;
  if (spectrum.reason.empty() && decay_times < kShortestLength) {
    spectrum.reason = fmt::format(
        "the segments have {:.2g} decay times, fewer than {:g}, and do not resolve the peaks; reduce "
        "the largest frequency",
        decay_times, kShortestLength);
  }
  spectrum.status = spectrum.reason.empty() ? Status::ok : Status::not_converged;
  spectrum.seconds = stopwatch.seconds();
  return spectrum;
}

}  // namespace fpkcheck::mcs
