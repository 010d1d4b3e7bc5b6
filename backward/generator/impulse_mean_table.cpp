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

// Returns the atoms of the impulse law, and the amplitudes at which the density of the law, or the
// derivative of the density, is discontinuous. A break u of a spline B causes breaks of the mean K
// B at the velocities u minus the amplitudes of atoms and discontinuities of the law.
std::vector<double> break_amplitudes(const GaussianLaw&) { return {}; }
std::vector<double> break_amplitudes(const LaplaceLaw& law) {
  return law.mean == 0 ? std::vector<double>{} : std::vector{law.mean};
}
std::vector<double> break_amplitudes(const TwoPointLaw& law) {
  return {law.mean - law.deviation, law.mean + law.deviation};
}
std::vector<double> break_amplitudes(const UniformLaw& law) {
  return {law.mean - law.half_width, law.mean + law.half_width};
}

std::vector<double> break_amplitudes(const ExponentialLaw& law) { return {law.mean - law.scale}; }

// Returns the largest length of a piece of the velocity axis with accurate tabulated polynomials.
// The largest length of a piece is small relative to the scale of the amplitude density.
double max_piece_length(const GaussianLaw& law) { return 0.8 * law.deviation; }
double max_piece_length(const LaplaceLaw& law) { return 0.6 * law.scale; }
double max_piece_length(const ExponentialLaw& law) { return 0.6 * std::abs(law.scale); }
double max_piece_length(const TwoPointLaw& law) { return 2 * law.deviation; }
double max_piece_length(const UniformLaw& law) { return law.half_width; }

// Returns the central moment E[(Y - E[Y])^n] of the impulse amplitude Y. For symmetric laws the
// formulas of central moments hold only for even n.
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

// An amplitude law with guaranteed enclosures of its moments and of E[B(v + Y)] for splines B.
template <class Law>
concept LawWithEnclosures = requires(const Law& law, const ImpactSplineBasis& basis) {
  central_moment(law, 0);
  tabulate_impulse_means(law, basis, {});
};

[[noreturn]] void throw_unsupported(std::string_view law) {
  throw std::logic_error(
      fmt::format("law {}: no interval enclosures; check has_interval_enclosures() first", law));
}

}  // namespace

bool has_interval_enclosures(const problem::ImpulseLaw& law) {
  return std::visit([]<class Law>(const Law&) { return LawWithEnclosures<Law>; },
                    law.law_variant());
}

VelocityPieceConstraints velocity_piece_constraints(const ImpactSplineBasis& basis,
                                                    const problem::ImpulseLaw& law) {
  VelocityPieceConstraints constraints;
  const auto amplitudes = std::visit(
      [&]<class Law>(const Law& kind) -> std::vector<double> {
        if constexpr (LawWithEnclosures<Law>) {
          constraints.max_length = max_piece_length(kind);
          return break_amplitudes(kind);
        } else {
          throw_unsupported(Law::kName);
        }
      },
      law.law_variant());
  for (const double amplitude : amplitudes) {
    for (const double v : basis_break_velocities(basis))
      constraints.break_velocities.push_back(v - amplitude);
  }
  std::sort(constraints.break_velocities.begin(), constraints.break_velocities.end());
  return constraints;
}

PostImpulseMeanTable compute_impulse_mean_table(const ImpactSplineBasis& basis,
                                                const std::vector<VelocityAxisPiece>& pieces,
                                                const problem::ImpulseLaw& law) {
  return std::visit(
      [&]<class Law>(const Law& kind) -> PostImpulseMeanTable {
        if constexpr (LawWithEnclosures<Law>) {
          return tabulate_impulse_means(kind, basis, pieces);
        } else {
          throw_unsupported(Law::kName);
        }
      },
      law.law_variant());
}

numerics::Interval enclose_amplitude_moment(const problem::ImpulseLaw& law, int n) {
  return std::visit(
      [n, symmetric = law.is_symmetric()]<class Law>(const Law& kind) -> numerics::Interval {
        if constexpr (LawWithEnclosures<Law>) {
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

PostImpulseMeanTable make_zero_impulse_mean_table(const ImpactSplineBasis& basis,
                                                  const std::vector<VelocityAxisPiece>& pieces,
                                                  int coefficient_count) {
  PostImpulseMeanTable table{basis.size(), coefficient_count, {}, 0};
  table.coefficients.assign(
      pieces.size() * static_cast<std::size_t>(basis.size() * coefficient_count),
      numerics::Interval(0));
  return table;
}

}  // namespace fpkcheck::backward
