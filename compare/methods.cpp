#include "compare/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string_view>

#include "problem/input_error.hpp"

namespace fpkcheck::compare {
namespace {

constexpr std::string_view kClosurePrefix = "epc-gaussian-n";

// What stands for several methods in a list, in the order of trust.
struct Family {
  std::string_view name;
  std::vector<std::string> ids;
};
const std::vector<Family>& families() {
  static const std::vector<Family> list{
      {"epc", {"epc-gaussian-n2", "epc-gaussian-n4", "epc-gaussian-n6", "epc-gaussian-n8"}},
      {"fd", {"fd-white", "fd-km4", "fd-kf"}},
      {"mcs", {"mcs"}}};
  return list;
}

std::optional<int> order_of_closure(std::string_view id) {
  if (!id.starts_with(kClosurePrefix)) return std::nullopt;
  const std::string_view digits = id.substr(kClosurePrefix.size());
  int order = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), order);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return order;
}

Method method_of(const std::string& id, const mcs::Options& simulation) {
  if (const auto order = order_of_closure(id)) return epc_method({.order = *order});
  for (const auto equation : {fd_fpk::Equation::white, fd_fpk::Equation::km4,
                              fd_fpk::Equation::km4_pade, fd_fpk::Equation::kf}) {
    for (const auto impact : {problem::Impact::map, problem::Impact::delta}) {
      const fd_fpk::Options options{.equation = equation, .impact = impact};
      if (id == fd_fpk::id(options)) return fd_method(options);
    }
  }
  if (id == "mcs") return mcs_method(simulation);
  throw InputError(
      fmt::format("--methods: '{}' is no method (use epc, fd, mcs, or ids such as {}6, fd-kf)", id,
                  kClosurePrefix));
}

// Place in the order of trust: families first, then closures by their order.
std::pair<std::size_t, int> rank(const std::string& id) {
  std::size_t family = 0;
  while (family < families().size() && !id.starts_with(families()[family].name)) ++family;
  if (const auto order = order_of_closure(id)) return {family, *order};
  const auto& ids = families()[family].ids;
  return {family, static_cast<int>(std::ranges::find(ids, id) - ids.begin())};
}

}  // namespace

Method epc_method(const epc::Options& options) {
  epc::validate(options);
  return {
      .id = fmt::format("{}{}", kClosurePrefix, options.order),
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
  return {.id = "mcs",
          .parallel = true,
          .solve = [options](const problem::Problem& problem, const ComparisonAxes& axes,
                             const Fraction& progress) {
            mcs::Options on_axes = options;
            on_axes.y_edges = axes.y_edges;
            on_axes.v_edges = axes.v_edges;
            on_axes.progress = progress;
            auto [solution, summary] = mcs::simulate(problem, on_axes);
            return Entry{std::move(solution), mcs::to_json(options), mcs::to_json(summary)};
          }};
}

std::vector<Method> select_methods(const std::string& list, const mcs::Options& simulation) {
  std::vector<std::string> ids;
  std::istringstream items(list);
  for (std::string item; std::getline(items, item, ',');) {
    const auto family = std::ranges::find(families(), item, &Family::name);
    if (family == families().end()) {
      ids.push_back(item);
    } else {
      ids.insert(ids.end(), family->ids.begin(), family->ids.end());
    }
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
