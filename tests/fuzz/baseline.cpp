// Fuzzer of summary.json as a baseline of `check`: problems and methods to be solved again.
#include "workflows/check/baseline.hpp"

#include "methods/builtin.hpp"
#include "one_input.hpp"
#include "results/saved_run.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fpkcheck;
  static const methods::Registry registry = methods::builtin_registry();
  const auto file = fuzz::written(results::kSummaryFile, fuzz::text_of(data, size));
  return fuzz::only_input_errors([&] { check::load_baseline(file, registry, {}); });
}
