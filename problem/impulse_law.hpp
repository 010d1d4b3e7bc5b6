#pragma once

#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "problem/laws/parametric_laws.hpp"
#include "problem/laws/shape_parameters.hpp"
#include "problem/laws/tabulated_law.hpp"

namespace fpkcheck::problem {

/// Number of stored moments E[Y^k] of the impulse amplitude, k = 0 .. 6.
inline constexpr int kMomentCount = 7;

/// The probability law of the impulse amplitude Y of the Poisson impulse train, paper (3). A new
/// amplitude law needs a header in problem/laws, an alternative of LawVariant, and a sampler in
/// mcs/impulses.
class ImpulseLaw {
 public:
  using LawVariant = std::variant<GaussianLaw, LaplaceLaw, TwoPointLaw, UniformLaw, ExponentialLaw,
                                  GammaLaw, TabulatedLaw>;

  /// @throws InputError if the mean of the law is not finite or the width is not a positive number
  explicit ImpulseLaw(const LawVariant& law);

  /// Returns the names of all amplitude laws, as in the key `impulse.law` of a case file.
  static std::vector<std::string> law_names();
  /// Returns the amplitude law with the given name, mean and standard deviation.
  /// @throws InputError if the name is unknown (the message lists all names), if the law does not
  /// have a given shape parameter, if the mean is not finite, or if the standard deviation is not
  /// positive
  static ImpulseLaw from_name(std::string_view name, double mean, double deviation,
                              const LawShapeParameters& shape = {});
  ImpulseLaw with_negated_amplitudes() const;

  std::string_view name() const;
  const LawVariant& law_variant() const { return law_; }

  double moment(int order) const;
  /// Returns the moments E[Y^k], k = 0 .. 6.
  const std::array<double, kMomentCount>& moments() const { return moments_; }

  double mean() const;
  double amplitude_standard_deviation() const;
  /// Returns the skewness E[(Y - E[Y])^3] / deviation^3 of the amplitude Y.
  double skewness() const;
  /// Returns whether Y - E[Y] and E[Y] - Y have the same law.
  bool is_symmetric() const;

  /// Returns the probability density of the amplitude Y; 0 for a law that consists of atoms.
  double density(double amplitude) const;
  double cumulative_probability(double amplitude) const;
  /// Returns the amplitudes with positive probability, in increasing order; empty for an amplitude
  /// law with a density.
  std::vector<AmplitudeAtom> amplitude_atoms() const;
  /// Returns increasing break points between which the density of the amplitude Y is smooth; empty
  /// for a law without a density. The probability of amplitudes outside the range of the break
  /// points is below 1e-18.
  std::vector<double> amplitude_density_breakpoints() const;

 private:
  LawVariant law_;
  std::array<double, kMomentCount> moments_;
};

}  // namespace fpkcheck::problem
