#include "report/page/page_sections.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "report/figure/script_text.hpp"
#include "report/page/html_elements.hpp"
#include "report/page/page_plots.hpp"
#include "report/text/number_text.hpp"
#include "report/verdict/verdict.hpp"

namespace fpkcheck::report {
namespace {

std::string_view agreement_css_class(AgreementWithReference agreement) {
  switch (agreement) {
    case AgreementWithReference::reference:
      return "is-reference";
    case AgreementWithReference::indistinguishable:
    case AgreementWithReference::close:
      return "is-close";
    case AgreementWithReference::distant:
      return "is-off";
    case AgreementWithReference::no_density:
      return "is-none";
    default:
      return "";
  }
}

std::string colour_key_html(const std::vector<SolutionAgreementOverCases>& all) {
  struct Entry {
    AgreementWithReference agreement;
    std::string meaning;
  };
  const Entry entries[] = {{AgreementWithReference::reference, "the reference"},
                           {AgreementWithReference::close,
                            fmt::format("within L1 {:g} of the reference", compare::kCloseL1)},
                           {AgreementWithReference::distant, "farther from the reference"},
                           {AgreementWithReference::no_density, "no admissible density found"}};
  std::string html;
  for (const auto& [agreement, meaning] : entries) {
    const auto colour = agreement_css_class(agreement);
    const bool there = std::ranges::any_of(all, [&](const SolutionAgreementOverCases& row) {
      return std::ranges::any_of(row.entries, [&](const SolutionAgreementInCase& entry) {
        return agreement_css_class(entry.agreement) == colour;
      });
    });
    if (there) html += fmt::format("<span class=\"{}\">{}</span>\n", colour, escape_html(meaning));
  }
  return html.empty() ? "" : "<p class=\"small key\">" + html + "</p>\n";
}

std::string tooltip_text(const SolutionAgreementInCase& entry) {
  if (entry.solution == nullptr) return "";
  if (entry.agreement == AgreementWithReference::reference) return "the reference";
  std::string text(name(entry.solution->status));
  if (entry.agreement == AgreementWithReference::indistinguishable) text += ", indistinguishable";
  return text;
}

std::string distance_cell_html(const SolutionAgreementInCase& entry,
                               const std::optional<double>& l1, bool with_mark) {
  const std::string text =
      entry.agreement == AgreementWithReference::reference ? "ref" : number_text(l1, 2);
  const char mark = agreement_symbol(entry);
  const std::string marked = with_mark && mark != ' '
                                 ? fmt::format("<sup>{}</sup>", escape_html(std::string(1, mark)))
                                 : "";
  return fmt::format("<td class=\"number {}\" title=\"{}\">{}{}</td>",
                     agreement_css_class(entry.agreement), escape_html(tooltip_text(entry)),
                     escape_html(text), marked);
}

std::string distance_matrix_html(const results::Run& run,
                                 const std::vector<SolutionAgreementOverCases>& all,
                                 const std::vector<std::string>& anchors) {
  std::string cases, variables, rows;
  for (std::size_t k = 0; k < run.cases.size(); ++k) {
    cases += fmt::format("<th scope=\"colgroup\" colspan=\"2\"><a href=\"#{}\">{}</a></th>",
                         anchors[k], escape_html(run.cases[k].name()));
    for (const auto variable : transform::kVariables) {
      variables += fmt::format("<th scope=\"col\" class=\"number\">{}</th>",
                               density_in_plain_text(variable));
    }
  }
  for (const auto& row : all) {
    rows += fmt::format("<tr><th scope=\"row\">{}</th>", escape_html(row.identity->id));
    for (const auto& entry : row.entries) {
      rows +=
          distance_cell_html(entry, entry.y, false) + distance_cell_html(entry, entry.ydot, true);
    }
    rows += "</tr>\n";
  }
  auto marks = agreement_symbol_meanings(all);
  marks.insert(marks.begin(),
               "L1 distance to the reference (ref) of each case: 0 for equal "
               "densities, 2 for disjoint ones");
  return fmt::format(
      "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"Distances of all "
      "solutions\">\n<table class=\"matrix\">\n<thead><tr><th></th>{}</tr>\n<tr><th "
      "scope=\"col\">solution</th>{}</tr></thead>\n<tbody>\n{}</tbody>\n</table>\n</div>\n"
      "{}<p class=\"small\">{}.</p>\n",
      cases, variables, rows, colour_key_html(all),
      escape_html(fmt::format("{}", fmt::join(marks, "; "))));
}

std::string verdict_lines_html(const std::vector<MethodVerdictLine>& lines) {
  if (lines.empty()) return "";
  std::string html = "<dl class=\"lines\">\n";
  for (const auto& line : lines) {
    html += fmt::format("<dt class=\"{}\">{}</dt><dd>{}</dd>\n", line.reproduced ? "yes" : "no",
                        escape_html(line.subject), escape_html(line.outcome));
  }
  return html + "</dl>\n";
}

}  // namespace

std::string verdict_paragraph_html(const std::string& sentence) {
  return fmt::format("<p class=\"answer\">{}</p>\n", escape_html(sentence));
}

std::string verdict_html(const results::Run& run, const std::vector<std::string>& anchors) {
  const RunVerdict run_verdict = make_run_verdict(run);
  std::string html = "<section id=\"verdict\">\n";
  for (const auto& sentence : run_verdict.answer) html += verdict_paragraph_html(sentence);
  html += "<div class=\"front\">\n<div>\n" +
          distance_matrix_html(run, run_verdict.agreement_rows, anchors) + "</div>\n";
  html += reference_distance_plot_svg(run, run_verdict.agreement_rows) + "</div>\n";
  html += html_element("h2", "Outcome of each method") + verdict_lines_html(run_verdict.lines);
  html += html_element("h2", "Recommendation");
  for (const auto& sentence : run_verdict.recommendation) html += html_element("p", sentence);
  return html + "</section>\n";
}

}  // namespace fpkcheck::report
