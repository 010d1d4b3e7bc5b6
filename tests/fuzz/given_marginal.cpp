// Fuzzer of external marginal densities and the functions of ExternalMarginal.
#include "methods/external/given_marginal.hpp"

#include <sstream>

#include "one_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fpkcheck;
  return fuzz::only_input_errors([&] {
    std::istringstream csv{std::string(fuzz::text_of(data, size))};
    const methods::GivenMarginal given(methods::read_number_table(csv, "given.csv"),
                                       {.left = problem::Wall{0, 1}, .right = {}});
    const std::vector<double> edges{-3, -1, 0, 0.5, 1, 2, 5};
    fuzz::require(given.on(edges).size() + 1 == edges.size());
    if (given.has_errors()) given.sampling_l1(edges);
    given.moment(2);
    given.share_beyond(-1, 1);
  });
}
