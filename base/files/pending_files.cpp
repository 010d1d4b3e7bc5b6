#include "base/files/pending_files.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <system_error>

#include "base/files/atomic_file.hpp"
#include "base/files/journal.hpp"

namespace fpkcheck::base {
namespace {

namespace fs = std::filesystem;

std::runtime_error cannot_write(const fs::path& target, const std::error_code& why) {
  return std::runtime_error(fmt::format("cannot write {}: {}", target.string(), why.message()));
}

}  // namespace

PendingFiles::~PendingFiles() {
  std::error_code ignored;
  for (const auto& file : pending_) fs::remove(file.temporary, ignored);
}

void PendingFiles::require_same_directory(const fs::path& target) const {
  const fs::path directory = target.parent_path();
  if ((!pending_.empty() && pending_.front().target.parent_path() != directory) ||
      (!removals_.empty() && removals_.front().parent_path() != directory)) {
    throw std::logic_error("pending files are in different directories");
  }
}

void PendingFiles::add(const fs::path& target, const FileWriter& produce) {
  require_same_directory(target);
  const fs::path temporary = partial_file_path(target);
  // A file of this name was left by an earlier process that had the same process id.
  std::error_code ignored;
  fs::remove(temporary, ignored);
  // The partial file is registered before `produce` is called, so that the destructor also removes
  // the file if `produce` throws.
  pending_.push_back({temporary, target});
  produce(temporary);
}

void PendingFiles::add(const fs::path& target, std::string_view bytes) {
  add(target, [&](const fs::path& temporary) {
    try {
      write_new_file(temporary, bytes);
    } catch (const std::system_error& error) {
      throw cannot_write(target, error.code());
    }
  });
}

void PendingFiles::remove(const fs::path& target) {
  require_same_directory(target);
  removals_.push_back(target);
}

void PendingFiles::commit() {
  // All errors that can be detected in advance are thrown before the first target is replaced.
  for (const auto& [temporary, target] : pending_) {
    std::error_code error;
    if (!fs::exists(temporary, error)) {
      throw cannot_write(target, std::make_error_code(std::errc::no_such_file_or_directory));
    }
    if (fs::is_directory(target, error)) {
      throw cannot_write(target, std::make_error_code(std::errc::is_a_directory));
    }
  }
  if (!pending_.empty()) replace_targets(pending_.front().target.parent_path());
}

void PendingFiles::replace_targets(const fs::path& directory) {
  const fs::path first = pending_.front().target;
  try {
    for (const auto& file : pending_) flush(file.temporary);
    if (pending_.size() == 1 && removals_.empty()) {
      fs::rename(pending_.front().temporary, pending_.front().target);
      flush(directory);
    } else {
      complete_interrupted_commit(directory);
      Journal journal;
      for (const auto& [temporary, target] : pending_) {
        journal.renames.push_back({temporary.filename().string(), target.filename().string()});
      }
      for (const auto& target : removals_) journal.removals.push_back(target.filename().string());
      journal.write_to_directory(directory);
      // keep the partial files on failure: this or the next process applies the journal
      pending_.clear();
      removals_.clear();
      journal.apply(directory);
    }
  } catch (const std::system_error& error) {
    throw cannot_write(first, error.code());
  }
  pending_.clear();
  removals_.clear();
}

void replace_file(const fs::path& target, const PendingFiles::FileWriter& produce) {
  PendingFiles file;
  file.add(target, produce);
  file.commit();
}

void write_file(const fs::path& target, std::string_view bytes) {
  PendingFiles file;
  file.add(target, bytes);
  file.commit();
}

}  // namespace fpkcheck::base
