#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "compare/page/page.hpp"
#include "saved_run.hpp"

/// Runs with all that a page can show, and what stands in a page.
namespace fpkcheck::tests {

/// The joint densities of the made-up closures and finite differences that are ok, and one of the
/// simulation that is 2 % above the reference on y' > 0.
inline std::vector<compare::JointDensity> made_up_joints(const compare::CaseReport& report,
                                                         std::size_t ny, std::size_t nv) {
  std::vector<double> y_edges, v_edges;
  for (std::size_t i = 0; i <= ny; ++i) {
    y_edges.push_back(report.axes.y_edges.back() * static_cast<double>(i) /
                      static_cast<double>(ny));
  }
  for (std::size_t j = 0; j <= nv; ++j) {
    v_edges.push_back(report.axes.v_edges.back() *
                      (2 * static_cast<double>(j) / static_cast<double>(nv) - 1));
  }
  std::vector<compare::JointDensity> joints;
  for (const auto& entry : report.entries) {
    if (!entry.solution.density) continue;
    joints.push_back(
        {report.problem.name, entry.solution.id,
         on_cells(std::get<transform::SmoothDensity>(*entry.solution.density), y_edges, v_edges)});
  }
  auto simulated = joints.back();  // fd-kf
  simulated.solution = "mcs";
  for (std::size_t k = 0; k < simulated.density.averages.size(); ++k) {
    if (k % nv >= nv / 2) simulated.density.averages[k] *= 1.02;
  }
  joints.push_back(simulated);
  return joints;
}

inline nlohmann::ordered_json made_up_budget() {
  using Json = nlohmann::ordered_json;
  Json budget = Json::array();
  for (const char* variable : {"y", "ydot"}) {
    budget.push_back({{"solution", "epc-gaussian-n6"},
                      {"variable", variable},
                      {"reference", "mcs"},
                      {"total", 0.0024},
                      {"total_tail", 0.23},
                      {"tail", {{"from", 1e-4}, {"to", 1e-2}, {"bins", 17}}},
                      {"parts",
                       {{{"name", "closure"},
                         {"from", "epc-gaussian-n6"},
                         {"to", "fd-km4-delta"},
                         {"l1", 0.00231},
                         {"tail", 0.21},
                         {"uncertainty", 0.00004}},
                        {{"name", "impact"},
                         {"from", "fd-km4-delta"},
                         {"to", "fd-km4"},
                         {"l1", nullptr},
                         {"tail", nullptr},
                         {"uncertainty", nullptr}},
                        {{"name", "sampling"},
                         {"from", "fd-kf limit"},
                         {"to", "mcs"},
                         {"l1", 0.00047},
                         {"tail", 0.02},
                         {"expected", 0.00059},
                         {"in_99", 0.00081}}}}});
  }
  return budget;
}

/// A run with joint densities and a budget.
inline compare::SavedRun whole_run(const std::string& name = "case1") {
  const auto report = full_report(name);
  auto run = compare::make_run("fpkcheck run", std::vector<compare::CaseReport>{report});
  run.joints = made_up_joints(report, 20, 40);
  run.summary["cases"][0]["budget"] = made_up_budget();
  run.summary["cases"][0]["limits"] = "Nothing here is exact.";
  return run;
}

/// What page.js reads.
inline nlohmann::json plots_in(const std::string& page) {
  const std::string opening = "<script type=\"application/json\" id=\"plots\">";
  const auto begin = page.find(opening) + opening.size();
  return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

inline std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace fpkcheck::tests
