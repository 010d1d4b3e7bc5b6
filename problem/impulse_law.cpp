#include "problem/impulse_law.hpp"

#include <fmt/format.h>

#include <boost/math/distributions/normal.hpp>
#include <cmath>

#include "problem/input_error.hpp"

namespace fpkcheck::problem {
namespace {

std::array<double, kMomentCount> moments_of(const GaussianLaw& law) {
  const double variance = law.deviation * law.deviation;
  std::array<double, kMomentCount> moments{1.0, law.mean};
  for (int j = 2; j < kMomentCount; ++j) {
    // Stein: E[Y^j] = m E[Y^(j-1)] + (j-1) s^2 E[Y^(j-2)]
    moments[j] = law.mean * moments[j - 1] + (j - 1) * variance * moments[j - 2];
  }
  return moments;
}

void validate(const GaussianLaw& law) {
  if (!std::isfinite(law.mean) || !std::isfinite(law.deviation) || law.deviation <= 0) {
    throw InputError(fmt::format(
        "gaussian impulse law with mean {} and deviation {} (the deviation must be positive)",
        law.mean, law.deviation));
  }
}

}  // namespace

ImpulseLaw::ImpulseLaw(const Kind& kind) : kind_(kind) {
  std::visit([](const auto& law) { validate(law); }, kind_);
  moments_ = std::visit([](const auto& law) { return moments_of(law); }, kind_);
}

std::string_view ImpulseLaw::name() const {
  struct Name {
    std::string_view operator()(const GaussianLaw&) const { return "gaussian"; }
  };
  return std::visit(Name{}, kind_);
}

double ImpulseLaw::density(double amplitude) const {
  struct Density {
    double y;
    double operator()(const GaussianLaw& law) const {
      return boost::math::pdf(boost::math::normal(law.mean, law.deviation), y);
    }
  };
  return std::visit(Density{amplitude}, kind_);
}

}  // namespace fpkcheck::problem
