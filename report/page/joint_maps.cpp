#include "report/page/page_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/rest_atoms.hpp"
#include "report/case_solutions.hpp"
#include "report/figure/figure.hpp"
#include "report/figure/heat_map_values.hpp"
#include "report/page/html_elements.hpp"
#include "report/text/number_text.hpp"

namespace fpkcheck::report {
namespace {

using Json = nlohmann::ordered_json;
using results::JointDensity;
using transform::GridDensity;

// Number of quantisation levels of heat maps, which resolves differences down to 1e-8 of the
// largest difference. Logarithmic heat maps show ratios in the tails, where the densities exceed
// 1e-8 of the largest difference.
constexpr int kLevels = 4096;

double l1_distance(const GridDensity& a, const GridDensity& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.y_cell_count(); ++i) {
    for (std::size_t j = 0; j < a.v_cell_count(); ++j) {
      const double area = (a.y_edges[i + 1] - a.y_edges[i]) * (a.v_edges[j + 1] - a.v_edges[j]);
      sum += area * std::abs(a.cell_average(i, j) - b.cell_average(i, j));
    }
  }
  return sum;
}

JointDensityDifference joint_difference(const JointDensity& joint, const JointDensity& reference,
                                        const CellIndexWindow& window) {
  auto values = cell_averages_by_velocity_rows(joint.density, window);
  const auto subtracted = cell_averages_by_velocity_rows(reference.density, window);
  std::ranges::transform(values, subtracted, values.begin(), std::minus{});
  return {joint.solution, l1_distance(joint.density, reference.density),
          quantise_signed_roots(values, kLevels)};
}

const JointDensity* find_joint_density(const results::CaseResult& case_result,
                                       const std::string& solution) {
  const auto found = std::ranges::find(case_result.joints, solution, &JointDensity::solution);
  return found == case_result.joints.end() ? nullptr : &*found;
}

// Returns the ids of the `ok` closures, the closest closure first, then the ids of all other `ok`
// solutions.
std::vector<std::string> compared_solutions(const results::CaseResult& case_result,
                                            const std::string& reference) {
  std::vector<std::string> ids;
  for (const auto* closure : case_result.assessment.closures_ranked_by_distance())
    ids.push_back(closure->id);
  for (const auto& solution : case_result.solutions) {
    const bool ranked = std::ranges::find(ids, solution.id()) != ids.end();
    if (!ranked && solution.has_status_ok() && solution.id() != reference)
      ids.push_back(solution.id());
  }
  return ids;
}

bool has_same_cells(const GridDensity& a, const GridDensity& b) {
  return a.y_edges == b.y_edges && a.v_edges == b.v_edges;
}

// Returns the reference of the joint densities, usually the reference solution of the case. If the
// reference of the case has no joint density or is a simulation with control variates, another
// solution of the full problem is preferred. Control variates reduce the sampling error of averages
// over smooth bins, but not of averages over cells.
const transform::Solution* joint_reference(const results::CaseResult& case_result) {
  const transform::Solution* selected = nullptr;
  for (const auto* solution : solutions_of_full_problem(case_result)) {
    if (find_joint_density(case_result, solution->id()) == nullptr) continue;
    if (selected == nullptr || (selected->smooth_sampling && !solution->smooth_sampling))
      selected = solution;
  }
  return selected;
}

}  // namespace

std::optional<JointDensityHeatMaps> make_joint_density_maps(
    const results::CaseResult& case_result) {
  const auto* reference_solution = joint_reference(case_result);
  const JointDensity* reference = reference_solution != nullptr
                                      ? find_joint_density(case_result, reference_solution->id())
                                      : nullptr;
  if (reference == nullptr) return std::nullopt;
  const GridDensity& density = reference->density;
  const CellIndexWindow window = window_of_cells_above_peak_fraction(density, kLogarithmicFraction),
                        bulk = window_of_cells_above_peak_fraction(density, kLinearFraction);
  JointDensityHeatMaps maps{
      reference->solution,
      {density.y_edges.begin() + window.y_begin, density.y_edges.begin() + window.y_end + 1},
      {density.v_edges.begin() + window.v_begin, density.v_edges.begin() + window.v_end + 1},
      cell_averages_by_velocity_rows(density, window),
      {density.y_edges[bulk.y_begin], density.y_edges[bulk.y_end]},
      {density.v_edges[bulk.v_begin], density.v_edges[bulk.v_end]},
      {}};
  for (const auto& id : compared_solutions(case_result, reference->solution)) {
    const JointDensity* joint = find_joint_density(case_result, id);
    if (joint == nullptr || !has_same_cells(joint->density, density)) continue;
    maps.differences.push_back(joint_difference(*joint, *reference, window));
    // The integral over the cells of the phase plane does not include the atoms of mass at rest,
    // which are single points.
    maps.differences.back().l1 +=
        compare::rest_atom_l1_distance(transform::find_solution(case_result.solutions, id)->atoms,
                                       reference_solution->atoms, transform::StateVariable::y);
  }
  if (maps.differences.empty()) return std::nullopt;
  return maps;
}

std::string joint_density_maps_html(const JointDensityHeatMaps& maps, const std::string& prefix) {
  std::string options;
  for (const auto& difference : maps.differences) {
    options += fmt::format("<option value=\"{0}\">{0} (L1 {1})</option>",
                           escape_html(difference.solution), l1_distance_cell_text(difference.l1));
  }
  const std::string reference = escape_html(maps.reference);
  const std::string first = escape_html(maps.differences.front().solution);
  std::string html = fmt::format(
      "<p class=\"controls\"><label>Compared with {0}: <select id=\"{1}-joint-choice\">{2}</select>"
      "</label>\n"
      "<label>Colours: <select id=\"{1}-joint-scale\"><option value=\"linear\">linear</option>"
      "<option value=\"logarithmic\">logarithmic</option></select></label></p>\n"
      "<p>Here L1 is the integral of |p(y, y\u2032) \u2212 reference| over the plane.</p>\n"
      "<div class=\"maps\">\n",
      reference, prefix, options);
  const auto add_map = [&](const char* id, const std::string& caption, const char* spoken) {
    html += fmt::format(
        "<figure>\n<figcaption>{}</figcaption>\n<div class=\"plot\" id=\"{}-joint-{}\" "
        "role=\"img\" aria-label=\"{}\"></div>\n</figure>\n",
        caption, prefix, id, spoken);
  };
  add_map("reference", fmt::format("p(y, y\u2032) of {}", reference),
          "Heat map of the joint density of the reference");
  add_map("chosen",
          fmt::format("p(y, y\u2032) of <span id=\"{}-joint-name\">{}</span>", prefix, first),
          "Heat map of the joint density of the selected solution");
  add_map(
      "difference",
      fmt::format("<span id=\"{}-joint-caption\">{} \u2212 {}</span>", prefix, first, reference),
      "Heat map of the difference between both joint densities");
  return html + "</div>\n";
}

std::string joint_density_maps_json(const JointDensityHeatMaps& maps, const std::string& prefix) {
  Json json{{"id", prefix + "-joint"},
            {"prefix", prefix},
            {"reference", maps.reference},
            {"y_edges", encode_float_array(maps.y_edges)},
            {"v_edges", encode_float_array(maps.v_edges)},
            {"decades", -std::log10(kLogarithmicFraction)},
            {"colours", kDivergingColours},
            {"y_bulk", maps.y_bulk},
            {"v_bulk", maps.v_bulk},
            {"density", encode_float_array(maps.reference_density)},
            {"differences", Json::array()}};
  for (const auto& difference : maps.differences) {
    json["differences"].push_back({{"solution", difference.solution},
                                   {"largest", difference.values.largest},
                                   {"levels", difference.values.levels},
                                   {"steps", successive_differences(difference.values.roots)}});
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace fpkcheck::report
