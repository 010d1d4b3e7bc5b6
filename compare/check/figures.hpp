#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
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

inline constexpr double kNormal95 = 1.96;  ///< half-width of a 95 % interval in standard errors
/// What is known to worse than this share of itself is a handful of events, and not judged alone.
inline constexpr double kWidestInterval = 0.5;

/// "p(y)" or "p(y')".
/// @param variable as in summary.json and marginals.csv
inline const char* density_name(std::string_view variable) {
  return variable == "ydot" ? "p(y')" : "p(y)";
}

/// True for a solution that chance enters.
bool is_simulation(const nlohmann::ordered_json& solution);

/// True for a closure `moment` of so high an order that its quadrature depends on the path of the
/// search, which may turn on the last digit.
bool depends_on_path(const nlohmann::ordered_json& solution);

/// Status, moments, mass, balance of power and coefficients of every solution.
///
/// A simulation's numbers are judged in standard errors. A coefficient a of x1^p x2^q is judged
/// relative to itself, yet not to less than the rounding of a density can show: its term adds to a
/// Gaussian density, relative to the peak, at most
///
///     |a| sigma_1^p sigma_2^q (p/e)^(p/2) (q/e)^(q/2).
std::vector<Figure> solution_figures(const CaseOfRun& baseline, const CaseOfRun& now,
                                     const Tolerances& tolerances);

/// What else a solution's summary holds, without what measures the work (the list is in
/// detail_figures.cpp and in docs/checking.md): numbers of deterministic methods relative to
/// themselves, small ones absolutely; those of a simulation in their own standard errors, and these
/// by the scatter of errors from so many streams.
std::vector<Figure> detail_figures(const CaseOfRun& baseline, const CaseOfRun& now,
                                   const Tolerances& tolerances);

/// The error budget of every closure. Where it ends in a simulation that chance has moved, what
/// depends on the simulation is judged by its sampling.
std::vector<Figure> budget_figures(const CaseOfRun& baseline, const CaseOfRun& now,
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
/// expectation and a number of standard errors beyond it; 0 where one of the runs does not say.
double allowed_l1(const nlohmann::ordered_json& baseline, const nlohmann::ordered_json& now,
                  const std::string& variable, double standard_errors);

/// Ratio of the larger to the smaller of two positive numbers - 1; infinite where one is none.
double change_of_yardstick(const nlohmann::ordered_json& was, const nlohmann::ordered_json& is);

/// What chance leaves of it for the error^power of a simulation of so many streams, of which there
/// are `number_of_them`.
double allowed_of_yardstick(double streams, std::size_t number_of_them, double power,
                            const Tolerances& tolerances);

}  // namespace fpkcheck::compare
