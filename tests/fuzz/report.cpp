// Fuzzer of summary.json as input of `report`, and of its table.
#include <sstream>

#include "methods/builtin.hpp"
#include "one_input.hpp"
#include "report/table.hpp"
#include "results/run_json.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fpkcheck;
  static const methods::Registry registry = methods::builtin_registry();
  return fuzz::only_input_errors([&] {
    std::istringstream json{std::string(fuzz::text_of(data, size))};
    results::Run run = results::read_summary(json, "summary.json");
    registry.annotate(run);
    report::table(run);
  });
}
