#include "report/page/page_sections.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "made_up_page.hpp"

namespace fpkcheck::report {
namespace {

using tests::whole_case;

TEST(JointMaps, OfferTheClosestClosureFirstAndNothingThatIsNotOk) {
  const auto case_result = whole_case();
  const auto maps = make_joint_density_maps(case_result);
  ASSERT_TRUE(maps);
  EXPECT_EQ(maps->reference, "fd-kf");
  std::vector<std::string> offered;
  for (const auto& each : maps->differences) offered.push_back(each.solution);
  EXPECT_EQ(offered, (std::vector<std::string>{"epc-gaussian-n6", "epc-gaussian-n2", "fd-white",
                                               "fd-km4", "mcs"}));
}

TEST(JointMaps, HoldRowsOfConstantVelocityWhereTheReferenceIsSeen) {
  const auto case_result = whole_case();
  const auto maps = make_joint_density_maps(case_result);
  ASSERT_EQ(case_result.joints[case_result.joints.size() - 2].solution, "fd-kf");
  const auto& whole = case_result.joints[case_result.joints.size() - 2].density;
  const std::size_t ny = maps->y_edges.size() - 1, nv = maps->v_edges.size() - 1;
  ASSERT_EQ(maps->reference_density.size(), ny * nv);
  EXPECT_EQ(maps->y_edges.front(), 0);
  EXPECT_LT(ny, whole.y_cell_count());
  EXPECT_LT(nv, whole.v_cell_count());
  const auto first = static_cast<std::size_t>(
      std::ranges::find(whole.v_edges, maps->v_edges.front()) - whole.v_edges.begin());
  EXPECT_EQ(maps->reference_density[3 * ny + 2], whole.cell_average(2, first + 3));
  double seen = 0;
  for (std::size_t j = 0; j < nv; ++j) {
    for (std::size_t i = 0; i < ny; ++i) {
      seen += maps->reference_density[j * ny + i] * (maps->y_edges[i + 1] - maps->y_edges[i]) *
              (maps->v_edges[j + 1] - maps->v_edges[j]);
    }
  }
  EXPECT_NEAR(seen, transform::mass(whole), 1e-4);
}

TEST(JointMaps, RestoreTheDifferenceFromItsRoots) {
  const auto case_result = whole_case();
  const auto maps = make_joint_density_maps(case_result);
  const auto& simulated = maps->differences.back();
  ASSERT_EQ(simulated.solution, "mcs");  // 2 % above the reference for y' > 0
  EXPECT_NEAR(simulated.l1, 0.02 / 2, 1e-4);
  const std::size_t ny = maps->y_edges.size() - 1;
  for (std::size_t k = 0; k < simulated.values.roots.size(); ++k) {
    const double q = static_cast<double>(simulated.values.roots[k]) / simulated.values.levels;
    const double back = std::copysign(q * q, q) * simulated.values.largest;
    const double expected = maps->v_edges[k / ny] > -1e-9 ? 0.02 * maps->reference_density[k] : 0;
    // The root is rounded by half a unit: d((q/n)^2) = 2 q/n^2 dq.
    const double n = simulated.values.levels;
    const double rounding =
        std::sqrt(expected * simulated.values.largest) / n + simulated.values.largest / (4 * n * n);
    EXPECT_NEAR(back, expected, 1.001 * rounding) << k;
  }
}

// Differences of atoms add to the L1 distance.
TEST(JointMaps, AddTheDifferencesOfAtoms) {
  auto case_result = whole_case();
  const double before = make_joint_density_maps(case_result)->differences.back().l1;
  for (auto& solution : case_result.solutions) {
    if (solution.id() == "fd-kf") solution.atoms = {{.y = 0, .probability = 0.25}};
    if (solution.id() == "mcs") solution.atoms = {{.y = 0, .probability = 0.125}};
  }
  EXPECT_NEAR(make_joint_density_maps(case_result)->differences.back().l1, before + 0.125, 1e-12);
}

TEST(JointMaps, NeedAReferenceAndSomethingBesideIt) {
  auto case_result = whole_case();
  const auto joints = std::exchange(case_result.joints, {});
  EXPECT_FALSE(make_joint_density_maps(case_result));
  case_result.joints = joints;
  std::erase_if(case_result.joints, [](const auto& joint) { return joint.solution != "fd-kf"; });
  EXPECT_FALSE(make_joint_density_maps(case_result));
  case_result.joints = joints;
  for (const char* id : {"fd-kf", "mcs"}) {
    tests::solution_of(case_result, id).status = transform::Status::failed;
    case_result.update_assessment();
  }
  EXPECT_FALSE(make_joint_density_maps(case_result));
}

TEST(JointMaps, LeaveOutOtherCells) {
  auto case_result = whole_case();
  case_result.joints.back().density.y_edges.back() += 0.1;
  const auto maps = make_joint_density_maps(case_result);
  ASSERT_TRUE(maps);
  for (const auto& difference : maps->differences) EXPECT_NE(difference.solution, "mcs");
}

TEST(JointMaps, AreConvertedToHtmlAndJson) {
  auto maps = *make_joint_density_maps(whole_case());
  maps.differences.back().solution = "<b>";
  const std::string html = joint_density_maps_html(maps, "case-1");
  EXPECT_TRUE(tests::contains(html, "Compared with fd-kf: <select id=\"case-1-joint-choice\">"));
  EXPECT_TRUE(tests::contains(html, "<option value=\"&lt;b&gt;\">&lt;b&gt; (L1 0.01"));
  const auto json = nlohmann::json::parse(joint_density_maps_json(maps, "case-1"));
  EXPECT_EQ(json.at("id"), "case-1-joint");
  EXPECT_EQ(json.at("reference"), "fd-kf");
  EXPECT_EQ(json.at("differences").size(), maps.differences.size());
  EXPECT_EQ(json.at("density").at("dtype"), "f4");
  EXPECT_EQ(json.at("differences").at(0).at("steps").size(),
            maps.differences.front().values.roots.size());
}

}  // namespace
}  // namespace fpkcheck::report
