#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "base/options/enum_names.hpp"
#include "problem/expression/state_function.hpp"

namespace fpkcheck::problem {

/// Interpretation of an equation with multiplicative noise sqrt(2D) g(y, v) W(t). The
/// interpretations of Ito and Stratonovich differ only if the noise factor g depends on the
/// velocity v.
enum class NoiseInterpretation { ito, stratonovich };
inline constexpr base::EnumEntry<NoiseInterpretation> kInterpretationNames[] = {
    {NoiseInterpretation::ito, "ito"}, {NoiseInterpretation::stratonovich, "stratonovich"}};
constexpr const auto& enumerator_names(NoiseInterpretation) { return kInterpretationNames; }

/// The factor g(y, v) of multiplicative noise sqrt(2D) g W with diffusion coefficient D g^2.
class NoiseFactor {
 public:
  /// @throws InputError for an invalid formula of the noise factor
  NoiseFactor(const std::string& formula, const NamedConstants& constants)
      : g_(Expression::parse(formula, constants, "noise.factor")) {}

  double operator()(double y, double v) const { return g_(y, v); }
  /// Returns the square G = g^2 of the noise factor.
  double squared_noise_factor(double y, double v) const {
    const double g = g_(y, v);
    return g * g;
  }
  /// Returns the derivative dG/dv = 2 g dg/dv of the squared noise factor G.
  double squared_noise_factor_slope_in_v(double y, double v) const {
    const numerics::DualNumber g = g_.with_slope_in_v(y, v);
    return 2 * g.value * g.derivative;
  }
  /// Computes g at `count` <= Expression::kBatchPoints points, faster than by single evaluations.
  void evaluate_batch(std::size_t count, const double* y, const double* v, double* g) const {
    g_.evaluate_batch(count, y, v, g);
  }

  /// Computes the derivative dG/dv = 2 g dg/dv of the squared noise factor at `count` <=
  /// Expression::kBatchPoints points.
  void evaluate_squared_noise_slopes_in_v(std::size_t count, const double* y, const double* v,
                                          double* slopes) const {
    std::array<double, Expression::kBatchPoints> g{};
    g_.evaluate_batch_with_velocity_slopes(count, y, v, g.data(), slopes);
    for (std::size_t k = 0; k < count; ++k) slopes[k] *= 2 * g[k];
  }

  const std::string& formula_text() const { return g_.formula().formula_text(); }
  bool depends_on_v() const { return g_.formula().depends_on_v(); }
  bool has_jumps() const { return g_.formula().has_jumps(); }
  bool has_kinks() const { return g_.formula().has_kinks(); }
  /// Returns the increasing values of y in (low, high) at which the noise factor or its slope
  /// jumps.
  std::vector<double> kinks_in_y(double low, double high) const { return g_.kinks_in_x(low, high); }
  /// Returns the increasing values of v in (low, high) at which the noise factor or its slope
  /// jumps.
  std::vector<double> kinks_in_v(double low, double high) const { return g_.kinks_in_v(low, high); }
  /// Returns the parity of the noise factor g under (y, v) -> (-y, -v) in physical coordinates.
  FunctionParity parity() const { return g_.formula().parity(); }

  NoiseFactor to_wall_coordinates(const WallFrame& frame) const {
    NoiseFactor transformed = *this;
    transformed.g_ = g_.to_wall_coordinates(frame);
    return transformed;
  }

 private:
  StateFunction g_;
};

}  // namespace fpkcheck::problem
