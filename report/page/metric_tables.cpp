#include "report/page/page_sections.hpp"

#include <fmt/format.h>

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include "report/case_solutions.hpp"
#include "report/page/html_elements.hpp"
#include "report/text/number_text.hpp"

namespace fpkcheck::report {
namespace {

using transform::Solution;
using transform::SolverMetric;

constexpr int kDigits = 4;

bool repeats_option(const SolverMetric& metric, const Solution& solution) {
  return std::ranges::find(solution.options,
                           base::NamedParameterValue{metric.path, metric.value}) !=
         solution.options.end();
}

// Returns the group in the path of a metric: "support" for "support.edge_density", and an empty
// text for the path "disc_sensitivity", which has no dot.
std::string_view metric_group(const std::string& path) {
  const auto dot = path.find('.');
  return std::string_view(path).substr(0, dot == std::string::npos ? 0 : dot);
}

// Returns the paths of those metrics of a family that have a value and repeat no option, in the
// order of the solutions. Grouped metrics are last and sorted by group, since files of a run keep
// only the order within a group.
std::vector<std::string> metric_paths(const SolutionFamily& family) {
  std::vector<std::string> paths;
  std::set<std::string> paths_with_value;
  for (const Solution* solution : family.solutions) {
    auto at = paths.begin();
    for (const auto& metric : solution->metrics) {
      if (metric.path.find('[') != std::string::npos) continue;
      const auto known = std::ranges::find(paths, metric.path);
      at = (known != paths.end() ? known : paths.insert(at, metric.path)) + 1;
      if (!base::is_unset(metric.value) && !repeats_option(metric, *solution)) {
        paths_with_value.insert(metric.path);
      }
    }
  }
  std::erase_if(paths, [&](const auto& path) { return !paths_with_value.contains(path); });
  std::ranges::stable_sort(paths, {}, metric_group);
  return paths;
}

// Returns the label of a metric in the table: "support: edge density" for "support.edge_density".
std::string metric_label(std::string path) {
  boost::algorithm::replace_all(path, ".", ": ");
  boost::algorithm::replace_all(path, "_", " ");
  return path;
}

std::string metric_value_text(const Solution& solution, const std::string& path) {
  const SolverMetric* found = find_metric(solution.metrics, path);
  std::string text = parameter_value_text(found ? found->value : base::Value(), kDigits);
  const bool is_confined = transform::metric_text(solution.metrics, "tail.kind") == "confined";
  if (path == "support.rises_from" && is_confined && text != kNoValue) {
    text = fmt::format("confined (Q_n rises from {})", text);
  }
  return text;
}

std::string metric_table_html(const SolutionFamily& family) {
  const auto paths = metric_paths(family);
  std::vector<HtmlTableColumn> table{{"quantity", TextAlignment::left}};
  for (const auto& path : paths) table.front().cells.push_back(metric_label(path));
  for (const Solution* solution : family.solutions) {
    table.push_back({transform::solution_name_within_family(solution->identity)});
    for (const auto& path : paths) {
      table.back().cells.push_back(metric_value_text(*solution, path));
    }
  }
  return table_html(fmt::format("Metrics of {}", family.name), std::move(table));
}

}  // namespace

std::string metric_tables_html(const results::CaseResult& case_result) {
  std::string html;
  for (const auto& family : group_by_family(case_result.solutions))
    html += metric_table_html(family);
  return html.empty() ? "" : "<div class=\"families\">\n" + html + "</div>\n";
}

}  // namespace fpkcheck::report
