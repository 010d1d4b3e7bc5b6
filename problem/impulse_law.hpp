#pragma once

#include <array>
#include <string_view>
#include <variant>

namespace fpkcheck::problem {

/// Y ~ N(mean, deviation^2).
struct GaussianLaw {
  double mean;
  double deviation;
};

/// Number of moments of the impulse amplitude that the project keeps: E[Y^0] .. E[Y^6].
inline constexpr int kMomentCount = 7;

/// The law of an impulse amplitude Y of the Poisson train, paper (3). A further law is one more
/// alternative of Kind and one more branch in each function of impulse_law.cpp.
class ImpulseLaw {
 public:
  using Kind = std::variant<GaussianLaw>;

  /// @throws InputError when the deviation is not a positive number
  explicit ImpulseLaw(const Kind& kind);

  /// The law's name in case files.
  std::string_view name() const;
  const Kind& kind() const { return kind_; }

  /// E[Y^order], 0 <= order < kMomentCount.
  double moment(int order) const { return moments_.at(order); }
  const std::array<double, kMomentCount>& moments() const { return moments_; }

  /// Probability density of Y at `amplitude`.
  double density(double amplitude) const;

 private:
  Kind kind_;
  std::array<double, kMomentCount> moments_;
};

}  // namespace fpkcheck::problem
