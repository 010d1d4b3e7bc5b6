#pragma once

#include <string>

#include "problem/impulse_law.hpp"

namespace fpkcheck::problem {

/// Parameters of the Poisson impulse train, as read from a case file.
struct ImpulseParameters {
  double arrival_rate;  ///< lambda > 0
  std::string law;      ///< name of the law of Y: gaussian, laplace, two_point or uniform
  double intensity;     ///< lambda E[Y^2] > 0
  double mean;          ///< E[Y], with E[Y]^2 < intensity / arrival_rate
};

/// The excitation xi(t) of paper (3): impulses Y_k at the times of a Poisson process.
class ImpulseTrain {
 public:
  /// The law is given the variance that makes E[Y^2] = intensity / arrival_rate.
  /// @throws InputError naming the parameter, its value and the allowed range
  explicit ImpulseTrain(const ImpulseParameters& parameters);

  double arrival_rate() const { return arrival_rate_; }
  const ImpulseLaw& law() const { return law_; }

  /// lambda E[Y^order], the coefficients of paper (15).
  double rate_moment(int order) const { return arrival_rate_ * law_.moment(order); }
  /// lambda E[Y^2], the intensity of the Gaussian white noise of equal power.
  double intensity() const { return rate_moment(2); }

 private:
  double arrival_rate_;
  ImpulseLaw law_;
};

}  // namespace fpkcheck::problem
