#include "mcs/impulses/excitation.hpp"

#include <cmath>
#include <type_traits>
#include <variant>
#include <vector>

#include "mcs/impulses/standard_amplitude.hpp"
#include "problem/excitation.hpp"

namespace fpkcheck::mcs {
namespace {

template <class... Laws>
std::variant<Laws...> one_of(AmplitudeLawList<Laws...>);
static_assert(std::is_same_v<decltype(one_of(AmplitudeLaws())), problem::ImpulseLaw::LawVariant>,
              "a law without a StandardAmplitude, or in another order");

int law_index(const problem::ImpulseLaw::LawVariant& law) { return static_cast<int>(law.index()); }

// Returns the atoms of an amplitude law, and the intervals on which its density is linear.
template <class Law>
std::vector<AmplitudeHistogramInterval> amplitude_intervals(const Law& law) {
  std::vector<AmplitudeHistogramInterval> ranges;
  for (const auto& [amplitude, probability] : law.amplitude_atoms()) {
    ranges.push_back({.from = amplitude, .to = amplitude, .probability = probability});
  }
  const auto ends = law.amplitude_density_breakpoints();
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const double first = law.density(ends[k]), last = law.density(ends[k + 1]);
    ranges.push_back({.from = ends[k],
                      .to = ends[k + 1],
                      .probability = (ends[k + 1] - ends[k]) * (first + last) / 2,
                      .first_density = first,
                      .last_density = last});
  }
  return ranges;
}

// Returns the quantile function of an amplitude law with AmplitudeByQuantileFunction; null for
// other amplitude laws.
std::shared_ptr<const PiecewiseQuantileFunction> make_quantile_function(
    const problem::ImpulseLaw::LawVariant& law) {
  return std::visit(
      []<class Law>(const Law& kind) -> std::shared_ptr<const PiecewiseQuantileFunction> {
        if constexpr (std::is_base_of_v<AmplitudeByQuantileFunction, StandardAmplitude<Law>>) {
          if constexpr (requires { kind.standardised_quantile(0.5, 0.5); }) {
            return std::make_shared<const PiecewiseQuantileFunction>(interpolate_quantile_function(
                [&](double p, double q) { return kind.standardised_quantile(p, q); }));
          } else {
            return std::make_shared<const PiecewiseQuantileFunction>(
                quantile_function_of_intervals(amplitude_intervals(kind.standardised())));
          }
        } else {
          return {};
        }
      },
      law);
}

ImpulseProcess periodic_gaussian_excitation(double interval, double mean, double variance,
                                            double power) {
  return {.arrivals = ImpulseProcess::Arrivals::even,
          .interval = interval,
          .law = law_index(problem::GaussianLaw{}),
          .mean = mean,
          .width = std::sqrt(variance),
          .power = power,
          .shift = mean,
          .work = (variance + mean * mean) / (2 * interval)};
}

}  // namespace

ImpulseProcess poisson_impulse_process(const problem::ImpulseTrain& impulses) {
  const auto& law = impulses.amplitude_law().law_variant();
  return {.arrivals = ImpulseProcess::Arrivals::poisson,
          .interval = 1 / impulses.arrival_rate(),
          .law = law_index(law),
          .mean = impulses.amplitude_law().mean(),
          .width = std::visit([](const auto& kind) { return kind.width_parameter(); }, law),
          .power = impulses.intensity() / 2,
          .shift = 0,
          .work = impulses.intensity() / 2,
          .pieces = make_quantile_function(law)};
}

ImpulseProcess white_noise_impulse_process(const problem::ImpulseTrain& impulses, double interval) {
  return periodic_gaussian_excitation(interval, impulses.rate_times_moment(1) * interval,
                                      impulses.intensity() * interval, impulses.intensity() / 2);
}

ImpulseProcess standard_normal_number_process() {
  return periodic_gaussian_excitation(1, 0, 1, 0.5);
}

}  // namespace fpkcheck::mcs
