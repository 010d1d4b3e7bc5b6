#include "problem/impulse_law.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <boost/math/special_functions/binomial.hpp>
#include <boost/mp11/algorithm.hpp>
#include <cmath>
#include <optional>

#include "base/input_error.hpp"

namespace fpkcheck::problem {
namespace {

template <class Law>
void require_valid_law(const Law& law) {
  const double deviation = law.standard_deviation();
  if (std::isfinite(law.mean) && std::isfinite(deviation) && deviation > 0) return;
  throw InputError(
      fmt::format("{0} impulse law with mean {1} and {2} {3}: the {2} must be positive, and both "
                  "must be finite",
                  Law::kName, law.mean, Law::kWidthName, law.width_parameter()));
}

// Returns the moment E[Y^j] = sum_n binomial(j, n) mean^(j-n) E[(Y - mean)^n].
template <class Law>
double raw_moment(const Law& law, int j) {
  const double variance = law.standard_deviation() * law.standard_deviation();
  double sum = 0;
  for (int n = 0; n <= j; ++n) {
    const double standardised = law.standardised_amplitude_moment(n);
    if (standardised == 0) continue;
    sum += boost::math::binomial_coefficient<double>(j, n) * std::pow(law.mean, j - n) *
           standardised * std::pow(variance, n / 2.0);
  }
  return sum;
}

// An amplitude law that is not symmetric about its mean has a member function
// with_negated_amplitudes(), which returns the law of -Y.
template <class Law>
concept AsymmetricLaw = requires(Law law) {
  law.with_negated_amplitudes();
};
// An amplitude law with shape parameters besides its mean and standard deviation.
template <class Law>
concept LawWithShapeParameters = requires(LawShapeParameters shape) {
  Law::from_moments(0, 1, shape);
};

template <class Law>
Law law_from_moments(double mean, double deviation, const LawShapeParameters& shape) {
  if constexpr (LawWithShapeParameters<Law>) {
    return Law::from_moments(mean, deviation, shape);
  } else {
    if (shape.skewness.value_or(0) != 0) {
      throw InputError(fmt::format(
          "impulse.skewness = {}: impulse.law = {} has no skewness; omit the key, or take "
          "exponential or gamma",
          *shape.skewness, Law::kName));
    }
    return Law::from_moments(mean, deviation);
  }
}

template <class Function>
void for_each_law(const Function& function) {
  // mp_for_each passes a default-constructed value of each law.
  boost::mp11::mp_for_each<ImpulseLaw::LawVariant>(function);
}

}  // namespace

ImpulseLaw::ImpulseLaw(const LawVariant& law) : law_(law) {
  std::visit([](const auto& alternative) { require_valid_law(alternative); }, law_);
  for (int j = 0; j < kMomentCount; ++j) moments_[j] = moment(j);
}

std::vector<std::string> ImpulseLaw::law_names() {
  std::vector<std::string> list;
  for_each_law([&](const auto& law) { list.emplace_back(law.kName); });
  return list;
}

ImpulseLaw ImpulseLaw::from_name(std::string_view name, double mean, double deviation,
                                 const LawShapeParameters& shape) {
  if (!shape.table.empty() && name != TabulatedLaw::kName) {
    throw InputError(fmt::format(
        "impulse.table beside impulse.law = {}: this law has no table; omit the key, or set "
        "impulse.law = tabulated",
        name));
  }
  std::optional<LawVariant> kind;
  for_each_law([&]<class Law>(const Law&) {
    if (Law::kName == name) kind = law_from_moments<Law>(mean, deviation, shape);
  });
  if (kind) return ImpulseLaw(*kind);
  throw InputError(
      fmt::format("impulse.law = '{}' (must be one of {})", name, fmt::join(law_names(), ", ")));
}

ImpulseLaw ImpulseLaw::with_negated_amplitudes() const {
  return std::visit(
      []<class Law>(Law law) {
        if constexpr (AsymmetricLaw<Law>) {
          return ImpulseLaw(law.with_negated_amplitudes());
        } else {
          law.mean = -law.mean;
          return ImpulseLaw(law);
        }
      },
      law_);
}

std::string_view ImpulseLaw::name() const {
  return std::visit([](const auto& law) { return law.kName; }, law_);
}

double ImpulseLaw::moment(int order) const {
  return std::visit([&](const auto& law) { return raw_moment(law, order); }, law_);
}

double ImpulseLaw::mean() const {
  return std::visit([](const auto& law) { return law.mean; }, law_);
}

double ImpulseLaw::amplitude_standard_deviation() const {
  return std::visit([](const auto& law) { return law.standard_deviation(); }, law_);
}

double ImpulseLaw::skewness() const {
  return std::visit([](const auto& law) { return law.standardised_amplitude_moment(3); }, law_);
}

bool ImpulseLaw::is_symmetric() const {
  return std::visit([]<class Law>(const Law&) { return !AsymmetricLaw<Law>; }, law_);
}

double ImpulseLaw::density(double amplitude) const {
  return std::visit([&](const auto& law) { return law.density(amplitude); }, law_);
}

double ImpulseLaw::cumulative_probability(double amplitude) const {
  return std::visit([&](const auto& law) { return law.cumulative_probability(amplitude); }, law_);
}

std::vector<AmplitudeAtom> ImpulseLaw::amplitude_atoms() const {
  return std::visit([](const auto& law) { return law.amplitude_atoms(); }, law_);
}

std::vector<double> ImpulseLaw::amplitude_density_breakpoints() const {
  return std::visit([](const auto& law) { return law.amplitude_density_breakpoints(); }, law_);
}

}  // namespace fpkcheck::problem
