#include "compare/page/plot.hpp"

#include <fmt/format.h>

#include "compare/page/html.hpp"

namespace fpkcheck::compare {

std::string plot_html(const Plot& plot) {
  return fmt::format(
      "<figure>\n<figcaption>{0}</figcaption>\n"
      "<div class=\"plot\" id=\"{1}\" role=\"img\" aria-label=\"{0}\"></div>\n</figure>\n",
      escaped(plot.caption), escaped(plot.id));
}

std::string plots_html(const std::vector<Plot>& plots) {
  std::string html = "<div class=\"plots\">\n";
  for (const auto& plot : plots) html += plot_html(plot);
  return html + "</div>\n";
}

nlohmann::ordered_json plots_json(const std::vector<Plot>& plots) {
  auto json = nlohmann::ordered_json::array();
  for (const auto& plot : plots) json.push_back({{"id", plot.id}, {"figure", plot.figure}});
  return json;
}

std::string variable_text(const std::string& variable) { return variable == "y" ? "y" : "y\u2032"; }

}  // namespace fpkcheck::compare
