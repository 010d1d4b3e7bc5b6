#include "exact/law_transforms.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/log1p.hpp>
#include <cmath>
#include <limits>

#include "problem/amplitude_table.hpp"

namespace fpkcheck::exact {
namespace {

using namespace problem;
using Complex = std::complex<double>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The transform E[exp(s (Y - E[Y]))] of each law, for real or imaginary s.
Complex centred_transform(const GaussianLaw& law, Complex s) {
  return std::exp(s * s * law.deviation * law.deviation / 2.0);
}

Complex centred_transform(const LaplaceLaw& law, Complex s) {
  if (std::abs(s.real()) * law.scale >= 1) return kInfinity;
  return 1.0 / (1.0 - s * s * law.scale * law.scale);
}

Complex centred_transform(const TwoPointLaw& law, Complex s) {
  return std::cosh(s * law.deviation);
}

Complex centred_transform(const UniformLaw& law, Complex s) {
  const Complex x = s * law.half_width;
  return x == 0.0 ? 1.0 : std::sinh(x) / x;
}

Complex centred_transform(const ExponentialLaw& law, Complex s) {
  const Complex x = s * law.scale;
  return x.real() < 1 ? std::exp(-x) / (1.0 - x) : kInfinity;
}

// (1 - x)^-k exp(-kx) with x = s deviation skewness/2. The formulas avoid the difference of two
// large phases, and of two large exponents.
Complex centred_transform(const GammaLaw& law, Complex s) {
  const Complex x = s * law.deviation * law.skewness / 2.0;
  const double k = law.gamma_shape(), u = x.imag();
  if (u != 0) return std::polar(std::exp(-k * std::log1p(u * u) / 2), k * (std::atan(u) - u));
  return x.real() < 1 ? std::exp(-k * boost::math::log1pmx(-x.real())) : kInfinity;
}

Complex centred_transform(const TabulatedLaw& law, Complex s) {
  // Over an interval of length 6, the Gauss-Legendre rule with 20 points integrates exp(i x) and
  // exp(x) with only rounding errors.
  constexpr double kSmoothLength = 6;
  using Rule = boost::math::quadrature::gauss<double, 20>;
  const auto& z = law.standard->amplitude;
  const auto& w = law.standard->weight;
  const Complex x = s * law.scale;
  Complex sum = 0;
  for (std::size_t k = 0; k < z.size(); ++k) {
    if (law.standard->kind == AmplitudeTable::WeightType::probability) {
      sum += w[k] * std::exp(x * z[k]);
    } else if (k > 0) {
      const double length = z[k] - z[k - 1];
      const int panels =
          std::max(1, static_cast<int>(std::ceil(length * std::abs(x) / kSmoothLength)));
      const auto integrand = [&](double part) {  // fraction of the piece
        return std::lerp(w[k - 1], w[k], part) * length * std::exp(x * (z[k - 1] + part * length));
      };
      for (double panel = 0; panel < panels; ++panel) {
        sum += Rule::integrate(integrand, panel / panels, (panel + 1) / panels);
      }
    }
  }
  return sum;
}

Complex transform(const ImpulseLaw& law, Complex s) {
  return std::visit([&](const auto& kind) { return centred_transform(kind, s); },
                    law.law_variant());
}

}  // namespace

Complex characteristic_function(const ImpulseLaw& law, double u) {
  return transform(law, {0, u}) * std::polar(1.0, u * law.mean());
}

double moment_generating_function(const ImpulseLaw& law, double u) {
  return transform(law, u).real() * std::exp(u * law.mean());
}

}  // namespace fpkcheck::exact
