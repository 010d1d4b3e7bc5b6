#include "report/verdict/verdict.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "report/text/text_layout.hpp"

namespace fpkcheck::report {
namespace {

// Returns the text of an L1 distance in six characters: "0.0043", "7.2e-4". With two significant
// digits, the L1 distances of four cases fit into 80 characters.
std::string short_l1_text(const std::optional<double>& l1) {
  if (!l1) return kMissingCell;
  if (*l1 == 0 || *l1 >= 0.001) return fmt::format("{:.2g}", *l1);
  std::string text = fmt::format("{:.1e}", *l1);
  if (const auto zero = text.find("e-0"); zero != std::string::npos) text.erase(zero + 2, 1);
  return text;
}

TextTableColumn solution_column(const std::vector<SolutionAgreementOverCases>& all) {
  TextTableColumn column{"", "solution", true, kAlwaysShown};
  for (const auto& row : all) column.cells.push_back(row.identity->id);
  return column;
}

std::pair<TextTableColumn, TextTableColumn> case_columns(
    const std::vector<SolutionAgreementOverCases>& all, std::size_t k, const std::string& name) {
  TextTableColumn y{name, "p(y)", false, kAlwaysShown}, ydot{name, "p(y') ", false, kAlwaysShown};
  for (const auto& row : all) {
    const SolutionAgreementInCase& entry = row.entries[k];
    const bool is_reference = entry.agreement == AgreementWithReference::reference;
    y.cells.push_back(is_reference ? "ref" : short_l1_text(entry.y));
    ydot.cells.push_back((is_reference ? "ref" : short_l1_text(entry.ydot)) +
                         agreement_symbol(entry));
  }
  return {std::move(y), std::move(ydot)};
}

std::size_t matrix_width(const std::vector<TextTableColumn>& columns) {
  std::size_t total = 0;
  for (const auto& column : columns) total += column.column_width() + 1;
  return total - 1;
}

// Each block of the verdict's matrix has as many cases as fit into the text width.
std::string matrix_blocks(const results::Run& run,
                          const std::vector<SolutionAgreementOverCases>& all,
                          const TerminalTextFormat& format) {
  std::string text;
  std::vector<TextTableColumn> block{solution_column(all)};
  const auto flush_block = [&] {
    text += format_text_table(block, format);
    block.resize(1);
  };
  for (std::size_t k = 0; k < run.cases.size(); ++k) {
    auto [y, ydot] = case_columns(all, k, run.cases[k].name());
    auto extended_block = block;
    extended_block.push_back(y);
    extended_block.push_back(ydot);
    if (block.size() > 1 && matrix_width(extended_block) > format.width) flush_block();
    block.push_back(std::move(y));
    block.push_back(std::move(ydot));
  }
  flush_block();
  return text;
}

}  // namespace

std::string verdict_answer_text(const RunVerdict& run_verdict, const TerminalTextFormat& format) {
  std::string text;
  for (const auto& sentence : run_verdict.answer) text += wrap_text(sentence, format.width);
  return text;
}

std::string run_verdict_text(const results::Run& run, const RunVerdict& run_verdict,
                             const TerminalTextFormat& format) {
  std::string text;
  if (run.cases.size() > 1) {
    text += matrix_blocks(run, run_verdict.agreement_rows, format);
    auto marks = agreement_symbol_meanings(run_verdict.agreement_rows);
    marks.insert(marks.begin(), "L1 distance to the reference (ref) of each case");
    text += wrap_text(fmt::format("{}.", fmt::join(marks, "; ")), format.width) + '\n';
  }
  std::size_t longest = 0;
  for (const auto& line : run_verdict.lines) longest = std::max(longest, line.subject.size());
  for (const auto& line : run_verdict.lines) {
    std::string lines =
        wrap_text(std::string(longest + 2, ' ') + line.outcome, format.width, longest + 2);
    text += lines.replace(0, line.subject.size(), line.subject);
  }
  for (const auto& sentence : run_verdict.recommendation) text += wrap_text(sentence, format.width);
  return text;
}

}  // namespace fpkcheck::report
