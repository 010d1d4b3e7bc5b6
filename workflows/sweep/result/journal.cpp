#include "workflows/sweep/result/journal.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>

#include "base/files/input_file.hpp"
#include "base/input_error.hpp"
#include "base/process/files_in_hand.hpp"
#include "base/text/shown.hpp"
#include "results/crc32.hpp"
#include "workflows/sweep/plan/plan_json.hpp"
#include "workflows/sweep/result/point_json.hpp"

namespace fpkcheck::sweep {
namespace {

using base::shown;
using results::Json;

constexpr int kJournalSchema = 1;
constexpr std::size_t kChecksum = 8;  // its digits
constexpr std::size_t kMostBytes = std::size_t{4} << 30;

std::string checked(const std::string& text) { return results::crc32(text) + ' ' + text; }

// The text after a checksum that is its own.
std::optional<std::string> unchecked(const std::string& line) {
  if (line.size() <= kChecksum + 1 || line[kChecksum] != ' ') return std::nullopt;
  std::string text = line.substr(kChecksum + 1);
  if (results::crc32(text) != std::string_view(line).substr(0, kChecksum)) return std::nullopt;
  return text;
}

Json json_of(const std::string& text, const std::string& where) {
  std::istringstream in(text);
  return results::parsed(in, where);
}

Json header(const Json& plan) {
  return {{"schema", kJournalSchema},
          {"program", {{"name", "fpkcheck"}, {"version", results::this_program("").version}}},
          {"plan", plan}};
}

// The plan of a first line.
Json plan_of(const std::string& line, const std::filesystem::path& file) {
  const auto text = unchecked(line);
  const std::string name = shown(file.string());
  if (!text) {
    throw InputError(fmt::format(
        "{} is no journal of a sweep, or damaged in its first line (remove it, or use another "
        "directory)",
        name));
  }
  const Json json = json_of(*text, name);
  const Json expected = header({});
  for (const char* part : {"schema", "program"}) {
    if (json.contains(part) && json.at(part).dump() == expected.at(part).dump()) continue;
    throw InputError(fmt::format(
        "{} was begun by another version of the program (finish it with that one, or use another "
        "directory): {} is {}, here {}",
        name, part, json.contains(part) ? shown(json.at(part).dump()) : "missing",
        expected.at(part).dump()));
  }
  if (!json.contains("plan")) throw InputError(fmt::format("{}: no plan (remove it)", name));
  return json.at("plan");
}

void require_same(const Json& before, const Json& now, const std::filesystem::path& file) {
  const std::string difference = difference_of(before, now);
  if (difference.empty()) return;
  throw InputError(
      fmt::format("{} was begun with another plan: {} (use another directory, or remove it)",
                  shown(file.string()), difference));
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(std::move(line));
  return lines;
}

JournalContent content_of(const std::vector<std::string>& lines,
                          const std::filesystem::path& file) {
  JournalContent content{.plan = plan_of(lines.front(), file).dump()};
  std::set<std::size_t> seen;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const auto text = unchecked(lines[k]);
    if (!text) {
      ++content.damaged;
      continue;
    }
    const std::string where = fmt::format("{}:{}", shown(file.string()), k + 1);
    try {
      PointResult result = point_in(json_of(*text, where));
      if (seen.insert(result.point).second) content.points.push_back(std::move(result));
    } catch (const nlohmann::json::exception& error) {
      throw InputError(fmt::format("{}: not a point of a sweep ({}; remove the line)", where,
                                   results::said_by(error)));
    }
  }
  return content;
}

}  // namespace

JournalContent read_journal(const std::filesystem::path& file) {
  const auto text = base::read_input_file(file, kMostBytes);
  if (!text) {
    throw InputError(fmt::format("{} is not a readable file (a sweep leaves it in its directory)",
                                 shown(file.string())));
  }
  if (text->empty()) {
    throw InputError(fmt::format("{} is empty (nothing was solved yet)", shown(file.string())));
  }
  return content_of(lines_of(*text), file);
}

JournalContent read_journal(const std::filesystem::path& file, const Plan& plan) {
  auto content = read_journal(file);
  require_same(json_of(content.plan, shown(file.string())), plan_json(plan), file);
  return content;
}

Journal::Journal(const std::filesystem::path& file, const Plan& plan) : log_(file) {
  const Json asked = plan_json(plan);
  const auto lines = log_.read();
  if (lines.empty()) {
    log_.append(checked(header(asked).dump()));
    return;
  }
  require_same(plan_of(lines.front(), file), asked, file);
  found_ = content_of(lines, file);
  if (log_.cut_off()) ++found_.damaged;
}

void Journal::append(const PointResult& result) {
  constexpr std::chrono::seconds kBetweenFlushes(1);
  const base::FilesInHand in_hand;
  log_.append(checked(journal_text(result)));
  const auto now = std::chrono::steady_clock::now();
  if (now - flushed_ < kBetweenFlushes) return;
  log_.flush();
  flushed_ = now;
}

}  // namespace fpkcheck::sweep
