#include "workflows/sweep/report/page/sweep_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <regex>
#include <span>
#include <tuple>

#include "report/page/html_elements.hpp"
#include "workflows/sweep/report/figure/key_axis.hpp"
#include "workflows/sweep/report/figure/sweep_view.hpp"
#include "workflows/sweep/report/sweep_tables.hpp"

namespace fpkcheck::sweep {
namespace {

using report::escape_html;
using report::html_element;

// On a narrow screen a picture of the page scrolls instead of shrinking.
constexpr const char* kPictureStyle =
    "figure { margin: 1.2rem 0; }\n"
    ".picture { overflow-x: auto; }\n"
    ".picture img { display: block; width: 100%; min-width: 46rem; max-width: 1100px; "
    "height: auto; }\n"
    "figcaption { font-weight: 400; max-width: 60rem; }\n"
    "@media print { .picture img { min-width: 0; } figure { break-inside: avoid; } }\n";

std::string count_with_noun(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string axis_sentence(const SweepAxis& axis) {
  if (axis.spacing == SweepAxisSpacing::listed) return axis.axis_definition_text();
  const char* how = axis.spacing == SweepAxisSpacing::logarithmic ? " on a logarithmic scale" : "";
  return axis.values.empty()
             ? fmt::format("{} in {:g} .. {:g}{}", axis.key, axis.from, axis.to, how)
             : fmt::format("{} from {:g} to {:g} ({} values, evenly spaced{})", axis.key, axis.from,
                           axis.to, axis.values.size(), how);
}

std::string introduction_html(const SweepResults& results) {
  const SweepPlan& plan = results.plan;
  std::vector<std::string> varied;
  for (const auto& axis : plan.axes) varied.push_back(axis_sentence(axis));
  std::string text =
      fmt::format("Varied parameters of {}: {}", plan.base.name, fmt::join(varied, "; "));
  if (plan.axes.size() > 1 || plan.design == SweepPlanDesign::sobol) {
    text += fmt::format("; design: {}", base::meaning_of(plan.design));
  }
  text += fmt::format(". {}, each solved by {}.", count_with_noun(plan.points.size(), "point"),
                      count_with_noun(plan.methods.size(), "method"));
  if (!results.is_complete()) {
    text += fmt::format(" {} solved so far.", count_with_noun(results.points.size(), "point"));
  }
  if (!results.points.empty() &&
      std::ranges::all_of(results.points, &std::string::empty, &SweepPointResult::reference)) {
    text += " No method solves the full problem, so there is no reference.";
  }
  return text;
}

// Returns the HTML table of the methods, with the same columns as the text table for the terminal.
std::string methods_table_html(const SweepResults& results) {
  std::vector<report::HtmlTableColumn> columns;
  for (auto& column : method_table_columns(results)) {
    const std::string header =
        column.group.empty() ? column.header : fmt::format("{}, {}", column.group, column.header);
    std::ranges::replace(column.cells, std::string(report::kMissingCell),
                         std::string(report::kNoValue));
    columns.push_back(
        {header, column.left_aligned ? report::TextAlignment::left : report::TextAlignment::right,
         std::move(column.cells)});
  }
  return report::table_html("Methods", std::move(columns)) +
         html_element("p", method_table_legend());
}

std::string pictures_html(const std::vector<EmbeddedPicture>& pictures) {
  std::string html;
  for (const auto& picture : pictures) {
    html += fmt::format(
        "<figure>\n<div class=\"picture\" role=\"region\" tabindex=\"0\" aria-label=\"{0}\"><img "
        "alt=\"{0}\" src=\"data:{1};base64,{2}\"></div>\n<figcaption>{0}</figcaption>\n</figure>\n",
        escape_html(picture.caption), picture.media_type,
        report::encode_base64(std::as_bytes(std::span(picture.bytes))));
  }
  return html.empty() ? html : html_element("h2", "Pictures") + html;
}

std::string point_values_text(const SweepPlan& plan, std::size_t point) {
  std::vector<std::string> values;
  for (std::size_t k = 0; k < plan.axes.size(); ++k) {
    values.push_back(fmt::format("{} = {}", plan.axes[k].key,
                                 SweepParameterAxis::parameter_value_text(plan.points[point][k])));
  }
  return fmt::format("{}", fmt::join(values, ", "));
}

std::string status_reasons_html(const SweepResults& results) {
  constexpr std::size_t kMaxReasons = 40;
  const auto groups = status_reason_groups(results);
  if (groups.empty()) return "";
  std::string html =
      html_element("h2", "Reasons why solutions are not ok") + "<ul class=\"reasons\">\n";
  for (std::size_t k = 0; k < std::min(kMaxReasons, groups.size()); ++k) {
    const StatusReasonGroup& group = groups[k];
    html += fmt::format("<li><strong>{} {}</strong>, {}, first at {}: {}.</li>\n",
                        escape_html(results.plan.methods[group.method].id()), name(group.status),
                        count_with_noun(group.count, "point"),
                        escape_html(point_values_text(results.plan, group.point)),
                        escape_html(group.reason));
  }
  if (groups.size() > kMaxReasons) {
    html +=
        fmt::format("<li>and {} more reasons (see sweep.csv)</li>\n", groups.size() - kMaxReasons);
  }
  return html + "</ul>\n";
}

}  // namespace

std::string sweep_page(const SweepResults& results, const std::vector<EmbeddedPicture>& pictures,
                       const std::string& command) {
  const std::string title = "fpkcheck: a sweep of " + results.plan.base.name;
  const std::string fixed = fixed_parameters_text(results.plan);
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<!-- The page is self-contained: it loads nothing. -->\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
      "style-src 'unsafe-inline'; img-src data:\">\n"
      "{}<style>\n{}{}</style>\n</head>\n<body>\n<main>\n{}{}{}{}{}{}"
      "<h2>How to repeat this</h2>\n<pre><code>{}</code></pre>\n"
      "<p>All numbers: sweep.csv, sweep.nc.</p>\n</main>\n</body>\n</html>\n",
      html_element("title", title), report::page_style(), kPictureStyle, html_element("h1", title),
      html_element("p", introduction_html(results)),
      fixed.empty() ? "" : html_element("p", fmt::format("The same at all points: {}.", fixed)),
      methods_table_html(results), pictures_html(pictures), status_reasons_html(results),
      escape_html(command));
}

std::string replace_numbers_by_dots(const std::string& reason) {
  static const std::regex number("(^|[^A-Za-z0-9_])-?[0-9]+(\\.[0-9]+)?([eE][-+]?[0-9]+)?");
  return std::regex_replace(reason, number, "$1...");
}

std::vector<StatusReasonGroup> status_reason_groups(const SweepResults& results) {
  std::map<std::tuple<std::size_t, transform::Status, std::string>, StatusReasonGroup> found;
  for (const auto& point : results.points) {
    for (std::size_t m = 0; m < point.methods.size(); ++m) {
      const auto& [status, reason] = std::tie(point.methods[m].status, point.methods[m].reason);
      if (status == transform::Status::ok) continue;
      auto& group = found[{m, status, replace_numbers_by_dots(reason)}];
      if (group.count++ == 0) {
        group = {.method = m, .status = status, .count = 1, .point = point.point, .reason = reason};
      }
    }
  }
  std::vector<StatusReasonGroup> groups;
  for (auto& [key, group] : found) groups.push_back(std::move(group));
  std::ranges::stable_sort(groups, std::ranges::greater(), &StatusReasonGroup::count);
  return groups;
}

}  // namespace fpkcheck::sweep
