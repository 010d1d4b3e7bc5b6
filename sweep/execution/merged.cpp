#include "sweep/execution/merged.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>
#include <system_error>

#include "parameters/input_error.hpp"
#include "parameters/shown.hpp"
#include "sweep/plan/plan_json.hpp"
#include "sweep/result/journal.hpp"

namespace fpkcheck::sweep {
namespace {

namespace fs = std::filesystem;
using parameters::shown;
using results::Json;

bool is_journal(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  return name == "journal" || name.starts_with("journal.");
}

std::vector<fs::path> journals_in(const fs::path& directory) {
  std::error_code error;
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(directory, error)) {
    if (is_journal(entry)) found.push_back(entry.path());
  }
  if (found.empty()) {
    throw InputError(
        fmt::format("{} has no journal of a sweep (name a directory that a sweep wrote "
                    "into)",
                    shown(directory.string())));
  }
  std::ranges::sort(found);
  return found;
}

Json plan_json_of(const JournalContent& content, const fs::path& file) {
  std::istringstream text(content.plan);
  return results::parsed(text, shown(file.string()));
}

Plan plan_of_journal(const Json& json, const fs::path& file, const methods::Registry& registry) {
  try {
    return plan_in(json, registry);
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: not the plan of a sweep ({})", shown(file.string()),
                                 results::said_by(error)));
  }
}

}  // namespace

Merged merged(const std::vector<fs::path>& directories, const methods::Registry& registry) {
  std::optional<Json> plan;
  fs::path of_plan;
  std::vector<PointResult> points;
  std::set<std::size_t> seen;
  std::size_t damaged = 0;
  for (const auto& directory : directories) {
    for (const auto& file : journals_in(directory)) {
      auto content = read_journal(file);
      const Json json = plan_json_of(content, file);
      if (!plan) {
        plan = json;
        of_plan = file;
      }
      const std::string difference = difference_of(*plan, json);
      if (!difference.empty()) {
        throw InputError(fmt::format("{} and {} are of different plans ({})",
                                     shown(of_plan.string()), shown(file.string()), difference));
      }
      damaged += content.damaged;
      for (auto& point : content.points) {
        if (seen.insert(point.point).second) points.push_back(std::move(point));
      }
    }
  }
  Merged result{sweep_results(plan_of_journal(*plan, of_plan, registry), std::move(points))};
  const auto& [whole, there] = result.results;
  for (const auto& point : there) {
    if (point.point < whole.points.size() && point.methods.size() == whole.methods.size()) continue;
    throw InputError(fmt::format("{}: point {} is none of its plan (remove the file)",
                                 shown(of_plan.string()), point.point));
  }
  if (!result.results.is_whole()) {
    std::size_t first = 0;
    while (seen.contains(first)) ++first;
    result.remarks.push_back(
        fmt::format("{} of {} points are missing, the first is number {} (start its shard again)",
                    whole.points.size() - there.size(), whole.points.size(), first));
  }
  if (damaged > 0) {
    result.remarks.push_back(fmt::format("{} damaged lines of journals were left out", damaged));
  }
  return result;
}

}  // namespace fpkcheck::sweep
