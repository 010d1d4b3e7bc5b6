#include "compare/page/joint_maps.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "compare/page/closest.hpp"
#include "made_up_page.hpp"

namespace fpkcheck::compare {
namespace {

using tests::whole_run;

TEST(JointMaps, OfferTheClosestClosureFirstAndNothingThatIsNotOk) {
  const auto run = whole_run();
  const auto maps = joint_maps(run.summary["cases"][0], run.joints);
  ASSERT_TRUE(maps);
  EXPECT_EQ(maps->reference, "fd-kf");
  std::vector<std::string> offered;
  for (const auto& one : maps->differences) offered.push_back(one.solution);
  EXPECT_EQ(offered, (std::vector<std::string>{"epc-gaussian-n6", "epc-gaussian-n2", "fd-white",
                                               "fd-km4", "mcs"}));
}

TEST(JointMaps, HoldRowsOfConstantVelocityWhereTheReferenceIsSeen) {
  const auto run = whole_run();
  const auto maps = joint_maps(run.summary["cases"][0], run.joints);
  const auto& whole = run.joints[run.joints.size() - 2].density;
  ASSERT_EQ(run.joints[run.joints.size() - 2].solution, "fd-kf");
  const std::size_t ny = maps->y_edges.size() - 1, nv = maps->v_edges.size() - 1;
  ASSERT_EQ(maps->reference_density.size(), ny * nv);
  EXPECT_EQ(maps->y_edges.front(), 0);
  EXPECT_LT(ny, whole.ny());
  EXPECT_LT(nv, whole.nv());
  const auto first = static_cast<std::size_t>(
      std::ranges::find(whole.v_edges, maps->v_edges.front()) - whole.v_edges.begin());
  EXPECT_EQ(maps->reference_density[3 * ny + 2], whole.average(2, first + 3));
  double seen = 0;
  for (std::size_t j = 0; j < nv; ++j) {
    for (std::size_t i = 0; i < ny; ++i) {
      seen += maps->reference_density[j * ny + i] * (maps->y_edges[i + 1] - maps->y_edges[i]) *
              (maps->v_edges[j + 1] - maps->v_edges[j]);
    }
  }
  EXPECT_NEAR(seen, transform::mass(whole), 1e-4);
}

TEST(JointMaps, GiveTheDifferenceBackFromTwoBytes) {
  const auto run = whole_run();
  const auto maps = joint_maps(run.summary["cases"][0], run.joints);
  const auto& simulated = maps->differences.back();
  ASSERT_EQ(simulated.solution, "mcs");  // 2 % more on y' > 0
  EXPECT_NEAR(simulated.l1, 0.02 / 2, 1e-4);
  const std::size_t ny = maps->y_edges.size() - 1;
  for (std::size_t k = 0; k < simulated.roots.size(); ++k) {
    const double q = simulated.roots[k] / 32767.0;
    const double back = std::copysign(q * q, q) * simulated.largest;
    const double expected = maps->v_edges[k / ny] > -1e-9 ? 0.02 * maps->reference_density[k] : 0;
    // The root is rounded by half a unit: d((q/32767)^2) = 2 q/32767 dq.
    const double rounding = std::sqrt(expected * simulated.largest) / 32767 +
                            simulated.largest / (4 * 32767.0 * 32767.0);
    EXPECT_NEAR(back, expected, 1.001 * rounding) << k;
  }
}

TEST(JointMaps, NeedAReferenceAndSomethingBesideIt) {
  auto run = whole_run();
  const auto& summary_case = run.summary["cases"][0];
  EXPECT_FALSE(joint_maps(summary_case, {}));
  std::erase_if(run.joints, [](const auto& joint) { return joint.solution != "fd-kf"; });
  EXPECT_FALSE(joint_maps(summary_case, run.joints));
}

TEST(Closest, FollowsTheDistancesOfThoseThatAreOk) {
  auto summary_case = whole_run().summary["cases"][0];
  EXPECT_EQ(reference_of(summary_case), "fd-kf");
  EXPECT_EQ(closures_by_distance(summary_case),
            (std::vector<std::string>{"epc-gaussian-n6", "epc-gaussian-n2"}));
  summary_case["solutions"][0]["formulation"] = "moment";
  EXPECT_EQ(first_shown(summary_case),
            (std::vector<std::string>{"epc-gaussian-n6", "epc-gaussian-n2", "fd-kf", "mcs"}));
  for (auto& solution : summary_case["solutions"]) {
    if (solution["id"] == "fd-kf") solution["status"] = "failed";
  }
  EXPECT_EQ(reference_of(summary_case), "mcs");
}

}  // namespace
}  // namespace fpkcheck::compare
