#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gunzip_base64.hpp"
#include "modified_case.hpp"
#include "report/page/page_plots.hpp"
#include "report/page/page_sections.hpp"
#include "saved_run.hpp"

/// Runs with the data for all parts of a page, and readers of a page.
namespace fpkcheck::tests {

/// A case in which the full equation has an error estimate and is therefore the reference. The
/// simulation has a joint density 2 % above the reference for y' > 0.
inline results::CaseResult whole_case(const std::string& name = "case1") {
  auto case_result = made_up_case(name);
  solution_of(case_result, "fd-kf").error = {.y_l1 = 2e-5, .ydot_l1 = 3e-5, .moments = {}};
  case_result.update_assessment();
  auto simulated = case_result.joints.back();  // fd-kf
  simulated.solution = "mcs";
  auto& [y_edges, v_edges, averages] = simulated.density;
  for (std::size_t k = 0; k < averages.size(); ++k) {
    if (v_edges[k % simulated.density.v_cell_count()] > -1e-9) averages[k] *= 1.02;
  }
  case_result.joints.push_back(simulated);
  return case_result;
}

inline results::Run whole_run(const std::string& name = "case1") {
  return {results::current_program("fpkcheck run"), {whole_case(name)}};
}

/// The figure of a plot.
inline nlohmann::json figure_of(const report::ReportPagePlot& plot) {
  return nlohmann::json::parse(plot.figure);
}

/// The trace with this name.
inline nlohmann::json trace_of(const report::ReportPagePlot& plot, const std::string& name) {
  const auto figure = figure_of(plot);
  for (const auto& trace : figure.at("data")) {
    if (trace.at("name") == name) return trace;
  }
  return nullptr;
}

inline std::vector<std::string> names_in(const report::ReportPagePlot& plot) {
  std::vector<std::string> names;
  const auto figure = figure_of(plot);
  for (const auto& trace : figure.at("data")) names.push_back(trace.at("name"));
  return names;
}

inline std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// The cells of the row with this name in the first table with this caption, joined by "|".
inline std::string row_in(const std::string& html, const std::string& caption,
                          const std::string& name) {
  const auto table = html.find("<caption>" + caption + "</caption>");
  if (table == std::string::npos) return "no table";
  const std::string opening = "<tr><th scope=\"row\">" + name + "</th>";
  const auto row = html.find(opening, table);
  if (row == std::string::npos || row > html.find("</table>", table)) return "no row";
  std::string text;
  bool inside = false;
  const auto begin = row + opening.size();
  for (const char c : html.substr(begin, html.find("</tr>", begin) - begin)) {
    if (c == '<' && !inside && !text.empty() && !text.ends_with('|')) text += '|';
    if (c == '<') inside = true;
    if (!inside) text += c;
    if (c == '>') inside = false;
  }
  return text.substr(0, text.rfind('|'));
}

/// The headers of the first table with this caption, joined by "|".
inline std::string headers_in(const std::string& html, const std::string& caption) {
  const auto table = html.find("<caption>" + caption + "</caption>");
  if (table == std::string::npos) return "no table";
  std::string text;
  const auto end = html.find("</thead>", table);
  for (auto at = html.find("<th scope=\"col\"", table); at < end;
       at = html.find("<th scope=\"col\"", at + 1)) {
    const auto begin = html.find('>', at) + 1;
    text += (text.empty() ? "" : "|") + html.substr(begin, html.find("</th>", begin) - begin);
  }
  return text;
}

}  // namespace fpkcheck::tests
