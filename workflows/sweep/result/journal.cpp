#include "workflows/sweep/result/journal.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>

#include "base/files/input_file.hpp"
#include "base/input_error.hpp"
#include "base/process/stop_request.hpp"
#include "base/text/printable_text.hpp"
#include "results/saved_run.hpp"
#include "workflows/sweep/result/sweep_json.hpp"

namespace fpkcheck::sweep {
namespace {

using base::to_printable_text;
using results::Json;

constexpr int kJournalSchema = 1;
constexpr std::size_t kChecksum = 8;  // number of digits of a checksum
constexpr std::size_t kMaxBytes = std::size_t{4} << 30;

std::string prepend_checksum(const std::string& text) {
  return results::crc32_hex(text) + ' ' + text;
}

// Returns the text of a journal line after the checksum; empty if the checksum is wrong.
std::optional<std::string> verify_and_strip_checksum(const std::string& line) {
  if (line.size() <= kChecksum + 1 || line[kChecksum] != ' ') return std::nullopt;
  std::string text = line.substr(kChecksum + 1);
  if (results::crc32_hex(text) != std::string_view(line).substr(0, kChecksum)) return std::nullopt;
  return text;
}

Json parse_journal_json(const std::string& text, const std::string& where) {
  std::istringstream in(text);
  return results::parse_json(in, where);
}

Json journal_header_json(const Json& plan) {
  return {{"schema", kJournalSchema},
          {"program", {{"name", "fpkcheck"}, {"version", results::current_program("").version}}},
          {"plan", plan}};
}

Json parse_header_plan(const std::string& line, const std::filesystem::path& file) {
  const auto text = verify_and_strip_checksum(line);
  const std::string name = to_printable_text(file.string());
  if (!text) {
    throw InputError(fmt::format(
        "{} is no journal of a sweep, or damaged in its first line (remove it, or use another "
        "directory)",
        name));
  }
  const Json json = parse_journal_json(*text, name);
  const Json expected = journal_header_json({});
  for (const char* part : {"schema", "program"}) {
    if (json.contains(part) && json.at(part).dump() == expected.at(part).dump()) continue;
    throw InputError(fmt::format(
        "{} was begun by another version of the program (finish it with that version, or use "
        "another directory): {} is {}, here {}",
        name, part, json.contains(part) ? to_printable_text(json.at(part).dump()) : "missing",
        expected.at(part).dump()));
  }
  if (!json.contains("plan")) throw InputError(fmt::format("{}: no plan (remove it)", name));
  return json.at("plan");
}

void require_same_plan(const Json& before, const Json& now, const std::filesystem::path& file) {
  const std::string difference = first_sweep_plan_difference(before, now);
  if (difference.empty()) return;
  throw InputError(
      fmt::format("{} was begun with another plan: {} (use another directory, or remove it)",
                  to_printable_text(file.string()), difference));
}

std::vector<std::string> split_into_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(std::move(line));
  return lines;
}

SweepJournalContent parse_journal(const std::vector<std::string>& lines,
                                  const std::filesystem::path& file) {
  SweepJournalContent content{.plan = parse_header_plan(lines.front(), file).dump()};
  std::set<std::size_t> seen;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const auto text = verify_and_strip_checksum(lines[k]);
    if (!text) {
      ++content.damaged;
      continue;
    }
    const std::string where = fmt::format("{}:{}", to_printable_text(file.string()), k + 1);
    try {
      SweepPointResult result = point_result_from_json(parse_journal_json(*text, where));
      if (seen.insert(result.point).second) content.points.push_back(std::move(result));
    } catch (const nlohmann::json::exception& error) {
      throw InputError(fmt::format("{}: not a point of a sweep ({}; remove the line)", where,
                                   results::json_error_message(error)));
    }
  }
  return content;
}

}  // namespace

SweepJournalContent read_sweep_journal(const std::filesystem::path& file) {
  const auto text = base::read_input_file(file, kMaxBytes);
  if (!text) {
    throw InputError(fmt::format("{} is not a readable file (a sweep writes it into its directory)",
                                 to_printable_text(file.string())));
  }
  if (text->empty()) {
    throw InputError(
        fmt::format("{} is empty (nothing was solved yet)", to_printable_text(file.string())));
  }
  return parse_journal(split_into_lines(*text), file);
}

SweepJournalContent read_sweep_journal(const std::filesystem::path& file, const SweepPlan& plan) {
  auto content = read_sweep_journal(file);
  require_same_plan(parse_journal_json(content.plan, to_printable_text(file.string())),
                    sweep_plan_json(plan), file);
  return content;
}

SweepJournal::SweepJournal(const std::filesystem::path& file, const SweepPlan& plan) : log_(file) {
  const Json asked = sweep_plan_json(plan);
  const auto lines = log_.read_lines();
  if (lines.empty()) {
    log_.append(prepend_checksum(journal_header_json(asked).dump()));
    return;
  }
  require_same_plan(parse_header_plan(lines.front(), file), asked, file);
  initial_content_ = parse_journal(lines, file);
  if (log_.has_removed_partial_line()) ++initial_content_.damaged;
}

void SweepJournal::append(const SweepPointResult& result) {
  constexpr std::chrono::seconds kFlushInterval(1);
  const base::ProcessExitBlocker in_hand;
  log_.append(prepend_checksum(sweep_journal_line(result)));
  const auto now = std::chrono::steady_clock::now();
  if (now - flushed_ < kFlushInterval) return;
  log_.flush_to_disk();
  flushed_ = now;
}

}  // namespace fpkcheck::sweep
