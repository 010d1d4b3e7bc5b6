#include "workflows/paper/claims_supplement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "report/figure/case_figures.hpp"
#include "report/figure/density_content.hpp"
#include "report/page/page_plots.hpp"
#include "workflows/paper/claims.hpp"

namespace fpkcheck::paper {
namespace {

using results::CaseResult;

constexpr int kOrders[] = {2, 4, 6};
constexpr const char* kSimulation = "mcs";

std::vector<std::pair<std::string, std::string>> ids_and_paper_names() {
  std::vector<std::pair<std::string, std::string>> names;
  for (const int order : kOrders) {
    names.emplace_back(paper_closure_id(order), fmt::format("EPC (n = {})", order));
  }
  names.emplace_back(kSimulation, "MCS");
  return names;
}

// Returns the results of a case with only the four solutions of the paper's figure, under the
// paper's names EPC and MCS.
CaseResult paper_figure_case(const CaseResult& case_result) {
  CaseResult shown{.problem = case_result.problem};
  for (const auto& [id, paper_name] : ids_and_paper_names()) {
    const auto* solution = case_result.find(id);
    if (solution == nullptr) continue;
    shown.solutions.push_back(*solution);
    shown.solutions.back().identity.id = paper_name;
    for (const auto variable : transform::kVariables) {
      const auto* curve = case_result.marginal_curve(id, variable);
      if (curve == nullptr) continue;
      shown.curves.push_back(*curve);
      shown.curves.back().solution = paper_name;
    }
  }
  shown.update_assessment();
  return shown;
}

// Calls the function `use` with the figure number, the case with the paper's solutions, and the
// figure content for each figure of the paper.
template <class Use>
void for_each_paper_figure(const results::Run& run, const Use& use) {
  for (int number = 1; number <= 4; ++number) {
    const auto case_result =
        std::ranges::find(run.cases, paper_case_name(number), &CaseResult::name);
    if (case_result == run.cases.end()) continue;
    const int figure = PaperClaim::figure_number(number);
    const CaseResult shown = paper_figure_case(*case_result);
    auto content = report::density_content_for_picture(shown);
    if (content.marginals.empty()) continue;
    content.reference.clear();
    for (auto& marginal : content.marginals) {
      for (auto& drawn : marginal.curves) drawn.difference = {};
      // The axes of the paper's figures include the peaks of all curves, even of closures that are
      // not ok.
      const auto all_curves = report::density_axis_ranges(marginal.curves);
      marginal.ranges.linear_top = std::max(marginal.ranges.linear_top, all_curves.linear_top);
      marginal.ranges.largest_density =
          std::max(marginal.ranges.largest_density, all_curves.largest_density);
    }
    use(figure, shown, content);
  }
}

std::string figure_stem(int figure) { return fmt::format("paper-fig-{}", figure); }

}  // namespace

std::vector<report::PictureGnuplotScript> paper_figure_scripts(const results::Run& run,
                                                               report::FigureWidth width) {
  std::vector<report::PictureGnuplotScript> all;
  for_each_paper_figure(
      run, [&](int figure, const CaseResult& shown, const report::DensityFigureContent& content) {
        const std::string stem = figure_stem(figure);
        problem::Problem titled = shown.problem;
        titled.name = fmt::format("Fig. {} ({})", figure, shown.name());
        all.push_back({stem, report::make_gnuplot_script(
                                 report::density_figure(titled, content, width), stem, width)});
      });
  return all;
}

std::vector<std::vector<report::ReportPagePlot>> paper_figure_plots(const results::Run& run) {
  std::vector<std::vector<report::ReportPagePlot>> all;
  for_each_paper_figure(
      run, [&](int figure, const CaseResult& shown, const report::DensityFigureContent& content) {
        auto shown_content = content;
        shown_content.smallest_density = report::kSmallestDensityOnPage;
        auto plots = report::make_page_plots(report::density_figure(shown.problem, shown_content),
                                             figure_stem(figure));
        for (std::size_t k = 0; k < plots.size(); ++k) {
          const bool is_y = content.marginals[k].variable == transform::StateVariable::y;
          plots[k].caption = fmt::format("Fig. {}{} ({}). {}", figure, is_y ? "a, b" : "c, d",
                                         shown.problem.name, plots[k].caption);
        }
        all.push_back(std::move(plots));
      });
  return all;
}

}  // namespace fpkcheck::paper
