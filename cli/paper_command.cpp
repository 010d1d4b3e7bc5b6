#include <fmt/format.h>

#include "base/input_error.hpp"
#include "cli/command_line.hpp"
#include "cli/commands.hpp"
#include "cli/figure_options.hpp"
#include "cli/parameter_options.hpp"
#include "cli/program.hpp"
#include "cli/solve_and_report.hpp"
#include "problem/named_cases.hpp"
#include "workflows/paper/claims.hpp"
#include "workflows/paper/claims_files.hpp"
#include "workflows/paper/claims_table.hpp"
#include "workflows/paper/judge.hpp"
#include "workflows/paper/supplement.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kPaperUsage = R"(usage: fpkcheck paper [options]

The numerical part of the paper that this program checks (Stochastic response of a vibro-impact
Duffing system under external Poisson impulses): solves its four cases by its closures of order 2,
4, 6 and 8, by finite differences and by simulation as `run` does, and judges what its sections 3
and 4 say of them: a row a claim, with the numbers that decide it, what the claim asks of them, and
what came out. Draws its Figs. 2-5 too.
  established       the run's numbers are as the claim states
  established, but  they are, of a solution that is no probability density
  not established   they are not as the claim states
  unjudged          a number that decides it is missing
Exit code 0 when every claim was judged, whatever came out, and finite differences and simulation
reached their solutions; else 1.

DIR gets what a run leaves, claims.csv, claims.json, and the paper's figures as
figures/paper-fig-2.png .. -5; report.html has claims and figures too, and `report`
makes all of it again. Of --json, `claims` has the table.

examples:
  fpkcheck paper
  fpkcheck paper --out results --seed 7
)";
constexpr const char* kDefaultPaperDirectory = "fpkcheck-paper";

Supplement claims_of(const results::Run& run, report::FigureWidth width) {
  const auto judgements = paper::judge(run);
  Supplement supplement{.report = paper::supplement(judgements, run, width, terminal_format()),
                        .json = paper::summary_with_claims(judgements, run),
                        .failures = {}};
  for (const auto& one : judgements) {
    if (one.outcome != paper::Outcome::unjudged) continue;
    supplement.failures.push_back(fmt::format("case {}: '{}' was not judged: {}",
                                              paper::cases_text(one.claim), claim_text(one.claim),
                                              one.note));
  }
  return supplement;
}

}  // namespace

int paper_command(const Call& call) {
  CommonArguments common;
  base::Values given;
  auto options = options_of_a_run(call.registry, given);
  options.add(figure_options(common.figures));
  if (!parse(
          call.arguments, kPaperUsage,
          with_output_options(options, common, "write all files there (default: fpkcheck-paper)"),
          common.cases)) {
    return kDone;
  }
  if (!common.cases.empty()) {
    throw InputError("paper takes no case (its cases are the paper's four)");
  }
  for (const auto& named : problem::paper_cases()) common.cases.push_back(named.name);
  if (!common.out) common.out = kDefaultPaperDirectory;
  return solve_and_report(
      common, call.registry.select(paper::kRequiredMethods, given),
      {.required = Required::references,
       .threads = threads_in(given),
       .with_backward = true,
       .supplement = [&](const results::Run& run) { return claims_of(run, common.figures.width); }},
      call.command_line);
}

}  // namespace fpkcheck::cli
