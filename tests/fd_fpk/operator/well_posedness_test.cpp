#include "fd_fpk/operator/well_posedness.hpp"

#include <gtest/gtest.h>

#include <string>

#include "paper_cases.hpp"

namespace fpkcheck::fd_fpk {
namespace {

constexpr double kRate = 3.17;  // the default length of two_point is then 0.8 of an automatic cell

WellPosednessCheck posedness_of(const problem::Problem& problem, FiniteVolumeOptions options) {
  options.equation = DensityEquation::km4;
  return check_well_posedness(
      problem, options,
      discretise_density_equation(problem, options, initial_box(problem, options)));
}

// The number behind "at least " in a reason.
double advised(const std::string& ill_posed_reason) {
  const std::string before = "at least ";
  return std::stod(ill_posed_reason.substr(ill_posed_reason.find(before) + before.size()));
}

TEST(WellPosednessCheck, DefaultRegularisationLengthIsWellPosed) {
  for (const std::string law : {"two_point", "uniform", "gaussian"}) {
    for (const double rate : {kRate, 1000.0}) {
      const auto p = tests::make_problem({.rate = rate, .law = law});
      EXPECT_EQ(posedness_of(p, {}).ill_posed_reason, "") << law << ' ' << rate;
    }
  }
  const auto graded = tests::make_problem({.restitution = 0.8, .rate = kRate, .law = "two_point"});
  EXPECT_EQ(posedness_of(graded, {}).ill_posed_reason, "");
}

TEST(WellPosednessCheck, AdvisedRegularisationLengthIsWellPosed) {
  for (const std::string law : {"two_point", "gaussian"}) {
    const auto p = tests::make_problem({.law = law});
    const auto literal = posedness_of(p, {.regularisation_length = 0});
    ASSERT_NE(literal.ill_posed_reason.find("at least "), std::string::npos)
        << literal.ill_posed_reason;
    const double length = advised(literal.ill_posed_reason);
    EXPECT_EQ(posedness_of(p, {.regularisation_length = length}).ill_posed_reason, "") << law;
    const auto shorter = posedness_of(p, {.regularisation_length = 0.97 * length});
    EXPECT_EQ(advised(shorter.ill_posed_reason), length) << law;
  }
}

// Cells at the origin are 16 times narrower than cells far from the origin; compared with the
// narrow cells the regularisation length is long.
TEST(WellPosednessCheck, WideCellsFarOutAreCheckedToo) {
  const auto p = tests::make_problem({.restitution = 0.8, .rate = kRate, .law = "two_point"});
  const double of_law = default_regularisation_length(p.impulses.amplitude_law());
  const auto found = posedness_of(p, {.regularisation_length = of_law});
  EXPECT_GT(found.growth.rate, 0.1);
  EXPECT_NE(found.ill_posed_reason.find("leave out"), std::string::npos) << found.ill_posed_reason;
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
