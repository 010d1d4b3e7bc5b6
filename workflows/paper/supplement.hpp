#pragma once

#include <span>

#include "report/figure/options.hpp"
#include "report/supplement.hpp"
#include "report/text/text_format.hpp"
#include "results/run.hpp"
#include "workflows/paper/judge_claims.hpp"

namespace fpkcheck::paper {

/// Returns the claims of the paper, and the paper's figures, as a supplement to the report of a
/// run.
/// @param format text format of the table for the terminal
report::Supplement claims_supplement(std::span<const ClaimJudgement> judgements,
                                     const results::Run& run, report::FigureWidth width,
                                     const report::TextFormat& format = {});

/// Returns whether a run is a complete run of `fpkcheck paper`, whose report includes the claims.
bool is_paper_run(const results::Run& run);

}  // namespace fpkcheck::paper
