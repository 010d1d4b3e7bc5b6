#include "report/verdict/verdict.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "compare/agreement.hpp"
#include "compare/reference.hpp"
#include "report/references.hpp"
#include "report/verdict/outcome.hpp"

namespace fpkcheck::report {
namespace {

using transform::Role;
using transform::Solution;
using transform::Variable;

using Words = std::vector<std::string>;

std::string listed(const Words& words) { return fmt::format("{}", fmt::join(words, ", ")); }

// "mcs", or where cases differ "mcs (fd-kf in case2)".
std::string names_of_references(const results::Run& run) {
  std::map<std::string, Words> cases;
  for (const auto& one : run.cases) {
    if (const auto* chosen = compare::reference(one.solutions)) {
      cases[chosen->id()].push_back(one.name());
    }
  }
  const auto most =
      std::ranges::max_element(cases, {}, [](const auto& entry) { return entry.second.size(); });
  std::string text = most->first;
  for (const auto& [id, names] : cases) {
    if (id != most->first) text += fmt::format(" ({} in {})", id, listed(names));
  }
  return text;
}

/// Accuracy of the references of a run, as maxima over the cases.
struct Known {
  int judged = 0;             ///< cases with a reference
  double y = 0, ydot = 0;     ///< error estimates of the references
  std::string second = {};    ///< id of a second solution of the full problem
  int checked = 0;            ///< cases with this second solution
  int contradicted = 0;       ///< cases in which the second solution and the reference disagree
  MarginalDistances apart{};  ///< distances of the second solution to the reference
};

Known known_of(const results::Run& run) {
  Known known;
  for (const auto& one : run.cases) {
    const auto all = references(one);
    if (all.empty()) continue;
    ++known.judged;
    known.y = std::max(known.y, compare::own_error(*all.front(), Variable::y));
    known.ydot = std::max(known.ydot, compare::own_error(*all.front(), Variable::ydot));
    if (all.size() < 2) continue;
    const Solution& second = *all.back();
    if (known.second.empty()) known.second = second.id();
    if (known.second != second.id()) continue;
    ++known.checked;
    if (!compare::agree(*all.front(), second, one.pairs)) ++known.contradicted;
    known.apart.widen(one.l1(second.id(), all.front()->id(), Variable::y),
                      one.l1(second.id(), all.front()->id(), Variable::ydot));
  }
  return known;
}

std::string what_is_known(const results::Run& run, const Known& known) {
  const int cases = static_cast<int>(run.cases.size());
  if (known.judged == 0) {
    return "There is no reference: no solution of the full problem has status ok. Only the error "
           "estimate of each solution is available.";
  }
  std::string text =
      fmt::format("The reference{} is {}", in_cases(known.judged, cases), names_of_references(run));
  if (std::isfinite(known.y + known.ydot)) {
    text += fmt::format(", with L1 error estimates of {:.1g} in p(y) and {:.1g} in p(y')", known.y,
                        known.ydot);
  }
  if (known.checked > 0 && known.apart.any()) {
    text += fmt::format(". The L1 distance of the independent solution {} to the reference is {}",
                        known.second, text_of(known.apart));
  }
  return text + '.';
}

// "4, 8, 12".
std::string orders_text(const std::vector<const Record*>& members) {
  Words orders;
  for (const Record* record : members) {
    orders.push_back(fmt::format("{}", *record->identity->order));
  }
  return listed(orders);
}

bool is_by_order(const Record& record) { return transform::is_by_order(*record.identity); }

int order_of(const Record* record) { return *record->identity->order; }

std::vector<std::vector<const Record*>> families_of(const std::vector<Record>& all) {
  std::vector<std::vector<const Record*>> families;
  for (const auto& record : all) {
    if (!is_by_order(record)) continue;
    const auto same = std::ranges::find_if(families, [&](const auto& members) {
      return members.front()->identity->family == record.identity->family &&
             members.front()->identity->formulation == record.identity->formulation;
    });
    if (same == families.end()) {
      families.push_back({&record});
    } else {
      same->push_back(&record);
    }
  }
  for (auto& members : families) std::ranges::stable_sort(members, {}, order_of);
  return families;
}

// The closure of the paper has the impact to first order in 1-r.
bool is_the_papers(const Record& record) {
  return is_by_order(record) && !transform::is_guest(*record.identity) &&
         record.identity->impact == problem::Impact::delta;
}

// An external density that belongs to no family of several orders.
bool is_single_guest(const Record& record) {
  return transform::is_guest(*record.identity) && !is_by_order(record);
}

// "epc-gaussian (the paper's closure) at n = 6, not at n = 2, 4, 8".
// @param any set to whether some order reproduces the references
std::string orders_that_do(const std::vector<const Record*>& members, bool& any) {
  std::vector<const Record*> good, bad;
  for (const Record* record : members) {
    (record->reproduced() == record->present() ? good : bad).push_back(record);
  }
  any = !good.empty();
  const std::string subject =
      fmt::format("{}{}", members.front()->identity->family,
                  is_the_papers(*members.front()) ? " (the paper's closure)" : "");
  if (good.empty()) return fmt::format("{} at n = {}", subject, orders_text(members));
  return fmt::format("{} at n = {}{}", subject, orders_text(good),
                     bad.empty() ? "" : fmt::format(", not at n = {}", orders_text(bad)));
}

std::string who_reproduces_it(const results::Run& run, const std::vector<Record>& all) {
  Words yes, no;
  for (const auto& record : all) {
    if (!is_single_guest(record)) continue;
    (record.reproduced() == record.present() ? yes : no).push_back(record.identity->id);
  }
  for (const auto& members : families_of(all)) {
    bool any = false;
    const std::string text = orders_that_do(members, any);
    (any ? yes : no).push_back(text);
  }
  if (yes.empty() && no.empty()) return "";
  const int cases = static_cast<int>(run.cases.size());
  const std::string within =
      fmt::format("Within L1 {} of the reference{}", kCloseL1, in_cases(cases, cases));
  if (yes.empty()) return fmt::format("{}: none of {}.", within, fmt::join(no, "; "));
  return fmt::format("{}: {}{}.", within, fmt::join(yes, "; "),
                     no.empty() ? "" : fmt::format("; not {}", fmt::join(no, "; ")));
}

VerdictLine line_of(const Record& record, const std::string& reference, int cases) {
  return {record.identity->id, record.reproduced() == record.present(),
          outcome(record, reference, cases)};
}

// The largest distance for each order of a formulation: "n = 4 has L1 distance 0.0089, 8 has
// 0.0017".
VerdictLine line_of(const std::vector<const Record*>& members, int cases) {
  Words parts;
  bool all = true, first = true;
  for (const Record* record : members) {
    all = all && record->reproduced() == record->present();
    const auto farthest = record->farthest();
    const std::string order = fmt::format("{}{}", first ? "n = " : "", *record->identity->order);
    parts.push_back(
        farthest ? fmt::format("{} has {}{:.2g}", order, first ? "L1 distance " : "", *farthest)
                 : fmt::format("{} is {}", order, brief_outcome(*record, cases)));
    first = false;
  }
  return {members.front()->identity->family, all,
          fmt::format("{}{}", all ? "reproduced: " : "reproduced in part: ", listed(parts))};
}

std::vector<VerdictLine> lines_of(const results::Run& run, const std::vector<Record>& all) {
  const int cases = static_cast<int>(run.cases.size());
  const std::string reference = names_of_references(run);
  std::vector<VerdictLine> lines;
  for (const auto& record : all) {
    if (is_single_guest(record)) lines.push_back(line_of(record, reference, cases));
  }
  for (const auto& members : families_of(all)) {
    if (members.size() > 1 && !is_the_papers(*members.front())) {
      lines.push_back(line_of(members, cases));
    } else {
      for (const Record* record : members) lines.push_back(line_of(*record, reference, cases));
    }
  }
  for (const auto& record : all) {
    const bool solves_it = std::ranges::any_of(record.stands, [](const Stand& stand) {
      return stand.solution != nullptr && compare::solves_the_problem(*stand.solution);
    });
    const Role role = record.identity->role;
    if (solves_it || (role != Role::equation && role != Role::simulation)) continue;
    lines.push_back(line_of(record, reference, cases));
  }
  return lines;
}

// The fastest solution with status ok and total error within the accuracy in every case: its
// distance to the reference plus the error estimate of the reference.
const Record* quickest(const std::vector<Record>& all, double accuracy, double known) {
  const Record* best = nullptr;
  for (const auto& record : all) {
    const bool good = std::ranges::all_of(record.stands, [&](const Stand& stand) {
      if (stand.standing == Standing::reference) return known <= accuracy;
      return stand.solution != nullptr && stand.solution->is_ok() && stand.y && stand.ydot &&
             *stand.farthest() + known <= accuracy;
    });
    if (!good || transform::is_guest(*record.identity)) continue;
    if (best == nullptr || record.seconds() < best->seconds()) best = &record;
  }
  return best;
}

Words whom_to_trust(const results::Run& run, const std::vector<Record>& all, const Known& known) {
  const int cases = static_cast<int>(run.cases.size());
  if (known.judged < cases) {
    return {
        fmt::format("There is no reference{}: rely on the error estimate of each solution. Add "
                    "fd-kf and mcs to --methods, or raise their limits (--max-seconds, --time).",
                    in_cases(cases - known.judged, cases))};
  }
  Words sentences;
  std::string first = fmt::format(
      "For reference values use {}, the solution of the full problem (all jumps, exact impact) "
      "with the smallest error estimate",
      names_of_references(run));
  if (known.contradicted > 0) {
    first += fmt::format("; {} differs by more than the errors of both explain{}", known.second,
                         in_cases(known.contradicted, cases));
  } else if (known.checked == cases) {
    first += fmt::format("; {} confirms these values", known.second);
  } else {
    first += "; no independent solution in this run confirms these values";
  }
  sentences.push_back(first + '.');
  const double error = std::max(known.y, known.ydot);
  Words parts;
  const Record* last = nullptr;
  for (const double accuracy : {0.01, 0.001}) {
    const Record* found = quickest(all, accuracy, std::isfinite(error) ? error : 0);
    if (found == nullptr || found == last) continue;
    parts.push_back(fmt::format("within L1 {}{}, {} ({:.2g} s)", accuracy,
                                parts.empty() ? in_cases(cases, cases) : "", found->identity->id,
                                found->seconds()));
    last = found;
  }
  if (!parts.empty()) {
    sentences.push_back(
        fmt::format("Fastest solution with status ok: {}.", fmt::join(parts, "; ")));
  }
  return sentences;
}

}  // namespace

Verdict verdict(const results::Run& run) {
  Verdict said{.records = records(run), .answer = {}, .lines = {}, .trust = {}};
  if (run.cases.empty()) return said;
  const auto& all = said.records;
  const Known known = known_of(run);
  for (const auto& one : run.cases) {
    if (!one.bounds) continue;
    for (const auto& outside : compare::contradictions(*one.bounds, one.solutions)) {
      said.answer.push_back(
          fmt::format("{}: {} is wrong, its {} contradicts the guaranteed bounds.", one.name(),
                      outside.solution->id(), outside.bound->functional));
    }
  }
  said.answer.push_back(what_is_known(run, known));
  if (known.judged > 0) {
    if (auto text = who_reproduces_it(run, all); !text.empty()) said.answer.push_back(text);
    said.lines = lines_of(run, all);
  }
  said.trust = whom_to_trust(run, all, known);
  return said;
}

}  // namespace fpkcheck::report
