#include "workflows/check/baseline.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/input_error.hpp"
#include "methods/builtin_solvers.hpp"
#include "results/run_json.hpp"
#include "solved_run.hpp"
#include "thorough.hpp"

namespace fpkcheck::check {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

TEST(SavedProblem, IsReadBackFromASummary) {
  std::vector<problem::Problem> problems;
  for (const char* law : {"gaussian", "laplace", "two_point", "uniform"}) {
    problems.push_back(tests::make_problem({.damping = 0.11,
                                            .stiffness = 1.2,
                                            .cubic = 0.3,
                                            .restitution = 0.94,
                                            .rate = 1.5,
                                            .intensity = 0.16,
                                            .mean = 0.07,
                                            .law = law}));
  }
  for (int number = 1; number <= 4; ++number) problems.push_back(tests::paper_case(number));
  for (const auto& problem : problems) {
    auto saved = tests::case_of({});
    saved.problem = problem;
    saved.update_assessment();
    std::istringstream file(results::run_summary_text({results::current_program(""), {saved}}));
    const auto again = results::read_run_summary(file, "summary.json").cases.at(0).problem;
    EXPECT_EQ(again.name, problem.name);
    const auto was = problem::case_file_sections(problem), is = problem::case_file_sections(again);
    ASSERT_EQ(was.size(), is.size());
    for (std::size_t k = 0; k < was.size(); ++k) {
      EXPECT_EQ(was[k].name, is[k].name);
      EXPECT_EQ(was[k].values, is[k].values) << was[k].name;  // to the last digit
    }
  }
}

/// A temporary directory with a copy of a small run.
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

  static CheckBaseline load(const fs::path& place) {
    return load_baseline(place, methods::builtin_registry(), {{"threads", std::int64_t{2}}});
  }

  /// Changes the summary, loads it and returns the error message, or "accepted".
  std::string message(const std::function<void(Json&)>& change) {
    std::ifstream in(FPKCHECK_BASELINES "/case1/summary.json");
    Json summary = Json::parse(in);
    change(summary);
    std::ofstream(folder_ / "b.json") << summary;
    try {
      load(folder_ / "b.json");
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

TEST_F(BaselineTest, ReportsSolutionsThatCannotBeSolvedAgain) {
  const auto first = [](Json& json) -> Json& { return json["cases"][0]["solutions"][0]; };
  expect_message("accepted", [](Json&) {});
  expect_message("b.json: case1: epc-gaussian-n4: options.order is missing",
                 [&](Json& json) { first(json)["options"].erase("order"); });
  expect_message("case1: epc-gaussian-n4: options.colour is unknown",
                 [&](Json& json) { first(json)["options"]["colour"] = 1; });
  expect_message("options.order = 'six' (must be an even number",
                 [&](Json& json) { first(json)["options"]["order"] = "six"; });
  expect_message("order = 5", [&](Json& json) { first(json)["options"]["order"] = 5; });
  expect_message("options belong to epc-gaussian-n6",
                 [&](Json& json) { first(json)["options"]["order"] = 6; });
  expect_message("method 'magic'", [&](Json& json) { first(json)["method"] = "magic"; });
  expect_message("case1: system.stiffness is missing",
                 [](Json& json) { json["cases"][0]["system"].erase("stiffness"); });
  expect_message("system.restitution = -1",
                 [](Json& json) { json["cases"][0]["system"]["restitution"] = -1; });
  expect_message("impulse.law = 3 (must be one of",
                 [](Json& json) { json["cases"][0]["impulse"]["law"] = 3; });
  expect_message("schema 2", [](Json& json) { json["schema"] = 2; });
  expect_message("not a complete summary", [](Json& json) { json.erase("cases"); });
  expect_message("not a complete summary", [&](Json& json) { first(json).erase("options"); });
  expect_message("occurs twice",
                 [](Json& json) { json["cases"].push_back(Json(json["cases"][0])); });
  expect_message("no solution that can be solved again",
                 [](Json& json) { json["cases"] = Json::array(); });
}

TEST_F(BaselineTest, ASimulationMustBeCompleteWithStandardErrors) {
  const auto mcs = [](Json& json) -> Json& { return json["cases"][0]["solutions"].back(); };
  expect_message("case1: mcs: the simulation was interrupted: run it again, to its end",
                 [&](Json& json) { mcs(json)["interrupted"] = true; });
  for (const Json& bad : {Json(), Json(0.0), Json(-1e-4)}) {
    expect_message("case1: mcs: standard error of E[y^2] = ",
                   [&](Json& json) { mcs(json)["standard_errors"]["y2"] = bad; });
    expect_message("sampling L1 in 99 of 100 of p(y') = ",
                   [&](Json& json) { mcs(json)["sampling_l1"]["ydot_99"] = bad; });
  }
  expect_message("not a complete summary",
                 [&](Json& json) { mcs(json)["standard_errors"]["y2"] = "small"; });
}

TEST_F(BaselineTest, RefusesCurvesOfAnotherRun) {
  std::ofstream(folder_ / "marginals.csv")
      << "case,solution,variable,abscissa,density,lower,upper\ncase1,fd-kf,y,0.1,1,,\n";
  expect_message("marginals.csv", [](Json&) {});
  expect_message("not of the same run", [](Json&) {});
}

TEST_F(BaselineTest, HasANoteWithoutCurves) {
  message([](Json&) {});
  const auto baseline = load(folder_ / "b.json");
  EXPECT_FALSE(baseline.has_marginals);
  ASSERT_EQ(baseline.notes.size(), 1u);
  EXPECT_NE(baseline.notes[0].find("marginal densities are not compared"), std::string::npos);
}

TEST_F(BaselineTest, RemovesAnExternalSolutionWithANote) {
  EXPECT_EQ(message([](Json& json) {
              json["cases"][0]["solutions"][1]["method"] = "file";
              json["cases"][0]["solutions"][1]["options"] = {{"path", "theirs.csv"}};
            }),
            "accepted");
  const auto baseline = load(folder_ / "b.json");
  const auto whole = load(FPKCHECK_BASELINES "/case1");
  const std::size_t methods = whole.cases[0].methods.size();
  EXPECT_EQ(baseline.cases[0].methods.size() + 1, methods);
  EXPECT_EQ(baseline.run.cases[0].find("epc-gaussian-n6"), nullptr);
  EXPECT_NE(baseline.notes.back().find("case1 epc-gaussian-n6 is an external density"),
            std::string::npos);
  const auto& pairs = baseline.run.cases[0].pairs;
  for (const auto& pair : pairs) {
    EXPECT_NE(pair.a, "epc-gaussian-n6");
    EXPECT_NE(pair.b, "epc-gaussian-n6");
  }
  for (const auto& row : baseline.run.cases[0].budget) EXPECT_NE(row.solution, "epc-gaussian-n6");
  EXPECT_LT(baseline.run.cases[0].budget.size(), whole.run.cases[0].budget.size());
  EXPECT_EQ(pairs.size(), whole.run.cases[0].pairs.size() - 2 * (methods - 1));
}

TEST_F(BaselineTest, OptionOverridesReplaceOptionsOfTheRun) {
  const auto threads = [](const CheckBaseline& baseline) {
    for (const auto& [name, value] : baseline.cases[0].methods.back().options) {
      if (name == "threads") return value;
    }
    return base::Value("none");
  };
  EXPECT_EQ(threads(load(FPKCHECK_BASELINES "/case1")), base::Value(std::int64_t{2}));
}

TEST_F(BaselineTest, LoadsEveryPaperCaseWithItsCurves) {
  for (const char* name : {"case1", "case2", "case3", "case4"}) {
    const auto baseline = load(fs::path(FPKCHECK_BASELINES) / name);
    EXPECT_TRUE(baseline.has_marginals);
    EXPECT_TRUE(baseline.notes.empty());
    ASSERT_EQ(baseline.cases.size(), 1u);
    EXPECT_EQ(baseline.cases[0].methods.size(), 9u);
    EXPECT_EQ(baseline.run.cases[0].name(), name);
  }
}

/// The closures of the paper's first case, which are solved in a few milliseconds each.
CheckBaseline closures() {
  auto baseline = load_baseline(FPKCHECK_BASELINES "/case1", methods::builtin_registry(), {});
  auto& one = baseline.run.cases[0];
  const auto is_closure = [](const std::string& id) { return id.starts_with("epc-"); };
  std::erase_if(one.solutions, [&](const auto& s) { return !is_closure(s.id()); });
  // The stated errors of closures come from the comparison with `fd`.
  for (auto& s : one.solutions) s.error.reset();
  std::erase_if(one.curves, [&](const auto& c) { return !is_closure(c.solution); });
  std::erase_if(one.pairs, [&](const auto& p) { return !is_closure(p.a) || !is_closure(p.b); });
  one.budget.clear();
  std::erase_if(baseline.cases[0].methods, [&](const auto& m) { return !is_closure(m.id()); });
  return baseline;
}

TEST(RunAgain, AgreesWithTheSavedBaseline) {
  const auto baseline = closures();
  std::vector<methods::RunProgress> told;
  const auto run = repeat_baseline_run(baseline, "fpkcheck check", 2,
                                       [&](const methods::RunProgress& at) { told.push_back(at); });
  EXPECT_EQ(run.program.command, "fpkcheck check");
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told.back().total, baseline.cases[0].methods.size());
  const auto same = compare_runs(baseline.run, run, {});
  for (const auto& quantity_change : same.quantities_beyond_tolerance())
    ADD_FAILURE() << quantity_change.solution << " " << quantity_change.name;
  EXPECT_GT(same.changes.size(), 300u);
}

TEST(RunAgain, FindsEveryRelativeChangeOf1e6InAClosure) {
  const auto baseline = closures();
  const auto again = repeat_baseline_run(baseline, "", 2, {});
  std::size_t tried = 0;
  for (const auto& closure : baseline.run.cases[0].solutions) {
    auto before = tests::only(baseline.run, closure.id());
    const auto run = tests::only(again, closure.id());
    auto& was = before.cases[0].solutions.at(0);
    for (auto& o : was.metrics) {
      const auto* now = transform::find_metric(run.cases[0].find(was.id())->metrics, o.path);
      const auto value = transform::metric_number(was.metrics, o.path);
      if (now == nullptr || !value || now->kind == transform::SolverMetricKind::work) continue;
      const auto kept = o.value;
      const double size = std::max(std::abs(*value), now->min_scale);
      o.value = *value + size * (now->is_rounding_sensitive ? 3e-6 : 1e-6);
      EXPECT_GE(compare_runs(before, run, {}).quantities_beyond_tolerance().size(), 1u)
          << was.id() << " " << o.path;
      o.value = kept;
      ++tried;
    }
  }
  EXPECT_GT(tried, 200u);
}

/// A run of one simulation.
results::Run simulated_run(std::uint64_t seed, double intensity = 0.1, double time = 2e5) {
  const auto problem = tests::make_problem({.intensity = intensity});
  const auto method = methods::builtin_registry().find_method_by_id(
      "mcs",
      {{"time", time}, {"seed", static_cast<std::int64_t>(seed)}, {"streams", std::int64_t{64}}});
  return {results::current_program(""), methods::run_cases({problem}, {*method}, 0, {})};
}

TEST(SimulationCheck, AnotherSeedAgreesWithinItsErrors) {
  const auto baseline = simulated_run(1);
  for (std::uint64_t seed = 2; seed <= tests::part_unless_thorough(3u, 6u); ++seed) {
    const auto other = compare_runs(baseline, simulated_run(seed), {});
    for (const auto& quantity_change : other.quantities_beyond_tolerance())
      ADD_FAILURE() << seed << " " << quantity_change.name;
    // The runs differ: otherwise the agreement would prove nothing.
    EXPECT_TRUE(std::ranges::any_of(other.changes,
                                    [](const CheckedQuantityChange& f) { return f.change > 0.5; }));
  }
  constexpr double kShort = 2e4;  // identical digits at every length
  const auto same = compare_runs(simulated_run(1, 0.1, kShort), simulated_run(1, 0.1, kShort), {});
  EXPECT_TRUE(std::ranges::all_of(same.changes,
                                  [](const CheckedQuantityChange& f) { return f.change == 0; }));
}

TEST(SimulationCheck, FindsFivePercentStrongerImpulses) {
  constexpr double kTime = 4e4;
  const auto one = simulated_run(1, 0.1, kTime), stronger = simulated_run(2, 0.105, kTime);
  EXPECT_GE(compare_runs(one, stronger, {}).quantities_beyond_tolerance().size(), 2u);
}

}  // namespace
}  // namespace fpkcheck::check
