#include "compare/page/page.hpp"

#include <fmt/format.h>

#include <map>
#include <stdexcept>

#include "compare/findings.hpp"
#include "compare/page/budget_view.hpp"
#include "compare/page/case_tables.hpp"
#include "compare/page/convergence_plots.hpp"
#include "compare/page/density_plots.hpp"
#include "compare/page/html.hpp"
#include "compare/page/joint_maps.hpp"
#include "compare/page/number_text.hpp"
#include "compare/page/parts.hpp"
#include "compare/page/problem_text.hpp"
#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

template <class Curve>
std::vector<Curve> of_case(const std::vector<Curve>& all, const std::string& case_name) {
  std::vector<Curve> own;
  for (const auto& one : all) {
    if (one.case_name == case_name) own.push_back(one);
  }
  return own;
}

// Sentences under a key: one text or a list of them.
std::vector<std::string> sentences_under(const Json& object, const std::string& key) {
  std::vector<std::string> sentences;
  const auto found = object.find(key);
  if (found == object.end()) return sentences;
  const Json list = found->is_array() ? *found : Json::array({*found});
  for (const auto& one : list) {
    if (one.is_string()) sentences.push_back(one.get<std::string>());
  }
  return sentences;
}

std::string list_html(const std::vector<std::string>& sentences) {
  if (sentences.empty()) return "";
  std::string html = "<ul>\n";
  for (const auto& sentence : sentences) html += element("li", sentence);
  return html + "</ul>\n";
}

constexpr const char* kSimulationHint =
    "<p>Circles in a grey band: the simulation with its 95 % intervals.</p>\n";
constexpr const char* kLegendHint =
    "<p class=\"on-screen\">A click on a name in a legend switches that solution off or on in all "
    "plots of this case, a double click shows it alone.</p>\n";
constexpr const char* kBudgetHint =
    R"html(<p>What each step adds on the way from a closure to the reference, which is the simulation where there is
one: L1, and in the tail the mean |Δ log<sub>10</sub> p|. The total is at most the sum of the parts; it is less where they
cancel. (<a href="#budget-terms">What the parts are</a>)</p>
)html";

/// The section of one case, and the plots in it.
class CaseSection {
 public:
  CaseSection(const SavedRun& run, const Json& summary_case, const std::string& id) {
    html_ = fmt::format("<section id=\"{}\" class=\"case\">\n", id) +
            element("h2", word(summary_case, "name")) + element("p", parameters_text(summary_case));
    const auto name = word(summary_case, "name");
    html_ += element("h3", "Results") + results_table(summary_case) + reasons_html(summary_case);
    auto said = findings(summary_case);
    const auto limits = sentences_under(summary_case, "limits");
    said.insert(said.end(), limits.begin(), limits.end());
    html_ += list_html(said);

    const std::string hint = usable(summary_case, "mcs") ? kSimulationHint : "";
    add_plots("Densities", hint + kLegendHint,
              density_plots(summary_case, of_case(run.marginals, name), id));
    add_joint_maps(joint_maps(summary_case, of_case(run.joints, name)), id);
    add_plots("Error budget", kBudgetHint, budget_plots(summary_case, id));
    html_ += budget_tables(summary_case);
    add_plots("Convergence", "", order_plots(summary_case, id));
    add_plots("Distance against cost", "", cost_plots(summary_case, id));
    html_ += element("h3", "Diagnostics") + diagnostics_tables(summary_case) + "</section>\n";
  }

  const std::string& html() const { return html_; }

  Json plots() const { return {{"plots", plots_json(plots_)}, {"maps", maps_}}; }

 private:
  void add_plots(const std::string& heading, const std::string& introduction,
                 std::vector<Plot> plots) {
    if (plots.empty()) return;
    html_ += element("h3", heading) + introduction;
    html_ += plots_html(plots);
    for (auto& plot : plots) plots_.push_back(std::move(plot));
  }

  void add_joint_maps(const std::optional<JointMaps>& maps, const std::string& id) {
    if (!maps) return;
    html_ += element("h3", "Joint densities") + joint_maps_html(*maps, id);
    maps_ = joint_maps_json(*maps, id);
  }

  std::string html_;
  std::vector<Plot> plots_;
  Json maps_ = nullptr;
};

std::string navigation(const Json& summary, const std::vector<std::string>& ids) {
  std::string html = "<nav aria-label=\"Sections\">\n<a href=\"#problem\">Problem</a>\n";
  for (std::size_t k = 0; k < ids.size(); ++k) {
    html += fmt::format("<a href=\"#{}\">{}</a>\n", ids[k],
                        escaped(word(summary.at("cases").at(k), "name")));
  }
  return html + "<a href=\"#repeat\">Timings, command</a>\n</nav>\n";
}

std::string repetition(const Json& summary) {
  const Json program = summary.value("program", Json::object());
  return "<section id=\"repeat\">\n" + element("h2", "Timings, and how to repeat this") +
         timings_table(summary) +
         fmt::format("<p>Made by {} {} with</p>\n<pre><code>{}</code></pre>\n</section>\n",
                     escaped(word(program, "name")), escaped(word(program, "version")),
                     escaped(word(program, "command")));
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

std::string report_page(const SavedRun& run) {
  const Json& summary = run.summary;
  std::vector<std::string> ids;
  std::string sections;
  Json plots = Json::array();
  for (const auto& summary_case : summary.at("cases")) {
    ids.push_back(fmt::format("case-{}", ids.size() + 1));
    const CaseSection section(run, summary_case, ids.back());
    sections += section.html();
    plots.push_back(section.plots());
  }
  const std::string title = "fpkcheck: stationary densities of a vibro-impact oscillator";
  const std::string body =
      navigation(summary, ids) + "<main>\n" + element("h1", title) + "<section id=\"problem\">\n" +
      element("h2", "The problem") + problem_html(summary) + overview_table(summary) +
      "<details>\n<summary>What the names mean</summary>\n" + methods_html() +
      "</details>\n</section>\n" + sections + repetition(summary) + "</main>\n";
  const std::string data =
      inside_script(plots.dump(-1, ' ', false, Json::error_handler_t::replace));
  return filled(page_frame(), {{"title", title},
                               {"style", page_style()},
                               {"body", body},
                               {"plots", data},
                               {"plotly", plotly_script()},
                               {"script", page_script()}});
}

}  // namespace fpkcheck::compare
