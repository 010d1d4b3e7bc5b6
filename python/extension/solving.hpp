#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "methods/method.hpp"
#include "methods/run_cases.hpp"
#include "problem/problem.hpp"
#include "results/run.hpp"

namespace fpkcheck::python {

/// What is to be solved, and how.
struct Task {
  std::vector<problem::Problem> problems;
  std::vector<methods::Method> methods;  ///< by increasing trust
  int threads = 0;                       ///< 0 for all processors
  bool bounds = true;                    ///< guaranteed bounds and own errors too
  std::string command;                   ///< as summary.json keeps it
};

/// Solves in a thread of its own, as `fpkcheck run` does; the calling thread looks after it.
///
/// What takes long cannot be asked to stop (cli/ending.hpp), and a process that is Python's cannot
/// be ended: a thread that is given up is left behind, begins nothing new, and ends by itself.
/// @param look called by the calling thread about twenty times a second; what it throws gives the
///             work up, which takes a third of a second at most. Told where the run stands whenever
///             that has changed, else null
/// @throws what a solver throws, and what `look` throws
results::Run solve(Task task, const std::function<void(const methods::RunProgress*)>& look);

/// To be called when the interpreter ends: while any are left behind, exit() is to end the process
/// with the same status and without destroying what they stand on.
void prepare_for_exit();

}  // namespace fpkcheck::python
