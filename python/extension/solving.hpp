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

/// The problems, methods and settings of a run.
struct Task {
  std::vector<problem::Problem> problems;
  std::vector<methods::Method> methods;  ///< by increasing trust
  int threads = 0;                       ///< 0 for all processors
  bool bounds = true;                    ///< compute bounds and moment error estimates
  std::string command;                   ///< for summary.json
};

/// Solves as `fpkcheck run` does, in a worker thread; the calling thread polls.
///
/// Long operations cannot be interrupted (cli/shutdown.hpp), and the extension must not end the
/// process of Python. A cancelled thread is therefore abandoned: it starts no further operation and
/// ends by itself.
/// @param poll called by the calling thread about twenty times a second, with the progress of the
///        run if it has changed, else null. An exception from it cancels the run, within a third of
///        a second
/// @throws the exceptions of solvers and of `poll`
results::Run solve(Task task, const std::function<void(const methods::RunProgress*)>& poll);

/// Must be called when the interpreter ends. If abandoned threads still run, exit() then ends the
/// process with the same status, without destroying the data that these threads use.
void prepare_for_exit();

}  // namespace fpkcheck::python
