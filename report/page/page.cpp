#include "report/page/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

#include "compare/reference.hpp"
#include "report/findings.hpp"
#include "report/page/budget_view.hpp"
#include "report/page/case_tables.hpp"
#include "report/page/convergence_plots.hpp"
#include "report/page/density_plots.hpp"
#include "report/page/error_maps.hpp"
#include "report/page/html.hpp"
#include "report/page/joint_maps.hpp"
#include "report/page/parts.hpp"
#include "report/page/problem_text.hpp"

namespace fpkcheck::report {
namespace {

std::string list_html(const std::vector<std::string>& sentences) {
  if (sentences.empty()) return "";
  std::string html = "<ul>\n";
  for (const auto& sentence : sentences) html += element("li", sentence);
  return html + "</ul>\n";
}

constexpr const char* kSimulationHint =
    "<p>Circles in a grey band: the simulation with its 95 % intervals, before any noise is taken "
    "out of it.</p>\n";
constexpr const char* kLegendHint =
    "<p class=\"on-screen\">A click on a name in a legend switches that solution off or on in all "
    "plots of this case, a double click shows it alone.</p>\n";
bool has_a_simulation(const results::Case& one) {
  return std::ranges::any_of(one.solutions, [](const transform::Solution& solution) {
    return solution.identity.role == transform::Role::simulation && solution.is_ok();
  });
}

/// The section of one case, and what page.js draws in it.
class CaseSection {
 public:
  CaseSection(const results::Case& one, const std::string& id) {
    const std::string reference = compare::reference_text(one.solutions);
    html_ = fmt::format("<section id=\"{}\" class=\"case\">\n", id) + element("h2", one.name()) +
            element("p", problem::parameters_text(one.problem, true) + '.') +
            element("h3", "Results") + element("p", reference) + results_table(one) +
            moment_errors_table(one) + own_errors_table(one) + reasons_html(one);
    auto said = findings(one);
    std::erase(said, reference);  // stands above the table
    if (!one.limits.empty()) said.push_back(one.limits);
    html_ += list_html(said);

    const std::string hint = has_a_simulation(one) ? kSimulationHint : "";
    add_plots("Densities", hint + kLegendHint, density_plots(one, id));
    if (const auto maps = joint_maps(one)) {
      html_ += element("h3", "Joint densities") + joint_maps_html(*maps, id);
      maps_ = joint_maps_json(*maps, id);
    }
    if (const auto maps = error_maps(one)) {
      html_ += element("h3", "Where the errors of moments come from") + error_maps_html(*maps, id);
      errors_ = error_maps_json(*maps, id);
    }
    add_plots("Error budget", budget_introduction(one), budget_plots(one, id));
    html_ += budget_tables(one);
    add_plots("Convergence", "", order_plots(one, id));
    add_plots("Distance against cost", "", cost_plots(one, id));
    html_ += element("h3", "Diagnostics") + diagnostics_tables(one) + "</section>\n";
  }

  const std::string& html() const { return html_; }

  /// In JSON.
  std::string plots() const {
    return fmt::format(R"({{"plots":{},"maps":{},"errors":{}}})", plots_json(plots_), maps_,
                       errors_);
  }

 private:
  void add_plots(const std::string& heading, const std::string& introduction,
                 const std::vector<Plot>& plots) {
    if (plots.empty()) return;
    html_ += element("h3", heading) + introduction + plots_html(plots);
    plots_.insert(plots_.end(), plots.begin(), plots.end());
  }

  std::string html_;
  std::vector<Plot> plots_;
  std::string maps_ = "null", errors_ = "null";
};

std::string case_id(std::size_t place) { return fmt::format("case-{}", place + 1); }

std::string navigation(const results::Run& run) {
  std::string html = "<nav aria-label=\"Sections\">\n<a href=\"#problem\">Problem</a>\n";
  for (std::size_t k = 0; k < run.cases.size(); ++k) {
    html += fmt::format("<a href=\"#{}\">{}</a>\n", case_id(k), escaped(run.cases[k].name()));
  }
  return html + "<a href=\"#repeat\">Timings, command</a>\n</nav>\n";
}

std::string repetition(const results::Run& run) {
  return "<section id=\"repeat\">\n" + element("h2", "Timings, and how to repeat this") +
         timings_table(run) +
         fmt::format("<p>Made by {} {} with</p>\n<pre><code>{}</code></pre>\n</section>\n",
                     escaped(run.program.name), escaped(run.program.version),
                     escaped(run.program.command));
}

// The frame with its {{places}} filled, in one pass: what is put in is not searched again.
std::string filled(std::string_view frame, const std::map<std::string, std::string_view>& parts) {
  std::string page;
  while (true) {
    const auto begin = frame.find("{{");
    page += frame.substr(0, begin);
    if (begin == std::string_view::npos) return page;
    const auto end = frame.find("}}", begin);
    page += parts.at(std::string(frame.substr(begin + 2, end - begin - 2)));
    frame.remove_prefix(end + 2);
  }
}

}  // namespace

std::string page(const results::Run& run) {
  std::string sections, plots;
  for (std::size_t k = 0; k < run.cases.size(); ++k) {
    const CaseSection section(run.cases[k], case_id(k));
    sections += section.html();
    plots += (k == 0 ? "" : ",") + section.plots();
  }
  const std::string title = "fpkcheck: stationary densities of a vibro-impact oscillator";
  const std::string body =
      navigation(run) + "<main>\n" + element("h1", title) +
      (run.stopped.empty() ? "" : "<p>" + element("strong", run.stopped) + "</p>\n") +
      "<section id=\"problem\">\n" + element("h2", "The problem") + problem_html(run) +
      overview_table(run) + "<details>\n<summary>What the names mean</summary>\n" +
      glossary_html(run) + "</details>\n</section>\n" + sections + repetition(run) + "</main>\n";
  const std::string data = inside_script('[' + plots + ']');
  return filled(page_frame(), {{"title", title},
                               {"style", page_style()},
                               {"body", body},
                               {"plots", data},
                               {"plotly", plotly_script()},
                               {"script", page_script()}});
}

}  // namespace fpkcheck::report
