#include "workflows/paper/claims_supplement.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "report/page/html_elements.hpp"
#include "report/page/page_plots.hpp"
#include "workflows/paper/claims_table.hpp"

namespace fpkcheck::paper {
namespace {

std::string list_html(const std::vector<std::string>& lines) {
  std::string html;
  for (const auto& line : lines) html += report::html_element("li", line);
  return html.empty() ? "" : "<ul>\n" + html + "</ul>\n";
}

std::string claims_table_html(std::span<const PaperClaimJudgement> judgements) {
  using report::TextAlignment;
  std::vector<report::HtmlTableColumn> columns{{"case", TextAlignment::left},
                                               {"Fig.", TextAlignment::left},
                                               {"claim of the paper", TextAlignment::left},
                                               {"L1"},
                                               {"required", TextAlignment::left},
                                               {"tail"},
                                               {"required", TextAlignment::left},
                                               {"outcome", TextAlignment::left}};
  columns.back().is_status = true;
  for (const auto& row : claim_table_rows(judgements)) {
    const std::string* const cells[] = {&row.cases,    &row.figure, &row.claim,      &row.l1,
                                        &row.l1_limit, &row.tail,   &row.tail_limit, &row.outcome};
    for (std::size_t k = 0; k < columns.size(); ++k) {
      columns[k].cells.emplace_back(cells[k]->empty() ? report::kNoValue : *cells[k]);
    }
  }
  return report::table_html("The claims, and the numbers that decide them", std::move(columns));
}

std::string claim_quotations_html(std::span<const PaperClaimJudgement> judgements) {
  std::vector<std::string> lines;
  for (const auto& judgement : judgements) {
    lines.push_back(fmt::format("case {}, {}: \u201c{}\u201d", claim_cases_text(judgement.claim),
                                claim_text(judgement.claim), judgement.claim.quote));
  }
  return report::collapsible_html("claims-quotes", "Quotations of the claims", list_html(lines));
}

report::ReportPageSection claims_section(std::span<const PaperClaimJudgement> judgements,
                                         const results::Run& run) {
  report::ReportPageSection section{.anchor = "claims",
                                    .heading = "The paper's claims",
                                    .html = {},
                                    .groups = paper_figure_plots(run)};
  auto sentences = claim_outcome_summary(judgements);
  sentences.erase(sentences.begin());  // the page begins with the closing sentence
  for (const auto& sentence : sentences) section.html += report::html_element("p", sentence);
  section.html += claims_table_html(judgements);
  for (const auto& sentence : claim_criteria_sentences())
    section.html += report::html_element("p", sentence);
  section.html += report::collapsible_html("claims-notes", "Notes on single claims",
                                           list_html(claim_notes(judgements))) +
                  claim_quotations_html(judgements);
  if (!section.groups.empty()) {
    section.html +=
        "<h3 id=\"paper-figures\">The paper's figures, by the densities of this run</h3>\n";
  }
  for (const auto& plots : section.groups) section.html += report::plots_html(plots);
  return section;
}

}  // namespace

report::ReportSupplement claims_supplement(std::span<const PaperClaimJudgement> judgements,
                                           const results::Run& run, report::FigureWidth width,
                                           const report::TerminalTextFormat& format) {
  return {.summary = claim_outcome_summary(judgements),
          .text = '\n' + claims_table_text(judgements, format),
          .sections = {claims_section(judgements, run)},
          .files = {{kClaimsCsv, claims_csv(judgements)},
                    {kClaimsJson, claims_json(judgements, run.program) + '\n'}},
          .pictures = paper_figure_scripts(run, width)};
}

bool is_paper_run(const results::Run& run) {
  const std::string command = run.program.command + ' ';
  return command.starts_with("fpkcheck paper ") && run.stopped.empty();
}

}  // namespace fpkcheck::paper
