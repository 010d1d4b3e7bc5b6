#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "base/files/line_log.hpp"
#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/point_result.hpp"

namespace fpkcheck::sweep {

/// What a journal has.
struct JournalContent {
  std::string plan;                   ///< the text of plan_json; empty where it is new
  std::vector<PointResult> points{};  ///< each once, in the order in which they were solved
  std::size_t damaged = 0;            ///< lines that were left out
};

/// Reads a journal that nobody writes.
/// @throws InputError on one line where it is none
JournalContent read_journal(const std::filesystem::path& file);
/// @throws InputError also where it is another plan's
JournalContent read_journal(const std::filesystem::path& file, const Plan& plan);

/// The file that a sweep resumes from: a line that says what was asked, then a line for each point
/// as it is finished, each after its CRC-32. A process that is killed leaves at most its last line in
/// part: it is dropped, and its point solved again.
class Journal {
 public:
  /// Opens the journal, or begins one.
  /// @throws InputError on one line where it is another plan's, no journal, or where another process
  ///         writes it; std::runtime_error where it cannot be written
  Journal(const std::filesystem::path& file, const Plan& plan);

  /// What was there when it was opened.
  const JournalContent& found() const { return found_; }

  /// Adds a point, whole or not at all; from one thread at a time. Every second it goes to the disk.
  /// @throws std::runtime_error on one line
  void append(const PointResult& result);

 private:
  base::LineLog log_;
  JournalContent found_;
  std::chrono::steady_clock::time_point flushed_ = std::chrono::steady_clock::now();
};

}  // namespace fpkcheck::sweep
