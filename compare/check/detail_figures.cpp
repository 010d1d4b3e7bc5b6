#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "compare/check/figures.hpp"
#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Judged by solution_figures.
constexpr std::array<std::string_view, 6> kElsewhere{"id",   "status",          "moments",
                                                     "mass", "energy_residual", "coefficients"};
// How the solution came about and how long that took, not what it is; docs/checking.md gives the
// reasons. `worst_direction` is any direction where a form is isotropic, and `outside` is 1 - mass.
constexpr std::array<std::string_view, 30> kWork{
    // all methods
    "options", "reason", "seconds", "iterations", "residual",
    // closures
    "condition", "quadrature_change", "homotopies", "points", "worst_direction",
    // finite differences
    "nonzeros", "leak", "steps", "factorisations", "rhs_evaluations", "krylov_iterations",
    "factor_entries", "factor_seconds", "krylov_seconds", "stepped_against_direct",
    // simulation
    "time", "samples", "impulses", "flights", "rounds", "threads", "seed", "outside",
    "variance_reduction", "splitting_thresholds"};
// What a simulation says of its own errors.
constexpr std::array<std::string_view, 4> kYardsticks{"standard_errors", "sampling_l1",
                                                      "effective_samples", "effective_samples_y2"};
// Densities next to 0, in units of the peak or so.
constexpr std::array<std::string_view, 4> kFaintDensities{"min_density", "wall_density",
                                                          "edge_density", "cut_off"};

// Of closures whose quadrature depends on the path of the search: where nothing holds the density.
constexpr std::array<std::string_view, 2> kPathDependent{"edge_density", "cut_off"};

template <std::size_t N>
bool is_one_of(const std::array<std::string_view, N>& keys, std::string_view key) {
  return std::ranges::find(keys, key) != keys.end();
}

class DetailFigures {
 public:
  DetailFigures(const CaseOfRun& where, const Json& baseline, const Json& now,
                const Tolerances& tolerances, std::vector<Figure>& figures)
      : case_name_(where.summary.at("name").get<std::string>()),
        id_(baseline.at("id").get<std::string>()),
        depends_on_path_(depends_on_path(baseline)),
        baseline_(baseline),
        now_(now),
        tolerances_(tolerances),
        figures_(figures) {}

  void add_all() {
    const std::size_t before = figures_.size();
    add_members("", baseline_, now_, 0.1);
    allow_for_their_number(before);
  }

 private:
  void push(const std::string& name, FigureKind kind, const Json& was, const Json& is,
            double change, double allowed) {
    figures_.push_back({case_name_, id_, name, kind, was, is, change, allowed});
  }

  // A list or an object in the text stands for itself by its length.
  static Json shown(const Json& value) {
    if (value.is_structured()) return fmt::format("{} entries", value.size());
    return value.is_boolean() ? Json(value.dump()) : value;
  }

  void add(const std::string& name, const Json& was, const Json& is, double least_scale) {
    if (was.is_number() && is.is_number()) {
      add_number(name, was, is, least_scale);
    } else if (was.is_object() && is.is_object()) {
      add_members(name + '.', was, is, least_scale);
    } else if (was.is_array() && is.is_array() && was.size() == is.size()) {
      for (std::size_t k = 0; k < was.size(); ++k) {
        add(fmt::format("{}[{}]", name, k), was[k], is[k], least_scale);
      }
    } else {
      const bool same = was == is;
      push(name, same ? FigureKind::status : FigureKind::detail, shown(was), shown(is),
           same ? 0 : kInfinity, same ? 0 : tolerances_.deterministic);
    }
  }

  // Of the logarithm of a small difference, or far out where coefficients decide.
  static bool is_sensitive(std::string_view name) {
    return name == "error.observed_order" || name == "support.edge_density" ||
           name == "support.cut_off";
  }

  // A number smaller than `least_scale` may change as much as if it had that size.
  void add_number(const std::string& name, const Json& was, const Json& is, double least_scale) {
    const double a = was.get<double>(), b = is.get<double>();
    push(name, FigureKind::detail, was, is, std::abs(b - a) / std::max(std::abs(a), least_scale),
         is_sensitive(name) ? tolerances_.tail() : tolerances_.deterministic);
  }

  void add_members(const std::string& path, const Json& was, const Json& is, double least_scale) {
    if (add_estimate(path, was, is)) return;
    for (const auto& [key, value] : was.items()) {
      if (passed_over(path, key, was)) continue;
      const std::string name = path + key;
      if (!is.contains(key)) {
        push(name, FigureKind::detail, "there", "missing", kInfinity, tolerances_.deterministic);
      } else if (is_one_of(kYardsticks, key)) {
        add_yardsticks(name, value, is.at(key));
      } else if (const std::string error = key + "_error"; was.contains(error)) {
        add_in_standard_errors(name, value, is.at(key), number(was, error), number(is, error));
      } else {
        add(name, value, is.at(key), scale_of(path, key, least_scale));
      }
    }
    for (const auto& [key, value] : is.items()) {
      if (!passed_over(path, key, is) && !was.contains(key)) {
        push(path + key, FigureKind::detail, "missing", "there", kInfinity,
             tolerances_.deterministic);
      }
    }
  }

  bool passed_over(const std::string& path, std::string_view key, const Json& object) const {
    if (depends_on_path_ && is_one_of(kPathDependent, key)) return true;
    if (is_one_of(kWork, key) || (path.empty() && is_one_of(kElsewhere, key))) return true;
    constexpr std::string_view kError = "_error";
    return key.ends_with(kError) && object.contains(key.substr(0, key.size() - kError.size()));
  }

  double scale_of(const std::string& path, const std::string& key, double least_scale) const {
    constexpr double kFaint = 1e-6;
    if (is_one_of(kFaintDensities, key)) return kFaint;
    if (path != "error.moments." && path != "error.extrapolated.") return least_scale;
    // The error of a moment has the moment's rounding.
    const std::string of_size = key == "v1" ? "v2" : key;
    return std::max(least_scale, std::abs(number(baseline_.at("moments"), of_size).value_or(0)));
  }

  // {mean, standard_error} and its like.
  bool add_estimate(const std::string& path, const Json& was, const Json& is) {
    if (path.empty()) return false;
    const std::string name = path.substr(0, path.size() - 1);
    if (was.contains("lower") && was.contains("upper") && was.contains("value")) {
      const auto error = [](const Json& quantile) -> std::optional<double> {
        const auto lower = number(quantile, "lower"), upper = number(quantile, "upper");
        if (!lower || !upper) return std::nullopt;
        return (*upper - *lower) / (2 * kNormal95);
      };
      add("probability of " + name, was.at("probability"), is.at("probability"), 0.1);
      add_in_standard_errors(name, was.at("value"), is.at("value"), error(was), error(is), 2);
      return true;
    }
    if (!was.contains("standard_error")) return false;
    const auto a = number(was, "standard_error"), b = number(is, "standard_error");
    for (const auto& [key, value] : was.items()) {
      if (key == "standard_error") continue;
      if (key == "mean" || key == "relative") {
        add_in_standard_errors(name, value, is.at(key), a, b);
      } else if (key == "rate") {
        const int knowing = (known(value, a) ? 1 : 0) + (known(is.at(key), b) ? 1 : 0);
        // The errors of a handful of events are uncertain.
        if (knowing > 0) add_in_standard_errors(name, value, is.at(key), a, b, 5 - 2 * knowing);
      } else {
        add(path + key, value, is.at(key), 0.1);
      }
    }
    return true;
  }

  static bool known(const Json& rate, const std::optional<double>& error) {
    return rate.is_number() && error && rate.get<double>() > 0 &&
           kNormal95 * *error <= kWidestInterval * rate.get<double>();
  }

  void add_in_standard_errors(const std::string& name, const Json& was, const Json& is,
                              const std::optional<double>& error_was,
                              const std::optional<double>& error_is, int noise = 1) {
    const double error = std::hypot(error_was.value_or(0), error_is.value_or(0));
    const double difference =
        was.is_number() && is.is_number() ? std::abs(is.get<double>() - was.get<double>()) : NAN;
    const double change = was == is ? 0 : difference / error;
    push(name, FigureKind::simulated, was, is, std::isnan(change) ? kInfinity : change, 1);
    // A rate of a handful of events in one run has no error to speak of there.
    if (error_was == 0 || error_is == 0) return;
    add_yardstick("error of " + name, error_was ? Json(*error_was) : Json(),
                  error_is ? Json(*error_is) : Json(), noise);
  }

  void add_yardsticks(const std::string& name, const Json& was, const Json& is) {
    if (!was.is_object()) return add_yardstick(name, was, is, 2);  // samples go as 1 / error^2
    for (const auto& [key, value] : was.items()) {
      add_yardstick(name + '.' + key, value, is.contains(key) ? is.at(key) : Json(), 1);
    }
  }

  void add_yardstick(const std::string& name, const Json& was, const Json& is, int noise) {
    push(name, FigureKind::simulated_error, was, is, change_of_yardstick(was, is), noise);
  }

  // One may be the largest of so many. An error from n streams scatters by 1 / sqrt(2 (n - 1)) of
  // itself, the ratio of two by sqrt(2) times that.
  void allow_for_their_number(std::size_t first) {
    const auto count = [&](FigureKind kind) {
      return static_cast<std::size_t>(
          std::count_if(figures_.begin() + static_cast<std::ptrdiff_t>(first), figures_.end(),
                        [&](const Figure& figure) { return figure.kind == kind; }));
    };
    const double of_values = tolerances_.of_the_largest(count(FigureKind::simulated));
    const std::size_t errors = count(FigureKind::simulated_error);
    const double streams = number(baseline_, "streams").value_or(1);
    for (std::size_t k = first; k < figures_.size(); ++k) {
      Figure& figure = figures_[k];
      if (figure.kind == FigureKind::simulated) figure.allowed = of_values;
      if (figure.kind == FigureKind::simulated_error) {
        figure.allowed = allowed_of_yardstick(streams, errors, figure.allowed, tolerances_);
      }
    }
  }

  std::string case_name_, id_;
  bool depends_on_path_;
  const Json& baseline_;
  const Json& now_;
  const Tolerances& tolerances_;
  std::vector<Figure>& figures_;
};

}  // namespace

double change_of_yardstick(const Json& was, const Json& is) {
  if (was == is) return 0;
  if (!was.is_number() || !is.is_number()) return kInfinity;
  const double a = was.get<double>(), b = is.get<double>();
  return a > 0 && b > 0 ? std::max(a / b, b / a) - 1 : kInfinity;
}

double allowed_of_yardstick(double streams, std::size_t number_of_them, double power,
                            const Tolerances& tolerances) {
  // Heavier tails than the normal law's: docs/checking.md has the measurement.
  constexpr double kHeavyTails = 1.25;
  const double scatter = kHeavyTails / std::sqrt(std::max(streams - 1, 1.0));
  return std::exp(power * scatter * tolerances.of_the_largest(number_of_them)) - 1;
}

std::vector<Figure> detail_figures(const CaseOfRun& baseline, const CaseOfRun& now,
                                   const Tolerances& tolerances) {
  std::vector<Figure> figures;
  for (const Json& solution : baseline.summary.at("solutions")) {
    const Json* again = find_solution(now.summary, solution.at("id").get<std::string>());
    if (again != nullptr) {
      DetailFigures(baseline, solution, *again, tolerances, figures).add_all();
    }
  }
  return figures;
}

}  // namespace fpkcheck::compare
