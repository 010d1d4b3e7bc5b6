#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "compare/check/figures.hpp"
#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool is_same_pair(const Json& one, const Json& other) {
  return one.at("a") == other.at("a") && one.at("b") == other.at("b") &&
         one.at("variable") == other.at("variable");
}

const Json* find_pair(const Json& summary_case, const Json& pair) {
  for (const Json& comparison : summary_case.at("comparisons")) {
    if (is_same_pair(comparison, pair)) return &comparison;
  }
  return nullptr;
}

const char* density_of(const Json& pair) {
  return density_name(pair.at("variable").get<std::string>());
}

class PairFigures {
 public:
  PairFigures(const CaseOfRun& baseline, const CaseOfRun& now, const Json& pair, const Json& again,
              const Tolerances& tolerances, std::vector<Figure>& figures)
      : baseline_(baseline),
        now_(now),
        pair_(pair),
        again_(again),
        tolerances_(tolerances),
        figures_(figures) {}

  void add_all() {
    double by_chance = 0;
    for (const char* side : {"a", "b"}) by_chance += chance_of(pair_.at(side).get<std::string>());
    if (by_chance > 0) {
      add("l1", "L1", FigureKind::simulated_l1, 1, by_chance);
      return;
    }
    const double allowed = tolerances_.deterministic;
    const double deviation = reference_deviation();
    add("l1", "L1", FigureKind::distance, 1, allowed);
    add("l2", "L2", FigureKind::distance, 1 / std::sqrt(deviation), allowed);
    add("sup", "sup", FigureKind::distance, 1 / deviation, allowed);
    add("hellinger", "Hellinger", FigureKind::distance, 1, allowed);
    if (pair_.at("kl").is_number() && again_.at("kl").is_number()) {
      add("kl", "KL", FigureKind::distance, 1, allowed);
    }
    add_tail();
  }

 private:
  // L1 by which chance may move the distance to this solution; 0 where none enters.
  double chance_of(const std::string& id) const {
    const Json* was = find_solution(baseline_.summary, id);
    const Json* is = find_solution(now_.summary, id);
    if (was == nullptr || is == nullptr || !is_simulation(*was)) return 0;
    return allowed_l1(*was, *is, pair_.at("variable").get<std::string>(),
                      tolerances_.standard_errors);
  }

  double reference_deviation() const {
    const Json* reference = find_solution(baseline_.summary, pair_.at("b").get<std::string>());
    const char* second = pair_.at("variable") == "ydot" ? "v2" : "y2";
    if (reference == nullptr || !reference->at("moments").is_object()) return 1;
    return std::sqrt(number(reference->at("moments"), second).value_or(1));
  }

  void add(const char* key, const char* symbol, FigureKind kind, double scale, double allowed) {
    push(fmt::format("{} {} to {}", symbol, density_of(pair_), pair_.at("b").get<std::string>()),
         kind, pair_.at(key), again_.at(key), scale, allowed);
  }

  void add_tail() {
    const Json& was = pair_.at("log10_tail");
    const Json& is = again_.at("log10_tail");
    if (was.size() != is.size()) {
      const auto decades = [](const Json& tail) { return fmt::format("{} decades", tail.size()); };
      figures_.push_back(
          {baseline_.summary.at("name").get<std::string>(), pair_.at("a").get<std::string>(),
           fmt::format("tail {} to {}", density_of(pair_), pair_.at("b").get<std::string>()),
           FigureKind::tail, decades(was), decades(is), kInfinity, tolerances_.tail()});
      return;
    }
    for (std::size_t k = 0; k < was.size(); ++k) {
      push(fmt::format("tail {:.0e} {} to {}", was[k].at("from").get<double>(), density_of(pair_),
                       pair_.at("b").get<std::string>()),
           FigureKind::tail, was[k].at("mean_abs"), is[k].at("mean_abs"), 1, tolerances_.tail());
      add_bins(was[k], is[k]);
    }
  }

  // Of which densities, and how many bins: a figure only where they are others.
  void add_bins(const Json& was, const Json& is) {
    for (const char* key : {"from", "to", "bins", "left_out"}) {
      const double a = was.at(key).get<double>(), b = is.at(key).get<double>();
      constexpr double kSame = 1e-9;
      if (std::abs(b - a) <= kSame * std::abs(a)) continue;
      push(fmt::format("tail {:.0e} {} to {}: {}", was.at("from").get<double>(), density_of(pair_),
                       pair_.at("b").get<std::string>(), key),
           FigureKind::tail, was.at(key), is.at(key), 0, tolerances_.tail());
    }
  }

  void push(const std::string& name, FigureKind kind, const Json& was, const Json& is, double scale,
            double allowed) {
    const double a = was.is_null() ? NAN : was.get<double>();
    const double b = is.is_null() ? NAN : is.get<double>();
    const double change = was.is_null() && is.is_null() ? 0 : std::abs(b - a) / scale;
    figures_.push_back({baseline_.summary.at("name").get<std::string>(),
                        pair_.at("a").get<std::string>(), name, kind, was, is, change, allowed});
  }

  const CaseOfRun& baseline_;
  const CaseOfRun& now_;
  const Json& pair_;
  const Json& again_;
  const Tolerances& tolerances_;
  std::vector<Figure>& figures_;
};

}  // namespace

double allowed_l1(const Json& baseline, const Json& now, const std::string& variable,
                  double standard_errors) {
  // Expectation, and what 99 runs of 100 stay below: of the difference of both runs.
  const auto both = [&](const std::string& key) {
    return std::hypot(number(baseline.at("sampling_l1"), key).value_or(NAN),
                      number(now.at("sampling_l1"), key).value_or(NAN));
  };
  constexpr double kQuantile99 = 2.326;  // of the normal law
  const double expected = both(variable);
  const double deviation = (both(variable + "_99") - expected) / kQuantile99;
  const double allowed = expected + standard_errors * std::max(deviation, 0.0);
  return std::isfinite(allowed) ? allowed : 0;
}

std::vector<Figure> distance_figures(const CaseOfRun& baseline, const CaseOfRun& now,
                                     const Tolerances& tolerances) {
  std::vector<Figure> figures;
  const auto missing = [&](const Json& pair, const char* was, const char* is) {
    figures.push_back({baseline.summary.at("name").get<std::string>(),
                       pair.at("a").get<std::string>(),
                       fmt::format("{} to {}", density_of(pair), pair.at("b").get<std::string>()),
                       FigureKind::distance, was, is, kInfinity, tolerances.deterministic});
  };
  for (const Json& pair : baseline.summary.at("comparisons")) {
    const Json* again = find_pair(now.summary, pair);
    if (again == nullptr) {
      missing(pair, "there", "missing");
    } else {
      PairFigures(baseline, now, pair, *again, tolerances, figures).add_all();
    }
  }
  for (const Json& pair : now.summary.at("comparisons")) {
    if (find_pair(baseline.summary, pair) == nullptr) missing(pair, "missing", "there");
  }
  return figures;
}

}  // namespace fpkcheck::compare
