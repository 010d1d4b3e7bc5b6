#include "compare/check/baseline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>

#include "compare/check/check.hpp"
#include "compare/summary.hpp"
#include "paper_cases.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::compare {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

TEST(SavedProblem, ComesBackFromASummary) {
  for (const char* law : {"gaussian", "laplace", "two_point", "uniform"}) {
    const auto problem = tests::make_problem({.damping = 0.11,
                                              .stiffness = 1.2,
                                              .cubic = 0.3,
                                              .restitution = 0.94,
                                              .rate = 1.5,
                                              .intensity = 0.16,
                                              .mean = 0.07,
                                              .law = law});
    const Json saved = case_json(problem);
    const auto again = problem_from_json(Json::parse(saved.dump()));
    EXPECT_EQ(again.name, "test");
    EXPECT_EQ(case_json(again).at("system"), saved.at("system"));
    EXPECT_EQ(again.impulses.law().name(), law);
    EXPECT_EQ(again.impulses.arrival_rate(), 1.5);
    EXPECT_EQ(again.impulses.law().mean(), 0.07);
    EXPECT_NEAR(again.impulses.intensity(), 0.16, 1e-16);
  }
  for (int number = 1; number <= 4; ++number) {
    const Json saved = case_json(tests::paper_case(number));
    EXPECT_EQ(case_json(problem_from_json(saved)), saved);  // to the last digit
  }
}

/// A directory of its own with a small run in it.
class BaselineTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        fs::temp_directory_path() / (std::string("fpkcheck-baseline-") +
                                     testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Saves the summary after a change and says how the program takes it.
  std::string message(const std::function<void(Json&)>& change) {
    std::ifstream in(FPKCHECK_BASELINES "/case1/summary.json");
    Json summary = Json::parse(in);
    change(summary);
    std::ofstream(folder_ / "b.json") << summary;
    try {
      load_baseline(folder_ / "b.json", 0);
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      return error.what();
    }
    return "accepted";
  }

  void expect_message(const std::string& part, const std::function<void(Json&)>& change) {
    const std::string said = message(change);
    EXPECT_NE(said.find(part), std::string::npos) << said;
  }

  fs::path folder_;
};

TEST_F(BaselineTest, WhatCannotBeSolvedAgainIsNamed) {
  const auto first = [](Json& json) -> Json& { return json["cases"][0]["solutions"][0]; };
  expect_message("accepted", [](Json&) {});
  expect_message("b.json: case1: epc-gaussian-n4: options.order is missing",
                 [&](Json& json) { first(json)["options"].erase("order"); });
  expect_message("case1: epc-gaussian-n4: options.colour is unknown",
                 [&](Json& json) { first(json)["options"]["colour"] = 1; });
  expect_message("options.order = \"six\" (must be an integer)",
                 [&](Json& json) { first(json)["options"]["order"] = "six"; });
  expect_message("order = 5", [&](Json& json) { first(json)["options"]["order"] = 5; });
  expect_message("options are those of epc-gaussian-n6",
                 [&](Json& json) { first(json)["options"]["order"] = 6; });
  expect_message("method 'magic'", [&](Json& json) { first(json)["method"] = "magic"; });
  expect_message("case1: system.cubic is missing",
                 [](Json& json) { json["cases"][0]["system"].erase("cubic"); });
  expect_message("system.damping = -1",
                 [](Json& json) { json["cases"][0]["system"]["damping"] = -1; });
  expect_message("impulse.law = 3 (must be a text)",
                 [](Json& json) { json["cases"][0]["impulse"]["law"] = 3; });
  expect_message("schema 2", [](Json& json) { json["schema"] = 2; });
  expect_message("not a whole summary", [](Json& json) { json.erase("cases"); });
  expect_message("not a whole summary", [&](Json& json) { first(json).erase("options"); });
  expect_message("is there twice",
                 [](Json& json) { json["cases"].push_back(Json(json["cases"][0])); });
  expect_message("no solution that can be solved again",
                 [](Json& json) { json["cases"] = Json::array(); });
}

TEST_F(BaselineTest, ASimulationMustBeWholeAndKnowItsErrors) {
  const auto mcs = [](Json& json) -> Json& { return json["cases"][0]["solutions"].back(); };
  expect_message("case1: mcs: the simulation was interrupted (run again, to its end)",
                 [&](Json& json) { mcs(json)["interrupted"] = true; });
  for (const Json& bad : {Json(), Json(0.0), Json(-1e-4), Json("small")}) {
    expect_message("case1: mcs: standard_errors.y2 = " + bad.dump() + " (must be a positive",
                   [&](Json& json) { mcs(json)["standard_errors"]["y2"] = bad; });
    expect_message("sampling_l1.ydot_99 = ",
                   [&](Json& json) { mcs(json)["sampling_l1"]["ydot_99"] = bad; });
    expect_message("effective_samples = ",
                   [&](Json& json) { mcs(json)["effective_samples"] = bad; });
  }
}

TEST_F(BaselineTest, CurvesOfAnotherRunAreRefused) {
  std::ofstream(folder_ / "marginals.csv")
      << "case,solution,variable,abscissa,density,lower,upper\ncase1,fd-kf,y,0.1,1,,\n";
  EXPECT_NE(message([](Json&) {}).find("marginals.csv beside it is of another run"),
            std::string::npos);
}

TEST_F(BaselineTest, WithoutCurvesANoteSaysSo) {
  message([](Json&) {});
  const auto baseline = load_baseline(folder_ / "b.json", 0);
  EXPECT_FALSE(baseline.has_marginals);
  ASSERT_EQ(baseline.notes.size(), 1u);
  EXPECT_NE(baseline.notes[0].find("curves are not compared"), std::string::npos);
}

TEST_F(BaselineTest, ASolutionFromAFileIsLeftOutWithANote) {
  EXPECT_EQ(message([](Json& json) {
              json["cases"][0]["solutions"][1]["method"] = "file";
              json["cases"][0]["solutions"][1]["options"] = {{"path", "theirs.csv"}};
            }),
            "accepted");
  const auto baseline = load_baseline(folder_ / "b.json", 0);
  const auto whole = load_baseline(FPKCHECK_BASELINES "/case1", 0);
  EXPECT_EQ(baseline.cases[0].methods.size() + 1, whole.cases[0].methods.size());
  EXPECT_NE(baseline.notes.back().find("case1 epc-gaussian-n6 was read from a file"),
            std::string::npos);
  for (const auto& pair : baseline.run.summary["cases"][0]["comparisons"]) {
    EXPECT_NE(pair["a"], "epc-gaussian-n6");
    EXPECT_NE(pair["b"], "epc-gaussian-n6");
  }
  EXPECT_EQ(baseline.run.summary["cases"][0]["comparisons"].size(),
            whole.run.summary["cases"][0]["comparisons"].size() -
                2 * (whole.cases[0].methods.size() - 1));
}

/// A simulation alone, saved as a run is.
SavedRun simulated(std::uint64_t seed, double intensity = 0.1) {
  const auto problem = tests::make_problem({.intensity = intensity});
  const auto method = mcs_method({.time = 2e5, .seed = seed, .streams = 64});
  return make_run("", run_cases({problem}, {method}, 0, {}));
}

TEST(SimulationCheck, AnotherSeedAgreesWithinItsErrors) {
  const SavedRun baseline = simulated(1);
  for (const std::uint64_t seed : {2, 3, 4, 5, 6}) {
    const auto other = check(baseline, simulated(seed), {});
    for (const auto& figure : other.moved()) ADD_FAILURE() << seed << " " << figure.name;
    // Chance enters: it is not the same run.
    EXPECT_TRUE(std::ranges::any_of(other.figures, [](const Figure& f) { return f.change > 0.5; }));
  }
  EXPECT_EQ(check(baseline, simulated(1), {}).figures[1].change, 0);
}

TEST(SimulationCheck, ImpulsesFivePercentStrongerAreFound) {
  const auto moved = check(simulated(1), simulated(2, 0.105), {}).moved();
  EXPECT_GE(moved.size(), 2u);
}

}  // namespace
}  // namespace fpkcheck::compare
