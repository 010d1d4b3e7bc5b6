#include <gtest/gtest.h>

#include <cmath>

#include "compare/pair_distances.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/case_results.hpp"
#include "problem/case_file.hpp"

// The closure for a mass that comes to rest in contact with a wall, compared with finite volumes
// along characteristics. Its error estimate follows from the reference, since residuals are
// unsupported.
namespace fpkcheck::methods {
namespace {

using transform::Solution;
using transform::StateVariable;
using transform::Status;

results::CaseResult run(const std::string& case_name, const std::vector<std::string>& overrides,
                        const std::string& methods) {
  return compute_case_results(
             {problem::load_case(case_name, overrides)},
             // A loaded machine needs more than the default time.
             builtin_registry().methods_selected_by_list(methods, {{"max_seconds", 300.0}}), {})
      .at(0);
}

struct Contact {
  const char* name;
  std::vector<std::string> overrides;
  int order;
  double at_rest, l1;  // tolerances: P0 relative; L1 of the marginals
};

TEST(RestInContact, AgreesWithFiniteVolumes) {
  const Contact problems[] = {{"preload", {}, 8, 0.05, 0.012},
                              {"preload", {"system.restitution=0.5"}, 6, 0.01, 0.022},
                              {"ball", {}, 4, 0.01, 0.022},
                              {"ball", {"system.restitution=0.5"}, 4, 0.003, 0.021}};
  for (const auto& [name, overrides, order, at_rest, l1] : problems) {
    const std::string id = "epc-polar-n" + std::to_string(order);
    const auto one = run(name, overrides, id + ",fd-kf");
    const Solution &closure = one.solutions[0], &volumes = one.solutions[1];
    ASSERT_TRUE(volumes.has_status_ok()) << volumes.reason;
    ASSERT_TRUE(closure.density) << closure.reason;
    EXPECT_NEAR(closure.atoms.at(0).probability / volumes.atoms.at(0).probability, 1, at_rest)
        << name;
    EXPECT_NEAR(closure.moments.y2 / volumes.moments.y2, 1, l1) << name;
    for (const auto variable : transform::kVariables) {
      const auto distance = compare::l1_distance_between(one.pairs, id, "fd-kf", variable);
      ASSERT_TRUE(distance);
      EXPECT_LT(*distance, l1) << name;
      // The error estimate includes that of the reference.
      ASSERT_TRUE(closure.error);
      EXPECT_NEAR(transform::l1_error_of_marginal(*closure.error, variable),
                  *distance + transform::l1_error_of_marginal(*volumes.error, variable), 1e-12);
    }
  }
}

TEST(RestInContact, IsOkOnlyWithAReference) {
  const auto beside = run("preload", {}, "epc-polar-n4,epc-polar-n8,fd-kf");
  EXPECT_EQ(beside.solutions[0].status, Status::inaccurate);
  EXPECT_NE(beside.solutions[0].reason.find("its L1 distance from fd-kf is"), std::string::npos);
  EXPECT_EQ(beside.solutions[1].status, Status::ok) << beside.solutions[1].reason;
  const auto alone = run("preload", {}, "epc-polar-n8");
  EXPECT_EQ(alone.solutions[0].status, Status::inaccurate);
  EXPECT_NE(alone.solutions[0].reason.find("cannot be estimated"), std::string::npos);
}

}  // namespace
}  // namespace fpkcheck::methods
