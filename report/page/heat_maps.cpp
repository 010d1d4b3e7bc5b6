#include "report/page/page_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "report/figure/heat_map_values.hpp"
#include "report/page/html_elements.hpp"
#include "report/page/page_plots.hpp"

namespace fpkcheck::report {
namespace {

using Json = nlohmann::ordered_json;

// Number of quantisation levels of a heat map, which limits the resolution of the colours and of
// the displayed values.
constexpr int kMapLevels = 127;

std::vector<std::string> panel_choices(const Figure& figure) {
  std::vector<std::string> choices;
  for (const auto& panel : figure.panels) {
    if (std::ranges::find(choices, panel.choice) == choices.end()) choices.push_back(panel.choice);
  }
  return choices;
}

std::vector<const FigurePanel*> panels_with_choice(const Figure& figure,
                                                   const std::string& choice) {
  std::vector<const FigurePanel*> panels;
  for (const auto& panel : figure.panels) {
    if (panel.choice == choice) panels.push_back(&panel);
  }
  return panels;
}

std::string screen_reader_text(const FigurePanel& panel) {
  return fmt::format("Heat map, {}: {}", panel.map.value().quantity, panel.caption);
}

Json heat_map_json(const FigurePanel& panel, const std::string& prefix) {
  const FigureHeatMap& map = panel.map.value();
  assert(map.root_scale > 0 && !map.values.empty());
  std::vector<int> levels;
  for (const double value : map.values) {
    levels.push_back(static_cast<int>(std::lround(kMapLevels * value)));
  }
  Json places = Json::array(), labels = places;
  for (const auto& tic : map.colour_axis.tics) {
    places.push_back(tic.place);
    labels.push_back(enhanced_text_to_plotly(tic.label));
  }
  return {{"id", prefix + '-' + panel.id},
          {"caption", panel.caption},
          {"spoken", screen_reader_text(panel)},
          {"x", map.x_range},
          {"y", map.y_range},
          {"columns", map.columns},
          {"colours", map.colours},
          {"title", enhanced_text_to_plotly(map.colour_axis.label)},
          {"tickvals", places},
          {"ticktext", labels},
          {"quantity", map.quantity},
          {"largest", map.root_scale},
          {"levels", kMapLevels},
          {"steps", successive_differences(levels)}};
}

std::string choice_control_id(const Figure& figure, const std::string& prefix) {
  return fmt::format("{}-{}-choice", prefix, figure.panels.front().id);
}

}  // namespace

std::string heat_maps_html(const Figure& figure, const std::string& prefix,
                           const std::string& label, const std::string& introduction) {
  const auto choices = panel_choices(figure);
  std::string options, places;
  for (const auto& choice : choices) options += html_element("option", choice);
  for (const auto* panel : panels_with_choice(figure, choices.front())) {
    places += fmt::format(
        "<figure>\n<figcaption></figcaption>\n<div class=\"plot\" id=\"{}-{}\" role=\"img\" "
        "aria-label=\"{}\"></div>\n</figure>\n",
        prefix, panel->id, escape_html(screen_reader_text(*panel)));
  }
  return fmt::format(
      "<p class=\"controls\"><label>{}: <select id=\"{}\">{}</select></label></p>\n{}"
      "<div class=\"maps\">\n{}</div>\n",
      label, choice_control_id(figure, prefix), options, introduction, places);
}

std::string heat_maps_json(const Figure& figure, const std::string& prefix) {
  Json json{{"control", choice_control_id(figure, prefix)}, {"choices", Json::array()}};
  for (const auto& choice : panel_choices(figure)) {
    Json maps = Json::array();
    for (const auto* panel : panels_with_choice(figure, choice))
      maps.push_back(heat_map_json(*panel, prefix));
    json["choices"].push_back(std::move(maps));
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace fpkcheck::report
