#include "report/budget/part_look.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "compare/budget.hpp"
#include "parameters/input_error.hpp"

namespace fpkcheck::report {
namespace {

TEST(PartLook, TellsEveryLinkFromEveryOther) {
  std::set<std::string> colours{part_colour("closure + impact")};
  for (const auto& link : compare::kLinkNames) {
    EXPECT_TRUE(colours.insert(part_colour(std::string(link.name))).second) << link.name;
  }
  std::set<std::string> patterns;
  for (const char* part :
       {"impact", "white noise", "discretisation", "sampling", "closure + impact"}) {
    EXPECT_TRUE(patterns.insert(part_pattern(part)).second) << part;
  }
  EXPECT_EQ(part_pattern("closure"), std::string());
  EXPECT_EQ(part_colour("impact + truncation"), std::string(part_colour("closure + impact")));
}

TEST(PartLook, OfNoPartIsRefused) { EXPECT_THROW(part_colour("luck"), InputError); }

}  // namespace
}  // namespace fpkcheck::report
