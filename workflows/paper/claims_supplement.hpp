#pragma once

#include <span>
#include <string>
#include <vector>

#include "report/figure/figure_options.hpp"
#include "report/report_supplement.hpp"
#include "report/text/text_layout.hpp"
#include "results/run.hpp"
#include "workflows/paper/judge_claims.hpp"

namespace fpkcheck::paper {

/// Returns the claims of the paper, and the paper's figures, as a supplement to the report of a
/// run.
/// @param format text format of the table of claims for the terminal
report::ReportSupplement claims_supplement(std::span<const PaperClaimJudgement> judgements,
                                           const results::Run& run, report::FigureWidth width,
                                           const report::TerminalTextFormat& format = {});

/// Returns whether a run is a complete run of `fpkcheck paper`, whose report includes the claims.
bool is_paper_run(const results::Run& run);

inline constexpr const char* kClaimsCsv = "claims.csv";
inline constexpr const char* kClaimsJson = "claims.json";

/// Returns the judged claims of the paper as CSV, with one row for each claim. Missing values are
/// empty fields.
std::string claims_csv(std::span<const PaperClaimJudgement> judgements);

/// Returns the contents of claims.json: the program version, the criteria of the judgement, and the
/// list `claims`. Each element of the list `claims` has the fields of claims.csv and the reason for
/// the status of the closure.
std::string claims_json(std::span<const PaperClaimJudgement> judgements,
                        const results::ProgramInfo& program);

/// Returns the output of --json, the summary of the run with the additional keys `criteria` and
/// `claims`.
std::string summary_json_with_claims(std::span<const PaperClaimJudgement> judgements,
                                     const results::Run& run);

/// Returns the paper's Figs. 2-5, one figure for each case, with the curves EPC (n = 2), (n = 4),
/// (n = 6) and MCS. The panels of each figure are (a) p(y), (b) the logarithm of p(y), (c) p(y'),
/// (d) the logarithm of p(y'). If the status of a closure is not `ok`, the legend of the figure
/// states the status. A case without any of the curves EPC (n = 2), (n = 4), (n = 6) and MCS has no
/// figure.
std::vector<report::PictureGnuplotScript> paper_figure_scripts(
    const results::Run& run, report::FigureWidth width = report::FigureWidth::screen);

/// Returns two plots for each figure of the paper, one with the panels a and b, and one with the
/// panels c and d.
std::vector<std::vector<report::ReportPagePlot>> paper_figure_plots(const results::Run& run);

}  // namespace fpkcheck::paper
