#include <gtest/gtest.h>

#include "mcs/simulate.hpp"
#include "saved_options.hpp"

namespace fpkcheck::mcs {
namespace {

TEST(Options, ComeBackFromASummary) {
  tests::expect_round_trip(Options{.equation = Equation::white,
                                   .time = 12345.5,
                                   .samples = 2e6,
                                   .target_error = 1e-3,
                                   .seed = 18446744073709551615u,
                                   .threads = 3,
                                   .streams = 64,
                                   .step = 0.7,
                                   .white_step = 0.04,
                                   .tails = true},
                           options_from_json);
}

}  // namespace
}  // namespace fpkcheck::mcs
