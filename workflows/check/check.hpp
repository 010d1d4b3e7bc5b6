#pragma once

#include <string>
#include <vector>

#include "report/text/format.hpp"
#include "results/run.hpp"
#include "workflows/check/figure.hpp"
#include "workflows/check/tolerances.hpp"

namespace fpkcheck::check {

/// A run beside its baseline.
struct Check {
  Tolerances tolerances;
  std::vector<Figure> figures;  ///< all that were compared, in the order of the baseline
  std::size_t solutions;        ///< of the baseline
  std::vector<std::string> notes;

  std::vector<Figure> moved() const;
  bool agrees() const;
};

/// Compares what two runs hold in common and reports what only one of them has. Not compared are
/// times, options and what solvers call work or text: they are how a solution came about, not what
/// it is.
/// @param now a run that was just solved: its observations say what they are
/// @throws InputError when the new run lacks a case
Check check(const results::Run& baseline, const results::Run& now, const Tolerances& tolerances,
            bool with_marginals = true);

/// For people: what moved, the largest change of each kind beside what is allowed, and a closing
/// sentence.
std::string check_table(const Check& check, const report::TextFormat& format);

/// For scripts: the contents of check.json.
/// @param baseline its path as given
std::string check_json(const Check& check, const std::string& command, const std::string& baseline);

/// The figures of one kind.
struct KindSummary {
  FigureKind kind;
  std::size_t count = 0;
  std::size_t moved = 0;
  const Figure* largest = nullptr;  ///< the nearest to its allowance of those that did not move
};

/// Of the kinds that there are, in their order; pointing into the check.
std::vector<KindSummary> by_kind(const Check& check);

}  // namespace fpkcheck::check
