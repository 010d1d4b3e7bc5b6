#pragma once

#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "problem/laws/parametric.hpp"
#include "problem/laws/shape_parameters.hpp"
#include "problem/laws/tabulated.hpp"

namespace fpkcheck::problem {

/// Number of moments of the impulse amplitude in summaries: E[Y^0] .. E[Y^6].
inline constexpr int kMomentCount = 7;

/// The law of the impulse amplitude Y of the Poisson impulse train, paper (3). To add a law, write
/// a header in problem/laws, an alternative of the variant type of this class, and a sampler in
/// mcs/impulses.
class ImpulseLaw {
 public:
  using LawVariant = std::variant<GaussianLaw, LaplaceLaw, TwoPointLaw, UniformLaw, ExponentialLaw,
                                  GammaLaw, TabulatedLaw>;

  /// @throws InputError if the mean is not finite or the width is not a positive number
  explicit ImpulseLaw(const LawVariant& kind);

  /// The names of all laws, as written in case files.
  static std::vector<std::string> law_names();
  /// The law with this name, mean and standard deviation.
  /// @throws InputError if the name is unknown (the message lists all names), if the law has no
  /// such shape parameter, if the mean is not finite, or if the width is not a positive number
  static ImpulseLaw from_name(std::string_view name, double mean, double deviation,
                              const LawShapeParameters& shape = {});
  /// The law of -Y.
  ImpulseLaw mirror_image() const;

  /// The name of the law, as written in case files.
  std::string_view name() const;
  const LawVariant& kind() const { return kind_; }

  /// The moment E[Y^order], order >= 0.
  double moment(int order) const;
  /// The moments E[Y^0] .. E[Y^6].
  const std::array<double, kMomentCount>& moments() const { return moments_; }

  double mean() const;
  /// Standard deviation of Y.
  double deviation() const;
  /// The skewness E[(Y - E[Y])^3] / deviation^3.
  double skewness() const;
  /// Whether Y - E[Y] and E[Y] - Y have the same law.
  bool is_symmetric() const;

  /// Density of the continuous part of the law; 0 if the law has no continuous part. The law may
  /// have atoms in addition.
  double density(double amplitude) const;
  /// The probability P(Y <= amplitude).
  double cumulative_probability(double amplitude) const;
  /// The atoms of the law (amplitudes of positive probability), by increasing amplitude. Empty for
  /// a law that has a density.
  std::vector<AmplitudeAtom> atoms() const;
  /// Increasing break points between which the density is smooth. The probability outside the break
  /// points is below 1e-18. Empty for a law without a density.
  std::vector<double> density_breakpoints() const;

 private:
  LawVariant kind_;
  std::array<double, kMomentCount> moments_;
};

}  // namespace fpkcheck::problem
