#include "problem/impulse_law.hpp"

#include <fmt/format.h>

#include <boost/math/distributions/laplace.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/uniform.hpp>
#include <boost/math/special_functions/binomial.hpp>
#include <boost/math/special_functions/sinc.hpp>
#include <boost/math/special_functions/sinhc.hpp>
#include <cmath>
#include <limits>

#include "problem/input_error.hpp"

namespace fpkcheck::problem {
namespace {

std::string_view name_of(const GaussianLaw&) { return "gaussian"; }
std::string_view name_of(const LaplaceLaw&) { return "laplace"; }
std::string_view name_of(const TwoPointLaw&) { return "two_point"; }
std::string_view name_of(const UniformLaw&) { return "uniform"; }

void validate(std::string_view name, double mean, const char* width_name, double width) {
  if (!std::isfinite(mean) || !std::isfinite(width) || width <= 0) {
    throw InputError(
        fmt::format("{0} impulse law with mean {1} and {2} {3} (the {2} must be "
                    "positive, and both must be finite)",
                    name, mean, width_name, width));
  }
}
void validate(const GaussianLaw& law) {
  validate(name_of(law), law.mean, "deviation", law.deviation);
}
void validate(const LaplaceLaw& law) { validate(name_of(law), law.mean, "scale", law.scale); }
void validate(const TwoPointLaw& law) {
  validate(name_of(law), law.mean, "deviation", law.deviation);
}
void validate(const UniformLaw& law) {
  validate(name_of(law), law.mean, "half_width", law.half_width);
}

double deviation_of(const GaussianLaw& law) { return law.deviation; }
double deviation_of(const LaplaceLaw& law) { return std::sqrt(2.0) * law.scale; }
double deviation_of(const TwoPointLaw& law) { return law.deviation; }
double deviation_of(const UniformLaw& law) { return law.half_width / std::sqrt(3.0); }

// E[((Y - mean) / deviation)^(2n)], n = 0 .. 3; the odd ones are zero.
using StandardisedMoments = std::array<double, 4>;
// (2n-1)!!
StandardisedMoments standardised_moments(const GaussianLaw&) { return {1, 1, 3, 15}; }
// (2n)! / 2^n
StandardisedMoments standardised_moments(const LaplaceLaw&) { return {1, 1, 6, 90}; }
StandardisedMoments standardised_moments(const TwoPointLaw&) { return {1, 1, 1, 1}; }
// 3^n / (2n+1)
StandardisedMoments standardised_moments(const UniformLaw&) { return {1, 1, 9.0 / 5, 27.0 / 7}; }

double density_of(const GaussianLaw& law, double y) {
  return boost::math::pdf(boost::math::normal(law.mean, law.deviation), y);
}
double density_of(const LaplaceLaw& law, double y) {
  return boost::math::pdf(boost::math::laplace(law.mean, law.scale), y);
}
double density_of(const TwoPointLaw&, double) { return 0; }
double density_of(const UniformLaw& law, double y) {
  return boost::math::pdf(
      boost::math::uniform(law.mean - law.half_width, law.mean + law.half_width), y);
}

std::vector<Atom> atoms_of(const GaussianLaw&) { return {}; }
std::vector<Atom> atoms_of(const LaplaceLaw&) { return {}; }
std::vector<Atom> atoms_of(const TwoPointLaw& law) {
  return {{law.mean - law.deviation, 0.5}, {law.mean + law.deviation, 0.5}};
}
std::vector<Atom> atoms_of(const UniformLaw&) { return {}; }

std::vector<double> pieces_of(const GaussianLaw& law) {
  return {law.mean - 9 * law.deviation, law.mean + 9 * law.deviation};
}
std::vector<double> pieces_of(const LaplaceLaw& law) {
  return {law.mean - 42 * law.scale, law.mean, law.mean + 42 * law.scale};
}
std::vector<double> pieces_of(const TwoPointLaw&) { return {}; }
std::vector<double> pieces_of(const UniformLaw& law) {
  return {law.mean - law.half_width, law.mean + law.half_width};
}

// E[cos(u (Y - mean))]; the sines cancel by symmetry.
double mean_cosine(const GaussianLaw& law, double u) {
  return std::exp(-u * u * law.deviation * law.deviation / 2);
}
double mean_cosine(const LaplaceLaw& law, double u) {
  return 1 / (1 + u * u * law.scale * law.scale);
}
double mean_cosine(const TwoPointLaw& law, double u) { return std::cos(u * law.deviation); }
double mean_cosine(const UniformLaw& law, double u) {
  return boost::math::sinc_pi(u * law.half_width);
}

// E[cosh(u (Y - mean))]
double mean_hyperbolic_cosine(const GaussianLaw& law, double u) {
  return std::exp(u * u * law.deviation * law.deviation / 2);
}
double mean_hyperbolic_cosine(const LaplaceLaw& law, double u) {
  const double ub = std::abs(u) * law.scale;
  return ub < 1 ? 1 / (1 - ub * ub) : std::numeric_limits<double>::infinity();
}
double mean_hyperbolic_cosine(const TwoPointLaw& law, double u) {
  return std::cosh(u * law.deviation);
}
double mean_hyperbolic_cosine(const UniformLaw& law, double u) {
  return boost::math::sinhc_pi(u * law.half_width);
}

template <class Law>
std::array<double, kMomentCount> moments_of(const Law& law) {
  const StandardisedMoments standardised = standardised_moments(law);
  const double variance = deviation_of(law) * deviation_of(law);
  std::array<double, kMomentCount> moments{};
  for (int j = 0; j < kMomentCount; ++j) {
    // E[Y^j] = sum_n binomial(j, 2n) mean^(j-2n) E[(Y - mean)^(2n)]
    for (int n = 0; 2 * n <= j; ++n) {
      moments[j] += boost::math::binomial_coefficient<double>(j, 2 * n) *
                    std::pow(law.mean, j - 2 * n) * standardised[n] * std::pow(variance, n);
    }
  }
  return moments;
}

}  // namespace

ImpulseLaw::ImpulseLaw(const Kind& kind) : kind_(kind) {
  std::visit([](const auto& law) { validate(law); }, kind_);
  moments_ = std::visit([](const auto& law) { return moments_of(law); }, kind_);
}

ImpulseLaw ImpulseLaw::named(std::string_view name, double mean, double deviation) {
  if (name == "gaussian") return ImpulseLaw(GaussianLaw{mean, deviation});
  if (name == "laplace") return ImpulseLaw(LaplaceLaw{mean, deviation / std::sqrt(2.0)});
  if (name == "two_point") return ImpulseLaw(TwoPointLaw{mean, deviation});
  if (name == "uniform") return ImpulseLaw(UniformLaw{mean, deviation * std::sqrt(3.0)});
  throw InputError(fmt::format(
      "impulse.law = {} (not a known law; use gaussian, laplace, two_point or uniform)", name));
}

std::string_view ImpulseLaw::name() const {
  return std::visit([](const auto& law) { return name_of(law); }, kind_);
}

double ImpulseLaw::mean() const {
  return std::visit([](const auto& law) { return law.mean; }, kind_);
}

double ImpulseLaw::deviation() const {
  return std::visit([](const auto& law) { return deviation_of(law); }, kind_);
}

double ImpulseLaw::density(double amplitude) const {
  return std::visit([&](const auto& law) { return density_of(law, amplitude); }, kind_);
}

std::vector<Atom> ImpulseLaw::atoms() const {
  return std::visit([](const auto& law) { return atoms_of(law); }, kind_);
}

std::vector<double> ImpulseLaw::smooth_pieces() const {
  return std::visit([](const auto& law) { return pieces_of(law); }, kind_);
}

std::complex<double> ImpulseLaw::characteristic_function(double u) const {
  return std::visit([&](const auto& law) { return mean_cosine(law, u); }, kind_) *
         std::polar(1.0, u * mean());
}

double ImpulseLaw::moment_generating_function(double u) const {
  return std::visit([&](const auto& law) { return mean_hyperbolic_cosine(law, u); }, kind_) *
         std::exp(u * mean());
}

}  // namespace fpkcheck::problem
