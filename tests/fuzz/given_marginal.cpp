// Fuzzer of external marginal densities and the functions of ExternalMarginal.
#include "methods/external/external_marginal.hpp"

#include <sstream>

#include "fuzz_helpers.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fpkcheck;
  return fuzz::catch_input_errors([&] {
    std::istringstream csv{std::string(fuzz::as_text(data, size))};
    const methods::ExternalMarginal given(methods::read_number_table(csv, "given.csv"),
                                          {.left = problem::Wall{0, 1}, .right = {}});
    const std::vector<double> edges{-3, -1, 0, 0.5, 1, 2, 5};
    fuzz::require(given.average_over_bins(edges).size() + 1 == edges.size());
    if (given.has_standard_errors()) given.l1_sampling_error(edges);
    given.moment(2);
    given.mass_fraction_outside(-1, 1);
  });
}
