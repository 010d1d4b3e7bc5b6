#include <fmt/format.h>

#include "base/input_error.hpp"
#include "cli/command_line.hpp"
#include "cli/program.hpp"
#include "cli/solve_and_report.hpp"
#include "cli/terminal.hpp"
#include "problem/case_file.hpp"
#include "workflows/paper/claims.hpp"
#include "workflows/paper/claims_supplement.hpp"
#include "workflows/paper/claims_table.hpp"
#include "workflows/paper/judge_claims.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kPaperUsage = R"(usage: fpkcheck paper [options]

Tests the numerical claims of the paper "Stochastic response of a vibro-impact Duffing system under
external Poisson impulses". Solves its four cases by its closures of order 2, 4, 6 and 8, by finite
volumes and by simulation, as `run` does. Judges each claim of its sections 3 and 4: the table has
a row for each claim with the deciding numbers, their required values and the outcome. Also draws
Figs. 2-5 of the paper.
  established       the numbers of the run meet the claim
  established, but  the numbers meet the claim, but the solution is no probability density
  not established   the numbers of the run do not meet the claim
  unjudged          a deciding number is missing
Exit code 0 when all claims were judged, whatever the outcome, and finite volumes and simulation
have status ok; else 1.

DIR receives the files of `run`, claims.csv, claims.json, and the figures of the paper as
figures/paper-fig-2.png .. -5. report.html includes claims and figures; `report` rebuilds it.
With --json, the key `claims` has the table.

examples:
  fpkcheck paper
  fpkcheck paper --out results --seed 7
)";
constexpr const char* kDefaultPaperDirectory = "fpkcheck-paper";

RunSupplement make_claims_supplement(const results::Run& run, report::FigureWidth width) {
  const auto judgements = paper::judge_claims(run);
  RunSupplement supplement{
      .report = paper::claims_supplement(judgements, run, width, terminal_format()),
      .json = paper::summary_json_with_claims(judgements, run),
      .failures = {}};
  for (const auto& judgement : judgements) {
    if (judgement.outcome != paper::PaperClaimOutcome::unjudged) continue;
    supplement.failures.push_back(fmt::format("case {}: '{}' was not judged: {}",
                                              paper::claim_cases_text(judgement.claim),
                                              claim_text(judgement.claim), judgement.note));
  }
  return supplement;
}

}  // namespace

int paper_command(const CommandInvocation& call) {
  CommonCommandArguments common;
  base::Values given;
  auto options = make_solver_run_options(call.registry, given);
  options.add(make_figure_options(common.figures));
  if (!parse_arguments(
          call.arguments, kPaperUsage,
          add_output_options(options, common, "write all files to DIR (default: fpkcheck-paper)"),
          common.cases)) {
    return kSuccess;
  }
  if (!common.cases.empty()) {
    throw InputError("paper takes no case: it solves those of the paper; use run for other cases");
  }
  for (const auto& named : problem::paper_cases()) common.cases.push_back(named.name);
  if (!common.out) common.out = kDefaultPaperDirectory;
  return solve_and_report(common,
                          call.registry.methods_selected_by_list(paper::kRequiredMethods, given),
                          {.required = SolutionsRequiredForSuccess::references,
                           .threads = requested_thread_count(given),
                           .with_backward = true,
                           .supplement =
                               [&](const results::Run& run) {
                                 return make_claims_supplement(run, common.figures.width);
                               }},
                          call.command_line);
}

}  // namespace fpkcheck::cli
