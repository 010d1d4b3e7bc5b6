#include "report/page/page_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "report/case_solutions.hpp"
#include "report/figure/case_figures.hpp"
#include "report/figure/curve_selection.hpp"
#include "report/findings.hpp"
#include "report/page/html_elements.hpp"
#include "report/page/page_plots.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {
namespace {

std::string sentence_list_html(const std::vector<std::string>& sentences) {
  if (sentences.empty()) return "";
  std::string html = "<ul>\n";
  for (const auto& sentence : sentences) html += html_element("li", sentence);
  return html + "</ul>\n";
}

constexpr const char* kSimulationHint =
    "<p>Circles in a grey band: the simulation with its 95 % confidence intervals, without control "
    "variates.</p>\n";
constexpr const char* kErrorSourceIntroduction =
    "<p>The integral of a map is the error of the moment (dual-weighted residual). The map shows "
    "minus the solution of the backward equation times the residual of the density in the "
    "stationary equation. No other density is needed.</p>\n";
constexpr const char* kLegendHint =
    "<p class=\"on-screen\">A click on a name in a legend hides or shows the solution in all plots "
    "of this case; a double click hides all other solutions.</p>\n";
bool has_simulation(const results::CaseResult& case_result) {
  return std::ranges::any_of(case_result.solutions, [](const transform::Solution& solution) {
    return solution.identity.role == transform::SolutionRole::simulation &&
           solution.has_status_ok();
  });
}

struct ReportCaseSubsection {
  std::string anchor, name;
};

/// The section of a case with its plots. The density plots of a case come first; all other
/// subsections are closed <details> elements.
class ReportCaseSection {
 public:
  ReportCaseSection(const results::Run& run, const results::CaseResult& case_result,
                    const std::string& id)
      : id_(id) {
    const std::string reference = reference_description_text(case_result);
    const std::string parameters =
        run.cases.size() > 1 ? varying_parameters_text(run, case_result)
                             : problem::non_default_parameters_text(case_result.problem, true);
    html_ = fmt::format("<section id=\"{}\" class=\"case\">\n<h2>{} <small>{}</small></h2>\n", id,
                        escape_html(case_result.name()), escape_html(parameters));
    const std::string hint = has_simulation(case_result) ? kSimulationHint : "";
    add_plots(
        "densities", "Densities and differences", hint + kLegendHint,
        make_page_plots(density_figure(case_result.problem,
                                       density_content_for_page(
                                           case_result, initially_visible_solutions(case_result))),
                        id));
    begin_subsection("results", "Results");
    html_ += html_element("p", reference) + solutions_table_html(case_result) +
             status_reasons_html(case_result);
    auto sentences = case_finding_sentences(case_result);
    std::erase(sentences, reference);  // the sentence on the reference is already above the table
    if (const auto limits = results::limiting_errors_text(case_result); !limits.empty())
      sentences.push_back(limits);
    html_ += sentence_list_html(sentences);
    add_plots("budget", "Error budget", error_budget_introduction_html(case_result),
              make_page_plots(error_budget_figure(case_result), id));
    html_ += collapsible_html(id + "-budget-table", "The error budget in numbers",
                              error_budget_tables_html(case_result));
    add_plots("convergence", "Convergence", "",
              make_page_plots(convergence_figure(case_result), id));
    if (const auto maps = make_joint_density_maps(case_result)) {
      add_details("joint", "Joint densities", joint_density_maps_html(*maps, id));
      maps_ = joint_density_maps_json(*maps, id);
    }
    if (const Figure maps = error_source_page_figure(case_result); !maps.panels.empty()) {
      add_details("sources", "Sources of the errors of moments",
                  heat_maps_html(maps, id, "Errors of", kErrorSourceIntroduction));
      errors_ = heat_maps_json(maps, id);
    }
    const auto cost = make_page_plots(computing_time_figure(case_result), id);
    if (!cost.empty()) add_details("cost", "L1 distance against computing time", plots_html(cost));
    plots_.insert(plots_.end(), cost.begin(), cost.end());
    add_details("diagnostics", "Diagnostics",
                guaranteed_bound_errors_table_html(case_result) +
                    residual_errors_table_html(case_result) + diagnostics_tables_html(case_result));
    html_ += "</section>\n";
  }

  const std::string& html() const { return html_; }
  const std::vector<ReportCaseSubsection>& subsections() const { return subsections_; }

  std::string plots_json_text() const {
    return fmt::format(R"({{"plots":{},"maps":{},"errors":{}}})", plots_json(plots_), maps_,
                       errors_);
  }

 private:
  void begin_subsection(const std::string& anchor, const std::string& heading) {
    subsections_.push_back({id_ + '-' + anchor, heading});
    html_ +=
        fmt::format("<h3 id=\"{}\">{}</h3>\n", subsections_.back().anchor, escape_html(heading));
  }
  void add_details(const std::string& anchor, const std::string& heading, const std::string& html) {
    if (html.empty()) return;
    subsections_.push_back({id_ + '-' + anchor + "-part", heading});
    html_ += collapsible_html(subsections_.back().anchor, heading, html);
  }
  void add_plots(const std::string& anchor, const std::string& heading,
                 const std::string& introduction, const std::vector<ReportPagePlot>& plots) {
    if (plots.empty()) return;
    begin_subsection(anchor, heading);
    html_ += introduction + plots_html(plots);
    plots_.insert(plots_.end(), plots.begin(), plots.end());
  }

  std::string id_, html_;
  std::vector<ReportCaseSubsection> subsections_;
  std::vector<ReportPagePlot> plots_;
  std::string maps_ = "null", errors_ = "null";
};

std::string case_anchor(std::size_t place) { return fmt::format("case-{}", place + 1); }

std::string link_html(std::string_view anchor, std::string_view text) {
  return fmt::format("<a href=\"#{}\">{}</a>", escape_html(anchor), escape_html(text));
}

std::string section_html(const ReportPageSection& section) {
  return fmt::format("<section id=\"{}\">\n", escape_html(section.anchor)) +
         html_element("h2", section.heading) + section.html + "</section>\n";
}

// Returns links to the sections of the report page. If the run has few cases, the sections of the
// cases have direct links. The navigation menu lists all cases with their parameters and
// subsections.
std::string navigation_html(const results::Run& run, const std::vector<ReportCaseSection>& sections,
                            const std::vector<ReportPageSection>& others) {
  constexpr std::size_t kMaxDirectLinks = 6;
  std::string html = "<nav aria-label=\"Sections\">\n" + link_html("verdict", "Verdict") + '\n';
  for (const auto& other : others) html += link_html(other.anchor, other.heading) + '\n';
  html += link_html("problem", "Problem") + '\n';
  std::string menu;
  for (std::size_t k = 0; k < sections.size(); ++k) {
    const std::string& name = run.cases[k].name();
    if (sections.size() <= kMaxDirectLinks) html += link_html(case_anchor(k), name) + '\n';
    menu += "<li>" + link_html(case_anchor(k), name) + ' ' +
            escape_html(varying_parameters_text(run, run.cases[k])) + "<span class=\"parts\">";
    for (const auto& [anchor, part] : sections[k].subsections())
      menu += link_html(anchor, part) + ' ';
    menu += "</span></li>\n";
  }
  return html +
         fmt::format(
             "<details class=\"menu\"><summary>{}</summary>\n<ul>\n{}</ul>\n</details>\n",
             sections.size() == 1 ? "Contents" : fmt::format("All {} cases", sections.size()),
             menu) +
         link_html("repeat", "Timings and command") + "\n</nav>\n";
}

std::string timings_section_html(const results::Run& run) {
  return "<section id=\"repeat\">\n" + html_element("h2", "Timings and command") +
         timings_table_html(run) +
         fmt::format(
             "<p>Command of this run, by {} {}:</p>\n<pre><code>{}</code></pre>\n</section>\n",
             escape_html(run.program.name), escape_html(run.program.version),
             escape_html(run.program.command));
}

}  // namespace

std::string report_page_html(const results::Run& run, const ReportSupplement& supplement) {
  std::vector<ReportCaseSection> sections;
  std::vector<std::string> anchors;
  std::string cases, plots, others;
  for (std::size_t k = 0; k < run.cases.size(); ++k) {
    anchors.push_back(case_anchor(k));
    sections.emplace_back(run, run.cases[k], case_anchor(k));
    cases += sections.back().html();
    plots += (k == 0 ? "" : ",") + sections.back().plots_json_text();
  }
  for (const auto& section : supplement.sections) {
    others += section_html(section);
    for (const auto& group : section.groups) {
      plots += fmt::format(R"({}{{"plots":{}}})", plots.empty() ? "" : ",", plots_json(group));
    }
  }
  const bool with_walls =
      std::ranges::any_of(run.cases, [](const results::CaseResult& case_result) {
        return case_result.problem.system.left_wall() || case_result.problem.system.right_wall();
      });
  const std::string title = std::string("fpkcheck: stationary densities of ") +
                            (with_walls ? "a vibro-impact oscillator" : "an oscillator");
  const std::string body =
      navigation_html(run, sections, supplement.sections) + "<main>\n" + html_element("h1", title) +
      (run.stopped.empty() ? "" : "<p>" + html_element("strong", run.stopped) + "</p>\n") +
      (supplement.summary.empty() ? "" : verdict_paragraph_html(supplement.summary.front())) +
      verdict_html(run, anchors) + others + "<section id=\"problem\">\n" +
      html_element("h2", "The problem") + problem_description_html(run) +
      collapsible_html("names", "Glossary", glossary_html(run)) + "</section>\n" + cases +
      timings_section_html(run) + "</main>\n";
  return page_with_plots_html(title, body, '[' + plots + ']');
}

}  // namespace fpkcheck::report
