#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "methods/method_interface.hpp"
#include "methods/run_cases.hpp"
#include "problem/problem.hpp"
#include "results/run.hpp"

namespace fpkcheck::python {

struct RunRequest {
  std::vector<problem::Problem> problems;
  std::vector<methods::Method> methods;  ///< methods by increasing trust
  int threads = 0;                       ///< number of threads; 0 for one per processor
  bool bounds = true;   ///< whether to compute guaranteed bounds and moment error estimates
  std::string command;  ///< command of the run, for summary.json
};

/// Function that is called about twenty times a second with the progress of a computation, or with
/// null if the progress has not changed.
using ProgressPoll = std::function<void(const methods::RunProgress*)>;

/// Functions that a computation in a worker thread calls. Both functions throw an exception if the
/// computation is cancelled.
struct WorkerCallbacks {
  methods::ProgressListener progress;
  std::function<void()> throw_if_cancelled;
};

/// Runs a computation in a worker thread. During the computation, the calling thread calls the
/// function `poll`.
///
/// If the computation is cancelled, the worker thread is abandoned, since long operations cannot be
/// interrupted (cli/shutdown_after_signal.hpp) and the extension must not end the process of
/// Python. An abandoned worker thread ends after its current operation. The computation must
/// therefore own its data.
/// @param poll an exception of this function cancels the computation within a third of a second
/// @throws the exceptions of `compute` and of `poll`
void compute_in_worker_thread(std::function<void(const WorkerCallbacks&)> compute,
                              const ProgressPoll& poll);

/// Solves the problems and compares the solutions in a worker thread, like `fpkcheck run`.
/// @throws the exceptions of compute_in_worker_thread()
results::Run solve(RunRequest request, const ProgressPoll& poll);

/// Prepares exit() for abandoned threads; must be called at the end of the Python interpreter. If
/// abandoned threads still run at exit(), the process ends with the same exit status without
/// destroying their data.
void prepare_for_exit();

/// Writes the files of `fpkcheck run --out` into a directory, in a separate thread.
/// @param poll function that the calling thread calls about twenty times a second. After an
/// exception of `poll`, the files are completed without figures.
/// @return warnings about figures that could not be drawn, one line each
/// @throws InputError if the directory cannot be used
/// @throws std::runtime_error if a file cannot be written
/// @throws the exceptions of `poll`
std::vector<std::string> save(const std::filesystem::path& directory, const results::Run& run,
                              const std::function<void()>& poll);

/// Reads the files of a run that save() or `fpkcheck run --out` wrote.
/// @throws the exceptions of results::load_run()
results::Run load(const std::filesystem::path& directory);

}  // namespace fpkcheck::python
