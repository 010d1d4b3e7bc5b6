#include "extension/saving.hpp"

#include <dlfcn.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <future>
#include <mutex>

#include "base/process/exit_blocker.hpp"
#include "base/process/stop_request.hpp"
#include "methods/builtin.hpp"
#include "report/report.hpp"
#include "results/output_directory.hpp"
#include "results/saved_run.hpp"

namespace fpkcheck::python {
namespace {

// The mutex that is locked while files are read or written, since netCDF is not thread-safe.
std::mutex& files_mutex() {
  static std::mutex& one = *new std::mutex;
  return one;
}

// Disables the error messages of HDF5 in the current thread. HDF5 prints a message on standard
// error for every missing attribute. netCDF disables these messages only in the first thread that
// uses netCDF.
void silence_hdf5_in_this_thread() {
  using SetAuto = int (*)(std::int64_t, void*, void*);
  const auto set_auto = reinterpret_cast<SetAuto>(dlsym(RTLD_DEFAULT, "H5Eset_auto2"));
  if (set_auto != nullptr) set_auto(0, nullptr, nullptr);
}

std::vector<std::string> write_files_locked(const std::filesystem::path& directory,
                                            const results::Run& run) {
  const std::lock_guard lock(files_mutex());
  silence_hdf5_in_this_thread();
  const base::ExitBlocker write_guard;
  const auto directory_lock = results::prepare_output_directory(directory);
  return report::write_report(directory, run);
}

}  // namespace

std::vector<std::string> save(const std::filesystem::path& directory, const results::Run& run,
                              const std::function<void()>& poll) {
  using namespace std::chrono_literals;
  auto warnings =
      std::async(std::launch::async, [&] { return write_files_locked(directory, run); });
  try {
    while (warnings.wait_for(50ms) != std::future_status::ready) poll();
  } catch (...) {
    base::request_stop(SIGINT);
    warnings.wait();
    base::request_stop(0);
    throw;
  }
  return warnings.get();
}

results::Run load(const std::filesystem::path& directory) {
  const std::lock_guard lock(files_mutex());
  silence_hdf5_in_this_thread();
  auto run = results::load_run(directory);
  methods::builtin_registry().complete_identities(run);
  return run;
}

}  // namespace fpkcheck::python
