#pragma once

#include <algorithm>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

/// Parser of gnuplot scripts: the plotted elements and the entries of the legend.
namespace fpkcheck::tests {

/// An element of a plot command, with its style.
struct PlotElement {
  std::string text, style, colour, dash, mark, title;

  bool has_line() const { return style == "lines" || style == "linespoints" || style == "vectors"; }
  bool has_marks() const {
    return style == "points" || style == "linespoints" || style == "yerrorbars";
  }
  // The colour scale beside the panels explains such elements; a white mark is the background of an
  // open mark.
  bool uses_colour_scale() const {
    return style == "image" || colour == "white" || text.find("palette") != std::string::npos;
  }
};

inline std::string first_match(const std::string& text, const std::string& pattern,
                               const std::string& fallback) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(pattern)) ? match[1].str() : fallback;
}

/// Splits a command at commas outside of parentheses and quotes.
inline std::vector<std::string> split_at_commas(const std::string& command) {
  std::vector<std::string> parts{""};
  int depth = 0;
  char quote = 0;
  for (const char c : command) {
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '\'' || c == '"') {
      quote = c;
    } else if (c == '(' || c == '[') {
      ++depth;
    } else if (c == ')' || c == ']') {
      --depth;
    } else if (c == ',' && depth == 0) {
      parts.emplace_back();
      continue;
    }
    parts.back() += c;
  }
  return parts;
}

inline std::vector<PlotElement> plot_elements(const std::string& script) {
  std::vector<PlotElement> all;
  std::istringstream lines(script);
  bool in_data = false;
  for (std::string line; std::getline(lines, line);) {
    if (line == "EOD") in_data = false;
    if (line.ends_with("<< EOD")) in_data = true;
    if (in_data || !line.starts_with("plot ")) continue;
    while (line.ends_with('\\')) {
      line.pop_back();
      std::string more;
      std::getline(lines, more);
      line += more;
    }
    for (const auto& part : split_at_commas(line.substr(5))) {
      all.push_back({part, first_match(part, "with (\\w+)", "lines"),
                     first_match(part, "(?:border|lc|fc|linecolor) rgb '([^']*)'", "palette"),
                     first_match(part, "(?:dt|dashtype) (\\S+)", "solid"),
                     first_match(part, "(?:pt|pointtype) (\\w+)", ""),
                     first_match(part, "[^o]title (.*)$", "")});
    }
  }
  return all;
}

/// True if a legend entry explains the element, by colour and dash or marker. A dark grey entry is
/// valid for all colours. An entry that begins with "open" is valid for all open markers whose
/// filled markers have an entry.
inline bool explains(const PlotElement& entry, const PlotElement& element, bool has_open_entry) {
  if (entry.title.empty()) return false;
  const bool is_edge = entry.text.find("border rgb '" + element.colour + "'") != std::string::npos;
  const bool has_its_colour = entry.colour == "#444444" ||
                              entry.text.find("rgb '" + element.colour + "'") != std::string::npos;
  if (!has_its_colour) return false;
  const bool has_its_line = (entry.has_line() && entry.dash == element.dash) || is_edge;
  if (element.has_line() && !has_its_line) return false;
  if (!element.has_marks() || entry.colour == "#444444") {
    return !element.has_marks() || entry.mark == element.mark;
  }
  const bool is_open_marker = has_open_entry && !entry.mark.empty() && !element.mark.empty() &&
                              element.mark != "variable" &&
                              std::stoi(entry.mark) == std::stoi(element.mark) + 1;
  return entry.has_marks() &&
         (entry.mark == element.mark || element.mark == "variable" || is_open_marker);
}

/// The plotted elements of a script without a legend entry.
inline std::vector<std::string> elements_without_entry(const std::string& script) {
  const auto all = plot_elements(script);
  const bool has_open_entry = std::ranges::any_of(all, [](const PlotElement& element) {
    return element.title.starts_with("'open") || element.title.find("(in") != std::string::npos ||
           element.title.find(" (not_") != std::string::npos;
  });
  std::vector<std::string> unexplained;
  for (const auto& element : all) {
    if (!element.title.empty() || element.uses_colour_scale()) continue;
    if (std::ranges::none_of(all, [&](const PlotElement& entry) {
          return explains(entry, element, has_open_entry);
        })) {
      unexplained.push_back(element.text);
    }
  }
  return unexplained;
}

}  // namespace fpkcheck::tests
