#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "report/figure/density_content.hpp"
#include "report/figure/figure.hpp"
#include "report/figure/figure_options.hpp"
#include "report/report_supplement.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Makes the figure of the marginal densities of a case, with the panels of the paper's Figs. 2-5:
/// (a) p(y), (b) the logarithm of p(y), (c) p(y'), (d) the logarithm of p(y'). Panels (e) and (f)
/// show the differences from the reference, since the density curves nearly coincide. A figure for
/// a single journal column has only the panels of the logarithms and of the differences. On the
/// report page, the panels of one marginal density are the rows of one plot. The figure has no
/// panels if `content` has no curves.
Figure density_figure(const problem::Problem& problem, const DensityFigureContent& content,
                      FigureWidth width = FigureWidth::screen);

/// Makes the figure of the L1 distances between closures and the reference against the closure
/// order n. Each marginal density has a panel, and each family of closures a curve. An external
/// density is a mark at its closure order, or a horizontal line if the order is unknown. The figure
/// has no panels if no family of closures has known distances at two or more orders.
Figure convergence_figure(const results::CaseResult& case_result);

/// Makes the figure of the L1 distances from the reference against the computing time, with one
/// panel for each marginal density. The figure has no panels without a reference.
Figure computing_time_figure(const results::CaseResult& case_result);

/// Makes the figure of the error sources of a case. Each solution has two heat maps over the phase
/// plane: the contributions to the errors of E[y^2] and of E[y'^2]. Each map has its own colour
/// scale, on which the colour depends on the signed square root of the value. The figure shows the
/// closest closure of each formulation and the solutions of the full problem, at most four
/// solutions, or two in a single journal column. The figure has no panels if all error sources are
/// 0 or missing, or if their cells differ.
Figure error_source_figure(const results::CaseResult& case_result,
                           FigureWidth width = FigureWidth::screen);

/// Makes the figure of the error sources of all solutions, one of which the reader of the page
/// selects. Closures come first, by increasing distance from the reference.
Figure error_source_page_figure(const results::CaseResult& case_result);

/// Makes the figure of the error budget of a case, with logarithmic axes. Each marginal density has
/// a panel of L1 distances and a panel of tail distances. Each closure has a group of bars, with a
/// bar for each part of the error budget and a black line at the total distance. The report page
/// and a figure for a single journal column omit the panels of tail distances. The figure has no
/// panels if the case has no error budget.
Figure error_budget_figure(const results::CaseResult& case_result,
                           FigureWidth width = FigureWidth::screen);

/// Removes the pictures and gnuplot scripts that draw_pictures_of_cases() wrote for the cases of a
/// run.
void remove_pictures_of_cases(const std::filesystem::path& directory, const results::Run& run);

/// Draws the pictures of every case. The directory DIRECTORY/figures receives the gnuplot script
/// NAME.gp and its picture NAME.png (or another format), with NAME = results::case_file_stem of the
/// case. Further pictures are NAME-budget for an error budget, NAME-sources for error sources, and
/// NAME-order for closures of several orders. Earlier pictures of each case are removed first, so
/// that no outdated picture remains after a failure.
/// @param gnuplot name or path of the program
/// @param additional_pictures additional pictures, drawn after the pictures of the cases
/// @return warnings about pictures that could not be drawn, one line each
/// @throws std::runtime_error if a script cannot be written
std::vector<std::string> draw_pictures_of_cases(
    const std::filesystem::path& directory, const results::Run& run,
    const FigureOptions& options = {}, const std::string& gnuplot = "gnuplot",
    const std::vector<PictureGnuplotScript>& additional_pictures = {});

}  // namespace fpkcheck::report
