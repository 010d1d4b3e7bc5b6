#include "problem/unsupported_features.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <vector>

namespace fpkcheck::problem {
namespace {

using Word = std::string_view;

constexpr Word kFriction[] = {"friction", "coulomb", "stiction"};
constexpr Word kForcing[] = {"forcing", "harmonic", "periodic", "sinusoidal", "frequency"};
constexpr Word kParametric[] = {"parametric", "multiplicative"};
constexpr Word kColoured[] = {"coloured", "colored", "correlation", "bandwidth", "filter"};
constexpr Word kArrivals[] = {"renewal", "arrivals", "interarrival", "levy"};
constexpr Word kDegrees[] = {"dof", "freedom", "coupling", "oscillators"};
constexpr Word kMemory[] = {"hysteresis", "delay", "fractional"};
constexpr Word kForce[] = {"force", "potential", "expression"};
constexpr Word kSoftWalls[] = {"contact", "compliance", "moving"};
constexpr Word kPassage[] = {"passage", "survival", "reliability", "exceedance"};
constexpr Word kSpectrum[] = {"spectrum", "spectra", "psd", "autocorrelation"};
constexpr Word kSensitivity[] = {"sensitivity", "sensitivities"};

constexpr UnsupportedFeature kAll[] = {{"dry friction", kFriction},
                                       {"harmonic forcing", kForcing},
                                       {"parametric excitation", kParametric},
                                       {"coloured noise", kColoured},
                                       {"impulses other than a Poisson process", kArrivals},
                                       {"two or more degrees of freedom", kDegrees},
                                       {"hysteresis, delay or fractional damping", kMemory},
                                       {"forces other than polynomials", kForce},
                                       {"soft or moving walls", kSoftWalls},
                                       {"first passages", kPassage},
                                       {"spectra", kSpectrum},
                                       {"sensitivities", kSensitivity}};

}  // namespace

std::span<const UnsupportedFeature> unsupported_features() { return kAll; }

std::string unsupported_feature_message(std::string_view name) {
  std::vector<std::string> parts;
  const std::string lower = boost::algorithm::to_lower_copy(std::string(name));
  boost::algorithm::split(parts, lower, boost::algorithm::is_any_of("._-"));
  for (const auto& [subject, words] : kAll) {
    const bool is_named = std::ranges::find_first_of(parts, words) != parts.end();
    if (is_named) {
      return fmt::format(
          "the program does not treat {}; `fpkcheck --help` and README.md list such features",
          subject);
    }
  }
  return "";
}

}  // namespace fpkcheck::problem
