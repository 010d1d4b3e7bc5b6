#include "backward/generator/impulse_mean_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace fpkcheck::backward {
namespace {

using problem::ExponentialLaw;
using problem::GaussianLaw;
using problem::LaplaceLaw;
using problem::TwoPointLaw;
using problem::UniformLaw;

// Returns the atoms of the law, and the amplitudes at which the density of the law, or the
// derivative of the density, is discontinuous.
std::vector<double> kink_offsets(const GaussianLaw&) { return {}; }
std::vector<double> kink_offsets(const LaplaceLaw& law) {
  return law.mean == 0 ? std::vector<double>{} : std::vector{law.mean};
}
std::vector<double> kink_offsets(const TwoPointLaw& law) {
  return {law.mean - law.deviation, law.mean + law.deviation};
}
std::vector<double> kink_offsets(const UniformLaw& law) {
  return {law.mean - law.half_width, law.mean + law.half_width};
}

std::vector<double> kink_offsets(const ExponentialLaw& law) { return {law.mean - law.scale}; }

// Returns the largest length of a piece, short compared with the length scale of the density of the
// law.
double longest_piece(const GaussianLaw& law) { return 0.8 * law.deviation; }
double longest_piece(const LaplaceLaw& law) { return 0.6 * law.scale; }
double longest_piece(const ExponentialLaw& law) { return 0.6 * std::abs(law.scale); }
double longest_piece(const TwoPointLaw& law) { return 2 * law.deviation; }
double longest_piece(const UniformLaw& law) { return law.half_width; }

// Returns the central moment E[(Y - mean)^n]. For symmetric laws the formulas hold only for even n.
numerics::Interval central_moment(const GaussianLaw& law, int n) {
  numerics::Interval m = power(numerics::Interval(law.deviation), n);
  for (int i = n - 1; i > 1; i -= 2) m *= static_cast<double>(i);
  return m;
}
numerics::Interval central_moment(const LaplaceLaw& law, int n) {
  numerics::Interval m = power(numerics::Interval(law.scale), n);
  for (int i = 2; i <= n; ++i) m *= static_cast<double>(i);
  return m;
}
numerics::Interval central_moment(const ExponentialLaw& law, int n) {
  numerics::Interval derangements = 1;
  for (int i = 1; i <= n; ++i) {
    derangements = static_cast<double>(i) * derangements + (i % 2 == 0 ? 1.0 : -1.0);
  }
  return power(numerics::Interval(law.scale), n) * derangements;
}
numerics::Interval central_moment(const TwoPointLaw& law, int n) {
  return power(numerics::Interval(law.deviation), n);
}
numerics::Interval central_moment(const UniformLaw& law, int n) {
  return power(numerics::Interval(law.half_width), n) / static_cast<double>(n + 1);
}

template <class Law>
concept Enclosed = requires(const Law& law, const ImpactBasis& basis) {
  central_moment(law, 0);
  impulse_mean_table_of_law(law, basis, {});
};

[[noreturn]] void throw_unsupported(std::string_view law) {
  throw std::logic_error(
      fmt::format("law {}: no interval enclosures; check has_interval_enclosures() first", law));
}

}  // namespace

bool has_interval_enclosures(const problem::ImpulseLaw& law) {
  return std::visit([]<class Law>(const Law&) { return Enclosed<Law>; }, law.law_variant());
}

VelocityPieceConstraints velocity_piece_constraints(const ImpactBasis& basis,
                                                    const problem::ImpulseLaw& law) {
  VelocityPieceConstraints kinks;
  const auto offsets = std::visit(
      [&]<class Law>(const Law& kind) -> std::vector<double> {
        if constexpr (Enclosed<Law>) {
          kinks.longest = longest_piece(kind);
          return kink_offsets(kind);
        } else {
          throw_unsupported(Law::kName);
        }
      },
      law.law_variant());
  for (const double offset : offsets) {
    for (const double v : velocity_breaks(basis)) kinks.cuts.push_back(v - offset);
  }
  std::sort(kinks.cuts.begin(), kinks.cuts.end());
  return kinks;
}

ImpulseMeanTable impulse_mean_table(const ImpactBasis& basis,
                                    const std::vector<VelocityPiece>& pieces,
                                    const problem::ImpulseLaw& law) {
  return std::visit(
      [&]<class Law>(const Law& kind) -> ImpulseMeanTable {
        if constexpr (Enclosed<Law>) {
          return impulse_mean_table_of_law(kind, basis, pieces);
        } else {
          throw_unsupported(Law::kName);
        }
      },
      law.law_variant());
}

numerics::Interval moment_enclosure(const problem::ImpulseLaw& law, int n) {
  return std::visit(
      [n, symmetric = law.is_symmetric()]<class Law>(const Law& kind) -> numerics::Interval {
        if constexpr (Enclosed<Law>) {
          numerics::Interval sum = 0;
          for (int i = 0; i <= n; i += symmetric ? 2 : 1) {
            sum += numerics::binomial_coefficient(n, i) *
                   power(numerics::Interval(kind.mean), n - i) * central_moment(kind, i);
          }
          return sum;
        } else {
          throw_unsupported(Law::kName);
        }
      },
      law.law_variant());
}

ImpulseMeanTable zero_impulse_mean_table(const ImpactBasis& basis,
                                         const std::vector<VelocityPiece>& pieces, int order) {
  ImpulseMeanTable table{basis.size(), order, {}, 0};
  table.coefficients.assign(pieces.size() * static_cast<std::size_t>(basis.size() * order),
                            numerics::Interval(0));
  return table;
}

}  // namespace fpkcheck::backward
