#include "compare/foreign/foreign_methods.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>

#include "compare/findings.hpp"
#include "compare/report.hpp"
#include "compare/table.hpp"
#include "problem/input_error.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::compare {
namespace {

namespace fs = std::filesystem;
using tests::contains;
using transform::Variable;

// A made-up run, files of its fd-kf, and the run with these files read.
class ForeignMethods : public testing::Test {
 protected:
  std::string write(const std::string& name, Variable variable, double standard_error = 0) {
    const fs::path file = directory_.path() / name;
    std::ofstream out(file);
    const auto& density = std::get<transform::SmoothDensity>(*report_.entries[6].solution.density);
    const auto& bins = edges(report_.axes, variable);
    const auto exact = transform::marginal(density, variable, bins);
    for (std::size_t b = 0; b < exact.size(); ++b) {
      out << (standard_error > 0
                  ? fmt::format("{} {} {}\n", exact.centre(b), exact.density[b], standard_error)
                  : fmt::format("{} {} {}\n", bins[b], bins[b + 1], exact.density[b]));
    }
    return file.string();
  }

  SavedRun run_with(const std::vector<std::string>& arguments) {
    std::vector<Entry> entries;
    for (const auto& method : foreign_methods(arguments)) {
      entries.push_back(method.solve(report_.problem, report_.axes, {}));
    }
    for (const auto& entry : report_.entries) entries.push_back(entry);
    const auto report = report_on_case(report_.problem, report_.axes, entries);
    return make_run("fpkcheck run", std::span(&report, 1));
  }

  std::string refusal(const std::vector<std::string>& arguments) {
    try {
      foreign_methods(arguments);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }

  tests::TemporaryDirectory directory_;
  CaseReport report_ = tests::full_report();
};

double l1(const SavedRun& run, const std::string& a, const std::string& b,
          const std::string& variable) {
  for (const auto& c : run.summary["cases"][0]["comparisons"]) {
    if (c["a"] == a && c["b"] == b && c["variable"] == variable) return c["l1"];
  }
  ADD_FAILURE() << "no distance of " << a << " to " << b;
  return -1;
}

TEST_F(ForeignMethods, AnExactFileIsNoDistanceFromWhatItIsOf) {
  const SavedRun run =
      run_with({write("y.csv", Variable::y) + ":lab", write("v.csv", Variable::ydot) + ":lab",
                write("alone.csv", Variable::ydot)});
  const auto& solutions = run.summary["cases"][0]["solutions"];
  ASSERT_EQ(solutions.size(), 10u);
  EXPECT_EQ(solutions[0]["id"], "lab");
  EXPECT_EQ(solutions[1]["id"], "alone");
  EXPECT_LT(l1(run, "lab", "fd-kf", "y"), 1e-9);
  EXPECT_LT(l1(run, "lab", "fd-kf", "ydot"), 1e-9);
  EXPECT_GT(l1(run, "lab", "mcs", "y"), 1e-4);

  EXPECT_EQ(solutions[0]["method"], "file");
  EXPECT_EQ(solutions[0]["equation"], "given");
  EXPECT_EQ(solutions[0]["impact"], "-");
  EXPECT_NEAR(solutions[0]["mass"], 1, 1e-9);
  for (const char* moment : {"y1", "y2", "y4", "v2", "v4"}) {
    EXPECT_NEAR(solutions[0]["moments"][moment].get<double>() /
                    solutions[8]["moments"][moment].get<double>(),
                1, 3e-3)
        << moment;
  }
  EXPECT_TRUE(solutions[1]["moments"]["y2"].is_null());
  EXPECT_FALSE(solutions[1]["moments"]["v2"].is_null());
  EXPECT_TRUE(solutions[1]["energy_residual"].is_null());
  EXPECT_TRUE(contains(solutions[0]["files"][1]["file"], "v.csv"));
}

TEST_F(ForeignMethods, TheirErrorsExplainTheDifferenceOrNot) {
  const auto sentence = [&](double standard_error) {
    const auto run = run_with({write("lab.csv", Variable::y, standard_error)});
    const auto all = findings(run.summary["cases"][0]);
    std::string own;
    for (const auto& text : all) {
      if (text.starts_with("lab differs")) own += text;
    }
    return own;
  };
  EXPECT_TRUE(contains(sentence(1e-2), "which explains that")) << sentence(1e-2);
  EXPECT_FALSE(contains(sentence(1e-2), "does not")) << sentence(1e-2);
  EXPECT_TRUE(contains(sentence(1e-2), "from the full jump equation (fd-kf) by L1"));
  // Chance of the file and of the simulation (0.0011) together.
  report_.entries.back() = report_.entries[0];
  report_.entries.back().solution.id = "mcs";
  EXPECT_TRUE(contains(sentence(1e-5), "which does not explain that")) << sentence(1e-5);
  EXPECT_FALSE(contains(sentence(0), "explain")) << sentence(0);
}

TEST_F(ForeignMethods, BiasIsNotExplainedByTheErrorsOfADenseFile) {
  // sigma of relative 5 %, 30 points a bin, bias of 8 % in turns.
  const auto sentence = [&](double bias) {
    const auto& density = std::get<transform::SmoothDensity>(*report_.entries[6].solution.density);
    const double end = report_.axes.y_edges.back();
    constexpr int kPoints = 3000;
    std::vector<double> fine{0};
    for (int k = 0; k < kPoints; ++k) fine.push_back(end * (k + 1) / kPoints);
    const auto exact = transform::marginal(density, Variable::y, fine);
    const fs::path file = directory_.path() / "dense.csv";
    std::ofstream out(file);
    std::mt19937_64 engine(3);
    std::normal_distribution<double> normal;
    for (std::size_t k = 0; k < exact.size(); ++k) {
      const double sign = exact.centre(k) < end / 10 ? 1 : -1;
      out << fmt::format("{} {} {}\n", exact.centre(k),
                         exact.density[k] * (1 + sign * bias + 0.05 * normal(engine)),
                         0.05 * exact.density[k]);
    }
    out.close();
    const auto run = run_with({file.string()});
    for (const auto& text : findings(run.summary["cases"][0])) {
      if (contains(text, "dense differs from the full")) return text;
    }
    return std::string();
  };
  EXPECT_TRUE(contains(sentence(0), "which explains that")) << sentence(0);
  EXPECT_TRUE(contains(sentence(0.02), "which does not explain that")) << sentence(0.02);
}

TEST_F(ForeignMethods, SayWhatLiesBeyondTheAxes) {
  const double end = report_.axes.y_edges.back();
  const auto file_of = [&](double length) {  // of an exponential density of this mean
    const fs::path file = directory_.path() / "far.csv";
    std::ofstream out(file);
    for (int k = 0; k <= 400; ++k) {
      const double y = length * k / 20;
      out << fmt::format("{} {}\n", y, std::exp(-y / length) / length);
    }
    return file.string();
  };
  const auto note = [&](const SavedRun& run) {
    std::string all;
    for (const auto& text : findings(run.summary["cases"][0])) {
      if (text.starts_with("Of far.csv")) all += text;
    }
    return all;
  };
  const auto share = [&](const SavedRun& run) {
    return run.summary["cases"][0]["solutions"][0]["files"][0]["beyond_axes"].get<double>();
  };
  const SavedRun within = run_with({file_of(end / 10)}), far = run_with({file_of(end / 2)});
  EXPECT_NEAR(share(within), std::exp(-10), 1e-5);
  EXPECT_EQ(note(within), "");
  EXPECT_NEAR(share(far), std::exp(-2), 1e-4);
  EXPECT_TRUE(contains(note(far), "13.5 % of it lies beyond the axes of the comparison, y = 0 to "))
      << note(far);
}

TEST_F(ForeignMethods, TheWorseOfTwoFilesStandsForBoth) {
  const auto shorter = [&](const std::string& name, Variable variable, double factor) {
    std::ifstream in(write("whole.csv", variable));
    const fs::path file = directory_.path() / name;
    std::ofstream out(file);
    double a, b, p;
    while (in >> a >> b >> p) out << fmt::format("{} {} {}\n", a, b, factor * p);
    return file.string();
  };
  for (const bool bad_first : {true, false}) {
    const auto y = shorter("y.csv", Variable::y, bad_first ? 0.94 : 1);
    const auto v = shorter("v.csv", Variable::ydot, bad_first ? 1 : 0.95);
    const SavedRun run = run_with({y + ":lab", v + ":lab"});
    const auto& lab = run.summary["cases"][0]["solutions"][0];
    EXPECT_NEAR(lab["mass"], bad_first ? 0.94 : 0.95, 1e-6);
    EXPECT_NEAR(lab["files"][0]["mass"], bad_first ? 0.94 : 1, 1e-6);
    EXPECT_NEAR(lab["files"][1]["mass"], bad_first ? 1 : 0.95, 1e-6);
    const double of_y = lab["files"][0]["min_density"], of_v = lab["files"][1]["min_density"];
    EXPECT_NE(of_y, of_v);
    EXPECT_EQ(lab["min_density"], std::min(of_y, of_v));
  }
}

TEST_F(ForeignMethods, AreReportedOnAgainFromTheSavedRun) {
  const SavedRun run = run_with({write("lab.csv", Variable::y, 1e-3)});
  const fs::path saved = directory_.path() / "run";
  fs::create_directory(saved);
  write_report(saved, run);
  const std::string again = report_again(saved, 80).table;
  EXPECT_EQ(again, table(run.summary, 80));
  EXPECT_TRUE(contains(again, "given/-"));
  EXPECT_TRUE(contains(again, "given: from a file."));
  EXPECT_FALSE(contains(table(tests::made_up_run().summary, 80), "given"));
  std::istringstream lines(again);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << line;
}

TEST_F(ForeignMethods, LabelsAreIdsOfTheirOwn) {
  const std::string y = write("y.csv", Variable::y), v = write("v.csv", Variable::ydot);
  EXPECT_EQ(foreign_methods(std::vector{y}).front().id, "y");
  const std::string colon = write("a:b.csv", Variable::y);
  EXPECT_EQ(foreign_methods(std::vector{colon}).front().id, "a_b");
  EXPECT_EQ(foreign_methods(std::vector{colon + ":c"}).front().id, "c");
  for (const char* label : {"", "a,b", "a b", "a/b", "much-too-long-for-a-table-of-80"}) {
    EXPECT_TRUE(contains(refusal({y + ":" + label}), "must be 1 to 24 letters")) << label;
  }
  for (const char* label : {"mcs", "fd-kf", "fd", "epc-gaussian-n6", "mcs-white"}) {
    EXPECT_TRUE(contains(refusal({y + ":" + label}), "is a method's")) << label;
  }
  EXPECT_EQ(refusal({y + ":a", v + ":a"}), "accepted");
  EXPECT_TRUE(contains(refusal({y + ":a", y + ":a"}), "two files of 'a' are densities of y "));
  EXPECT_TRUE(contains(refusal({"absent.csv:a"}), "'absent.csv' is not a readable file"));
}

}  // namespace
}  // namespace fpkcheck::compare
