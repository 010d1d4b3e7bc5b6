#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/check/figure.hpp"
#include "compare/check/tolerances.hpp"
#include "compare/marginals_csv.hpp"

/// The figures of two runs of the same case, side by side. What only one of the runs has is a
/// figure that moved. All functions throw nlohmann::json::exception where a summary lacks what its
/// schema promises.
namespace fpkcheck::compare {

/// One case of a run.
struct CaseOfRun {
  const nlohmann::ordered_json& summary;  ///< an element of "cases" in summary.json
  const std::vector<MarginalCurve>& marginals;

  /// The curve of a solution of this case, or null.
  const MarginalCurve* curve(const std::string& solution, const std::string& variable) const;
};

/// True for a solution that chance enters.
bool is_simulation(const nlohmann::ordered_json& solution);

/// Status, moments, mass, balance of power and coefficients of every solution.
///
/// A simulation's numbers are judged in standard errors. A coefficient a of x1^p x2^q is judged
/// relative to itself, yet not to less than the rounding of a density can show: its term adds to a
/// Gaussian density, relative to the peak, at most
///
///     |a| sigma_1^p sigma_2^q (p/e)^(p/2) (q/e)^(q/2).
std::vector<Figure> solution_figures(const CaseOfRun& baseline, const CaseOfRun& now,
                                     const Tolerances& tolerances);

/// l1, l2, sup, hellinger, kl and the decades of the tail of every pair. Of a pair with a
/// simulation, l1 alone: by the triangle inequality it moves by no more than the L1 between the two
/// simulations. A kl that is infinite in one of the runs is left out, since a rounding error in
/// the far tail decides that.
std::vector<Figure> distance_figures(const CaseOfRun& baseline, const CaseOfRun& now,
                                     const Tolerances& tolerances);

/// Every curve of marginals.csv: the bin that moved most; of a simulation, the bin that moved most
/// in standard errors, among those known to better than half their density and allowing for their
/// number, and L1.
std::vector<Figure> marginal_figures(const CaseOfRun& baseline, const CaseOfRun& now,
                                     const Tolerances& tolerances);

/// L1 that chance alone leaves between two runs of a simulation, from their `sampling_l1`: the
/// expectation and a number of standard errors beyond it.
double allowed_l1(const nlohmann::ordered_json& baseline, const nlohmann::ordered_json& now,
                  const std::string& variable, double standard_errors);

}  // namespace fpkcheck::compare
