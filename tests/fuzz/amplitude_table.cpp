// Fuzzer of amplitude tables and the impulse laws from them.
#include "problem/amplitude_table.hpp"

#include <cmath>

#include "fuzz_helpers.hpp"
#include "problem/impulse_law.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fpkcheck;
  return fuzz::catch_input_errors([&] {
    const auto table = problem::parse_amplitude_csv(fuzz::as_text(data, size), "table.csv");
    const std::string text = problem::amplitude_table_literal(table);
    fuzz::require(problem::amplitude_table_literal(problem::parse_amplitude_table_literal(text)) ==
                  text);
    const auto law = problem::ImpulseLaw::from_name("tabulated", 0.1, 0.5, {.table = text});
    fuzz::require(std::isfinite(law.moment(3)) && law.cumulative_probability(0.1) >= 0);
  });
}
