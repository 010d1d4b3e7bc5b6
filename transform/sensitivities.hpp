#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "transform/joint_density.hpp"
#include "transform/marginal_density.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::transform {

/// A moment E[y^p y'^q] whose parameter derivatives are computed. The moment E[y'] is not among the
/// differentiated moments, since E[y'] is exactly 0.
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

/// Derivatives of the marginal density p(y) or p(y') with respect to the parameters of the problem.
struct MarginalDerivatives {
  StateVariable variable;
  std::vector<double> edges;  ///< n + 1 increasing bin edges
  /// Bin averages of the derivative with respect to each parameter, shape (parameters, n)
  std::vector<std::vector<double>> derivatives = {};
  std::vector<std::vector<double>> errors = {};  ///< estimated errors, shape (parameters, n)

  double bin_centre(std::size_t b) const { return (edges[b] + edges[b + 1]) / 2; }
  /// Returns the L1 norm int |f| dy of a function f that is given by bin averages.
  double l1_norm(const std::vector<double>& bin_averages) const {
    double sum = 0;
    for (std::size_t b = 0; b < bin_averages.size(); ++b) {
      sum += std::abs(bin_averages[b]) * (edges[b + 1] - edges[b]);
    }
    return sum;
  }
};

/// Derivatives of stationary moments, and for some methods also of marginal densities, with respect
/// to parameters of the problem.
struct MomentSensitivities {
  std::string id;  ///< id of the solution, such as "fd-kf" or "mcs"
  Status status = Status::failed;
  std::string reason = {};  ///< reason of the status, one sentence; empty only for status ok
  double seconds = 0;
  std::vector<std::string> parameters = {};  ///< keys such as "system.damping"
  std::vector<double> parameter_values = {};
  std::vector<ExpectationDerivatives> expectations =
      {};  ///< in the order of kDifferentiatedMoments
  /// Derivatives of p(y) and p(y'); empty if the method computes only derivatives of moments
  std::vector<MarginalDerivatives> marginals = {};
  bool has_standard_errors = false;  ///< whether the errors are standard errors of a simulation
  std::string details = {};          ///< grid or simulated time, for tables
};

}  // namespace fpkcheck::transform
