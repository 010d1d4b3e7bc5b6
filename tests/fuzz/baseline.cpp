// Fuzzer of summary.json as a baseline of `check`: problems and methods to be solved again.
#include "workflows/check/baseline.hpp"

#include "fuzz_helpers.hpp"
#include "methods/builtin_solvers.hpp"
#include "results/saved_run.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fpkcheck;
  static const methods::SolverRegistry registry = methods::builtin_registry();
  const auto file = fuzz::write_file(results::kSummaryFile, fuzz::as_text(data, size));
  return fuzz::catch_input_errors([&] { check::load_baseline(file, registry, {}); });
}
