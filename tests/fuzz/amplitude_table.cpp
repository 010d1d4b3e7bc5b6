// Fuzzer of amplitude tables and the impulse laws from them.
#include "problem/amplitude_table.hpp"

#include <cmath>

#include "one_input.hpp"
#include "problem/impulse_law.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fpkcheck;
  return fuzz::only_input_errors([&] {
    const auto table = problem::amplitude_table_of_csv(fuzz::text_of(data, size), "table.csv");
    const std::string text = problem::text_of(table);
    fuzz::require(problem::text_of(problem::amplitude_table_of_text(text)) == text);
    const auto law = problem::ImpulseLaw::named("tabulated", 0.1, 0.5, {.table = text});
    fuzz::require(std::isfinite(law.moment(3)) && law.cumulative(0.1) >= 0);
  });
}
