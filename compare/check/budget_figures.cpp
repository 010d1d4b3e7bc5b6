#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/check/figures.hpp"
#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// By what factor a tail, or its number of bins, may differ between two simulations: the simulation
// picks the bins. docs/checking.md has the measurement.
constexpr double kOtherBins = 5;

const Json& budget_of(const Json& summary_case) {
  static const Json kNone = Json::array();
  const auto budget = summary_case.find("budget");
  return budget != summary_case.end() && budget->is_array() ? *budget : kNone;
}

const Json* find_row(const Json& summary_case, const Json& row) {
  for (const Json& other : budget_of(summary_case)) {
    if (other.at("solution") == row.at("solution") && other.at("variable") == row.at("variable")) {
      return &other;
    }
  }
  return nullptr;
}

std::string row_name(const Json& row) {
  return fmt::format("budget {}", density_name(row.at("variable").get<std::string>()));
}

// The chain of models in words.
std::string chain(const Json& row) {
  std::string text = row.at("reference").get<std::string>() + ":";
  for (const Json& part : row.at("parts")) {
    text += fmt::format(" {} ({} to {})", part.at("name").get<std::string>(),
                        part.at("from").get<std::string>(), part.at("to").get<std::string>());
  }
  return text;
}

class RowFigures {
 public:
  RowFigures(const CaseOfRun& baseline, const CaseOfRun& now, const Json& was, const Json& is,
             const Tolerances& tolerances, std::vector<Figure>& figures)
      : baseline_(baseline),
        now_(now),
        was_(was),
        is_(is),
        tolerances_(tolerances),
        figures_(figures),
        simulation_(find_solution(baseline.summary, was.at("reference").get<std::string>())),
        again_(find_solution(now.summary, was.at("reference").get<std::string>())) {
    if (simulation_ == nullptr || again_ == nullptr || !is_simulation(*simulation_) ||
        is_the_same_simulation()) {
      simulation_ = again_ = nullptr;
    }
  }

  void add_all() {
    const std::string before = chain(was_), after = chain(is_);
    push("chain", FigureKind::status, before, after, before == after ? 0 : kInfinity, 0);
    if (before != after) return;
    const std::string end = was_.at("reference").get<std::string>();
    add_l1("total", was_.at("total"), is_.at("total"), true);
    const Json &bins = was_.at("tail"), &bins_again = is_.at("tail");
    add_tail("tail of total", was_.at("total_tail"), is_.at("total_tail"));
    for (const char* key : {"from", "to"}) {
      add_number(fmt::format("tail {}", key), FigureKind::budget, bins.at(key), bins_again.at(key),
                 tolerances_.deterministic);
    }
    add_tail("bins of tail", bins.at("bins"), bins_again.at("bins"));
    for (std::size_t k = 0; k < was_.at("parts").size(); ++k) {
      const Json &part = was_.at("parts")[k], &part_again = is_.at("parts")[k];
      const auto name = part.at("name").get<std::string>();
      add_l1(name, part.at("l1"), part_again.at("l1"), part.at("to") == end);
      add_tail("tail of " + name, part.at("tail"), part_again.at("tail"));
      add_errors(name, part, part_again);
    }
  }

 private:
  // The same seed on the same machine: then chance does not enter.
  bool is_the_same_simulation() const {
    return simulation_->at("moments") == again_->at("moments") &&
           simulation_->at("standard_errors") == again_->at("standard_errors");
  }

  bool by_chance() const { return simulation_ != nullptr; }

  void push(const std::string& name, FigureKind kind, const Json& was, const Json& is,
            double change, double allowed) {
    figures_.push_back({baseline_.summary.at("name").get<std::string>(),
                        was_.at("solution").get<std::string>(), row_name(was_) + ' ' + name, kind,
                        was, is, std::isnan(change) ? kInfinity : change, allowed});
  }

  void add_number(const std::string& name, FigureKind kind, const Json& was, const Json& is,
                  double allowed) {
    const bool both = was.is_number() && is.is_number();
    const double difference = both ? std::abs(is.get<double>() - was.get<double>()) : kInfinity;
    push(name, kind, was, is, was == is ? 0 : difference, allowed);
  }

  void add_l1(const std::string& name, const Json& was, const Json& is, bool to_reference) {
    if (by_chance() && to_reference) {
      add_number(name, FigureKind::simulated_l1, was, is,
                 allowed_l1(*simulation_, *again_, was_.at("variable").get<std::string>(),
                            tolerances_.standard_errors));
    } else {
      add_number(name, FigureKind::budget, was, is, tolerances_.deterministic);
    }
  }

  void add_tail(const std::string& name, const Json& was, const Json& is) {
    if (by_chance()) {
      push(name, FigureKind::simulated_error, was, is, change_of_yardstick(was, is),
           kOtherBins - 1);
    } else {
      add_number(name, FigureKind::budget, was, is, tolerances_.tail());
    }
  }

  void add_errors(const std::string& name, const Json& was, const Json& is) {
    for (const char* key : {"uncertainty", "expected", "in_99"}) {
      const Json a = was.value(key, Json()), b = is.value(key, Json());
      if (by_chance() && std::string(key) != "uncertainty") {
        const double streams = number(*simulation_, "streams").value_or(1);
        push(fmt::format("{} {}", key, name), FigureKind::simulated_error, a, b,
             change_of_yardstick(a, b), allowed_of_yardstick(streams, 2, 1, tolerances_));
      } else {
        add_number(fmt::format("{} {}", key, name), FigureKind::budget, a, b,
                   tolerances_.deterministic);
      }
    }
  }

  const CaseOfRun& baseline_;
  const CaseOfRun& now_;
  const Json& was_;
  const Json& is_;
  const Tolerances& tolerances_;
  std::vector<Figure>& figures_;
  const Json* simulation_;  ///< at the end of the chain, where chance may have moved it; or null
  const Json* again_;
};

}  // namespace

std::vector<Figure> budget_figures(const CaseOfRun& baseline, const CaseOfRun& now,
                                   const Tolerances& tolerances) {
  std::vector<Figure> figures;
  const auto missing = [&](const Json& row, const char* was, const char* is) {
    figures.push_back({baseline.summary.at("name").get<std::string>(),
                       row.at("solution").get<std::string>(), row_name(row), FigureKind::budget,
                       was, is, kInfinity, tolerances.deterministic});
  };
  for (const Json& row : budget_of(baseline.summary)) {
    const Json* again = find_row(now.summary, row);
    if (again == nullptr) {
      missing(row, "there", "missing");
    } else {
      RowFigures(baseline, now, row, *again, tolerances, figures).add_all();
    }
  }
  for (const Json& row : budget_of(now.summary)) {
    if (find_row(baseline.summary, row) == nullptr) missing(row, "missing", "there");
  }
  return figures;
}

}  // namespace fpkcheck::compare
