#include "report/page/error_maps.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

#include "report/page/heat_map_values.hpp"
#include "report/page/html.hpp"
#include "report/text/number_text.hpp"

namespace fpkcheck::report {
namespace {

using Json = nlohmann::ordered_json;
using results::CaseResult;
using transform::Moments;

// Number of levels of a map's values, which limits the resolution of the colours and of the value
// shown for a cell.
constexpr int kErrorLevels = 127;

struct MappedMoment {
  const char* name;
  const char* text;
  double Moments::*member;
};
constexpr MappedMoment kMappedMoments[] = {{"y2", "E[y\u00b2]", &Moments::y2},
                                           {"v2", "E[y\u2032\u00b2]", &Moments::v2}};

// The ids of the solutions: closures with status ok by increasing distance to the reference, then
// all other solutions.
std::vector<std::string> solutions_by_accuracy(const CaseResult& one) {
  std::vector<std::string> ids;
  for (const auto* closure : one.assessment.ranked_closures()) ids.push_back(closure->id);
  for (const auto& own : one.moment_error_estimates) {
    if (std::ranges::find(ids, own.solution) == ids.end()) ids.push_back(own.solution);
  }
  return ids;
}

ErrorMaps::OfSolution maps_of(const CaseResult& one, const std::string& id,
                              const CellWindow& window) {
  ErrorMaps::OfSolution maps{id, {}};
  const auto* own = one.moment_error_estimate(id);
  if (own == nullptr) return maps;
  for (const auto& [name, text, member] : kMappedMoments) {
    const auto* source = one.error_source(id, name);
    if (source == nullptr) continue;
    maps.moments.push_back(
        {text, own->error.*member,
         signed_roots(rows_of_constant_velocity(source->density, window), kErrorLevels)});
  }
  return maps;
}

}  // namespace

std::optional<ErrorMaps> error_maps(const CaseResult& one) {
  if (one.error_sources.empty()) return std::nullopt;
  const auto& cells = one.error_sources.front().density;
  const bool same = std::ranges::all_of(one.error_sources, [&](const auto& source) {
    return source.density.y_edges == cells.y_edges && source.density.v_edges == cells.v_edges;
  });
  // The maps use the window of the reference, or the window of the first joint density if there is
  // no reference: nearly all densities have the same window.
  const auto* measure = one.reference();
  const auto joint = std::ranges::find_if(one.joints, [&](const auto& candidate) {
    return measure == nullptr || candidate.solution == measure->id();
  });
  if (!same || joint == one.joints.end() || joint->density.y_edges != cells.y_edges ||
      joint->density.v_edges != cells.v_edges) {
    return std::nullopt;
  }
  const CellWindow window = cells_above_fraction(joint->density, kLogarithmicFraction);
  ErrorMaps maps{{cells.y_edges.begin() + std::ptrdiff_t(window.y_begin),
                  cells.y_edges.begin() + std::ptrdiff_t(window.y_end) + 1},
                 {cells.v_edges.begin() + std::ptrdiff_t(window.v_begin),
                  cells.v_edges.begin() + std::ptrdiff_t(window.v_end) + 1},
                 {}};
  for (const auto& id : solutions_by_accuracy(one)) {
    auto of_solution = maps_of(one, id, window);
    if (of_solution.moments.size() == std::size(kMappedMoments)) {
      maps.solutions.push_back(std::move(of_solution));
    }
  }
  if (maps.solutions.empty()) return std::nullopt;
  return maps;
}

std::string error_maps_html(const ErrorMaps& maps, const std::string& prefix) {
  std::string options;
  for (const auto& one : maps.solutions) {
    options += fmt::format("<option>{}</option>", escape_html(one.solution));
  }
  std::string html = fmt::format(
      "<p class=\"controls\"><label>Errors of: <select id=\"{}-errors-choice\">{}</select></label>"
      "</p>\n<p>The integral of a map is the error of the moment (dual-weighted residual). The map "
      "shows minus the solution of the backward equation times the residual of the density in the "
      "stationary equation. No other density is needed.</p>\n<div class=\"maps\">\n",
      prefix, options);
  for (std::size_t k = 0; k < std::size(kMappedMoments); ++k) {
    html += fmt::format(
        "<figure>\n<figcaption id=\"{0}-errors-caption{1}\"></figcaption>\n<div class=\"plot\" "
        "id=\"{0}-errors-map{1}\" role=\"img\" aria-label=\"Heat map of the sources of the error "
        "of {2}\"></div>\n</figure>\n",
        prefix, k, kMappedMoments[k].text);
  }
  return html + "</div>\n";
}

std::string error_maps_json(const ErrorMaps& maps, const std::string& prefix) {
  Json json{{"id", prefix + "-errors"},
            {"y_edges", float_array(maps.y_edges)},
            {"v_edges", float_array(maps.v_edges)},
            {"solutions", Json::array()}};
  for (const auto& one : maps.solutions) {
    Json moments = Json::array();
    for (const auto& [moment, error, values] : one.moments) {
      moments.push_back({{"moment", moment},
                         {"error", number_text(error, 2)},
                         {"largest", values.largest},
                         {"levels", values.levels},
                         {"steps", successive_differences(values.roots)}});
    }
    json["solutions"].push_back({{"solution", one.solution}, {"moments", moments}});
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace fpkcheck::report
