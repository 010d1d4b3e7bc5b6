#include <gtest/gtest.h>

#include "epc/solve.hpp"
#include "saved_options.hpp"

namespace fpkcheck::epc {
namespace {

TEST(Options, ComeBackFromASummary) {
  tests::expect_round_trip(Options{.order = 10,
                                   .formulation = Formulation::moment,
                                   .monomials = MonomialSet::general,
                                   .equation = Equation::white,
                                   .tail = moment::Tail::cut,
                                   .tolerance = 3.1e-9,
                                   .max_iterations = 17},
                           options_from_json);
}

TEST(Options, EveryNameComesBack) {
  for (const auto formulation : {Formulation::gaussian, Formulation::moment, Formulation::polar}) {
    for (const auto equation : {Equation::white, Equation::km4, Equation::kf}) {
      const auto again =
          options_from_json(to_json(Options{.formulation = formulation, .equation = equation}));
      EXPECT_EQ(again.formulation, formulation);
      EXPECT_EQ(again.equation, equation);
    }
  }
}

}  // namespace
}  // namespace fpkcheck::epc
