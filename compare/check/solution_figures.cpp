#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "compare/check/figures.hpp"
#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// What a coefficient may do to a density, relative to its peak, before it is more than rounding.
constexpr double kRounding = 1e-14;
// Where the quadrature depends on the path of the search.
constexpr double kPathRounding = 3e-9;

class SolutionFigures {
 public:
  SolutionFigures(const CaseOfRun& where, const Json& baseline, const Json& now,
                  const Tolerances& tolerances, std::vector<Figure>& figures)
      : case_name_(where.summary.at("name").get<std::string>()),
        id_(baseline.at("id").get<std::string>()),
        baseline_(baseline),
        now_(now),
        tolerances_(tolerances),
        figures_(figures) {}

  void add_all() {
    add_words("status", baseline_.at("status").get<std::string>(),
              now_.at("status").get<std::string>());
    const bool had = has_density(baseline_), has = has_density(now_);
    if (had != has) add_words("density", had ? "one" : "none", has ? "one" : "none");
    if (had && has) {
      add_moments();
      add_mass_and_energy();
    }
    add_coefficients();
  }

 private:
  static bool has_density(const Json& solution) { return !solution.at("mass").is_null(); }

  void add_words(const char* name, const std::string& was, const std::string& is) {
    add(name, FigureKind::status, was, is, was == is ? 0 : kInfinity, 0);
  }

  void add(const std::string& name, FigureKind kind, const Json& was, const Json& is, double change,
           double allowed) {
    figures_.push_back(
        {case_name_, id_, name, kind, was, is, std::isnan(change) ? kInfinity : change, allowed});
  }

  // A number that JSON has as null is not finite: it must stay so.
  void add_number(const std::string& name, FigureKind kind, const Json& was, const Json& is,
                  double scale, double allowed) {
    const double a = was.is_null() ? NAN : was.get<double>();
    const double b = is.is_null() ? NAN : is.get<double>();
    const double difference =
        was.is_null() && is.is_null() ? 0 : std::abs(b - a);  // one of them: not a number, moved
    add(name, kind, was, is, difference == 0 ? 0 : difference / scale, allowed);
  }

  void add_moments() {
    static const std::vector<std::pair<const char*, const char*>> kMoments{
        {"y1", "E[y]"},  {"y2", "E[y^2]"},  {"y4", "E[y^4]"},
        {"v1", "E[y']"}, {"v2", "E[y'^2]"}, {"v4", "E[y'^4]"}};
    for (const auto& [key, name] : kMoments) {
      const Json& was = baseline_.at("moments").at(key);
      const Json& is = now_.at("moments").at(key);
      if (is_simulation(baseline_)) {
        add_number(name, FigureKind::simulated, was, is, standard_error(key),
                   tolerances_.standard_errors);
      } else {
        add_number(name, FigureKind::moment, was, is, scale_of_moment(key),
                   tolerances_.deterministic);
      }
    }
  }

  // E[y'] = 0 in every stationary state: where it is less than a thousandth of a deviation it is an
  // error of the method, and its last digits are rounding.
  double scale_of_moment(const std::string& key) const {
    const Json& moments = baseline_.at("moments");
    const double size = std::abs(number(moments, key).value_or(0));
    constexpr double kLeastDeviations = 1e-3;
    if (key != "v1") return size;
    return std::max(size, kLeastDeviations * std::sqrt(number(moments, "v2").value_or(0)));
  }

  void add_mass_and_energy() {
    const Json& mass = baseline_.at("mass");
    const Json& energy = baseline_.at("energy_residual");
    if (is_simulation(baseline_)) {
      add_number("mass", FigureKind::simulated, mass, now_.at("mass"), error_of_mass(),
                 tolerances_.standard_errors);
      add_number("energy residual", FigureKind::simulated, energy, now_.at("energy_residual"),
                 standard_error("energy_residual"), tolerances_.standard_errors);
    } else {
      add_number("mass", FigureKind::mass, mass, now_.at("mass"), 1, tolerances_.deterministic);
      add_number("energy residual", FigureKind::energy, energy, now_.at("energy_residual"), 1,
                 tolerances_.deterministic);
    }
  }

  double standard_error(const char* key) const {
    return std::hypot(number(baseline_.at("standard_errors"), key).value_or(NAN),
                      number(now_.at("standard_errors"), key).value_or(NAN));
  }

  // 1 - mass is the share of the samples outside the bins; with n that are as good as independent
  // it has the variance of a share, and one sample more may always be there.
  double error_of_mass() const {
    const auto variance = [](const Json& solution) {
      const double n = number(solution, "effective_samples").value_or(NAN);
      return (number(solution, "outside").value_or(NAN) + 1 / n) / n;
    };
    return std::sqrt(variance(baseline_) + variance(now_));
  }

  using Coefficients = std::map<std::pair<int, int>, double>;
  static Coefficients coefficients(const Json& solution) {
    Coefficients result;
    if (!solution.contains("coefficients")) return result;
    for (const auto& term : solution.at("coefficients")) {
      result[{term.at("x1").get<int>(), term.at("x2").get<int>()}] = term.at("a").get<double>();
    }
    return result;
  }

  void add_coefficients() {
    const Coefficients was = coefficients(baseline_), is = coefficients(now_);
    Coefficients either = was;
    either.insert(is.begin(), is.end());
    for (const auto& [powers, ignored] : either) {
      const std::string name = fmt::format("a({},{})", powers.first, powers.second);
      const auto a = was.find(powers), b = is.find(powers);
      if (a == was.end() || b == is.end()) {
        add(name, FigureKind::coefficient, a == was.end() ? Json() : Json(a->second),
            b == is.end() ? Json() : Json(b->second), kInfinity, tolerances_.coefficient());
        continue;
      }
      const double scale = std::max(std::abs(a->second), least_scale(powers));
      add_number(name, FigureKind::coefficient, a->second, b->second, scale,
                 tolerances_.coefficient());
    }
  }

  // The size of a coefficient of which the tolerance is what rounding alone may do.
  double least_scale(const std::pair<int, int>& powers) const {
    const auto y2 = number(baseline_.at("moments"), "y2"),
               v2 = number(baseline_.at("moments"), "v2");
    if (!y2 || !v2) return 0;
    // max of |x|^p exp(-x^2/2)
    const auto summit = [](int p) { return p == 0 ? 1 : std::pow(p / std::exp(1.0), p / 2.0); };
    const auto [p, q] = powers;
    const double effect = std::pow(*y2, p / 2.0) * std::pow(*v2, q / 2.0) * summit(p) * summit(q);
    return (depends_on_path(baseline_) ? kPathRounding : kRounding) /
           (effect * Tolerances{}.coefficient());
  }

  std::string case_name_, id_;
  const Json& baseline_;
  const Json& now_;
  const Tolerances& tolerances_;
  std::vector<Figure>& figures_;
};

}  // namespace

bool is_simulation(const Json& solution) { return solution.at("method") == "mcs"; }

bool depends_on_path(const Json& solution) {
  constexpr int kSettledOrder = 8;
  return solution.value("formulation", std::string()) == "moment" &&
         solution.value("order", 0) > kSettledOrder;
}

std::vector<Figure> solution_figures(const CaseOfRun& baseline, const CaseOfRun& now,
                                     const Tolerances& tolerances) {
  std::vector<Figure> figures;
  const auto missing = [&](const Json& solution, const char* was, const char* is) {
    figures.push_back({baseline.summary.at("name").get<std::string>(),
                       solution.at("id").get<std::string>(), "solution", FigureKind::status, was,
                       is, kInfinity, 0});
  };
  for (const Json& solution : baseline.summary.at("solutions")) {
    const Json* again = find_solution(now.summary, solution.at("id").get<std::string>());
    if (again == nullptr) {
      missing(solution, "there", "missing");
    } else {
      SolutionFigures(baseline, solution, *again, tolerances, figures).add_all();
    }
  }
  for (const Json& solution : now.summary.at("solutions")) {
    if (find_solution(baseline.summary, solution.at("id").get<std::string>()) == nullptr) {
      missing(solution, "missing", "there");
    }
  }
  return figures;
}

}  // namespace fpkcheck::compare
