#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "methods/builtin_solvers.hpp"
#include "methods/run_cases.hpp"
#include "paper_cases.hpp"
#include "thorough.hpp"

namespace fpkcheck::methods {
namespace {

using transform::StateVariable;

/// Closures compared with finite volumes for the full jump equation.
class Closures {
 public:
  Closures(const problem::Problem& problem, const std::string& list)
      : case_(run_cases({problem}, builtin_registry().methods_selected_by_list(list + ",fd-kf", {}),
                        1, {})
                  .front()) {}

  bool has_status_ok(const std::string& id) const { return case_.find(id)->has_status_ok(); }
  double l1(const std::string& id, StateVariable variable) const {
    return case_.l1_distance(id, "fd-kf", variable).value_or(NAN);
  }
  /// Mean difference of log10 p over reference densities 1e-5 .. 1e-4.
  double tail(const std::string& id, StateVariable variable) const {
    const auto* pair = compare::find_pair_distances(case_.pairs, id, "fd-kf", variable);
    return pair->distances.log10_tail.at(4).mean_abs;
  }

 private:
  results::CaseResult case_;
};

// The closure on the half-plane and the finite volumes share only the problem. The limits are a few
// per cent above the measured values; finite volumes are accurate to 6e-5.
TEST(MomentClosure, ErrorDecreasesWithOrder) {
  const std::map<int, std::pair<double, double>> bars{
      {6, {0.003, 0.004}}, {8, {0.0015, 0.0025}}, {12, {0.0005, 0.0018}}};
  for (const int number : {1, 2, 3, 4}) {
    if ((number == 2 || number == 3) && !tests::is_thorough()) continue;
    const Closures closures(tests::paper_case(number),
                            "epc-moment-n6,epc-moment-n8,epc-moment-n12");
    for (const auto& [order, bar] : bars) {
      SCOPED_TRACE("case " + std::to_string(number) + ", n = " + std::to_string(order));
      const std::string id = "epc-moment-n" + std::to_string(order);
      EXPECT_TRUE(closures.has_status_ok(id));
      EXPECT_LT(closures.l1(id, StateVariable::y), bar.first);
      EXPECT_LT(closures.l1(id, StateVariable::ydot), bar.second);
      // Identical computations would agree to rounding.
      EXPECT_GT(closures.l1(id, StateVariable::ydot), 1e-4);
      if (order == 8) {
        EXPECT_LT(closures.tail(id, StateVariable::y), 0.1);
        EXPECT_LT(closures.tail(id, StateVariable::ydot), 0.1);
      }
    }
  }
}

// Both methods solve the same process for other laws, a non-zero mean and stronger losses.
TEST(MomentClosure, FollowsEveryImpulseLawAndMean) {
  for (const char* law : {"laplace", "two_point", "uniform"}) {
    for (const double mean : {-0.1, 0.15}) {
      if ((mean < 0) != (law[0] == 't') && !tests::is_thorough()) continue;
      const auto p =
          tests::make_problem({.restitution = 0.95, .rate = 3, .mean = mean, .law = law});
      const Closures closures(p, "epc-moment-n2,epc-moment-n8");
      SCOPED_TRACE(std::string(law) + ", mean " + std::to_string(mean));
      EXPECT_TRUE(closures.has_status_ok("epc-moment-n8"));
      EXPECT_LT(closures.l1("epc-moment-n8", StateVariable::y), 0.005);
      EXPECT_LT(closures.l1("epc-moment-n8", StateVariable::ydot), 0.008);
      EXPECT_LT(closures.l1("epc-moment-n8", StateVariable::ydot),
                closures.l1("epc-moment-n2", StateVariable::ydot) / 3);
    }
  }
}

// The same number of unknowns with the exponent in amplitude and phase. Includes strong losses and
// rare impulses, where polynomials of y and y' cannot represent the jump at the origin. The limits
// are 35 to 80 per cent above the measured values.
TEST(PolarClosure, RepresentsTheJumpAtTheOrigin) {
  struct Bars {
    tests::Parameters parameters;
    double y, ydot;    // at n = 6
    double advantage;  // lower limit of the ratio of L1 errors of p(y'), moment to polar, n = 6
    bool is_usual = true;
  };
  for (const auto& [parameters, y, ydot, advantage, is_usual] :
       {Bars{{}, 2e-4, 2.2e-4, 12},                                   //
        Bars{{.cubic = 1, .intensity = 1}, 2e-4, 2.5e-4, 10, false},  //
        Bars{{.restitution = 0.8}, 4e-4, 9e-4, 30, false},            //
        Bars{{.restitution = 0.5}, 2.2e-3, 4e-3, 30},                 //
        Bars{{.rate = 0.3}, 1.3e-3, 1.3e-3, 20}}) {
    if (!is_usual && !tests::is_thorough()) continue;
    SCOPED_TRACE("r = " + std::to_string(parameters.restitution) +
                 ", lambda = " + std::to_string(parameters.rate));
    const Closures closures(tests::make_problem(parameters), "epc-moment-n6,epc-polar-n6");
    EXPECT_TRUE(closures.has_status_ok("epc-polar-n6"));
    EXPECT_LT(closures.l1("epc-polar-n6", StateVariable::y), y);
    EXPECT_LT(closures.l1("epc-polar-n6", StateVariable::ydot), ydot);
    EXPECT_GT(closures.l1("epc-moment-n6", StateVariable::ydot) /
                  closures.l1("epc-polar-n6", StateVariable::ydot),
              advantage);
  }
}

}  // namespace
}  // namespace fpkcheck::methods
