#include "report/page/verdict_view.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "report/page/distance_strip.hpp"
#include "report/page/html.hpp"
#include "report/page/number_text.hpp"
#include "report/page/plot.hpp"
#include "report/verdict/marks.hpp"
#include "report/verdict/verdict.hpp"

namespace fpkcheck::report {
namespace {

// CSS class of a cell, which sets the colour.
std::string_view class_of(Standing standing) {
  switch (standing) {
    case Standing::reference:
      return "is-reference";
    case Standing::indistinguishable:
    case Standing::close:
      return "is-close";
    case Standing::off:
      return "is-off";
    case Standing::no_density:
      return "is-none";
    default:
      return "";
  }
}

// Key of the colours that occur in the cells.
std::string key_html(const std::vector<Record>& all) {
  struct Entry {
    Standing standing;
    std::string meaning;
  };
  const Entry entries[] = {
      {Standing::reference, "the reference"},
      {Standing::close, fmt::format("within L1 {:g} of the reference", kCloseL1)},
      {Standing::off, "farther from the reference"},
      {Standing::no_density, "no admissible density found"}};
  std::string html;
  for (const auto& [standing, meaning] : entries) {
    const auto colour = class_of(standing);
    const bool there = std::ranges::any_of(all, [&](const Record& record) {
      return std::ranges::any_of(
          record.stands, [&](const Stand& stand) { return class_of(stand.standing) == colour; });
    });
    if (there) html += fmt::format("<span class=\"{}\">{}</span>\n", colour, escaped(meaning));
  }
  return html.empty() ? "" : "<p class=\"small key\">" + html + "</p>\n";
}

std::string spoken(const Stand& stand) {
  if (stand.solution == nullptr) return "";
  if (stand.standing == Standing::reference) return "the reference";
  std::string text(name(stand.solution->status));
  if (stand.standing == Standing::indistinguishable) text += ", indistinguishable";
  return text;
}

std::string distance_cell(const Stand& stand, const std::optional<double>& l1, bool with_mark) {
  const std::string text = stand.standing == Standing::reference ? "ref" : number_text(l1, 2);
  const char mark = mark_of(stand);
  const std::string marked =
      with_mark && mark != ' ' ? fmt::format("<sup>{}</sup>", escaped(std::string(1, mark))) : "";
  return fmt::format("<td class=\"number {}\" title=\"{}\">{}{}</td>", class_of(stand.standing),
                     escaped(spoken(stand)), escaped(text), marked);
}

std::string matrix_html(const results::Run& run, const std::vector<Record>& all,
                        const std::vector<std::string>& anchors) {
  std::string cases, variables, rows;
  for (std::size_t k = 0; k < run.cases.size(); ++k) {
    cases += fmt::format("<th scope=\"colgroup\" colspan=\"2\"><a href=\"#{}\">{}</a></th>",
                         anchors[k], escaped(run.cases[k].name()));
    for (const auto variable : transform::kVariables) {
      variables +=
          fmt::format("<th scope=\"col\" class=\"number\">{}</th>", density_text(variable));
    }
  }
  for (const auto& record : all) {
    rows += fmt::format("<tr><th scope=\"row\">{}</th>", escaped(record.identity->id));
    for (const auto& stand : record.stands) {
      rows += distance_cell(stand, stand.y, false) + distance_cell(stand, stand.ydot, true);
    }
    rows += "</tr>\n";
  }
  auto marks = meanings_of_marks(all);
  marks.insert(marks.begin(),
               "L1 distance to the reference (ref) of each case: 0 for equal "
               "densities, 2 for disjoint ones");
  return fmt::format(
      "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"Distances of all "
      "solutions\">\n<table class=\"matrix\">\n<thead><tr><th></th>{}</tr>\n<tr><th "
      "scope=\"col\">solution</th>{}</tr></thead>\n<tbody>\n{}</tbody>\n</table>\n</div>\n"
      "{}<p class=\"small\">{}.</p>\n",
      cases, variables, rows, key_html(all), escaped(fmt::format("{}", fmt::join(marks, "; "))));
}

std::string lines_html(const std::vector<VerdictLine>& lines) {
  if (lines.empty()) return "";
  std::string html = "<dl class=\"lines\">\n";
  for (const auto& line : lines) {
    html += fmt::format("<dt class=\"{}\">{}</dt><dd>{}</dd>\n", line.reproduced ? "yes" : "no",
                        escaped(line.subject), escaped(line.outcome));
  }
  return html + "</dl>\n";
}

}  // namespace

std::string answer_html(const std::string& sentence) {
  return fmt::format("<p class=\"answer\">{}</p>\n", escaped(sentence));
}

std::string verdict_html(const results::Run& run, const std::vector<std::string>& anchors) {
  const Verdict said = verdict(run);
  std::string html = "<section id=\"verdict\">\n";
  for (const auto& sentence : said.answer) html += answer_html(sentence);
  html += "<div class=\"front\">\n<div>\n" + matrix_html(run, said.records, anchors) + "</div>\n";
  html += distance_strip(run, said.records) + "</div>\n";
  html += element("h2", "Outcome of each method") + lines_html(said.lines);
  html += element("h2", "Recommendation");
  for (const auto& sentence : said.trust) html += element("p", sentence);
  return html + "</section>\n";
}

}  // namespace fpkcheck::report
