#include "compare/study/grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compare/methods.hpp"
#include "compare/study/richardson.hpp"
#include "compare/summary.hpp"
#include "compare/summary_view.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;
using transform::Variable;

// The box ends where the density is this small relative to its peak, so that what lies beyond does
// not limit the convergence.
constexpr double kWallDensity = 1e-9;

/// A grid's solution, as the study needs it.
struct Level {
  double refinement = 1;
  Entry entry;
  std::optional<Marginals> marginals;  ///< where it has a density
};

double seconds(const Entry& entry) { return entry.solution.seconds; }

/// The problem with what every solve of the study shares.
class Study {
 public:
  Study(const problem::Problem& problem, const GridStudyOptions& options,
        const std::vector<Method>& others, const ProgressListener& listener)
      : problem_(problem),
        axes_(comparison_axes(problem)),
        options_(options),
        listener_(listener),
        total_(options.orders.size() * static_cast<std::size_t>(options.levels) + others.size()) {}

  std::vector<Level> grids_of_order(int order) {
    std::vector<Level> levels;
    for (int k = 0; k < options_.levels; ++k) {
      Level level{.refinement = options_.coarsest * std::pow(kGridLevelRatio, k),
                  .entry = {},
                  .marginals = {}};
      level.entry = solve(fd_method({.equation = options_.equation,
                                     .impact = options_.impact,
                                     .stepper = fd_fpk::Stepper::direct,
                                     .order = order,
                                     .refinement = level.refinement,
                                     .origin_refinement = options_.origin_refinement,
                                     .x1_max = y_max_,
                                     .x2_max = v_max_,
                                     .wall_density = kWallDensity,
                                     .refine_unresolved = false}),
                          fmt::format("order {}, level {}", order, k + 1));
      if (level.entry.solution.density) {
        // All levels share a box: where it ends is no part of the convergence.
        y_max_ = number(level.entry.details, "x1_max");
        v_max_ = number(level.entry.details, "x2_max");
        level.marginals = marginals_of(level.entry);
      }
      levels.push_back(std::move(level));
    }
    return levels;
  }

  Entry solve(const Method& method, const std::string& shown) {
    const auto tell = [&](double fraction, const std::string& note) {
      if (!listener_) return;
      listener_({.done = done_,
                 .total = total_,
                 .case_name = problem_.name,
                 .method = shown,
                 .fraction = fraction,
                 .note = note});
    };
    tell(0, "");
    Entry entry = method.solve(problem_, axes_, tell);
    ++done_;
    return entry;
  }

  Marginals marginals_of(const Entry& entry) const {
    return {transform::marginal(entry.solution, Variable::y, axes_.y_edges),
            transform::marginal(entry.solution, Variable::ydot, axes_.v_edges),
            entry.solution.moments};
  }

 private:
  const problem::Problem& problem_;
  ComparisonAxes axes_;
  const GridStudyOptions& options_;
  const ProgressListener& listener_;
  std::size_t done_ = 0, total_;
  std::optional<double> y_max_{}, v_max_{};
};

/// The grids of one order, and what they tend to.
struct OrderOfScheme {
  int order;
  std::vector<Level> levels;
  std::optional<RichardsonLimit> limit = {};  ///< of the last three levels
  std::string no_limit = {};                  ///< why there is none
};

// Only where the finest density is ok, and where they converge: else the extrapolation leads away.
void find_limit(OrderOfScheme& scheme) {
  const auto count = scheme.levels.size();
  for (std::size_t k = count - 3; k < count; ++k) {
    const auto& solution = scheme.levels[k].entry.solution;
    const bool finest = k + 1 == count;
    if (!scheme.levels[k].marginals || (finest && solution.status != transform::Status::ok)) {
      scheme.no_limit = fmt::format("one of the three finest grids is {} ({})",
                                    transform::name(solution.status), solution.reason);
      return;
    }
  }
  for (std::size_t k = count - 2; k < count; ++k) {
    const Json &before = scheme.levels[k - 1].entry.details, &here = scheme.levels[k].entry.details;
    if (before.at("nx") == here.at("nx") && before.at("nv") == here.at("nv")) {
      scheme.no_limit = fmt::format(
          "two of the three finest levels have the same {} x {} cells, the "
          "fewest there are (begin with a larger --coarsest)",
          here.at("nx").get<int>(), here.at("nv").get<int>());
      return;
    }
  }
  const Marginals &coarse = *scheme.levels[count - 3].marginals,
                  &middle = *scheme.levels[count - 2].marginals,
                  &fine = *scheme.levels[count - 1].marginals;
  const double observed = observed_orders(coarse, middle, fine, kGridLevelRatio).l1;
  if (!(observed >= kLeastOrderOfALimit)) {
    scheme.no_limit = fmt::format(
        "the differences fall at order {:.2g} only, and the limit takes {} (refine the origin, or "
        "take finer levels)",
        observed, kLeastOrderOfALimit);
    return;
  }
  scheme.limit = richardson_limit(coarse, middle, fine, kGridLevelRatio, scheme.order);
}

Json l1_of(const std::optional<Marginals>& marginals, const std::optional<Marginals>& truth) {
  if (!marginals || !truth) return {{"l1_y", nullptr}, {"l1_ydot", nullptr}};
  return {{"l1_y", distances(marginals->y, truth->y).l1},
          {"l1_ydot", distances(marginals->ydot, truth->ydot).l1}};
}

Json row_of(const OrderOfScheme& scheme, std::size_t k, const std::optional<Marginals>& truth) {
  const Level& level = scheme.levels[k];
  const auto& solution = level.entry.solution;
  Json row{{"order", scheme.order},
           {"level", k + 1},
           {"refinement", level.refinement},
           {"nx", level.entry.details.at("nx")},
           {"nv", level.entry.details.at("nv")},
           {"origin_refinement", level.entry.details.at("origin_refinement")},
           {"status", transform::name(solution.status)},
           {"reason", solution.reason},
           {"seconds", seconds(level.entry)}};
  row.update(l1_of(level.marginals, truth));
  Json observed{{"l1", nullptr}, {"y2", nullptr}, {"v2", nullptr}};
  if (k >= 2 && level.marginals && scheme.levels[k - 1].marginals &&
      scheme.levels[k - 2].marginals) {
    const auto orders =
        observed_orders(*scheme.levels[k - 2].marginals, *scheme.levels[k - 1].marginals,
                        *level.marginals, kGridLevelRatio);
    observed = {{"l1", orders.l1}, {"y2", orders.y2}, {"v2", orders.v2}};
  }
  row["observed_order"] = observed;
  row["y2"] = level.marginals ? Json(solution.moments.y2) : Json();
  row["v2"] = level.marginals ? Json(solution.moments.v2) : Json();
  return row;
}

Json limit_json(const OrderOfScheme& scheme, const std::optional<Marginals>& truth) {
  Json json{{"order", scheme.order}};
  json.update(l1_of(scheme.limit ? std::optional(scheme.limit->value) : std::nullopt, truth));
  for (const auto& [name, moment] : kRichardsonMoments) {
    json[name] = scheme.limit ? Json(scheme.limit->value.moments.*moment) : Json();
    json[fmt::format("{}_error", name)] = scheme.limit ? Json(scheme.limit->error.*moment) : Json();
  }
  return json;
}

// The closures and the simulation that solve the equation of the grids, or, for the full jump
// equation, claim to.
std::vector<Method> other_methods(const GridStudyOptions& options) {
  std::string list;
  const auto add = [&](const char* pattern, std::initializer_list<int> orders) {
    for (const int n : orders) list += fmt::format(fmt::runtime(pattern), n) + ',';
  };
  const bool map = options.impact == problem::Impact::map;
  using fd_fpk::Equation;
  if (options.equation == Equation::kf && map) {
    add("epc-gaussian-n{}", {2, 4, 6});
    add("epc-moment-n{}", {2, 4, 6, 8, 10, 12});
    add("epc-polar-n{}", {2, 4, 6, 8, 10, 12});
    list += "mcs";
  } else if (options.equation == Equation::km4 && !map) {
    add("epc-gaussian-n{}", {2, 4, 6});
  } else if (options.equation == Equation::white && map) {
    add("epc-moment-white-n{}", {2, 4, 6, 8, 10, 12});
    list += "mcs-white";
  } else if (options.equation == Equation::white) {
    add("epc-gaussian-white-n{}", {2, 4, 6});
  } else if (options.equation == Equation::kf) {
    add("epc-gaussian-kf-n{}", {2, 4, 6});
  }
  return list.empty() ? std::vector<Method>{} : select_methods(list, options.simulation);
}

// With its variant: "moment-white" of "epc-moment-white-n4"; null where it is no closure.
Json formulation_of(const std::string& id) {
  constexpr std::string_view kPrefix = "epc-";
  if (!id.starts_with(kPrefix)) return nullptr;
  return id.substr(kPrefix.size(), id.rfind("-n") - kPrefix.size());
}

Json other_row(const Entry& entry, const std::optional<Marginals>& own,
               const std::optional<Marginals>& truth) {
  const auto& solution = entry.solution;
  Json row{{"id", solution.id},
           {"method", solution.method},
           {"formulation", formulation_of(solution.id)},
           {"order", entry.details.value("order", Json())},
           {"status", transform::name(solution.status)},
           {"reason", solution.reason},
           {"seconds", seconds(entry)}};
  row.update(l1_of(own, truth));
  row["sampling_l1"] = entry.details.value("sampling_l1", Json());
  return row;
}

// How far the truth is known: the distance of the limits at the two highest orders.
Json known_to(const std::vector<OrderOfScheme>& schemes, const std::optional<Marginals>& truth) {
  if (schemes.size() < 2 || !truth || !schemes[schemes.size() - 2].limit) {
    return {{"y", nullptr}, {"ydot", nullptr}};
  }
  const auto& other = schemes[schemes.size() - 2].limit->value;
  return {{"y", distances(other.y, truth->y).l1}, {"ydot", distances(other.ydot, truth->ydot).l1}};
}

}  // namespace

void validate(const GridStudyOptions& options) {
  constexpr int kFewest = 3, kMost = 9;
  if (options.levels < kFewest || options.levels > kMost) {
    throw InputError(
        fmt::format("--levels {} (an observed order takes 3, and 9 are {} times the coarsest "
                    "cells; use 3 .. 9)",
                    options.levels, 256));
  }
  if (options.orders.empty()) {
    throw InputError("--orders: the list is empty (use some of 2 .. 8)");
  }
  for (const int order : options.orders) {
    fd_fpk::validate({.equation = options.equation, .impact = options.impact, .order = order});
  }
  fd_fpk::validate(
      {.refinement = options.coarsest, .origin_refinement = options.origin_refinement});
}

Json study_grid(const std::string& command, const problem::Problem& problem,
                const GridStudyOptions& options, const ProgressListener& listener) {
  validate(options);
  const auto others = other_methods(options);
  Study study(problem, options, others, listener);
  std::vector<int> orders = options.orders;
  std::ranges::sort(orders);
  orders.erase(std::unique(orders.begin(), orders.end()), orders.end());

  std::vector<OrderOfScheme> schemes;
  for (const int order : orders) {
    schemes.push_back({.order = order, .levels = study.grids_of_order(order)});
    find_limit(schemes.back());
  }
  std::optional<Marginals> truth;
  if (schemes.back().limit) truth = schemes.back().limit->value;

  Json rows = Json::array(), limits = Json::array(), other_rows = Json::array();
  for (const auto& scheme : schemes) {
    for (std::size_t k = 0; k < scheme.levels.size(); ++k) {
      rows.push_back(row_of(scheme, k, truth));
    }
    limits.push_back(limit_json(scheme, truth));
  }
  for (const auto& method : others) {
    if (!truth) break;  // nothing to measure them by
    const Entry entry = study.solve(method, method.id);
    std::optional<Marginals> own;
    if (entry.solution.density) own = study.marginals_of(entry);
    other_rows.push_back(other_row(entry, own, truth));
  }
  const Json of_case = case_json(problem);
  return with_null_for_non_finite({{"schema", kSummarySchema},
                                   {"program", program_json(command)},
                                   {"study", "grid"},
                                   {"name", of_case.at("name")},
                                   {"system", of_case.at("system")},
                                   {"impulse", of_case.at("impulse")},
                                   {"equation", fd_fpk::name(options.equation)},
                                   {"impact", problem::name(options.impact)},
                                   {"ratio", kGridLevelRatio},
                                   {"truth",
                                    {{"order", truth ? Json(schemes.back().order) : Json()},
                                     {"reason", schemes.back().no_limit},
                                     {"known_to", known_to(schemes, truth)}}},
                                   {"limits", limits},
                                   {"rows", rows},
                                   {"others", other_rows}});
}

std::string grid_csv(const Json& report) {
  std::string text = "id,order,level,nx,nv,status,l1_y,l1_ydot,observed_order,seconds\n";
  const auto cell = [](const Json& object, const char* key) {
    return object.contains(key) && !object.at(key).is_null() ? object.at(key).dump()
                                                             : std::string();
  };
  const auto line = [&](const std::string& id, const Json& row, const std::string& observed) {
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{}\n", id, cell(row, "order"), cell(row, "level"),
                    cell(row, "nx"), cell(row, "nv"), row.at("status").get<std::string>(),
                    cell(row, "l1_y"), cell(row, "l1_ydot"), observed, cell(row, "seconds"));
  };
  for (const auto& row : report.at("rows")) {
    line(fmt::format("fd-{}", report.at("equation").get<std::string>()), row,
         cell(row.at("observed_order"), "l1"));
  }
  for (const auto& row : report.at("others")) line(row.at("id").get<std::string>(), row, "");
  return text;
}

}  // namespace fpkcheck::compare
