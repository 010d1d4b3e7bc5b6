#pragma once

#include <optional>
#include <string>

#include "base/options/description.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::problem {

/// Parameters of the Poisson impulse train, as read from a case file.
struct ImpulseParameters {
  double arrival_rate;  ///< lambda > 0
  std::string law;      ///< name of the law of Y, one of ImpulseLaw::known_names()
  double intensity;     ///< lambda E[Y^2] > 0
  double mean;          ///< E[Y], with E[Y]^2 < intensity / arrival_rate
  /// Skewness of Y, for laws that are not symmetric; the default of the law where absent.
  std::optional<double> skewness = {};
  /// The table of a tabulated law as one word (problem/amplitude_table.hpp).
  std::optional<std::string> table = {};
};

/// The description of these parameters.
const base::Description<ImpulseParameters>& impulse_description();

/// The excitation xi(t) of paper (3): impulses Y_k at the times of a Poisson process.
class ImpulseTrain {
 public:
  /// No impulses: the rate and every rate_moment are 0. (The law is a placeholder.)
  ImpulseTrain();
  /// The law gets the variance that makes E[Y^2] = intensity / arrival_rate.
  /// @throws InputError naming the parameter, its value and the allowed range
  explicit ImpulseTrain(const ImpulseParameters& parameters);

  const ImpulseParameters& parameters() const { return parameters_; }
  bool is_present() const { return arrival_rate() > 0; }
  double arrival_rate() const { return parameters_.arrival_rate; }
  const ImpulseLaw& law() const { return law_; }

  /// lambda E[Y^order], the coefficients of paper (15).
  double rate_moment(int order) const { return arrival_rate() * law_.moment(order); }
  /// lambda E[Y^2], the intensity of the Gaussian white noise of equal power.
  double intensity() const { return rate_moment(2); }

  /// The train of impulses -Y.
  ImpulseTrain mirrored() const;

 private:
  ImpulseTrain(const ImpulseParameters& parameters, const ImpulseLaw& law)
      : parameters_(parameters), law_(law) {}

  ImpulseParameters parameters_;
  ImpulseLaw law_;
};

}  // namespace fpkcheck::problem
