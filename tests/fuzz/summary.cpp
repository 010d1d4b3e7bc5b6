// Fuzzer of summary.json. A run that was read, written and read again is unchanged.
#include <sstream>

#include "fuzz_helpers.hpp"
#include "results/run_json.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fpkcheck;
  return fuzz::catch_input_errors([&] {
    std::istringstream json{std::string(fuzz::as_text(data, size))};
    const std::string text =
        results::run_summary_text(results::read_run_summary(json, "summary.json"));
    std::istringstream again(text);
    fuzz::require(results::run_summary_text(results::read_run_summary(again, "again.json")) ==
                  text);
  });
}
