#pragma once

#include <optional>
#include <string>

#include "base/options/description.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::problem {

/// Parameters of the Poisson impulse train, as read from a case file.
struct ImpulseParameters {
  double arrival_rate;  ///< lambda > 0
  std::string law;      ///< name of the law of Y, one of ImpulseLaw::known()
  double intensity;     ///< lambda E[Y^2] > 0
  double mean;          ///< E[Y], with E[Y]^2 < intensity / arrival_rate
  /// Of Y about its mean, for laws that are not symmetric; theirs unless given.
  std::optional<double> skewness = {};
  /// Of a tabulated law: the whole table in a word (problem/amplitude_table.hpp).
  std::optional<std::string> table = {};
};

/// The parameters as case files, tables and files name them.
const base::Description<ImpulseParameters>& impulse_description();

/// The excitation xi(t) of paper (3): impulses Y_k at the times of a Poisson process.
class ImpulseTrain {
 public:
  /// No impulses: the rate is 0, and so is every rate_moment. (The law is that of none.)
  ImpulseTrain();
  /// The law is given the variance that makes E[Y^2] = intensity / arrival_rate.
  /// @throws InputError naming the parameter, its value and the allowed range
  explicit ImpulseTrain(const ImpulseParameters& parameters);

  const ImpulseParameters& parameters() const { return parameters_; }
  bool present() const { return arrival_rate() > 0; }
  double arrival_rate() const { return parameters_.arrival_rate; }
  const ImpulseLaw& law() const { return law_; }

  /// lambda E[Y^order], the coefficients of paper (15).
  double rate_moment(int order) const { return arrival_rate() * law_.moment(order); }
  /// lambda E[Y^2], the intensity of the Gaussian white noise of equal power.
  double intensity() const { return rate_moment(2); }

  /// Impulses -Y.
  ImpulseTrain mirrored() const;

 private:
  ImpulseTrain(const ImpulseParameters& parameters, const ImpulseLaw& law)
      : parameters_(parameters), law_(law) {}

  ImpulseParameters parameters_;
  ImpulseLaw law_;
};

}  // namespace fpkcheck::problem
