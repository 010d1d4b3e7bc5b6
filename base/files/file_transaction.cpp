#include "base/files/file_transaction.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cassert>
#include <chrono>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "base/files/atomic_file.hpp"
#include "base/files/input_file.hpp"
#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"

namespace fpkcheck::base {
namespace {

namespace fs = std::filesystem;

std::runtime_error cannot_write(const fs::path& target, const std::error_code& why) {
  return std::runtime_error(fmt::format("cannot write {}: {}", target.string(), why.message()));
}

constexpr const char* kFirstLine = "fpkcheck commit 1";
constexpr const char *kRename = "rename", *kRemove = "remove";

// File names in a journal may contain spaces, since a journal has one file name per line. File
// names with a slash are rejected, since a forged journal could name files of other directories.
bool is_plain_file_name(const std::string& name) {
  return !name.empty() && name != "." && name != ".." &&
         name.find_first_of(std::string("/\n\0", 3)) == std::string::npos;
}

std::string journal_as_text(const FileChangeJournal& journal) {
  std::string text =
      fmt::format("{}\n{}\n{}\n", kFirstLine, journal.writer.host, journal.writer.pid);
  for (const auto& [from, to] : journal.renames) {
    text += fmt::format("{}\n{}\n{}\n", kRename, from, to);
  }
  for (const auto& name : journal.removals) text += fmt::format("{}\n{}\n", kRemove, name);
  return text + "end\n";
}

// Parses the text of a journal of file changes; returns nullopt for an incomplete journal.
std::optional<FileChangeJournal> parse_journal(std::istream& in) {
  FileChangeJournal journal;
  journal.writer.pid = 0;
  std::string line;
  const auto next = [&] { return static_cast<bool>(std::getline(in, line)); };
  if (!next() || line != kFirstLine || !next()) return std::nullopt;
  journal.writer.host = line;
  if (!next()) return std::nullopt;
  std::istringstream(line) >> journal.writer.pid;
  while (next()) {
    if (line == "end") return journal.writer.pid > 0 ? std::optional(journal) : std::nullopt;
    if (line == kRename) {
      FileChangeJournal::FileRename rename;
      if (!std::getline(in, rename.from) || !std::getline(in, rename.to)) return std::nullopt;
      if (!is_plain_file_name(rename.from) || !is_plain_file_name(rename.to)) return std::nullopt;
      journal.renames.push_back(std::move(rename));
    } else if (line == kRemove && next() && is_plain_file_name(line)) {
      journal.removals.push_back(line);
    } else {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

std::optional<FileChangeJournal> read_sweep_journal(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(fs::symlink_status(file, ignored))) return std::nullopt;
  // A journal of another user is rejected: in a shared directory, another user's journal could make
  // this process remove files of its own user.
  struct stat status = {};
  if (stat(file.c_str(), &status) != 0 || status.st_uid != geteuid()) return std::nullopt;
  constexpr std::size_t kMostBytes = 1 << 20;
  const auto text = base::read_input_file(file, kMostBytes);
  if (!text) return std::nullopt;
  std::istringstream in(*text);
  return parse_journal(in);
}

bool path_exists(const fs::path& file) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(file, ignored));
}

}  // namespace

FileTransaction::~FileTransaction() {
  std::error_code ignored;
  for (const auto& file : pending_) fs::remove(file.temporary, ignored);
}

void FileTransaction::require_target_in_same_directory(const fs::path& target) const {
  const fs::path directory = target.parent_path();
  if ((!pending_.empty() && pending_.front().target.parent_path() != directory) ||
      (!removals_.empty() && removals_.front().parent_path() != directory)) {
    throw std::logic_error("pending files are in different directories");
  }
}

void FileTransaction::add(const fs::path& target, const FileWriter& produce) {
  require_target_in_same_directory(target);
  const fs::path temporary = partial_file_path(target);
  // An earlier process with the same process id may have left a partial file with the same name.
  std::error_code ignored;
  fs::remove(temporary, ignored);
  // The partial file is registered before `produce` is called, so that the destructor also removes
  // the file if `produce` throws.
  pending_.push_back({temporary, target});
  produce(temporary);
}

void FileTransaction::add(const fs::path& target, std::string_view bytes) {
  add(target, [&](const fs::path& temporary) {
    try {
      write_new_file(temporary, bytes);
    } catch (const std::system_error& error) {
      throw cannot_write(target, error.code());
    }
  });
}

void FileTransaction::remove(const fs::path& target) {
  require_target_in_same_directory(target);
  removals_.push_back(target);
}

void FileTransaction::commit() {
  assert(!committed_);
  committed_ = true;
  // All errors that can be detected in advance are thrown before the first target file is replaced.
  for (const auto& [temporary, target] : pending_) {
    std::error_code error;
    if (!fs::exists(temporary, error)) {
      throw cannot_write(target, std::make_error_code(std::errc::no_such_file_or_directory));
    }
    if (fs::is_directory(target, error)) {
      throw cannot_write(target, std::make_error_code(std::errc::is_a_directory));
    }
  }
  if (!pending_.empty()) replace_target_files(pending_.front().target.parent_path());
}

void FileTransaction::replace_target_files(const fs::path& directory) {
  const fs::path first = pending_.front().target;
  try {
    for (const auto& file : pending_) flush_to_disk(file.temporary);
    if (pending_.size() == 1 && removals_.empty()) {
      fs::rename(pending_.front().temporary, pending_.front().target);
      flush_to_disk(directory);
    } else {
      recover_interrupted_commit(directory);
      FileChangeJournal journal;
      for (const auto& [temporary, target] : pending_) {
        journal.renames.push_back({temporary.filename().string(), target.filename().string()});
      }
      for (const auto& target : removals_) journal.removals.push_back(target.filename().string());
      journal.write_to_directory(directory);
      // After the journal is written, the partial files must be kept until this or a later process
      // applies the journal.
      pending_.clear();
      removals_.clear();
      journal.apply_file_changes(directory);
    }
  } catch (const std::system_error& error) {
    throw cannot_write(first, error.code());
  }
  pending_.clear();
  removals_.clear();
}

void replace_file_atomically(const fs::path& target, const FileTransaction::FileWriter& produce) {
  FileTransaction file;
  file.add(target, produce);
  file.commit();
}

void write_file_atomically(const fs::path& target, std::string_view bytes) {
  FileTransaction file;
  file.add(target, bytes);
  file.commit();
}

void FileChangeJournal::write_to_directory(const fs::path& directory) const {
  // The journal is written under a temporary name and then linked to its final name, so that other
  // processes never read an incomplete journal.
  const fs::path file = directory / kFileName, partial = partial_file_path(file);
  write_new_file(partial, journal_as_text(*this));
  std::error_code error;
  // A hard link, unlike a rename, never replaces the journal of another process.
  fs::create_hard_link(partial, file, error);
  if (error == std::errc::file_exists) {
    std::error_code ignored;
    fs::remove(partial, ignored);
    throw std::system_error(error);
  }
  if (error) {
    fs::rename(partial, file);  // fallback for file systems without hard links
  } else {
    fs::remove(partial);
  }
  flush_to_disk(directory);
}

// If the source file of a rename is missing, an earlier process has already renamed the file.
void FileChangeJournal::apply_file_changes(const fs::path& directory) const {
  for (const auto& [from, to] : renames) {
    std::error_code error;
    fs::rename(directory / from, directory / to, error);
    if (error && error != std::errc::no_such_file_or_directory) throw std::system_error(error);
  }
  for (const auto& name : removals) {
    std::error_code ignored;
    fs::remove(directory / name, ignored);
  }
  flush_to_disk(directory);
  fs::remove(directory / kFileName);
}

void recover_interrupted_commit(const fs::path& directory) {
  const fs::path file = directory / FileChangeJournal::kFileName;
  // A running process removes its journal within milliseconds; the loop therefore waits up to 2 s
  // until the journal is removed.
  constexpr int kMaxAttempts = 20;
  constexpr std::chrono::milliseconds kRetryInterval(100);
  for (int attempt = 0; path_exists(file); ++attempt) {
    const auto journal = read_sweep_journal(file);
    if (!journal) {
      if (!path_exists(file)) return;
      throw InputError(fmt::format(
          "{} is not a journal of this user, or damaged: an interrupted run may have left it; "
          "remove it and run again",
          to_printable_text(file.string())));
    }
    if (!journal->writer.may_be_running()) {
      try {
        journal->apply_file_changes(directory);
      } catch (const std::system_error& error) {
        throw InputError(fmt::format(
            "the files in {} are incomplete: an interrupted run could not be completed ({}); make "
            "the directory writable",
            in_quotes(directory.string()), error.code().message()));
      }
      return;
    }
    if (attempt == kMaxAttempts) {
      throw InputError(fmt::format(
          "process {} on {} is writing files into {}, or was interrupted there; wait, or remove {}",
          journal->writer.pid, to_printable_text(journal->writer.host),
          in_quotes(directory.string()), to_printable_text(file.string())));
    }
    std::this_thread::sleep_for(kRetryInterval);
  }
}

}  // namespace fpkcheck::base
