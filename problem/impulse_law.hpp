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

/// Number of moments of the impulse amplitude that summaries hold: E[Y^0] .. E[Y^6].
inline constexpr int kMomentCount = 7;

/// The law of an impulse amplitude Y of the Poisson train, paper (3). A further law is a file in
/// problem/laws, one more alternative of Kind, and how to draw from it (mcs/impulses).
class ImpulseLaw {
 public:
  using Kind = std::variant<GaussianLaw, LaplaceLaw, TwoPointLaw, UniformLaw, ExponentialLaw,
                            GammaLaw, TabulatedLaw>;

  /// @throws InputError when the mean is not finite or the width is not a positive number
  explicit ImpulseLaw(const Kind& kind);

  /// Names of all laws, as case files have them.
  static std::vector<std::string> known();
  /// The law of a name with a mean and a standard deviation.
  /// @throws InputError as above, where the law has no such shape, and listing the known names when
  /// there is no such law
  static ImpulseLaw named(std::string_view name, double mean, double deviation,
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
  /// Whether Y - E[Y] and E[Y] - Y have one law.
  bool symmetric() const;

  /// The law is a continuous part with this density, and atoms. A law without a continuous part
  /// has the density 0.
  double density(double amplitude) const;
  /// P(Y <= amplitude).
  double cumulative(double amplitude) const;
  /// The values that Y takes with a positive probability, increasing; none for a law with a
  /// density.
  std::vector<Atom> atoms() const;
  /// Increasing break points. Between neighbours the density is smooth; less than 1e-18 of the
  /// probability lies outside. None for a law without a density.
  std::vector<double> smooth_pieces() const;

  /// E[exp(i u Y)].
  std::complex<double> characteristic_function(double u) const;
  /// E[exp(u Y)]; infinite where the expectation does not exist (laplace: |u| >= 1/scale).
  double moment_generating_function(double u) const;

 private:
  Kind kind_;
  std::array<double, kMomentCount> moments_;
};

}  // namespace fpkcheck::problem
