#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "base/files/line_log.hpp"
#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/point_result.hpp"

namespace fpkcheck::sweep {

/// Content of a journal.
struct JournalContent {
  std::string plan;                   ///< text of plan_json; empty for a new journal
  std::vector<PointResult> points{};  ///< each point once, in the order in which they were solved
  std::size_t damaged = 0;            ///< number of lines that were ignored
};

/// Reads a journal while no process writes it.
/// @throws InputError with a message of one line, where the file is no journal
JournalContent read_journal(const std::filesystem::path& file);
/// @throws InputError also where the journal belongs to another plan
JournalContent read_journal(const std::filesystem::path& file, const Plan& plan);

/// Journal of a sweep: the file that a sweep resumes from. The first line holds the plan; each
/// solved point adds a line. Each line begins with its CRC-32. A killed process can leave at most
/// its last line incomplete: that line is dropped and its point solved again.
class Journal {
 public:
  /// Opens the journal, or creates it.
  /// @throws InputError with a message of one line, where the file belongs to another plan, is no
  ///         journal, or is open in another process; std::runtime_error where it cannot be written
  Journal(const std::filesystem::path& file, const Plan& plan);

  /// Content of the journal when it was opened.
  const JournalContent& initial_content() const { return initial_content_; }

  /// Appends a point completely or not at all; not thread-safe. Flushes to the disk if the last
  /// flush was more than 1 s ago.
  /// @throws std::runtime_error with a message of one line
  void append(const PointResult& result);

 private:
  base::LineLog log_;
  JournalContent initial_content_;
  std::chrono::steady_clock::time_point flushed_ = std::chrono::steady_clock::now();
};

}  // namespace fpkcheck::sweep
