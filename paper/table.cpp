#include "paper/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "paper/criteria.hpp"
#include "paper/measured_text.hpp"
#include "report/text/columns.hpp"
#include "report/text/l1_text.hpp"
#include "report/text/wrapped.hpp"

namespace fpkcheck::paper {
namespace {

using report::Column;
using report::kAlwaysShown;

std::string wanted(const Measured& of, const std::string& limit) {
  return limit.empty() ? "" : fmt::format("{} {}", of.above ? ">" : "<=", limit);
}

// Of the two numbers one is enough to differ.
std::string tail_wanted(const Judgement& one) {
  const std::string text = wanted(one.tail, tail_text(one.tail.limit));
  return one.claim.relation == Relation::differs && !text.empty() ? "or " + text : text;
}

std::string rows(std::span<const Judgement> judgements, const report::TextFormat& format) {
  constexpr int kLimits = 1;
  std::vector<Column> columns{{"", "case", true, kAlwaysShown},
                              {"", "fig.", true, kAlwaysShown},
                              {"", "the paper says", true, kAlwaysShown},
                              {"L1", "is", false, kAlwaysShown},
                              {"L1", "wanted", true, kLimits},
                              {"tail", "is", false, kAlwaysShown},
                              {"tail", "wanted", true, kLimits},
                              {"", "came out", true, kAlwaysShown}};
  for (const auto& one : judgements) {
    const std::string figure = figure_text(one.claim);
    const std::string cells[] = {
        cases_text(one.claim),
        figure.empty() ? report::kAbsent : figure,
        words(one.claim),
        one.l1.value ? report::l1_text(*one.l1.value) : report::kAbsent,
        wanted(one.l1, l1_text(one.l1.limit)),
        one.tail.value ? fmt::format("{:.3f}", *one.tail.value) : report::kAbsent,
        tail_wanted(one),
        std::string(name(one.outcome))};
    for (std::size_t k = 0; k < columns.size(); ++k) columns[k].cells.push_back(cells[k]);
  }
  return report::rows(std::move(columns), format);
}

// A closure's own words are quoted where they come first.
std::string notes(std::span<const Judgement> judgements, std::size_t width) {
  std::set<std::pair<int, int>> quoted;  // case, n
  std::string text;
  for (const auto& one : judgements) {
    const bool of_a_search = one.claim.relation == Relation::not_found;
    if (one.note.empty() && !of_a_search) continue;
    std::string line = fmt::format("  case {}, {}: {}", cases_text(one.claim), words(one.claim),
                                   name(one.outcome));
    if (!one.note.empty()) {
      line += fmt::format("{} {}", one.outcome == Outcome::qualified ? "" : ":", one.note);
    }
    const bool speaks = of_a_search || one.status == transform::Status::inadmissible;
    if (speaks && !one.reason.empty() &&
        quoted.insert({one.claim.cases.front(), one.claim.order}).second) {
      line += ": " + one.reason;
    }
    text += report::wrapped(line, width, 4);
  }
  return text;
}

std::string criteria(std::size_t width) {
  std::string text;
  for (const auto& sentence :
       {fmt::format("MCS: the simulation; n: the order of the paper's closure, epc-gaussian. L1: "
                    "integral of |p - MCS|. tail: mean |log10 p - log10 MCS| where MCS is 1e-5 .. "
                    "1e-3."),
        fmt::format("agrees: L1 at most {:g}, the accuracy that closures are held to, and tail at "
                    "most {:g}, a factor of 1.6: what a simulation of the paper's 1e7 samples can "
                    "tell apart there. differs: one of them above. better: both smaller, by more "
                    "than the reference leaves open (L1: its own error; tail: its distance to "
                    "finite differences). less Gaussian: n=2, a Gaussian, is further off "
                    "in L1 than in case 1.",
                    kAgreementL1, kAgreementInTail),
        fmt::format("equivalent linearisation: L1 to its Gaussian at most {:g}. not found: plain "
                    "Newton steps from equivalent linearisation find no root.",
                    kSameGaussianL1)}) {
    text += report::wrapped(sentence, width);
  }
  return text;
}

}  // namespace

std::string cases_text(const Claim& claim) {
  const auto& cases = claim.cases;
  return cases.size() == 1 ? fmt::format("{}", cases.front())
                           : fmt::format("{}-{}", cases.front(), cases.back());
}

std::string figure_text(const Claim& claim) {
  if (claim.panels.empty()) return "";
  const int first = Claim::figure(claim.cases.front()), last = Claim::figure(claim.cases.back());
  return first == last ? fmt::format("{}{}", first, claim.panels)
                       : fmt::format("{}-{}", first, last);
}

std::string closing_sentence(std::span<const Judgement> judgements) {
  std::vector<std::string> parts;
  for (const auto& [outcome, name, meaning] : kOutcomeNames) {
    const auto count = std::ranges::count(judgements, outcome, &Judgement::outcome);
    if (count == 0) continue;
    parts.push_back(meaning.empty() ? fmt::format("{} {}", count, name)
                                    : fmt::format("{} {} ({})", count, name, meaning));
  }
  return fmt::format("{} claims of the paper: {}.", judgements.size(), fmt::join(parts, ", "));
}

std::string table(std::span<const Judgement> judgements, const report::TextFormat& format) {
  return rows(judgements, format) + notes(judgements, format.width) + '\n' +
         criteria(format.width) + '\n' +
         report::wrapped(closing_sentence(judgements), format.width);
}

}  // namespace fpkcheck::paper
