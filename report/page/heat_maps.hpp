#pragma once

#include <string>

#include "report/figure/figure.hpp"

namespace fpkcheck::report {

/// Returns the HTML elements of the heat maps of a figure: a control that selects a choice, and a
/// place for each panel of a choice. The script page.js draws the maps.
/// @param prefix prefix of the ids of the maps
/// @param label label of the control
/// @param introduction HTML between the control and the maps
/// @pre the figure has at least one panel
std::string heat_maps_html(const Figure& figure, const std::string& prefix,
                           const std::string& label, const std::string& introduction);

/// Returns the heat maps of a figure as JSON, the input of the script page.js.
/// @pre all maps have cells, and their values are signed square roots from -1 to 1
std::string heat_maps_json(const Figure& figure, const std::string& prefix);

}  // namespace fpkcheck::report
