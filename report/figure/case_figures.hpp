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

/// Makes the figure of the marginal densities of a case, with the panels of the paper's Figs. 2-5,
/// which are (a) p(y), (b) log p(y), (c) p(y') and (d) log p(y'). Panels (e) and (f) show the
/// differences of p(y) and p(y') from the reference solution, since the density curves nearly
/// coincide. A figure for a single journal column has only the panels of log p and of the
/// differences from the reference solution. On the report page, the panels of one marginal density
/// are the rows of one plot. The density figure has no panels if `content` has no density curves.
Figure density_figure(const problem::Problem& problem, const DensityFigureContent& content,
                      FigureWidth width = FigureWidth::screen);

/// Makes the figure of the L1 distances between closures and the reference solution, plotted
/// against the closure order n. In the convergence figure each marginal density has a panel, and
/// each family of closures has a curve. The figure shows an external density as a mark at its
/// closure order, or as a horizontal line if the order is unknown. The figure has no panels unless
/// a family of closures has known L1 distances at two or more orders.
Figure convergence_figure(const results::CaseResult& case_result);

/// Makes the figure of the L1 distances from the reference solution against the computing time,
/// with one panel for each marginal density. Without a reference solution the figure has no panels.
Figure computing_time_figure(const results::CaseResult& case_result);

/// Makes the figure of the error sources of a case, the contributions of phase-plane cells to the
/// errors of moments. Each solution has two heat maps over the phase plane, for the errors of
/// E[y^2] and of E[y'^2]. Each heat map has its own colour scale, on which the colour depends on
/// the signed square root of the value. The figure of error sources shows the closest closure of
/// each formulation and the solutions of the full problem, at most four solutions, or two in a
/// single journal column. The figure has no panels if all error sources are 0 or missing, or if the
/// solutions have different cells.
Figure error_source_figure(const results::CaseResult& case_result,
                           FigureWidth width = FigureWidth::screen);

/// Makes the figure of the error sources of all solutions; the reader of the report page selects
/// one solution. Closures precede other solutions, sorted by increasing distance from the reference
/// solution.
Figure error_source_page_figure(const results::CaseResult& case_result);

/// Makes the figure of the error budget of a case, with logarithmic axes. Each marginal density has
/// a panel of L1 distances and a panel of tail distances. In the figure each closure has a group of
/// bars, with a bar for each part of the error budget and a black line at the total distance. The
/// report page and a figure for a single journal column omit the panels of tail distances. The
/// figure has no panels if the case has no error budget.
Figure error_budget_figure(const results::CaseResult& case_result,
                           FigureWidth width = FigureWidth::screen);

/// Removes the pictures and gnuplot scripts that draw_pictures_of_cases() wrote for the cases of a
/// run.
void remove_pictures_of_cases(const std::filesystem::path& directory, const results::Run& run);

/// Draws the pictures of every case. The directory DIRECTORY/figures receives the gnuplot script
/// NAME.gp and its picture NAME.png (or another format), with NAME = results::case_file_stem of the
/// case. Pictures with the suffixes -budget, -sources and -order show the error budget, the error
/// sources, and closures of several orders. Earlier pictures of each case are removed first, so
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
