#pragma once

#include <string>
#include <vector>

#include "transform/density.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::transform {

/// A moment E[y^p y'^q] whose derivatives are computed. E[y'] = 0 is not among these moments.
struct DifferentiatedMoment {
  const char* symbol;
  int p, q;
  double Moments::*moment;
};
inline constexpr DifferentiatedMoment kDifferentiatedMoments[] = {{"E[y]", 1, 0, &Moments::y1},
                                                                  {"E[y^2]", 2, 0, &Moments::y2},
                                                                  {"E[y^4]", 4, 0, &Moments::y4},
                                                                  {"E[y'^2]", 0, 2, &Moments::v2},
                                                                  {"E[y'^4]", 0, 4, &Moments::v4}};

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
  std::vector<ExpectationDerivatives> expectations =
      {};                            ///< in the order of kDifferentiatedMoments
  bool has_standard_errors = false;  ///< whether the errors are standard errors of a simulation
  std::string details = {};          ///< grid or simulated time, for tables
};

}  // namespace fpkcheck::transform
