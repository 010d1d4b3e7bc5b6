#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "compare/axes.hpp"
#include "compare/case_report.hpp"
#include "epc/solve.hpp"
#include "fd_fpk/solve.hpp"
#include "mcs/simulate.hpp"

namespace fpkcheck::compare {

/// Told the fraction of a method's work that is done, 0 .. 1, and what else there is to say of it
/// (may be empty).
using Fraction = std::function<void(double, const std::string& note)>;

/// One way to solve a problem, ready to run: the only place where the comparison meets a solver.
struct Method {
  std::string id;  ///< of the solution it yields
  /// True when it uses all processors itself, so that nothing else should run beside it.
  bool parallel = false;
  std::function<Entry(const problem::Problem&, const ComparisonAxes&, const Fraction&)> solve;
};

/// @throws InputError when the options cannot be used (all three)
Method epc_method(const epc::Options& options);
Method fd_method(const fd_fpk::Options& options);
/// The histogram is made on the comparison axes.
Method mcs_method(const mcs::Options& options);

/// The method that made a solution of summary.json, with its options; nothing for a solution that
/// was read from a file.
/// @param threads of a simulation, whose results do not depend on it; 0 for one per processor
/// @throws InputError when the options cannot be read or used, when they are those of another id,
///         or when no method here makes such solutions
std::optional<Method> saved_method(const nlohmann::ordered_json& solution, int threads);

/// The methods of a comma-separated list, by increasing trust (epc, fd, mcs), each once. An item is
/// a solution's id (epc-gaussian-n6, fd-km4, mcs) or a family: epc (orders 2, 4, 6, 8), fd (white,
/// km4 with both impacts, kf). Finite differences estimate their discretisation error.
///
/// A further solver joins by one line in the list of families in methods.cpp.
/// @param simulation options of the simulation, where the list has it
/// @throws InputError naming the item that is no method
std::vector<Method> select_methods(const std::string& list, const mcs::Options& simulation);

}  // namespace fpkcheck::compare
