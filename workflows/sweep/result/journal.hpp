#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "base/files/line_log.hpp"
#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// The content of the journal of a sweep.
struct JournalContent {
  std::string plan;                   ///< text of plan_json; empty for a new journal
  std::vector<PointResult> points{};  ///< each point once, in the order in which they were solved
  std::size_t damaged = 0;            ///< number of lines that were ignored
};

/// Reads the journal of a sweep. No process may write to the journal during this call.
/// @throws InputError with a message of one line if the file is no journal
JournalContent read_journal(const std::filesystem::path& file);
/// Reads the journal of a plan.
/// @throws InputError with a message of one line if the file is no journal, or belongs to another
///                    plan
JournalContent read_journal(const std::filesystem::path& file, const Plan& plan);

/// The journal of a sweep: the file from which an interrupted sweep is resumed. The first line
/// contains the plan; each solved point adds a line. Each line begins with a CRC-32 checksum of the
/// line. If the process is killed, at most the last line is incomplete: such a line is ignored, and
/// its point is solved again.
class Journal {
 public:
  /// Opens the journal, or creates a new journal.
  /// @throws InputError with a message of one line if the file belongs to another plan, is no
  ///         journal, or is open in another process; std::runtime_error if the file cannot be
  ///         written
  Journal(const std::filesystem::path& file, const Plan& plan);

  /// The content that the journal had when it was opened.
  const JournalContent& initial_content() const { return initial_content_; }

  /// Appends the result of a point: the line is written completely or not at all. The file is
  /// flushed to the disk if the last flush was more than 1 s ago. append is not thread-safe.
  /// @throws std::runtime_error with a message of one line
  void append(const PointResult& result);

 private:
  base::LineLog log_;
  JournalContent initial_content_;
  std::chrono::steady_clock::time_point flushed_ = std::chrono::steady_clock::now();
};

}  // namespace fpkcheck::sweep
