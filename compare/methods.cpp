#include "compare/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string_view>
#include <tuple>

#include "problem/input_error.hpp"

namespace fpkcheck::compare {
namespace {

// What stands for several methods in a list, in the order of trust.
struct Family {
  std::string_view name;
  std::vector<std::string> ids;
};
const std::vector<Family>& families() {
  static const std::vector<Family> list{
      {"epc-gaussian",
       {"epc-gaussian-n2", "epc-gaussian-n4", "epc-gaussian-n6", "epc-gaussian-n8"}},
      {"epc-moment", {"epc-moment-n4", "epc-moment-n8", "epc-moment-n12"}},
      {"epc-polar", {"epc-polar-n4", "epc-polar-n6", "epc-polar-n8"}},
      {"fd", {"fd-white", "fd-km4-delta", "fd-km4", "fd-kf"}},
      {"mcs", {"mcs"}}};
  return list;
}

// The number behind "-n" at the end of an id, and what stands before them.
struct Ordered {
  std::string stem;
  int order;
};
std::optional<Ordered> split(std::string_view id) {
  const auto mark = id.rfind("-n");
  if (mark == std::string_view::npos) return std::nullopt;
  const std::string_view digits = id.substr(mark + 2);
  int order = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), order);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return Ordered{std::string(id.substr(0, mark)), order};
}

std::optional<epc::Options> closure_of(std::string_view id) {
  const auto ordered = split(id);
  if (!ordered) return std::nullopt;
  const std::string plain = fmt::format("{}-n{}", ordered->stem, ordered->order);
  for (const auto formulation :
       {epc::Formulation::gaussian, epc::Formulation::moment, epc::Formulation::polar}) {
    for (const auto equation : {epc::Equation::km4, epc::Equation::kf, epc::Equation::white}) {
      for (const auto tail : {epc::moment::Tail::confined, epc::moment::Tail::cut}) {
        const epc::Options options{.order = ordered->order,
                                   .formulation = formulation,
                                   .equation = equation,
                                   .tail = tail};
        if (plain == epc::id(options)) return options;
      }
    }
  }
  return std::nullopt;
}

Method method_of(const std::string& id, const mcs::Options& simulation) {
  if (const auto closure = closure_of(id)) return epc_method(*closure);
  for (const auto equation : {fd_fpk::Equation::white, fd_fpk::Equation::km4,
                              fd_fpk::Equation::km4_pade, fd_fpk::Equation::kf}) {
    for (const auto impact : {problem::Impact::map, problem::Impact::delta}) {
      // The error budget (budget/budget.hpp) sets each difference beside what it is known to.
      const fd_fpk::Options options{.equation = equation, .impact = impact, .error_estimate = true};
      if (id == fd_fpk::id(options)) return fd_method(options);
    }
  }
  for (const auto equation : {mcs::Equation::kf, mcs::Equation::white}) {
    mcs::Options options = simulation;
    options.equation = equation;
    if (id == mcs::id(options)) return mcs_method(options);
  }
  throw InputError(
      fmt::format("--methods: '{}' is no method (use epc, fd, mcs, or ids such as epc-gaussian-n6, "
                  "epc-moment-n8, fd-kf)",
                  id));
}

// Place in the order of trust: families first, then closures by their order, then by name.
std::tuple<std::size_t, int, std::string> rank(const std::string& id) {
  std::size_t family = 0;
  while (family < families().size() && !id.starts_with(families()[family].name)) ++family;
  if (const auto ordered = split(id)) return {family, ordered->order, id};
  const auto& ids = families()[family].ids;
  return {family, static_cast<int>(std::ranges::find(ids, id) - ids.begin()), id};
}

}  // namespace

Method epc_method(const epc::Options& options) {
  epc::validate(options);
  return {
      .id = epc::id(options),
      .solve = [options](const problem::Problem& problem, const ComparisonAxes&, const Fraction&) {
        auto [solution, summary] = epc::solve(problem, options);
        return Entry{std::move(solution), epc::to_json(options), epc::to_json(summary)};
      }};
}

Method fd_method(const fd_fpk::Options& options) {
  fd_fpk::validate(options);
  return {
      .id = fd_fpk::id(options),
      .solve = [options](const problem::Problem& problem, const ComparisonAxes&, const Fraction&) {
        auto [solution, summary] = fd_fpk::solve(problem, options);
        return Entry{std::move(solution), fd_fpk::to_json(options), fd_fpk::to_json(summary)};
      }};
}

Method mcs_method(const mcs::Options& options) {
  mcs::validate(options);
  return {.id = mcs::id(options),
          .parallel = true,
          .solve = [options](const problem::Problem& problem, const ComparisonAxes& axes,
                             const Fraction& progress) {
            mcs::Options on_axes = options;
            on_axes.y_edges = axes.y_edges;
            on_axes.v_edges = axes.v_edges;
            on_axes.progress = [&](const mcs::Progress& at) {
              if (progress) progress(at.fraction, fmt::format("error {:.1e}", at.error));
            };
            auto [solution, summary] = mcs::simulate(problem, on_axes);
            return Entry{std::move(solution), mcs::to_json(options), mcs::to_json(summary)};
          }};
}

std::optional<Method> saved_method(const nlohmann::ordered_json& solution, int threads) {
  const auto made_by = solution.at("method").get<std::string>();
  const auto& options = solution.at("options");
  if (made_by == "file") return std::nullopt;
  Method method;
  if (made_by == "epc") {
    method = epc_method(epc::options_from_json(options));
  } else if (made_by == "fd") {
    method = fd_method(fd_fpk::options_from_json(options));
  } else if (made_by == "mcs") {
    mcs::Options simulation = mcs::options_from_json(options);
    simulation.threads = threads;
    method = mcs_method(simulation);
  } else {
    throw InputError(fmt::format("method '{}' (must be epc, fd, mcs or file)", made_by));
  }
  const auto id = solution.at("id").get<std::string>();
  if (method.id != id) {
    throw InputError(fmt::format("its options are those of {} (run again)", method.id));
  }
  return method;
}

std::vector<Method> select_methods(const std::string& list, const mcs::Options& simulation) {
  std::vector<std::string> ids;
  std::istringstream items(list);
  for (std::string item; std::getline(items, item, ',');) {
    const std::size_t before = ids.size();
    for (const auto& [name, members] : families()) {
      if (name == item || name.starts_with(item + '-')) {  // epc: all its formulations
        ids.insert(ids.end(), members.begin(), members.end());
      }
    }
    if (ids.size() == before) ids.push_back(item);
  }
  if (ids.empty()) {
    throw InputError("--methods: the list is empty (use epc, fd, mcs, or ids separated by commas)");
  }
  std::map<std::string, Method> methods;
  for (const auto& id : ids) {
    Method method = method_of(id, simulation);
    methods.emplace(method.id, std::move(method));
  }
  std::vector<Method> ordered;
  for (auto& [id, method] : methods) ordered.push_back(std::move(method));
  std::ranges::stable_sort(ordered, {}, [](const Method& m) { return rank(m.id); });
  return ordered;
}

}  // namespace fpkcheck::compare
