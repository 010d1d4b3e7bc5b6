// Fuzzer of summary.json. A run that was read, written and read again is unchanged.
#include <sstream>

#include "one_input.hpp"
#include "results/run_json.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fpkcheck;
  return fuzz::only_input_errors([&] {
    std::istringstream json{std::string(fuzz::text_of(data, size))};
    const std::string text = results::summary_text(results::read_summary(json, "summary.json"));
    std::istringstream again(text);
    fuzz::require(results::summary_text(results::read_summary(again, "again.json")) == text);
  });
}
