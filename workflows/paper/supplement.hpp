#pragma once

#include <span>

#include "report/figure/options.hpp"
#include "report/supplement.hpp"
#include "report/text/format.hpp"
#include "results/run.hpp"
#include "workflows/paper/judge_claims.hpp"

namespace fpkcheck::paper {

/// The claims of the paper as a supplement to the report of a run. The supplement has a summary, a
/// table and files of the claims, a section of the page with the table and the paper's figures, and
/// the same figures as pictures.
/// @param judgements the judgements of the claims by this run
/// @param format     text format of the table for the terminal
report::Supplement claims_supplement(std::span<const Judgement> judgements, const results::Run& run,
                                     report::FigureWidth width,
                                     const report::TextFormat& format = {});

/// Whether a run is a complete run of `fpkcheck paper`. The report of such a run includes the
/// claims of the paper.
bool is_paper_run(const results::Run& run);

}  // namespace fpkcheck::paper
