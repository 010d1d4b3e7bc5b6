#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "methods/method.hpp"
#include "methods/solver.hpp"
#include "results/run.hpp"

namespace fpkcheck::methods {

/// The solvers of the program. Every command receives a registry. `builtin_registry` has the
/// solvers of this project; programs that link the library may add others (docs/extending.md).
class Registry {
 public:
  /// @throws std::logic_error when a solver or a family of this name is already registered
  void add(Solver solver);

  const std::vector<Solver>& solvers() const { return solvers_; }
  /// The solver with this name, or null.
  const Solver* find(std::string_view name) const;
  /// All families, by increasing trust.
  std::vector<const Family*> families() const;

  /// The method with this id.
  /// @param overrides values that replace defaults where the solver has an option of that name
  /// @return no value when no solver has such an id
  /// @throws InputError when the options are invalid
  std::optional<Method> method_by_id(std::string_view id, const base::Values& overrides = {}) const;

  /// The method of a solver with these options.
  /// @throws InputError when the options cannot be read or are invalid
  Method method(const Solver& solver, const base::Values& options) const;

  /// The methods of a comma-separated list, by increasing trust, each once. An item is a solution's
  /// id (epc-gaussian-n6, fd-km4, mcs), a family (epc-gaussian) or a solver (epc). A family or
  /// solver selects its default ids.
  /// @throws InputError with the item that is no method
  std::vector<Method> select(const std::string& list, const base::Values& overrides) const;

  /// The method that computed a solution of a saved run, with its options. No value for an external
  /// density (a file, a function or samples).
  /// @throws InputError when the options are invalid or belong to another id, or when the registry
  ///         has no such solver
  std::optional<Method> method_for_solution(const transform::Solution& solution,
                                            const base::Values& overrides) const;

  /// Completes the identities (family, meaning, trust, plot style) of solutions of a saved run that
  /// lacks them.
  void annotate(results::Run& run) const;

 private:
  Method annotated_method(Method method) const;
  void annotate(transform::Identity& identity) const;

  std::vector<Solver> solvers_;
};

/// True when `first` is trusted less than `second`.
bool is_less_trusted(const transform::Identity& first, const transform::Identity& second);

/// The admissible items of a list of methods, for messages: "epc, fd, mcs, or ids such as ..".
std::string selectable_items_text(const Registry& registry);

}  // namespace fpkcheck::methods
