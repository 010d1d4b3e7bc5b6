#include "problem/laws/tabulated_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/input_error.hpp"
#include "problem/amplitude_table.hpp"

namespace fpkcheck::problem {
namespace {

bool table_has_atoms(const TabulatedLaw& law) {
  return law.standard->kind == AmplitudeTable::WeightType::probability;
}

// Returns the moment E[Z^n] of the standardised amplitude Z. The 20-point Gauss rule is exact for
// the integrand, which is a polynomial on each interval of the table.
double expectation_of_power(const AmplitudeTable& table, int n) {
  using Rule = boost::math::quadrature::gauss<double, 20>;
  double sum = 0;
  const auto& z = table.amplitude;
  const auto& w = table.weight;
  for (std::size_t k = 0; k < z.size(); ++k) {
    if (table.kind == AmplitudeTable::WeightType::probability) {
      sum += w[k] * std::pow(z[k], n);
    } else if (k > 0) {
      const double length = z[k] - z[k - 1];
      const auto integrand = [&](double part) {  // part: position in the piece, 0 .. 1
        return std::lerp(w[k - 1], w[k], part) * length * std::pow(z[k - 1] + part * length, n);
      };
      sum += Rule::integrate(integrand, 0, 1);
    }
  }
  return sum;
}

// Returns P(Z <= at) of the standardised amplitude Z if `with_equal` is true, else P(Z < at).
double table_cumulative_probability(const AmplitudeTable& table, double at, bool with_equal) {
  const auto& z = table.amplitude;
  const auto& w = table.weight;
  double sum = 0;
  if (table.kind == AmplitudeTable::WeightType::probability) {
    for (std::size_t k = 0; k < z.size(); ++k) {
      if (z[k] < at || (with_equal && z[k] == at)) sum += w[k];
    }
    return std::min(sum, 1.0);
  }
  for (std::size_t k = 1; k < z.size() && z[k - 1] < at; ++k) {
    const double to = std::min(at, z[k]), part = (to - z[k - 1]) / (z[k] - z[k - 1]);
    sum += (to - z[k - 1]) * (w[k - 1] + std::lerp(w[k - 1], w[k], part)) / 2;
  }
  return std::min(sum, 1.0);
}

}  // namespace

TabulatedLaw TabulatedLaw::from_moments(double mean, double deviation,
                                        const LawShapeParameters& shape) {
  if (shape.table.empty()) {
    throw InputError(
        "impulse.table is missing: impulse.law = tabulated needs a CSV file with the columns "
        "amplitude,probability or amplitude,density");
  }
  if (shape.skewness) {
    throw InputError(fmt::format(
        "impulse.skewness = {}: a tabulated law has the skewness of its table; omit the key",
        *shape.skewness));
  }
  AmplitudeTable table = parse_amplitude_table_literal(shape.table);
  const double centre = table.amplitude_mean(), width = std::sqrt(table.amplitude_variance());
  for (double& y : table.amplitude) y = (y - centre) / width;
  if (table.kind == AmplitudeTable::WeightType::density) {
    for (double& w : table.weight) w *= width;
  }
  return {mean, deviation, std::make_shared<const AmplitudeTable>(std::move(table))};
}

double TabulatedLaw::standard_deviation() const { return std::abs(scale); }

double TabulatedLaw::standardised_amplitude_moment(int n) const {
  if (n <= 2) return n == 1 ? 0 : 1;
  const double sign = scale < 0 && n % 2 != 0 ? -1 : 1;
  return sign * expectation_of_power(*standard, n);
}

double TabulatedLaw::density(double y) const {
  if (table_has_atoms(*this)) return 0;
  const auto& z = standard->amplitude;
  const double at = (y - mean) / scale;
  if (!(at >= z.front() && at <= z.back())) return 0;
  const auto next = std::upper_bound(z.begin() + 1, z.end() - 1, at);
  const auto k = static_cast<std::size_t>(next - z.begin());
  const double part = (at - z[k - 1]) / (z[k] - z[k - 1]);
  return std::lerp(standard->weight[k - 1], standard->weight[k], part) / std::abs(scale);
}

double TabulatedLaw::cumulative_probability(double y) const {
  const double at = (y - mean) / scale;
  return scale > 0 ? table_cumulative_probability(*standard, at, true)
                   : 1 - table_cumulative_probability(*standard, at, false);
}

std::vector<AmplitudeAtom> TabulatedLaw::amplitude_atoms() const {
  std::vector<AmplitudeAtom> atoms;
  if (!table_has_atoms(*this)) return atoms;
  for (std::size_t k = 0; k < standard->amplitude.size(); ++k) {
    atoms.push_back({mean + scale * standard->amplitude[k], standard->weight[k]});
  }
  if (scale < 0) std::ranges::reverse(atoms);
  return atoms;
}

std::vector<double> TabulatedLaw::amplitude_density_breakpoints() const {
  std::vector<double> pieces;
  if (table_has_atoms(*this)) return pieces;
  for (const double z : standard->amplitude) pieces.push_back(mean + scale * z);
  if (scale < 0) std::ranges::reverse(pieces);
  return pieces;
}

}  // namespace fpkcheck::problem
