#include "report/page/family_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include "report/page/html.hpp"
#include "report/solution_families.hpp"
#include "report/text/number_text.hpp"

namespace fpkcheck::report {
namespace {

using transform::Metric;
using transform::Solution;

constexpr int kDigits = 4;

bool is_repeated_option(const Metric& observation, const Solution& solution) {
  return std::ranges::find(solution.options,
                           base::NamedParameterValue{observation.path, observation.value}) !=
         solution.options.end();
}

// Returns the group in the path of a metric: "support" for "support.edge_density", and an empty
// text for the path "disc_sensitivity", which has no dot.
std::string_view group_of(const std::string& path) {
  const auto dot = path.find('.');
  return std::string_view(path).substr(0, dot == std::string::npos ? 0 : dot);
}

// Returns the paths of metrics that have a value and repeat no option, in the order of the
// solutions. Grouped metrics are last and sorted by group, since files keep only the order within a
// group.
std::vector<std::string> metric_paths(const SolutionFamily& family) {
  std::vector<std::string> paths;
  std::set<std::string> metric_value_text;
  for (const Solution* solution : family.solutions) {
    auto at = paths.begin();
    for (const auto& observation : solution->metrics) {
      if (observation.path.find('[') != std::string::npos) continue;
      const auto known = std::ranges::find(paths, observation.path);
      at = (known != paths.end() ? known : paths.insert(at, observation.path)) + 1;
      if (!base::is_unset(observation.value) && !is_repeated_option(observation, *solution)) {
        metric_value_text.insert(observation.path);
      }
    }
  }
  std::erase_if(paths, [&](const auto& path) { return !metric_value_text.contains(path); });
  std::ranges::stable_sort(paths, {}, group_of);
  return paths;
}

// Returns the label of a metric in the table: "support: edge density" for "support.edge_density".
std::string path_text(const std::string& path) {
  std::string text;
  for (const char c : path) {
    if (c == '.') text += ':';
    text += c == '.' || c == '_' ? ' ' : c;
  }
  return text;
}

// Returns the text of the value of a metric. In a confined closure, the polynomial Q_n may increase
// although the whole exponent decreases, because of the fixed confinement term. The radius from
// which Q_n increases would then wrongly appear to be the reason for the status `inadmissible`. The
// text therefore adds an explanation.
std::string metric_value_text(const Solution& solution, const std::string& path) {
  const Metric* found = find_metric(solution.metrics, path);
  std::string text = value_text(found ? found->value : base::Value(), kDigits);
  const bool is_confined = transform::metric_text(solution.metrics, "tail.kind") == "confined";
  if (path == "support.rises_from" && is_confined && text != kNoValue) {
    text = fmt::format("confined (Q_n rises from {})", text);
  }
  return text;
}

std::string family_table(const SolutionFamily& family) {
  const auto paths = metric_paths(family);
  std::vector<HtmlColumn> table{{"quantity", Align::left}};
  for (const auto& path : paths) table.front().cells.push_back(path_text(path));
  for (const Solution* solution : family.solutions) {
    table.push_back({transform::short_name(solution->identity)});
    for (const auto& path : paths) {
      table.back().cells.push_back(metric_value_text(*solution, path));
    }
  }
  return table_html(fmt::format("Metrics of {}", family.name), std::move(table));
}

}  // namespace

std::string family_tables(const results::CaseResult& case_result) {
  std::string html;
  for (const auto& family : group_by_family(case_result.solutions)) html += family_table(family);
  return html.empty() ? "" : "<div class=\"families\">\n" + html + "</div>\n";
}

}  // namespace fpkcheck::report
