#include "methods/external/external_methods.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>

#include "methods/builtin_solvers.hpp"
#include "methods/run_cases.hpp"
#include "refusal.hpp"
#include "report/findings.hpp"
#include "report/terminal_tables.hpp"
#include "report/write_report.hpp"
#include "results/saved_run.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::methods {
namespace {

namespace fs = std::filesystem;
using tests::contains;
using transform::StateVariable;

// A synthetic run, files of the marginals of its fd-kf, and the run with these files added.
class ExternalMethods : public testing::Test {
 protected:
  std::string write(const std::string& name, StateVariable variable, double standard_error = 0) {
    const fs::path file = directory_.path() / name;
    std::ofstream out(file);
    const auto& density = std::get<transform::SmoothDensity>(*solutions_[6].density);
    const auto& bins = compare::comparison_bin_edges(axes_, variable);
    const auto exact = transform::marginal(density, variable, bins);
    for (std::size_t b = 0; b < exact.size(); ++b) {
      out << (standard_error > 0
                  ? fmt::format("{} {} {}\n", exact.bin_centre(b), exact.density[b], standard_error)
                  : fmt::format("{} {} {}\n", bins[b], bins[b + 1], exact.density[b]));
    }
    return file.string();
  }

  results::CaseResult case_with(const std::vector<std::string>& arguments) {
    std::vector<transform::Solution> all;
    for (const auto& method : external_density_methods_from_files(arguments, builtin_registry())) {
      all.push_back(solve_with_method(method, problem_, {axes_, {}}));
    }
    all.insert(all.end(), solutions_.begin(), solutions_.end());
    return results::make_case_result(problem_, axes_, all);
  }

  std::string refusal(const std::vector<std::string>& arguments) {
    return tests::refusal(
        [&] { external_density_methods_from_files(arguments, builtin_registry()); });
  }

  tests::TemporaryDirectory directory_;
  problem::Problem problem_ = tests::paper_case(1);
  compare::ComparisonBins axes_ = compare::comparison_bins(problem_);
  std::vector<transform::Solution> solutions_ = tests::made_up_solutions(axes_);
};

double observed(const transform::Solution& solution, const std::string& path) {
  return transform::metric_number(solution.metrics, path).value_or(NAN);
}

TEST_F(ExternalMethods, AnExactFileHasNoDistanceFromItsSolution) {
  const auto one = case_with({write("y.csv", StateVariable::y) + ":lab",
                              write("v.csv", StateVariable::ydot) + ":lab",
                              write("alone.csv", StateVariable::ydot)});
  ASSERT_EQ(one.solutions.size(), 10u);
  const auto &lab = one.solutions[0], &alone = one.solutions[1], &full = one.solutions[8];
  EXPECT_EQ(lab.id(), "lab");
  EXPECT_EQ(alone.id(), "alone");
  EXPECT_LT(*one.l1_distance("lab", "fd-kf", StateVariable::y), 1e-9);
  EXPECT_LT(*one.l1_distance("lab", "fd-kf", StateVariable::ydot), 1e-9);
  EXPECT_GT(*one.l1_distance("lab", "mcs", StateVariable::y), 1e-4);

  EXPECT_EQ(lab.identity.method, "file");
  EXPECT_EQ(transform::equation_and_impact_text(lab.identity), "given/-");
  EXPECT_EQ(lab.identity.role, transform::SolutionRole::external);
  EXPECT_NEAR(lab.mass, 1, 1e-9);
  using transform::Moments;
  for (const auto moment : {&Moments::y1, &Moments::y2, &Moments::y4, &Moments::v2, &Moments::v4}) {
    EXPECT_NEAR(lab.moments.*moment / (full.moments.*moment), 1, 3e-3);
  }
  EXPECT_TRUE(std::isnan(alone.moments.y2));
  EXPECT_FALSE(std::isnan(alone.moments.v2));
  EXPECT_TRUE(std::isnan(alone.energy_residual));
  EXPECT_TRUE(contains(transform::metric_text(lab.metrics, "files[1].file").value(), "v.csv"));
}

TEST_F(ExternalMethods, DifferencesAreComparedWithTheirErrors) {
  const auto sentence = [&](double standard_error) {
    const auto all = report::case_finding_sentences(
        case_with({write("lab.csv", StateVariable::y, standard_error)}));
    std::string own;
    for (const auto& text : all) {
      if (text.starts_with("lab differs")) own += text;
    }
    return own;
  };
  EXPECT_TRUE(contains(sentence(1e-2), "the densities agree")) << sentence(1e-2);
  EXPECT_FALSE(contains(sentence(1e-2), "disagree")) << sentence(1e-2);
  EXPECT_TRUE(contains(sentence(1e-2), "from the full jump equation (fd-kf) by L1"));
  // Sampling errors of the file and of the simulation (0.0011) together.
  const auto who = solutions_.back().identity;
  solutions_.back() = solutions_[0];
  solutions_.back().identity = who;
  EXPECT_TRUE(contains(sentence(1e-5), "the densities disagree")) << sentence(1e-5);
  EXPECT_FALSE(contains(sentence(0), "explain")) << sentence(0);
}

TEST_F(ExternalMethods, BiasIsNotExplainedByTheErrorsOfADenseFile) {
  // Relative standard error 5 %, 30 points per bin, bias of 8 % with alternating sign.
  const auto sentence = [&](double bias) {
    const auto& density = std::get<transform::SmoothDensity>(*solutions_[6].density);
    const double end = axes_.y_edges.back();
    constexpr int kPoints = 3000;
    std::vector<double> fine{0};
    for (int k = 0; k < kPoints; ++k) fine.push_back(end * (k + 1) / kPoints);
    const auto exact = transform::marginal(density, StateVariable::y, fine);
    const fs::path file = directory_.path() / "dense.csv";
    std::ofstream out(file);
    std::mt19937_64 engine(3);
    std::normal_distribution<double> normal;
    for (std::size_t k = 0; k < exact.size(); ++k) {
      const double sign = exact.bin_centre(k) < end / 10 ? 1 : -1;
      out << fmt::format("{} {} {}\n", exact.bin_centre(k),
                         exact.density[k] * (1 + sign * bias + 0.05 * normal(engine)),
                         0.05 * exact.density[k]);
    }
    out.close();
    for (const auto& text : report::case_finding_sentences(case_with({file.string()}))) {
      if (contains(text, "dense differs from the full")) return text;
    }
    return std::string();
  };
  EXPECT_TRUE(contains(sentence(0), "the densities agree")) << sentence(0);
  EXPECT_TRUE(contains(sentence(0.02), "the densities disagree")) << sentence(0.02);
}

TEST_F(ExternalMethods, NoteMassBeyondTheAxes) {
  const double end = axes_.y_edges.back();
  const auto file_of = [&](double length) {  // exponential density with this mean
    const fs::path file = directory_.path() / "far.csv";
    std::ofstream out(file);
    for (int k = 0; k <= 400; ++k) {
      const double y = length * k / 20;
      out << fmt::format("{} {}\n", y, std::exp(-y / length) / length);
    }
    return file.string();
  };
  const auto note = [&](const results::CaseResult& one) {
    std::string all;
    for (const auto& text : report::case_finding_sentences(one)) {
      if (text.starts_with("Note on far.csv")) all += text;
    }
    return all;
  };
  const auto share = [&](const results::CaseResult& one) {
    return observed(one.solutions[0], "files[0].beyond_axes");
  };
  const auto within = case_with({file_of(end / 10)}), far = case_with({file_of(end / 2)});
  EXPECT_NEAR(share(within), std::exp(-10), 1e-5);
  EXPECT_EQ(note(within), "");
  EXPECT_NEAR(share(far), std::exp(-2), 1e-4);
  EXPECT_TRUE(contains(note(far), "13.5 % of the mass is outside the comparison axes, y = 0 to "))
      << note(far);
}

TEST_F(ExternalMethods, TheWorseOfTwoFilesIsReported) {
  const auto shorter = [&](const std::string& name, StateVariable variable, double factor) {
    std::ifstream in(write("whole.csv", variable));
    const fs::path file = directory_.path() / name;
    std::ofstream out(file);
    double a, b, p;
    while (in >> a >> b >> p) out << fmt::format("{} {} {}\n", a, b, factor * p);
    return file.string();
  };
  for (const bool bad_first : {true, false}) {
    const auto y = shorter("y.csv", StateVariable::y, bad_first ? 0.94 : 1);
    const auto v = shorter("v.csv", StateVariable::ydot, bad_first ? 1 : 0.95);
    const auto lab = case_with({y + ":lab", v + ":lab"}).solutions[0];
    EXPECT_NEAR(lab.mass, bad_first ? 0.94 : 0.95, 1e-6);
    EXPECT_NEAR(observed(lab, "files[0].mass"), bad_first ? 0.94 : 1, 1e-6);
    EXPECT_NEAR(observed(lab, "files[1].mass"), bad_first ? 1 : 0.95, 1e-6);
    const double of_y = observed(lab, "files[0].min_density"),
                 of_v = observed(lab, "files[1].min_density");
    EXPECT_NE(of_y, of_v);
    EXPECT_EQ(lab.min_density, std::min(of_y, of_v));
  }
}

TEST_F(ExternalMethods, AreReportedFromTheSavedRun) {
  const results::Run run{results::current_program("fpkcheck run"),
                         {case_with({write("lab.csv", StateVariable::y, 1e-3)})}};
  const fs::path saved = directory_.path() / "run";
  fs::create_directory(saved);
  report::write_report(saved, run);
  const std::string again = report::rebuild_report(saved, results::load_run(saved), 80).text;
  EXPECT_EQ(again, report::terminal_tables_text(run, 80));
  EXPECT_TRUE(contains(again, "given/-"));
  EXPECT_TRUE(contains(again, "given: an external density."));
  EXPECT_FALSE(contains(report::terminal_tables_text(tests::made_up_run(), 80), "given"));
  std::istringstream lines(again);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << line;
}

TEST_F(ExternalMethods, LabelsMustNotBeIdsOfMethods) {
  const std::string y = write("y.csv", StateVariable::y), v = write("v.csv", StateVariable::ydot);
  EXPECT_EQ(external_density_methods_from_files(std::vector{y}, builtin_registry()).front().id(),
            "y");
  const std::string colon = write("a:b.csv", StateVariable::y);
  EXPECT_EQ(
      external_density_methods_from_files(std::vector{colon}, builtin_registry()).front().id(),
      "a_b");
  EXPECT_EQ(external_density_methods_from_files(std::vector{colon + ":c"}, builtin_registry())
                .front()
                .id(),
            "c");
  for (const char* label : {"", "a,b", "a b", "a/b", "much-too-long-for-a-table-of-80"}) {
    EXPECT_TRUE(contains(refusal({y + ":" + label}), "must be 1 to 24 letters")) << label;
  }
  for (const char* label : {"mcs", "fd-kf", "fd", "epc-gaussian-n6", "mcs-white"}) {
    EXPECT_TRUE(contains(refusal({y + ":" + label}), "is the name of a method")) << label;
  }
  EXPECT_EQ(refusal({y + ":a", v + ":a"}), "accepted");
  EXPECT_TRUE(contains(refusal({y + ":a", y + ":a"}), "two files of 'a' are densities of y;"));
  EXPECT_TRUE(contains(refusal({"absent.csv:a"}), "'absent.csv' is not a readable file"));
}

// Names of netCDF variables and of gnuplot data blocks cannot contain '-' or '.'.
TEST_F(ExternalMethods, LabelsMustDifferInLettersOrDigits) {
  const auto y = write("y.csv", StateVariable::y), v = write("v.csv", StateVariable::ydot);
  EXPECT_TRUE(contains(refusal({y + ":fd_kf"}), "label 'fd_kf' is the name of a method"));
  EXPECT_TRUE(
      contains(refusal({y + ":epc.gaussian"}), "label 'epc.gaussian' is the name of a method"));
  EXPECT_TRUE(contains(refusal({y + ":a.b", v + ":a-b"}), "labels 'a.b' and 'a-b' differ only in"));
  EXPECT_EQ(refusal({y + ":a.b", v + ":a.b"}), "accepted");
  EXPECT_EQ(refusal({y + ":fdm"}), "accepted");
}

}  // namespace
}  // namespace fpkcheck::methods
