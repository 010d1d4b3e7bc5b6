#include "problem/impulse_law.hpp"

#include <fmt/format.h>

#include <boost/math/distributions/laplace.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/uniform.hpp>
#include <boost/math/special_functions/binomial.hpp>
#include <boost/math/special_functions/factorials.hpp>
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

// E[((Y - mean) / deviation)^(2n)]; the odd ones are zero.
// (2n-1)!!
double standardised_moment(const GaussianLaw&, int n) {
  return n == 0 ? 1 : boost::math::double_factorial<double>(static_cast<unsigned>(2 * n - 1));
}
// (2n)! / 2^n
double standardised_moment(const LaplaceLaw&, int n) {
  return boost::math::factorial<double>(static_cast<unsigned>(2 * n)) / std::pow(2.0, n);
}
double standardised_moment(const TwoPointLaw&, int) { return 1; }
// 3^n / (2n+1)
double standardised_moment(const UniformLaw&, int n) { return std::pow(3.0, n) / (2 * n + 1); }

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

// E[Y^j] = sum_n binomial(j, 2n) mean^(j-2n) E[(Y - mean)^(2n)]
template <class Law>
double moment_of(const Law& law, int j) {
  const double variance = deviation_of(law) * deviation_of(law);
  double sum = 0;
  for (int n = 0; 2 * n <= j; ++n) {
    sum += boost::math::binomial_coefficient<double>(j, 2 * n) * std::pow(law.mean, j - 2 * n) *
           standardised_moment(law, n) * std::pow(variance, n);
  }
  return sum;
}

}  // namespace

ImpulseLaw::ImpulseLaw(const Kind& kind) : kind_(kind) {
  std::visit([](const auto& law) { validate(law); }, kind_);
  for (int j = 0; j < kMomentCount; ++j) moments_[j] = moment(j);
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

double ImpulseLaw::moment(int order) const {
  return std::visit([&](const auto& law) { return moment_of(law, order); }, kind_);
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
