// Fuzzer of marginals.csv.
#include "results/marginals_csv.hpp"

#include <sstream>

#include "fuzz_helpers.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fpkcheck;
  return fuzz::catch_input_errors([&] {
    std::istringstream csv{std::string(fuzz::as_text(data, size))};
    for (const auto& [name, curve] : results::read_marginals_csv(csv, "marginals.csv")) {
      fuzz::require(curve.abscissa.size() == curve.density.size());
      fuzz::require(curve.lower.empty() || curve.lower.size() == curve.density.size());
      fuzz::require(curve.lower.size() == curve.upper.size());
    }
  });
}
