#pragma once

#include <optional>
#include <string>

#include "base/options/option_description.hpp"
#include "problem/impulse_law.hpp"
#include "problem/noise_factor.hpp"

namespace fpkcheck::problem {

/// Gaussian white noise sqrt(2 D) g(y, v) W(t) as excitation, alone or in addition to the impulses.
struct WhiteNoise {
  double intensity = 0;  ///< intensity 2 D >= 0, comparable with lambda E[Y^2] of impulses
  std::optional<std::string> factor = {};  ///< formula of g (NoiseFactor); if absent, g = 1
  std::optional<NoiseInterpretation> interpretation = {};  ///< given if g depends on v

  /// Returns the diffusion coefficient D of the white noise, the coefficient of the second
  /// derivative of the density in v in the density equation.
  double diffusion() const { return intensity / 2; }
  bool is_acting() const { return intensity > 0; }
};

const base::OptionsDescription<WhiteNoise>& noise_parameter_description();

struct ImpulseParameters {
  double arrival_rate;  ///< mean number lambda > 0 of impulses per unit time
  std::string law;      ///< name of the law of Y, one of ImpulseLaw::law_names()
  double intensity;     ///< intensity lambda E[Y^2] > 0
  double mean;          ///< mean amplitude E[Y], with E[Y]^2 < intensity / arrival_rate
  /// Skewness of the amplitude Y, for asymmetric laws; if absent, the default skewness of the law.
  std::optional<double> skewness = {};
  /// Amplitudes of a tabulated amplitude law, as a table literal (problem/amplitude_table.hpp).
  std::optional<std::string> table = {};
  /// Formula of the factor b(y) of parametric impulses, which change the velocity y' by b(y) Y; if
  /// absent, b = 1.
  std::optional<std::string> factor = {};
};

const base::OptionsDescription<ImpulseParameters>& impulse_parameter_description();

/// The impulsive excitation xi(t) of paper (3): impulses of random amplitudes Y_k at the times of a
/// Poisson process.
class ImpulseTrain {
 public:
  /// Constructs an impulse train with arrival rate 0, that is, an excitation without impulses.
  ImpulseTrain();
  /// Constructs an impulse train whose amplitude law has the second moment E[Y^2] = intensity /
  /// arrival_rate.
  /// @throws InputError that states the invalid parameter, its value and the allowed range
  explicit ImpulseTrain(const ImpulseParameters& parameters);

  const ImpulseParameters& impulse_parameters() const { return parameters_; }
  bool is_acting() const { return arrival_rate() > 0; }
  double arrival_rate() const { return parameters_.arrival_rate; }
  const ImpulseLaw& amplitude_law() const { return law_; }

  /// Returns the product lambda E[Y^order], a coefficient of paper (15).
  double rate_times_moment(int order) const { return arrival_rate() * law_.moment(order); }
  /// Returns the intensity lambda E[Y^2] of the impulses, equal to the intensity of Gaussian white
  /// noise with the power of the impulses.
  double intensity() const { return rate_times_moment(2); }

  /// Returns an impulse train with the arrival rate multiplied by `factor` > 0.
  ImpulseTrain with_rate_multiplied_by(double factor) const;
  /// Returns the mirrored impulse train, with amplitudes -Y instead of Y.
  ImpulseTrain with_negated_amplitudes() const;

 private:
  ImpulseTrain(const ImpulseParameters& parameters, const ImpulseLaw& law)
      : parameters_(parameters), law_(law) {}

  ImpulseParameters parameters_;
  ImpulseLaw law_;
};

}  // namespace fpkcheck::problem
