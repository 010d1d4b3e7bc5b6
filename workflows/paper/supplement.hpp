#pragma once

#include <span>

#include "report/figure/options.hpp"
#include "report/supplement.hpp"
#include "report/text/format.hpp"
#include "results/run.hpp"
#include "workflows/paper/judge.hpp"

namespace fpkcheck::paper {

/// What the paper's claims add to the report of a run: their summary, table and files, a section of
/// the page with the table and the paper's figures, and these as pictures.
/// @param judgements of the run
/// @param format     of the table on a terminal
report::Supplement supplement(std::span<const Judgement> judgements, const results::Run& run,
                              report::FigureWidth width, const report::TextFormat& format = {});

/// Whether a run is one of `fpkcheck paper` that came to its end: then its report has the claims.
bool is_run_of_paper(const results::Run& run);

}  // namespace fpkcheck::paper
