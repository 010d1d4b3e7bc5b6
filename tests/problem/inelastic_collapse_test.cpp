#include "problem/inelastic_collapse.hpp"

#include <gtest/gtest.h>

#include "paper_cases.hpp"

namespace fpkcheck::problem {
namespace {

TEST(InelasticCollapse, EndsWhiteNoiseAloneAndOnlyUpToItsThreshold) {
  const auto objection = [](double r, Equation equation) {
    return collapse_objection(tests::make_problem({.restitution = r}), equation);
  };
  EXPECT_TRUE(objection(0.1631, Equation::white).empty());
  EXPECT_FALSE(objection(0.1630, Equation::white).empty());
  for (const auto equation : {Equation::km4, Equation::km4_pade, Equation::kf}) {
    EXPECT_TRUE(objection(0.1, equation).empty()) << name(equation);
  }
}

TEST(InelasticCollapse, SaysWhatIsWrongAndWhatToDo) {
  const auto text = collapse_objection(tests::make_problem({.restitution = 0.15}), Equation::white);
  EXPECT_NE(text.find("restitution 0.15"), std::string::npos) << text;
  EXPECT_NE(text.find("0.1630"), std::string::npos) << text;
  EXPECT_NE(text.find("solve kf"), std::string::npos) << text;
}

}  // namespace
}  // namespace fpkcheck::problem
