#pragma once

#include <algorithm>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

/// Parser of gnuplot scripts: the plotted elements and the entries of the legend.
namespace fpkcheck::tests {

/// An element of a plot command, with its style.
struct Drawn {
  std::string text, style, colour, dash, mark, title;

  bool has_line() const { return style == "lines" || style == "linespoints" || style == "vectors"; }
  bool has_marks() const {
    return style == "points" || style == "linespoints" || style == "yerrorbars";
  }
  // The colour scale beside the panels explains such elements.
  bool has_scale() const { return style == "image" || text.find("palette") != std::string::npos; }
};

inline std::string first_match(const std::string& text, const std::string& pattern,
                               const std::string& otherwise) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(pattern)) ? match[1].str() : otherwise;
}

/// Splits a command at commas outside of parentheses and quotes.
inline std::vector<std::string> parts_of(const std::string& command) {
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

inline std::vector<Drawn> drawn_by(const std::string& script) {
  std::vector<Drawn> all;
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
    for (const auto& part : parts_of(line.substr(5))) {
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
inline bool tells(const Drawn& entry, const Drawn& drawn, bool open_is_told) {
  if (entry.title.empty()) return false;
  const bool is_edge = entry.text.find("border rgb '" + drawn.colour + "'") != std::string::npos;
  const bool of_its_colour = entry.colour == "#444444" ||
                             entry.text.find("rgb '" + drawn.colour + "'") != std::string::npos;
  if (!of_its_colour) return false;
  const bool has_its_line = (entry.has_line() && entry.dash == drawn.dash) || is_edge;
  if (drawn.has_line() && !has_its_line) return false;
  if (!drawn.has_marks() || entry.colour == "#444444") {
    return !drawn.has_marks() || entry.mark == drawn.mark;
  }
  const bool is_open_one = open_is_told && !entry.mark.empty() && !drawn.mark.empty() &&
                           drawn.mark != "variable" &&
                           std::stoi(entry.mark) == std::stoi(drawn.mark) + 1;
  return entry.has_marks() && (entry.mark == drawn.mark || drawn.mark == "variable" || is_open_one);
}

/// The plotted elements of a script without a legend entry.
inline std::vector<std::string> without_entry(const std::string& script) {
  const auto all = drawn_by(script);
  const bool open_is_told = std::ranges::any_of(all, [](const Drawn& one) {
    return one.title.starts_with("'open") || one.title.find("(in") != std::string::npos ||
           one.title.find(" (not_") != std::string::npos;
  });
  std::vector<std::string> untold;
  for (const auto& drawn : all) {
    if (!drawn.title.empty() || drawn.has_scale()) continue;
    if (std::ranges::none_of(
            all, [&](const Drawn& entry) { return tells(entry, drawn, open_is_told); })) {
      untold.push_back(drawn.text);
    }
  }
  return untold;
}

}  // namespace fpkcheck::tests
