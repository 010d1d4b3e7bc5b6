#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "methods/method.hpp"
#include "results/run.hpp"

namespace fpkcheck::methods {

/// The list of the solvers of the program. Every command receives a registry. builtin_registry()
/// contains the solvers of this project; programs that link the library may add other solvers
/// (docs/extending.md).
class Registry {
 public:
  /// Adds a solver.
  /// @throws std::logic_error when the registry has a solver or a family with the same name
  void add(Solver solver);

  /// All solvers, in the order in which they were added.
  const std::vector<Solver>& solvers() const { return solvers_; }
  /// The solver with this name; null if there is none.
  const Solver* find_solver(std::string_view name) const;
  /// The families of methods of all solvers, by increasing trust.
  std::vector<const MethodFamily*> families() const;

  /// The method with this id; empty if no solver has such an id.
  /// @param overrides values of options, in place of the defaults. Names that are no options of the
  ///        solver are ignored
  /// @throws InputError when the options are invalid
  std::optional<Method> method_by_id(std::string_view id, const base::Values& overrides = {}) const;

  /// The method that consists of a solver and values of its options.
  /// @throws InputError when the options cannot be read or are invalid
  Method make_method(const Solver& solver, const base::Values& options) const;

  /// The methods that a comma-separated list selects, by increasing trust, each method once. An
  /// item of the list is the id of a method (epc-gaussian-n6, fd-km4, mcs), a family (epc-gaussian)
  /// or a solver (epc). A family or a solver selects its default ids.
  /// @param overrides values of options, as in method_by_id()
  /// @throws InputError when an item of the list selects no method
  std::vector<Method> select_methods(const std::string& list, const base::Values& overrides) const;

  /// The method that computed a solution of a saved run, with the options of the solution. Empty
  /// for an external density (a file, a function or samples).
  /// @param overrides values of options, as in method_by_id()
  /// @throws InputError when the options are invalid or belong to another id, or when the registry
  ///         does not contain the solver
  std::optional<Method> method_for_solution(const transform::Solution& solution,
                                            const base::Values& overrides) const;

  /// Sets the family, meaning, trust and plot style of solutions of a saved run, if the run was
  /// saved without them.
  void complete_identities(results::Run& run) const;

 private:
  /// A copy of a method with the family, meaning, trust and plot style of its solutions.
  Method with_complete_identity(Method method) const;
  /// Sets the family, meaning, trust and plot style of a solution with this id.
  void complete_identity(transform::SolutionIdentity& identity) const;

  std::vector<Solver> solvers_;
};

/// Whether the solutions of `first` are less trusted than the solutions of `second`.
bool is_less_trusted(const transform::SolutionIdentity& first,
                     const transform::SolutionIdentity& second);

/// The admissible items of a list of methods, as text for messages: "epc, fd, mcs, or ids such
/// as ..".
std::string selectable_items_text(const Registry& registry);

}  // namespace fpkcheck::methods
