#include "epc/half_plane/root_assessment.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <limits>

namespace fpkcheck::epc::half_plane {
namespace {

using transform::Status;

// Returns the status of a root whose slowest deviation has the given eigenvalue.
ClosureResult result_with_eigenvalue(std::complex<double> eigenvalue) {
  ClosureRootSearchResult root;
  root.rightmost_eigenvalue = eigenvalue;
  root.relaxation_rate_unit = 0.1;
  ClosureResult result;
  result.solution.mass = 1;
  result.summary.half_plane = HalfPlaneClosureSummary{};
  set_status(root, 1e-6, "", result);
  return result;
}

TEST(RootAssessment, RefusesUnstableRoots) {
  EXPECT_EQ(result_with_eigenvalue({-0.1, 2}).solution.status, Status::ok);
  // Rounding errors of a marginal root are accepted, up to 1e-3 of the relaxation rate 0.1.
  EXPECT_EQ(result_with_eigenvalue({0.9e-4, 0}).solution.status, Status::ok);
  EXPECT_EQ(result_with_eigenvalue({1.1e-4, 0}).solution.status, Status::inadmissible);
  EXPECT_EQ(result_with_eigenvalue({0.1, 2}).solution.status, Status::inadmissible);
  EXPECT_EQ(result_with_eigenvalue({std::numeric_limits<double>::quiet_NaN(), 0}).solution.status,
            Status::inadmissible);
  EXPECT_FALSE(result_with_eigenvalue({0.1, 2}).solution.reason.empty());
}

}  // namespace
}  // namespace fpkcheck::epc::half_plane
