#include "compare/budget/limits.hpp"

#include <gtest/gtest.h>

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

Json part(const std::string& name, const std::string& from, const std::string& to, double l1) {
  return {{"name", name}, {"from", from}, {"to", to}, {"l1", l1}, {"uncertainty", 1e-5}};
}

/// One closure against the simulation, the same in both variables.
void add(Json& one, const std::string& id, double closure, double impact, double total,
         const std::string& status = "ok") {
  one["solutions"].push_back({{"id", id}, {"status", status}});
  for (const char* variable : {"y", "ydot"}) {
    Json sampling = part("sampling", "fd-kf limit", "mcs", 5e-4);
    sampling.erase("uncertainty");
    sampling["in_99"] = 8e-4;
    one["budget"].push_back({{"solution", id},
                             {"variable", variable},
                             {"reference", "mcs"},
                             {"total", total},
                             {"parts",
                              {part("closure", id, "fd-km4-delta", closure),
                               part("impact", "fd-km4-delta", "fd-km4", impact), sampling}}});
  }
}

Json no_budget() { return {{"solutions", Json::array()}, {"budget", Json::array()}}; }

TEST(Limits, GroupClosuresByTheLargestPartAndByTheReference) {
  Json one = no_budget();
  add(one, "epc-gaussian-n2", 9e-3, 5e-4, 9.2e-3);
  add(one, "epc-gaussian-n4", 4e-3, 5e-4, 4.2e-3, "inadmissible");
  add(one, "epc-gaussian-n6", 1e-4, 2e-3, 2.1e-3);
  add(one, "epc-gaussian-n8", 1e-4, 2e-4, 6e-4);
  add(one, "epc-polar-n8", 1e-5, 2e-5, 7.9e-4);
  EXPECT_EQ(limits(one),
            "What limits each closure: the closure itself in epc-gaussian-n2 and -n4 "
            "(inadmissible) (80 to 90 % of the sum of the parts); the impact to first order in 1-r "
            "in epc-gaussian-n6 (77 %); the reference in epc-gaussian-n8 and epc-polar-n8, which "
            "lie within its sampling error in L1.");
}

TEST(Limits, BothVariablesMustLieWithinTheErrorOfTheReference) {
  Json one = no_budget();
  add(one, "epc-polar-n8", 4e-4, 2e-5, 7e-4);
  EXPECT_NE(limits(one).find("which lies within its sampling error"), std::string::npos);
  one["budget"][1]["total"] = 8.1e-4;
  EXPECT_EQ(limits(one),
            "What limits each closure: the sampling of the reference in epc-polar-n8 (54 % of the "
            "sum of the parts).");
}

TEST(Limits, WithoutASimulationTheDiscretisationErrorIsTheMeasure) {
  Json one = no_budget();
  one["solutions"].push_back({{"id", "epc-polar-n8"}, {"status", "ok"}});
  one["budget"].push_back({{"solution", "epc-polar-n8"},
                           {"variable", "y"},
                           {"reference", "fd-kf limit"},
                           {"total", 2e-5},
                           {"parts",
                            {part("closure", "epc-polar-n8", "fd-kf", 4e-5),
                             part("discretisation", "fd-kf", "fd-kf limit", 3e-5)}}});
  one["budget"][0]["parts"][1]["uncertainty"] = 3e-5;
  EXPECT_EQ(limits(one),
            "What limits each closure: the reference in epc-polar-n8, which lies within its "
            "discretisation error in L1.");
  one["budget"][0]["total"] = 5e-5;
  EXPECT_EQ(limits(one),
            "What limits each closure: the closure itself in epc-polar-n8 (57 % of the sum of the "
            "parts).");
}

TEST(Limits, ADisagreementOfTheReferencesIsNotCalledSampling) {
  Json one = no_budget();
  add(one, "epc-polar-n8", 1e-5, 2e-5, 7e-4);
  ASSERT_EQ(limits(one).find("further apart"), std::string::npos);
  for (auto& row : one["budget"]) row["parts"].back()["l1"] = 9e-4;  // 99 of 100 below 8e-4
  const auto text = limits(one);
  EXPECT_NE(text.find("further apart than 99 of 100 simulations"), std::string::npos) << text;
  EXPECT_EQ(text.find("lies within"), std::string::npos) << text;
}

TEST(Limits, NothingToSayWithoutABudget) { EXPECT_EQ(limits(no_budget()), ""); }

}  // namespace
}  // namespace fpkcheck::compare
