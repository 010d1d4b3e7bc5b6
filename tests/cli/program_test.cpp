#include "cli/program.hpp"

#include <gtest/gtest.h>

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "base/files/atomic_file.hpp"
#include "base/process/stop_request.hpp"
#include "methods/builtin_solvers.hpp"
#include "workflows/study/toy_methods.hpp"

namespace fpkcheck::cli {
namespace {

namespace fs = std::filesystem;

struct Outcome {
  int exit_code;
  std::string out;
  std::string err;
};

Outcome program(const std::vector<std::string>& arguments,
                const methods::SolverRegistry& registry = methods::builtin_registry()) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int exit_code = run_program(arguments, registry);
  std::fflush(stdout);
  return {exit_code, testing::internal::GetCapturedStdout(),
          testing::internal::GetCapturedStderr()};
}

// The words of a text that are separated by blanks.
std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

class Program : public testing::Test {
 protected:
  void SetUp() override {
    const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / ("fpkcheck-" + std::string(test->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  fs::path folder_;
};

// Bad inputs and unwritable directories: bad_inputs.txt.
TEST_F(Program, BoundsHaveValuesOrAReason) {
  const auto [done, table, none] = program({"bounds", "case1", "--width", "1e-2"});
  EXPECT_EQ(done, kSuccess) << none;
  EXPECT_NE(table.find("\nE[y'^2]"), std::string::npos) << table;
  const auto [refused, reason, nothing] = program({"bounds", "case1", "--set", "system.damping=2"});
  EXPECT_EQ(refused, kFailure);
  EXPECT_NE(reason.find("no bounds: "), std::string::npos) << reason;
}

TEST_F(Program, RunWritesFilesThatReportReads) {
  const std::string out = path("out");
  const auto run = program({"run", "case1", "--methods", "epc-gaussian-n6,fd-white,mcs", "--time",
                            "20000", "--out", out});
  ASSERT_EQ(run.exit_code, kSuccess) << run.err;
  EXPECT_EQ(run.err, "");  // no progress line: standard error is not a terminal
  std::ifstream file(fs::path(out) / "summary.json");
  const auto summary = nlohmann::json::parse(file);
  EXPECT_EQ(summary.at("schema"), 1);
  EXPECT_EQ(summary.at("cases").at(0).at("solutions").size(), 3u);
  EXPECT_NE(summary.at("program").at("command").get<std::string>().find("--time 20000"),
            std::string::npos);
  EXPECT_GT(fs::file_size(fs::path(out) / "marginals.csv"), 1000u);

  const auto again = program({"report", out});
  EXPECT_EQ(again.exit_code, kSuccess);
  EXPECT_EQ(run.out.substr(0, again.out.size()), again.out);  // `run` appends a closing line
  const auto quiet = program({"report", out, "-q"});
  EXPECT_EQ(quiet.exit_code, kSuccess);
  EXPECT_EQ(quiet.out, "");
}

TEST_F(Program, ADensityFromAFileIsComparedWithTheMethods) {
  std::ofstream mine(path("mine.csv"));
  for (int k = 0; k < 40; ++k) mine << 0.1 * k << ' ' << std::exp(-0.5 * k * k / 40) << '\n';
  mine.close();
  const auto run = program({"run", "case1", "--methods", "fd-white", "--against", path("mine.csv"),
                            "--json", "--out", path("out")});
  ASSERT_EQ(run.exit_code, kSuccess) << run.err;
  const auto one = nlohmann::json::parse(run.out).at("cases").at(0);
  EXPECT_EQ(one.at("solutions").at(0).at("id"), "mine");
  EXPECT_EQ(one.at("comparisons").size(), 1u);  // the file has p(y) only
  EXPECT_EQ(one.at("comparisons").at(0).at("a"), "mine");
  EXPECT_EQ(program({"report", path("out")}).exit_code, kSuccess);
}

TEST_F(Program, EvaluatesTheClosuresOfARunFromTheirCoefficients) {
  const std::string out = path("out");
  ASSERT_EQ(program({"epc", "case1", "--order", "4", "--accuracy", "1", "--formulation", "moment",
                     "--out", out})
                .exit_code,
            kSuccess);
  std::ofstream(path("at.csv")) << "y,v\n0,0\n0.5,-0.2\n-0.5,0\n";
  const auto done = program({"evaluate", out, "epc-moment-n4", "--at", path("at.csv"), "--json"});
  EXPECT_EQ(done.exit_code, kSuccess) << done.err;
  EXPECT_EQ(done.err, "");
  // The formula in docs/external.md, at energies below the confinement level.
  const auto summary = nlohmann::json::parse(std::ifstream(out + "/summary.json"));
  const auto& closure = summary.at("cases").at(0).at("solutions").at(0);
  double exponent = closure.at("log_C");
  for (const auto& term : closure.at("coefficients")) {
    exponent += term.at("a").get<double>() * std::pow(0.5, term.at("x1").get<int>()) *
                std::pow(-0.2, term.at("x2").get<int>());
  }
  const auto p = nlohmann::json::parse(done.out).at("p");
  EXPECT_NEAR(p.at(0).get<double>() / std::exp(closure.at("log_C").get<double>()), 1, 1e-12);
  EXPECT_NEAR(p.at(1).get<double>() / std::exp(exponent), 1, 1e-12);
  EXPECT_EQ(p.at(2), 0);
  const auto grid = program({"evaluate", out});
  EXPECT_EQ(grid.out.substr(0, 6), "y,v,p\n");
  EXPECT_EQ(std::ranges::count(grid.out, '\n'), 1 + 41 * 81);
}

TEST_F(Program, EvaluatesAClosedFormFromAFile) {
  std::ofstream(path("at.csv")) << "0.5 -0.2\n";
  std::ofstream(path("form.json")) << R"({"coordinates": "x1,x2", "C": 0.25, "coefficients": [
      {"x1": 1, "x2": 1, "a": 0.5}, {"x1": 0, "x2": 3, "a": 2}]})";
  const auto done = program({"evaluate", path("form.json"), "--at", path("at.csv")});
  EXPECT_EQ(done.exit_code, kSuccess) << done.err;
  // The sum over both points of the (z, z') plane that map to (y, y').
  const double p = 0.25 * (std::exp(-0.05 - 0.016) + std::exp(-0.05 + 0.016));
  EXPECT_NEAR(std::stod(done.out.substr(done.out.rfind(',') + 1)), p, 1e-14) << done.out;
}

TEST_F(Program, ASecondRunRemovesTheFilesOfTheFirst) {
  const std::string out = path("out");
  ASSERT_EQ(program({"run", "case1", "case2", "--methods", "epc-gaussian-n2", "--accuracy", "1",
                     "--out", out})
                .exit_code,
            kSuccess);
  const fs::path partial = base::partial_file_path(fs::path(out) / "figures" / "case2.png");
  const std::string mine = partial.string();
  constexpr const char* kUnusedPid = "4194999";  // exceeds the largest process id of Linux, 2^22
  std::ofstream(mine.substr(0, mine.rfind('-') + 1) + kUnusedPid) << "stopped";
  std::ofstream(fs::path(out) / "figures" / "mine.png") << "not ours";
  const auto second = program({"run", "case1", "--methods", "epc-gaussian-n8", "--out", out});
  EXPECT_EQ(second.exit_code, kFailure);  // no density, hence no figure
  std::vector<std::string> left;
  for (const auto& entry : fs::directory_iterator(fs::path(out) / "figures")) {
    left.push_back(entry.path().filename());
  }
  EXPECT_EQ(left, std::vector<std::string>{"mine.png"});
}

TEST_F(Program, ReportRefusesFilesOfDifferentRuns) {
  const std::string a = path("a"), b = path("b");
  program({"run", "case1", "--methods", "epc-gaussian-n2", "--out", a});
  program({"run", "case2", "--methods", "epc-gaussian-n2", "--out", b});
  fs::copy_file(fs::path(b) / "marginals.csv", fs::path(a) / "marginals.csv",
                fs::copy_options::overwrite_existing);
  const auto report = program({"report", a});
  EXPECT_EQ(report.exit_code, kBadInput);
  EXPECT_NE(report.err.find("not of the same run"), std::string::npos) << report.err;
}

TEST_F(Program, CheckFindsChangesAndWritesTheNewRun) {
  const std::string before = path("before"), after = path("after");
  ASSERT_EQ(
      program({"run", "case1", "case4", "--methods", "epc-gaussian-n2,epc-moment-n4,mcs", "--time",
               "20000", "--accuracy", "1", "--set", "impulse.mean=0.1", "--out", before})
          .exit_code,
      kSuccess);
  const auto same = program({"check", before + "/summary.json"});
  EXPECT_EQ(same.exit_code, kSuccess) << same.out;
  EXPECT_EQ(same.err, "");
  EXPECT_NE(same.out.find("figures of 6 solutions agree."), std::string::npos) << same.out;

  auto summary = nlohmann::ordered_json::parse(std::ifstream(before + "/summary.json"));
  auto& v2 = summary["cases"][1]["solutions"][1]["moments"]["v2"];
  v2 = v2.get<double>() * (1 + 1e-6);
  std::ofstream(before + "/summary.json") << summary;
  const auto moved = program({"check", before, "--out", after});
  EXPECT_EQ(moved.exit_code, kFailure);
  EXPECT_NE(moved.out.find("1 of "), std::string::npos) << moved.out;
  EXPECT_NE(moved.out.find("case4, E[Y] = 0.1  epc-moment-n4"), std::string::npos) << moved.out;
  const auto json = nlohmann::json::parse(std::ifstream(after + "/check.json"));
  EXPECT_EQ(json.at("agrees"), false);
  ASSERT_EQ(json.at("moved").size(), 1u);
  EXPECT_EQ(json.at("moved").at(0).at("figure"), "E[y'^2]");
  EXPECT_NEAR(json.at("moved").at(0).at("change").get<double>(), 1e-6, 1e-9);

  // The new run can serve as baseline.
  const auto adopted = program({"check", after, "--json"});
  EXPECT_EQ(adopted.exit_code, kSuccess);
  EXPECT_EQ(nlohmann::json::parse(adopted.out).at("agrees"), true);
  const auto quiet = program({"check", before, "--quiet"});
  EXPECT_EQ(quiet.exit_code, kFailure);
  EXPECT_EQ(quiet.out, "");
}

TEST_F(Program, CtrlCEndsARunWithOneLineAndNoDirectory) {
  std::jthread user([](const std::stop_token& stop) {
    // One signal only: a second signal would end the tests.
    while (!stop.stop_requested()) {
      struct sigaction now = {};
      sigaction(SIGINT, nullptr, &now);
      if (now.sa_handler != SIG_DFL) {
        kill(getpid(), SIGINT);
        return;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  const auto run = program({"run", "case1", "--methods", "mcs", "--out", path("a") + "/b"});
  user.request_stop();
  EXPECT_EQ(run.exit_code, kInterrupted);
  EXPECT_EQ(run.err, "fpkcheck: interrupted; nothing was written\n");
  EXPECT_EQ(run.out, "");
  EXPECT_FALSE(fs::exists(path("a")));
  // The next run is not interrupted.
  EXPECT_EQ(program({"run", "case1", "--methods", "epc-gaussian-n2", "--accuracy", "1", "--out",
                     path("a")})
                .exit_code,
            kSuccess);
}

// Two methods in sequence; a stop is requested while the first solves the case of this name.
methods::SolverRegistry registry_stopped_in(const std::string& case_name) {
  methods::SolverRegistry registry;
  for (const auto& toy : {tests::Toy{"plain", "plain", transform::SolutionRole::closure},
                          tests::Toy{"cells", "cells", transform::SolutionRole::equation}}) {
    auto solver = tests::toy_solver(toy);
    solver.method = [made = solver.method, case_name](const base::Values& values) {
      methods::Method method = made(values);
      method.uses_all_processors = true;  // each alone, in their order
      method.solve = [solve = method.solve, case_name, id = method.id()](
                         const problem::Problem& problem,
                         const methods::SolverInputContext& context) {
        if (problem.name == case_name && id == "plain") base::request_stop(SIGINT);
        return solve(problem, context);
      };
      return method;
    };
    registry.add_solver(std::move(solver));
  }
  return registry;
}

TEST_F(Program, AStoppedRunWritesCompletedCasesAndNamesMissingOnes) {
  std::vector<std::string> run{"run", "--out", path("out")};
  for (const auto* name : {"a", "b", "c"}) {
    run.push_back(path(name) + std::string(".ini"));
    std::ofstream(run.back()) << "[system]\ndamping=0.1\nstiffness=1\ncubic=0\nrestitution=1\n"
                              << "[impulse]\nrate=1\nlaw=gaussian\nintensity=0.1\n";
  }
  const auto stopped = program(run, registry_stopped_in("b"));
  EXPECT_EQ(stopped.exit_code, kInterrupted);
  EXPECT_EQ(stopped.err, "fpkcheck: interrupted; 1 case was written to " + path("out") +
                             " (`fpkcheck report " + path("out") + "` draws the figures)\n");
  const auto summary = nlohmann::json::parse(std::ifstream(path("out") + "/summary.json"));
  ASSERT_EQ(summary.at("cases").size(), 1u);
  EXPECT_EQ(summary.at("cases").at(0).at("name"), "a");
  EXPECT_EQ(summary.at("cases").at(0).at("solutions").size(), 2u);
  EXPECT_EQ(summary.at("stopped"),
            "This run was stopped by Ctrl-C (SIGINT) before its end. Missing: b, c. Without bounds "
            "and error estimates: a.");
  const auto report = program({"report", path("out")});
  EXPECT_EQ(report.exit_code, kSuccess) << report.err;
  EXPECT_NE(report.out.find("Missing: b, c."), std::string::npos) << report.out;
  // A stop during the first case leaves no results.
  EXPECT_EQ(program({"run", run[3], "--out", path("none")}, registry_stopped_in("a")).err,
            "fpkcheck: interrupted; nothing was written\n");
  EXPECT_FALSE(fs::exists(path("none")));
}

// A path may contain any bytes; the name of a case, which goes into JSON and netCDF, must be UTF-8.
TEST_F(Program, APathMayBeAnyBytesButACaseNameMustBeUtf8) {
  std::filesystem::create_directory(path("odd\xff"));
  const std::string ini = path("odd\xff/mine.ini");
  std::ofstream(ini) << "[system]\ndamping=0.1\nstiffness=1\ncubic=0\nrestitution=1\n"
                     << "[impulse]\nrate=1\nlaw=gaussian\nintensity=0.1\n";
  const auto run = program({"run", ini, "--methods", "epc-moment-n8", "--out", path("o\xff")});
  EXPECT_EQ(run.exit_code, kSuccess) << run.err;
  EXPECT_EQ(program({"report", path("o\xff")}).exit_code, kSuccess);
  std::filesystem::rename(ini, path("bad\xff.ini"));
  const auto refused = program({"epc", path("bad\xff.ini")});
  EXPECT_EQ(refused.exit_code, kBadInput);
  EXPECT_NE(refused.err.find("is not UTF-8"), std::string::npos) << refused.err;
}

TEST_F(Program, JsonIsTheOnlyOutput) {
  const auto [exit_code, out, err] =
      program({"epc", "case1", "--order", "2", "--accuracy", "0.1", "--json"});
  EXPECT_EQ(exit_code, kSuccess);
  const auto summary = nlohmann::json::parse(out);
  const auto& solution = summary.at("cases").at(0).at("solutions").at(0);
  EXPECT_EQ(solution.at("id"), "epc-gaussian-n2");
  EXPECT_EQ(solution.at("coefficients").size(), 3u);  // x1^2, x1 x2, x2^2
}

TEST_F(Program, AnUnmetRequestHasExitCodeOne) {
  const auto closure = program({"epc", "case1", "--order", "8"});
  EXPECT_EQ(closure.exit_code, kFailure);
  EXPECT_NE(closure.out.find("not_converged"), std::string::npos);
  const auto linearised = program({"epc", "case1", "--order", "2"});
  EXPECT_EQ(linearised.exit_code, kFailure);
  EXPECT_NE(linearised.out.find("inaccurate"), std::string::npos);
  const auto literal =
      program({"fd", "case1", "--equation", "km4", "--regularisation-length", "0", "--quiet"});
  EXPECT_EQ(literal.exit_code, kFailure);
  EXPECT_EQ(literal.out, "");
}

TEST_F(Program, AFullRunSucceedsIfSomeClosuresFail) {
  const auto run = program({"run", "case1", "--time", "20000", "--json", "--out", path("out")});
  EXPECT_EQ(run.exit_code, kSuccess) << run.err;
  const auto summary = nlohmann::json::parse(run.out);
  const auto& solutions = summary.at("cases").at(0).at("solutions");
  ASSERT_EQ(solutions.size(), 15u);
  EXPECT_EQ(solutions.at(3).at("status"), "not_converged");
}

TEST_F(Program, AStudyIsTabulatedAndSaved) {
  const std::string out = path("out");
  // Rare, strong impulses make the grids small.
  const auto study = program(words(
      "study regularisation case1 --set impulse.rate=0.2 --set system.restitution=0.9 --out " +
      out));
  EXPECT_EQ(study.exit_code, kSuccess) << study.err;
  EXPECT_NE(study.out.find("The literal scheme, l = h, grows at"), std::string::npos) << study.out;
  EXPECT_EQ(study.err, "");
  std::ifstream file(fs::path(out) / "study-regularisation.json");
  const auto saved = nlohmann::json::parse(file);
  EXPECT_EQ(saved.at("rows").size(), 20u);
  EXPECT_EQ(saved.at("impulse").at("rate"), 0.2);
  EXPECT_TRUE(fs::exists(fs::path(out) / "study-regularisation.csv"));
}

TEST_F(Program, SettingsReachTheSolver) {
  const auto [exit_code, out, err] =
      program({"fd", "case1", "--set", "system.restitution=1", "--equation", "white", "--stepper",
               "direct", "--nx", "40", "--nv", "80", "--json"});
  ASSERT_EQ(exit_code, kSuccess) << err;
  const auto solution = nlohmann::json::parse(out).at("cases").at(0).at("solutions").at(0);
  EXPECT_EQ(solution.at("nx"), 40);
  EXPECT_EQ(solution.at("steps"), 0);
  EXPECT_NEAR(solution.at("moments").at("v2").get<double>(), 0.5, 1e-5);  // lambda E[Y^2]/(2c)
}

TEST_F(Program, ADensityOverTimeWritesNetCdfAndAFigure) {
  const std::string out = path("out");
  const auto arguments = words(
      "fd case1 --until 0.5 --snapshots 2 --refinement 0.6 --start-y 0.6 --start-v 0.6 --equation "
      "white --set system.restitution=1 --time-tolerance 1e-4 --out " +
      out);
  const auto table = program(arguments);
  ASSERT_EQ(table.exit_code, kSuccess) << table.err;
  EXPECT_EQ(table.err, "");
  EXPECT_NE(table.out.find("E[y'^2]"), std::string::npos);
  EXPECT_TRUE(fs::exists(fs::path(out) / "transient.nc"));
  EXPECT_TRUE(fs::exists(fs::path(out) / "figures" / "transient-case1_r_1.gp"));

  auto as_json = arguments;
  as_json.back() = path("again");
  as_json.emplace_back("--json");
  const auto json = nlohmann::json::parse(program(as_json).out);
  EXPECT_EQ(json.at("status"), "ok");
  EXPECT_EQ(json.at("snapshots").size(), 3u);
  EXPECT_EQ(json.at("snapshots").at(2).at("time"), 0.5);
  EXPECT_NEAR(json.at("snapshots").at(0).at("moments").at("y2").get<double>(), 0.36, 1e-4);

  auto too_small = arguments;
  too_small.insert(too_small.end(), {"--y-max", "1", "--json"});
  EXPECT_EQ(program(too_small).exit_code, kFailure);
}

// x'' = xi in (-1, 1), with y = |x|: the exact mean time from 0.5 is 2.15610 (docs/functionals.md).
TEST_F(Program, PassagesFromAStateNeedNoStationaryDensity) {
  std::ofstream(path("exit.ini")) << "[system]\ndamping = 0\nstiffness = 0\n[noise]\n"
                                     "intensity = 1\n[wall]\nleft = 0\nleft_restitution = 1\n";
  const std::vector<std::string> common{"passage",        path("exit.ini"),
                                        "--displacement", "1",
                                        "--methods",      "fd-white",
                                        "--accuracy",     "0.1",
                                        "--times",        "1",
                                        "--json"};
  std::vector<std::string> from_state = common;
  from_state.insert(from_state.end(), {"--start", "0.5,0"});
  const Outcome solved = program(from_state);
  ASSERT_EQ(solved.exit_code, 0) << solved.err;
  const auto passage = nlohmann::json::parse(solved.out).at("cases").at(0).at("passage");
  EXPECT_NEAR(passage.at("solutions").at(0).at("mean_from_start").get<double>(), 2.1561, 2e-3);
  std::ofstream(path("no_wall.ini")) << "[system]\ndamping = 0\nstiffness = 0\n"
                                        "[noise]\nintensity = 1\n";
  from_state[1] = path("no_wall.ini");
  EXPECT_NE(program(from_state).err.find("'system.restitution' is missing"), std::string::npos);
  const Outcome refused = program(common);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("no stationary density"), std::string::npos) << refused.err;
}

TEST_F(Program, HelpAndVersionSucceed) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"--help"},
                                                    {"run", "--help"},
                                                    {"epc", "--help"},
                                                    {"fd", "-h"},
                                                    {"mcs", "--help"},
                                                    {"report", "--help"},
                                                    {"check", "--help"},
                                                    {"paper", "--help"},
                                                    {"study", "--help"},
                                                    {"study", "grid", "--help"},
                                                    {"study", "order", "--help"},
                                                    {"study", "regularisation", "--help"},
                                                    {"bounds", "--help"},
                                                    {"reference", "--help"},
                                                    {"help"},
                                                    {"help", "run"},
                                                    {"--version"}}) {
    const auto [exit_code, out, err] = program(arguments);
    EXPECT_EQ(exit_code, kSuccess);
    EXPECT_FALSE(out.empty());
    EXPECT_EQ(err, "");
    std::istringstream lines(out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << line;
  }
}

TEST_F(Program, HelpCommandEqualsHelpOption) {
  EXPECT_EQ(program({"help", "run"}).out, program({"run", "--help"}).out);
  EXPECT_EQ(program({"help", "study", "grid"}).out, program({"study", "grid", "--help"}).out);
  EXPECT_EQ(program({"help", "cook"}).exit_code, kBadInput);
}

TEST_F(Program, VersionNamesTheLibraries) {
  const auto out = program({"--version"}).out;
  EXPECT_TRUE(out.starts_with("fpkcheck "));
  for (const auto* library :
       {"SUNDIALS", "SuiteSparse", "KLU", "Eigen", "netCDF", "nlohmann-json", "Boost", "fmt"}) {
    const auto at = out.find("\n  " + std::string(library) + ' ');
    ASSERT_NE(at, std::string::npos) << library;
    const auto version = out.find_first_of("0123456789", at);
    EXPECT_LT(version, out.find('\n', at + 1)) << library;
  }
}

TEST_F(Program, ASweepPrintsJsonOnly) {
  const auto sweep = words(
      "sweep case1 --vary system.restitution=0.9,1 --methods epc-gaussian-n2 --set system.cubic=0 "
      "--accuracy auto --out " +
      path("sweep"));
  auto as_json = sweep;
  as_json.emplace_back("--json");
  const auto first = program(as_json);
  EXPECT_EQ(first.exit_code, kSuccess);
  const auto json = nlohmann::json::parse(first.out);
  ASSERT_EQ(json["points"].size(), 2);
  EXPECT_EQ(json["points"][0]["at"]["system.restitution"], 0.9);
  EXPECT_EQ(json["points"][1]["methods"][0]["status"], "ok");
  EXPECT_EQ(json["plan"]["case"]["system"]["cubic"], 0);
  // All points are in the journal: the same results, as a table.
  const auto again = program(sweep);
  EXPECT_EQ(again.exit_code, kSuccess);
  EXPECT_NE(again.out.find("2 points of case1, system.restitution = 0.9,1"), std::string::npos);
  EXPECT_TRUE(fs::exists(path("sweep") + "/sweep.csv"));
  EXPECT_TRUE(fs::exists(path("sweep") + "/report.html"));
}

}  // namespace
}  // namespace fpkcheck::cli
