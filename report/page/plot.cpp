#include "report/page/plot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "report/page/html.hpp"

namespace fpkcheck::report {

std::string plots_html(const std::vector<Plot>& plots) {
  std::string html = "<div class=\"plots\">\n";
  for (const auto& plot : plots) {
    html += fmt::format(
        "<figure>\n<figcaption>{0}</figcaption>\n"
        "<div class=\"plot\" id=\"{1}\" role=\"img\" aria-label=\"{0}\"></div>\n</figure>\n",
        escape_html(plot.caption), escape_html(plot.id));
  }
  return html + "</div>\n";
}

std::string plots_json(const std::vector<Plot>& plots) {
  std::vector<std::string> entries;
  for (const auto& plot : plots) {
    entries.push_back(
        fmt::format(R"({{"id":{},"figure":{}}})", nlohmann::json(plot.id).dump(), plot.figure));
  }
  return fmt::format("[{}]", fmt::join(entries, ","));
}

std::string plotly_text(std::string_view text) {
  std::string shown;
  for (const char c : text) {
    if (c == '&') {
      shown += "&amp;";
    } else if (c == '<') {
      shown += "&lt;";
    } else {
      shown += c;
    }
  }
  return shown;
}

std::string legend_name(const transform::Solution& solution) {
  const std::string name = plotly_text(solution.id());
  return solution.is_ok() ? name : fmt::format("{} ({})", name, transform::name(solution.status));
}

std::string plotly_dash(const std::string& gnuplot_dash) {
  std::string dash;
  for (const char c : gnuplot_dash) {
    if (c == ',' || c == ')') dash += "px";
    if (c != '(' && c != ')') dash += c;
  }
  return dash;
}

}  // namespace fpkcheck::report
