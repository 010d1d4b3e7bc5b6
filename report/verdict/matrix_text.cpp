#include "report/verdict/matrix_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "report/text/columns.hpp"
#include "report/text/wrapped.hpp"
#include "report/verdict/marks.hpp"

namespace fpkcheck::report {
namespace {

// "0.0043", "7.2e-4": two digits in six characters, so that four cases fit into 80 characters.
std::string short_l1(const std::optional<double>& l1) {
  if (!l1) return kAbsent;
  if (*l1 == 0 || *l1 >= 0.001) return fmt::format("{:.2g}", *l1);
  std::string text = fmt::format("{:.1e}", *l1);
  if (const auto zero = text.find("e-0"); zero != std::string::npos) text.erase(zero + 2, 1);
  return text;
}

Column names_of_records(const std::vector<Record>& all) {
  Column column{"", "solution", true, kAlwaysShown};
  for (const auto& record : all) column.cells.push_back(record.identity->id);
  return column;
}

// The columns of both marginals for case k.
std::pair<Column, Column> columns_of_case(const std::vector<Record>& all, std::size_t k,
                                          const std::string& name) {
  Column y{name, "p(y)", false, kAlwaysShown}, ydot{name, "p(y') ", false, kAlwaysShown};
  for (const auto& record : all) {
    const Stand& stand = record.stands[k];
    const bool is_reference = stand.standing == Standing::reference;
    y.cells.push_back(is_reference ? "ref" : short_l1(stand.y));
    ydot.cells.push_back((is_reference ? "ref" : short_l1(stand.ydot)) + mark_of(stand));
  }
  return {std::move(y), std::move(ydot)};
}

std::size_t total_width_of(const std::vector<Column>& columns) {
  std::size_t total = 0;
  for (const auto& column : columns) total += column.width() + 1;
  return total - 1;
}

// As many cases as fit into the width form a block; further blocks follow below.
std::string matrix_blocks(const results::Run& run, const std::vector<Record>& all,
                          const TextFormat& format) {
  std::string text;
  std::vector<Column> block{names_of_records(all)};
  const auto put_block = [&] {
    text += rows(block, format);
    block.resize(1);
  };
  for (std::size_t k = 0; k < run.cases.size(); ++k) {
    auto [y, ydot] = columns_of_case(all, k, run.cases[k].name());
    auto with_it = block;
    with_it.push_back(y);
    with_it.push_back(ydot);
    if (block.size() > 1 && total_width_of(with_it) > format.width) put_block();
    block.push_back(std::move(y));
    block.push_back(std::move(ydot));
  }
  put_block();
  return text;
}

}  // namespace

std::string answer_text(const Verdict& said, const TextFormat& format) {
  std::string text;
  for (const auto& sentence : said.answer) text += wrapped(sentence, format.width);
  return text;
}

std::string verdict_text(const results::Run& run, const Verdict& said, const TextFormat& format) {
  std::string text;
  if (run.cases.size() > 1) {
    text += matrix_blocks(run, said.records, format);
    auto marks = meanings_of_marks(said.records);
    marks.insert(marks.begin(), "L1 distance to the reference (ref) of each case");
    text += wrapped(fmt::format("{}.", fmt::join(marks, "; ")), format.width) + '\n';
  }
  std::size_t longest = 0;
  for (const auto& line : said.lines) longest = std::max(longest, line.subject.size());
  for (const auto& line : said.lines) {
    std::string lines =
        wrapped(std::string(longest + 2, ' ') + line.outcome, format.width, longest + 2);
    text += lines.replace(0, line.subject.size(), line.subject);
  }
  for (const auto& sentence : said.trust) text += wrapped(sentence, format.width);
  return text;
}

}  // namespace fpkcheck::report
