#include "compare/page/problem_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compare/page/closest.hpp"
#include "compare/page/html.hpp"
#include "compare/page/number_text.hpp"
#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;
using transform::Variable;

constexpr const char* kProblem =
    R"html(<p>A particle on a hardening spring bounces off a wall at its equilibrium position and is kicked by random
impulses:</p>
<p class="formula">y″ + c y′ + k y + μ y³ = Σ<sub>k</sub> Y<sub>k</sub> δ(t − τ<sub>k</sub>) &nbsp; for y &gt; 0,
&emsp; y′<sub>+</sub> = −r y′<sub>−</sub> &nbsp; at y = 0.</p>
<p>The impulses arrive as a Poisson process of rate λ; their amplitudes Y are independent and follow one law. Sought is the
stationary probability density p(y, y′) of displacement and velocity, and from it p(y) and p(y′). All quantities are
non-dimensional.</p>
)html";

constexpr const char* kMethods = R"html(<dl>
<dt>epc-gaussian-n6, …</dt><dd>Exponential-polynomial closure of the paper: p = C exp(Q<sub>n</sub>) with a polynomial of
degree n = 6, …, projected with Gaussian weights.</dd>
<dt>epc-moment-n8, …</dt><dd>The same form, made to meet the exact moment equations of the impact process on the half-plane
y ≥ 0.</dd>
<dt>epc-polar-n6, …</dt><dd>Likewise, with a polynomial of amplitude and phase.</dd>
<dt>fd-white, fd-km4, fd-kf</dt><dd>Finite differences for three equations, below.</dd>
<dt>fd-km4-delta</dt><dd>Finite differences for the equation of the paper's closure: km4, with the impact to first order in
1 − r.</dd>
<dt>mcs</dt><dd>Simulation of the impact system itself; bands are 95 % intervals.</dd>
<dt>solves: white, km4, kf</dt><dd>The excitation term: Gaussian white noise of the same intensity; the Kramers–Moyal series cut
after the fourth derivative; the full jump integral (Kolmogorov–Feller).</dd>
<dt>… / map, delta, exact</dt><dd>The impact: velocities mapped exactly; to first order in 1 − r, as in the paper; simulated.</dd>
<dt>given / –</dt><dd>A density from a file (<code>--against</code>): neither its equation nor its impact is known.</dd>
<dt>L1</dt><dd>Integral of |p − reference|: 0 for equal densities, 2 for disjoint ones.</dd>
<dt>energy residual</dt><dd>Of the balance of power between impulses, damping and impacts, relative to the input.</dd>
<dt>status</dt><dd><b>ok</b>; <b>inadmissible</b>: the equations are met, but not by a probability density;
<b>not_converged</b>: the equations are not met; <b>ill_posed</b>: the discrete problem grows without bound;
<b>failed</b>.</dd>
</dl>
<p id="budget-terms">Parts of an error budget:</p>
<dl>
<dt>closure</dt><dd>The exponential-polynomial form and its projection: the closure against finite differences of the same
equation with the same impact.</dd>
<dt>impact</dt><dd>The impact to first order in 1 − r instead of the exact one.</dd>
<dt>truncation</dt><dd>The Kramers–Moyal series cut after the fourth derivative instead of the full jump integral.</dd>
<dt>white noise</dt><dd>White noise of the same intensity instead of impulses.</dd>
<dt>discretisation</dt><dd>What the grid of fd-kf still misses, estimated by extrapolation.</dd>
<dt>sampling</dt><dd>From the extrapolated fd-kf to the simulation. If both are right, it is chance alone, which makes the
mean L1 of the last columns.</dd>
<dt>±</dt><dd>Discretisation errors of both ends of a step, added: a part below it may be nought.</dd>
</dl>
)html";

struct Parameter {
  const char* meaning;
  const char* group;
  const char* key;
};

constexpr Parameter kParameters[] = {
    {"c, damping", "system", "damping"},
    {"k, stiffness", "system", "stiffness"},
    {"\u03bc, cubic stiffness", "system", "cubic"},
    {"r, coefficient of restitution", "system", "restitution"},
    {"\u03bb, impulses per unit of time", "impulse", "rate"},
    {"law of the amplitudes", "impulse", "law"},
    {"\u03bb E[Y\u00b2], intensity", "impulse", "intensity"},
    {"E[Y], mean amplitude", "impulse", "mean"},
};

std::string shown(const Json& object, const char* key) {
  const std::string text = word(object, key);
  return text == kNoValue ? plain_text(number(object, key)) : text;
}

std::string l1_text(const Json& summary_case, const std::string& one, const std::string& other,
                    Variable variable) {
  return l1_cell(l1_between(summary_case, one, other, variable));
}

}  // namespace

std::string problem_html(const Json& summary) {
  std::vector<HtmlColumn> columns{{"parameter", Align::left, {}}};
  for (const auto& parameter : kParameters) columns[0].cells.push_back(parameter.meaning);
  for (const auto& summary_case : summary.at("cases")) {
    HtmlColumn column{word(summary_case, "name"), Align::right, {}};
    for (const auto& [meaning, group, key] : kParameters) {
      column.cells.push_back(shown(summary_case.at(group), key));
    }
    columns.push_back(column);
  }
  return kProblem + table_html("The numbers", std::move(columns));
}

std::string parameters_text(const Json& summary_case) {
  const Json& system = summary_case.at("system");
  const Json& impulse = summary_case.at("impulse");
  std::string text = fmt::format(
      "Damping c = {}, stiffness k = {}, cubic stiffness \u03bc = {}, restitution r = {}; {} "
      "impulses at rate \u03bb = {}, of intensity \u03bb E[Y\u00b2] = {}",
      shown(system, "damping"), shown(system, "stiffness"), shown(system, "cubic"),
      shown(system, "restitution"), shown(impulse, "law"), shown(impulse, "rate"),
      shown(impulse, "intensity"));
  if (number(impulse, "mean").value_or(0) != 0) text += ", E[Y] = " + shown(impulse, "mean");
  return text + '.';
}

std::string methods_html() { return kMethods; }

std::string overview_table(const Json& summary) {
  std::vector<HtmlColumn> columns{{"case", Align::left},
                                  {"reference", Align::left},
                                  {"E[y\u00b2]"},
                                  {"E[y\u2032\u00b2]"},
                                  {"L1 fd-kf to mcs, p(y)"},
                                  {"p(y\u2032)"},
                                  {"closest closure", Align::left},
                                  {"L1 to the reference, p(y)"},
                                  {"p(y\u2032)"}};
  for (const auto& summary_case : summary.at("cases")) {
    const std::string reference = reference_of(summary_case);
    const auto closures = closures_by_distance(summary_case);
    const std::string none(kNoValue);
    const std::string closest = reference.empty() || closures.empty() ? none : closures.front();
    const Json* solution = find_solution(summary_case, reference);
    const Json moments = solution == nullptr ? Json() : solution->at("moments");
    const std::string cells[] = {word(summary_case, "name"),
                                 reference.empty() ? none : reference,
                                 number_text(number(moments, "y2"), 4),
                                 number_text(number(moments, "v2"), 4),
                                 l1_text(summary_case, "fd-kf", "mcs", Variable::y),
                                 l1_text(summary_case, "fd-kf", "mcs", Variable::ydot),
                                 closest,
                                 l1_text(summary_case, closest, reference, Variable::y),
                                 l1_text(summary_case, closest, reference, Variable::ydot)};
    for (std::size_t c = 0; c < columns.size(); ++c) columns[c].cells.push_back(cells[c]);
  }
  return table_html("What came out", std::move(columns));
}

std::string timings_table(const Json& summary) {
  std::vector<HtmlColumn> columns{{"solution", Align::left}};
  auto& ids = columns.front().cells;
  for (const auto& summary_case : summary.at("cases")) {
    for (const auto& solution : summary_case.at("solutions")) {
      const std::string id = solution.at("id");
      if (std::ranges::find(ids, id) == ids.end()) ids.push_back(id);
    }
  }
  ids.push_back("all");
  for (const auto& summary_case : summary.at("cases")) {
    HtmlColumn column{word(summary_case, "name"), Align::right, {}};
    double all = 0;
    for (const auto& id : columns.front().cells) {
      const Json* solution = find_solution(summary_case, id);
      const auto seconds = solution ? number(*solution, "seconds") : std::nullopt;
      all += seconds.value_or(0);
      column.cells.push_back(seconds_text(id == "all" ? all : seconds));
    }
    columns.push_back(column);
  }
  return table_html("Seconds per solution", std::move(columns));
}

}  // namespace fpkcheck::compare
