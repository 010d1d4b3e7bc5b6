// Fuzzer of summary.json as input of `report`, and of its table.
#include <sstream>

#include "fuzz_helpers.hpp"
#include "methods/builtin_solvers.hpp"
#include "report/terminal_tables.hpp"
#include "results/run_json.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fpkcheck;
  static const methods::SolverRegistry registry = methods::builtin_registry();
  return fuzz::catch_input_errors([&] {
    std::istringstream json{std::string(fuzz::as_text(data, size))};
    results::Run run = results::read_run_summary(json, "summary.json");
    registry.set_missing_identity_fields_of_run(run);
    report::terminal_tables_text(run);
  });
}
