#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "base/files/append_only_log.hpp"
#include "workflows/sweep/plan/sweep_plan.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

struct SweepJournalContent {
  std::string plan;  ///< JSON text of the plan by sweep_plan_json(); empty for a new journal
  /// Results of the solved points in the order of their solution, without duplicates.
  std::vector<SweepPointResult> points{};
  std::size_t damaged = 0;  ///< number of damaged journal lines, which are ignored
};

/// Reads the journal of a sweep. No process may write to the journal while read_sweep_journal()
/// reads the journal.
/// @throws InputError with a message of one line if the file is no journal
SweepJournalContent read_sweep_journal(const std::filesystem::path& file);
/// @throws InputError with a message of one line if the file is no sweep journal, or is the journal
///         of another plan
SweepJournalContent read_sweep_journal(const std::filesystem::path& file, const SweepPlan& plan);

/// Journal file from which an interrupted sweep is resumed. The first line of a journal contains
/// the sweep plan, and each solved point adds a line with a CRC-32 checksum. If the process of a
/// sweep is killed, at most the last line of its journal is incomplete. An incomplete line of a
/// journal is ignored, and its sweep point is solved again.
class SweepJournal {
 public:
  /// Opens or creates the journal of a sweep.
  /// @throws InputError if the file belongs to another plan, is no journal, or is open in another
  ///         process
  /// @throws std::runtime_error if the file cannot be written
  SweepJournal(const std::filesystem::path& file, const SweepPlan& plan);

  /// Returns the content of the sweep journal at the time of opening.
  const SweepJournalContent& initial_journal_content() const { return initial_content_; }

  /// Appends the result of a point to the journal as one complete line, or leaves the journal file
  /// unchanged. The journal file is flushed if the last flush was more than 1 s ago. The function
  /// append() is not thread-safe.
  /// @throws std::runtime_error with a message of one line
  void append(const SweepPointResult& result);

 private:
  base::AppendOnlyLog log_;
  SweepJournalContent initial_content_;
  std::chrono::steady_clock::time_point flushed_ = std::chrono::steady_clock::now();
};

}  // namespace fpkcheck::sweep
