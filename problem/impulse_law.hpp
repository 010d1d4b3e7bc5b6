#pragma once

#include <array>
#include <complex>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "problem/laws/exponential.hpp"
#include "problem/laws/gamma.hpp"
#include "problem/laws/gaussian.hpp"
#include "problem/laws/laplace.hpp"
#include "problem/laws/shape.hpp"
#include "problem/laws/tabulated.hpp"
#include "problem/laws/two_point.hpp"
#include "problem/laws/uniform.hpp"

namespace fpkcheck::problem {

/// Number of moments of the impulse amplitude that summaries state: E[Y^0] .. E[Y^6].
inline constexpr int kMomentCount = 7;

/// The law of an impulse amplitude Y of the Poisson train, paper (3). To add a law: a file in
/// problem/laws, an alternative of Kind, and a sampler (mcs/impulses).
class ImpulseLaw {
 public:
  using Kind = std::variant<GaussianLaw, LaplaceLaw, TwoPointLaw, UniformLaw, ExponentialLaw,
                            GammaLaw, TabulatedLaw>;

  /// @throws InputError when the mean is not finite or the width is not a positive number
  explicit ImpulseLaw(const Kind& kind);

  /// Names of all laws in case files.
  static std::vector<std::string> known_names();
  /// The law of this name, mean and standard deviation.
  /// @throws InputError as above; where the law has no such shape parameter; or, for an unknown
  /// name, listing all names
  static ImpulseLaw from_name(std::string_view name, double mean, double deviation,
                              const LawShape& shape = {});
  /// The law of -Y.
  ImpulseLaw mirrored() const;

  /// The law's name in case files.
  std::string_view name() const;
  const Kind& kind() const { return kind_; }

  /// E[Y^order], order >= 0.
  double moment(int order) const;
  /// E[Y^0] .. E[Y^6].
  const std::array<double, kMomentCount>& moments() const { return moments_; }

  double mean() const;
  /// Standard deviation of Y.
  double deviation() const;
  /// E[(Y - E[Y])^3] / deviation^3.
  double skewness() const;
  /// Whether Y - E[Y] and E[Y] - Y have the same law.
  bool symmetric() const;

  /// Density of the continuous part of the law, which may have atoms besides; 0 without such a
  /// part.
  double density(double amplitude) const;
  /// P(Y <= amplitude).
  double cumulative(double amplitude) const;
  /// Amplitudes of positive probability, increasing; none for a law that has a density.
  std::vector<Atom> atoms() const;
  /// Increasing break points between which the density is smooth. Less than 1e-18 of the
  /// probability is outside. None for a law without a density.
  std::vector<double> density_breakpoints() const;

  /// E[exp(i u Y)].
  std::complex<double> characteristic_function(double u) const;
  /// E[exp(u Y)]; infinite where the expectation does not exist (laplace: |u| >= 1/scale).
  double moment_generating_function(double u) const;

 private:
  Kind kind_;
  std::array<double, kMomentCount> moments_;
};

}  // namespace fpkcheck::problem
