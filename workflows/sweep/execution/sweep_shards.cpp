#include "workflows/sweep/execution/sweep_shards.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <system_error>

#include "base/input_error.hpp"
#include "base/text/parse_number.hpp"
#include "base/text/printable_text.hpp"
#include "workflows/sweep/result/journal.hpp"
#include "workflows/sweep/result/sweep_json.hpp"

namespace fpkcheck::sweep {
namespace {

namespace fs = std::filesystem;
using base::to_printable_text;
using results::Json;

std::optional<SweepShard> parse_shard_numbers(std::string_view text, std::string_view separator) {
  const auto at = text.find(separator);
  if (at == std::string_view::npos) return std::nullopt;
  const auto number = base::parse_number<std::size_t>(text.substr(0, at)),
             of = base::parse_number<std::size_t>(text.substr(at + separator.size()));
  if (!number || !of || *number < 1 || *number > *of) return std::nullopt;
  return SweepShard{*number, *of};
}

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
                    to_printable_text(directory.string())));
  }
  std::ranges::sort(found);
  return found;
}

Json parse_plan_json(const SweepJournalContent& content, const fs::path& file) {
  std::istringstream text(content.plan);
  return results::parse_json(text, to_printable_text(file.string()));
}

SweepPlan plan_from_journal(const Json& json, const fs::path& file,
                            const methods::SolverRegistry& registry) {
  try {
    return sweep_plan_from_json(json, registry);
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: not the plan of a sweep ({})",
                                 to_printable_text(file.string()),
                                 results::json_error_message(error)));
  }
}

// Returns the text of the shards that contain the given sweep points, e.g. "1/3 (2 points), 2/3 (1
// point)".
std::string shards_of_points_text(const std::vector<std::size_t>& points, std::size_t of) {
  // Largest number of shards that a line of text on missing points names. Later runs name the
  // remaining shards.
  constexpr std::size_t kMaxNamedShards = 8;
  std::map<std::size_t, std::size_t> counts;
  for (const std::size_t p : points) ++counts[SweepShard::shard_containing_point(p, of).number];
  std::vector<std::string> named;
  for (const auto& [number, count] : counts) {
    if (named.size() == kMaxNamedShards) break;
    named.push_back(fmt::format("{}/{} ({} point{})", number, of, count, count == 1 ? "" : "s"));
  }
  const std::size_t others = counts.size() - named.size();
  return fmt::format("{}{}", fmt::join(named, ", "),
                     others > 0 ? fmt::format(" and {} more", others) : "");
}

// @param of number of shards into which the sweep was divided
std::string missing_points_text(const std::set<std::size_t>& there, std::size_t total,
                                std::size_t of) {
  std::vector<std::size_t> missing;
  for (std::size_t p = 0; p < total; ++p) {
    if (!there.contains(p)) missing.push_back(p);
  }
  const std::string again = of > 1 ? "run again with --shard " + shards_of_points_text(missing, of)
                                   : "run the sweep again";
  return fmt::format("{} of {} points are missing; {}", missing.size(), total, again);
}

}  // namespace

std::vector<std::size_t> SweepShard::shard_point_numbers(std::size_t total_points) const {
  std::vector<std::size_t> own_points;
  for (std::size_t p = number - 1; p < total_points; p += of) own_points.push_back(p);
  return own_points;
}

std::string SweepShard::shard_journal_name() const {
  return of == 1 ? "journal" : fmt::format("journal.{}-of-{}", number, of);
}

std::optional<SweepShard> shard_of_journal(std::string_view name) {
  if (name == "journal") return SweepShard{};
  constexpr std::string_view kBefore = "journal.";
  if (!name.starts_with(kBefore)) return std::nullopt;
  return parse_shard_numbers(name.substr(kBefore.size()), "-of-");
}

SweepShard parse_shard(std::string_view text) {
  if (const auto shard = parse_shard_numbers(text, "/")) return *shard;
  throw InputError(fmt::format("--shard {} (must be i/N with 1 <= i <= N)", base::in_quotes(text)));
}

MergedSweep merge_sweep_journals(const std::vector<fs::path>& directories,
                                 const methods::SolverRegistry& registry) {
  std::optional<Json> plan;
  fs::path of_plan;
  std::vector<SweepPointResult> points;
  std::set<std::size_t> seen;
  // If the numbers of shards differ between journals, the missing points are named for the largest
  // number of shards, with which the fewest points are solved twice.
  std::size_t damaged = 0, of = 1;
  for (const auto& directory : directories) {
    for (const auto& file : journals_in(directory)) {
      auto content = read_sweep_journal(file);
      if (const auto shard = shard_of_journal(file.filename().string())) {
        of = std::max(of, shard->of);
      }
      const Json json = parse_plan_json(content, file);
      if (!plan) {
        plan = json;
        of_plan = file;
      }
      const std::string difference = first_sweep_plan_difference(*plan, json);
      if (!difference.empty()) {
        throw InputError(fmt::format("{} and {} belong to different plans: {}",
                                     to_printable_text(of_plan.string()),
                                     to_printable_text(file.string()), difference));
      }
      damaged += content.damaged;
      for (auto& point : content.points) {
        if (seen.insert(point.point).second) points.push_back(std::move(point));
      }
    }
  }
  MergedSweep result{
      make_sweep_results(plan_from_journal(*plan, of_plan, registry), std::move(points))};
  const auto& [whole, there] = result.results;
  for (const auto& point : there) {
    if (point.point < whole.points.size() && point.methods.size() == whole.methods.size()) continue;
    throw InputError(fmt::format("{}: point {} is not in its plan (remove the file)",
                                 to_printable_text(of_plan.string()), point.point));
  }
  if (!result.results.is_complete()) {
    result.remarks.push_back(missing_points_text(seen, whole.points.size(), of));
  }
  if (damaged > 0) {
    result.remarks.push_back(fmt::format("{} damaged lines of journals were ignored", damaged));
  }
  return result;
}

}  // namespace fpkcheck::sweep
