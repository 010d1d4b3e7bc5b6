#pragma once

#include <string>
#include <vector>

#include "transform/solution.hpp"

namespace fpkcheck::transform {

/// A stationary expectation and its derivatives with respect to the parameters of the problem.
struct ExpectationDerivatives {
  std::string expectation;  ///< "E[y^2]"
  double value = 0;
  std::vector<double> derivatives = {};  ///< one for each parameter
  std::vector<double> errors = {};       ///< estimated discretisation errors, or standard errors
};

/// Derivatives of stationary moments with respect to parameters of the problem.
struct Sensitivities {
  std::string id;  ///< id of the solution, such as "fd-kf" or "mcs"
  Status status = Status::failed;
  std::string reason = {};  ///< reason of the status, one sentence; empty only for status ok
  double seconds = 0;
  std::vector<std::string> parameters = {};  ///< keys such as "system.damping"
  std::vector<double> parameter_values = {};
  std::vector<ExpectationDerivatives> expectations = {};
  bool has_standard_errors = false;  ///< whether the errors are standard errors of a simulation
  std::string details = {};          ///< grid or simulated time, for tables
};

}  // namespace fpkcheck::transform
