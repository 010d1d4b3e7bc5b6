#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "methods/method_interface.hpp"
#include "results/run.hpp"

namespace fpkcheck::methods {

/// The registry of solvers that the commands of the program can use. The registry from
/// builtin_registry() contains the solvers of the project. Programs that link the library may add
/// further solvers (docs/extending.md).
class SolverRegistry {
 public:
  /// @throws std::logic_error if the registry already has a solver or a family with the same name
  void add_solver(Solver solver);

  const std::vector<Solver>& solvers() const { return solvers_; }
  const Solver* find_solver(std::string_view name) const;
  /// Returns the families of methods of all solvers, by increasing trust.
  std::vector<const MethodFamily*> method_families_by_trust() const;

  /// Returns the method with a given id; empty if no solver has a method with this id.
  /// @param overrides values that replace default options; options of other solvers are ignored
  /// @throws InputError if the options are invalid
  std::optional<Method> find_method_by_id(std::string_view id,
                                          const base::Values& overrides = {}) const;

  /// @throws InputError if the options cannot be read or are invalid
  Method make_method(const Solver& solver, const base::Values& options) const;

  /// Returns the comma-separated list of the solvers that a run includes without --methods.
  std::string default_method_list() const;

  /// Returns the methods that a comma-separated list selects, by increasing trust and without
  /// repetitions. An item of the list of methods is the id of a method (epc-gaussian-n6, fd-km4,
  /// mcs), a family of methods (epc-gaussian) or a solver (epc). A family or a solver in the list
  /// selects the default methods of the family or solver. The item
  /// `all` selects the default methods of all solvers.
  /// @param overrides values of options, as in find_method_by_id()
  /// @throws InputError if an item of the list selects no method
  std::vector<Method> methods_selected_by_list(const std::string& list,
                                               const base::Values& overrides) const;

  /// Returns the method that computed a solution of a saved run, with the options of the solution;
  /// empty for an external density (from a file, a function or samples).
  /// @param overrides values of options, as in find_method_by_id()
  /// @throws InputError if the options are invalid or belong to another id, or if the registry
  ///         lacks the solver
  std::optional<Method> method_for_solution(const transform::Solution& solution,
                                            const base::Values& overrides) const;

  /// Sets the missing family, meaning, trust and plot style of solutions of a saved run.
  void set_missing_identity_fields_of_run(results::Run& run) const;

 private:
  void set_missing_identity_fields(transform::SolutionIdentity& identity) const;

  std::vector<Solver> solvers_;
};

/// Returns whether the solution `first` is less trusted than the solution `second`: the order of
/// trust is by role, then by trust within the role, then by id.
bool is_less_trusted(const transform::SolutionIdentity& first,
                     const transform::SolutionIdentity& second);

/// Returns the items that a list of methods may contain, for error messages: "epc, fd, mcs, or ids
/// such as ..".
std::string selectable_methods_text(const SolverRegistry& registry);

}  // namespace fpkcheck::methods
