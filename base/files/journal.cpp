#include "base/files/journal.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <optional>
#include <sstream>
#include <system_error>
#include <thread>

#include "base/files/input_file.hpp"
#include "base/input_error.hpp"
#include "base/text/shown.hpp"

namespace fpkcheck::base {
namespace {

namespace fs = std::filesystem;
using base::in_quotes;
using base::shown;

constexpr const char* kFirstLine = "fpkcheck commit 1";
constexpr const char *kRename = "rename", *kRemove = "remove";

// One word a line: names hold spaces, and line ends where somebody wants to do harm.
bool is_plain(const std::string& name) {
  return !name.empty() && name != "." && name != ".." &&
         name.find_first_of(std::string("/\n\0", 3)) == std::string::npos;
}

std::string text_of(const Journal& journal) {
  std::string text =
      fmt::format("{}\n{}\n{}\n", kFirstLine, journal.writer.host, journal.writer.pid);
  for (const auto& [from, to] : journal.renames) {
    text += fmt::format("{}\n{}\n{}\n", kRename, from, to);
  }
  for (const auto& name : journal.removals) text += fmt::format("{}\n{}\n", kRemove, name);
  return text + "end\n";
}

// Nothing where it is not a whole journal of ours.
std::optional<Journal> journal_in(std::istream& in) {
  Journal journal;
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
      Journal::Rename rename;
      if (!std::getline(in, rename.from) || !std::getline(in, rename.to)) return std::nullopt;
      if (!is_plain(rename.from) || !is_plain(rename.to)) return std::nullopt;
      journal.renames.push_back(std::move(rename));
    } else if (line == kRemove && next() && is_plain(line)) {
      journal.removals.push_back(line);
    } else {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

std::optional<Journal> journal_at(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(fs::symlink_status(file, ignored))) return std::nullopt;
  // In a directory that others may write to, somebody else's would have us remove our files.
  struct stat status = {};
  if (stat(file.c_str(), &status) != 0 || status.st_uid != geteuid()) return std::nullopt;
  constexpr std::size_t kMostBytes = 1 << 20;
  const auto text = base::read_input_file(file, kMostBytes);
  if (!text) return std::nullopt;
  std::istringstream in(*text);
  return journal_in(in);
}

bool is_there(const fs::path& file) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(file, ignored));
}

}  // namespace

void Journal::announce(const fs::path& directory) const {
  // Written aside first, then given its name: whoever finds it finds all of it.
  const fs::path file = directory / kFile, partial = partial_beside(file);
  write_new(partial, text_of(*this));
  std::error_code error;
  fs::create_hard_link(partial, file, error);  // unlike a rename not over that of another process
  if (error == std::errc::file_exists) {
    std::error_code ignored;
    fs::remove(partial, ignored);
    throw std::system_error(error);
  }
  if (error) {
    fs::rename(partial, file);  // a file system without links
  } else {
    fs::remove(partial);
  }
  flush(directory);
}

// What is done already is not there any more.
void Journal::carry_out(const fs::path& directory) const {
  for (const auto& [from, to] : renames) {
    std::error_code error;
    fs::rename(directory / from, directory / to, error);
    if (error && error != std::errc::no_such_file_or_directory) throw std::system_error(error);
  }
  for (const auto& name : removals) {
    std::error_code ignored;
    fs::remove(directory / name, ignored);
  }
  flush(directory);
  fs::remove(directory / kFile);
}

void finish_interrupted(const fs::path& directory) {
  const fs::path file = directory / Journal::kFile;
  // Another process is at it for some milliseconds.
  constexpr int kTimes = 20;
  constexpr std::chrono::milliseconds kBetween(100);
  for (int time = 0; is_there(file); ++time) {
    const auto journal = journal_at(file);
    if (!journal) {
      if (!is_there(file)) return;
      throw InputError(fmt::format(
          "{} is no journal of yours, or damaged (a run that is stopped while its files are put in "
          "place leaves one): remove it, and run again",
          shown(file.string())));
    }
    if (!journal->writer.may_run()) {
      try {
        journal->carry_out(directory);
      } catch (const std::system_error& error) {
        throw InputError(fmt::format(
            "the files of {} are not all in place ({}; a run was stopped as it put them there): "
            "make the directory writable",
            in_quotes(directory.string()), error.code().message()));
      }
      return;
    }
    if (time == kTimes) {
      throw InputError(fmt::format(
          "process {} on {} is putting files into {} (or was stopped there): wait, or remove {}",
          journal->writer.pid, shown(journal->writer.host), in_quotes(directory.string()),
          shown(file.string())));
    }
    std::this_thread::sleep_for(kBetween);
  }
}

}  // namespace fpkcheck::base
