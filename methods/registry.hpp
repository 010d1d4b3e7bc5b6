#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "methods/method.hpp"
#include "methods/solver.hpp"
#include "results/run.hpp"

namespace fpkcheck::methods {

/// The solvers that the program knows. Every command gets one; `builtin` has those of this project,
/// and whoever links the library may add others (docs/extending.md).
class Registry {
 public:
  /// @throws std::logic_error when a solver or a family of this name is there
  void add(Solver solver);

  const std::vector<Solver>& solvers() const { return solvers_; }
  /// The solver of this name, or null.
  const Solver* find(std::string_view name) const;
  /// All families, by increasing trust.
  std::vector<const Family*> families() const;

  /// The method of an id.
  /// @param given values that replace the usual options of those solvers that know them
  /// @return nothing when no solver has such an id
  /// @throws InputError when the options cannot be used
  std::optional<Method> by_id(std::string_view id, const base::Values& given = {}) const;

  /// The method of a solver with these options.
  /// @throws InputError when the options cannot be read or used
  Method method(const Solver& solver, const base::Values& options) const;

  /// The methods of a comma-separated list, by increasing trust, each once. An item is a solution's
  /// id (epc-gaussian-n6, fd-km4, mcs), a family (epc-gaussian) or a solver (epc): then their usual
  /// members.
  /// @throws InputError naming the item that is no method
  std::vector<Method> select(const std::string& list, const base::Values& given) const;

  /// The method that made a solution of a saved run, with its options; nothing for a solution that
  /// somebody brought along, as a file or otherwise.
  /// @throws InputError when its options cannot be read or used, when they are those of another id,
  ///         or when no solver here makes such solutions
  std::optional<Method> that_made(const transform::Solution& solution,
                                  const base::Values& given) const;

  /// Fills in what tells the solutions of a saved run from others, where the run does not say.
  void introduce(results::Run& run) const;

 private:
  Method presented(Method method) const;
  void present(transform::Identity& identity) const;

  std::vector<Solver> solvers_;
};

/// True when the first is trusted less than the second.
bool less_trusted(const transform::Identity& one, const transform::Identity& other);

/// What a list of methods may name, for messages: "epc, fd, mcs, or ids such as ..".
std::string what_to_select(const Registry& registry);

}  // namespace fpkcheck::methods
