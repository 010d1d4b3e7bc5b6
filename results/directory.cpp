#include "results/directory.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <vector>

#include "parameters/input_error.hpp"

namespace fpkcheck::results {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPartial = ".partial-";

// Of this process alone, so that two runs into one directory do not write into each other's files.
fs::path temporary_beside(const fs::path& target) {
  return target.parent_path() /
         fmt::format(".{}{}{}", target.filename().string(), kPartial, getpid());
}

void remove_partial_files(const fs::path& directory) {
  for (const auto& entry : fs::directory_iterator(directory)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with('.') && name.find(kPartial) != std::string::npos) fs::remove(entry.path());
  }
}

void write_plainly(const fs::path& path, std::string_view text) {
  errno = 0;
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out << text;
  out.close();  // a full disk may show only here
  if (!out) {
    const auto why = std::error_code(errno != 0 ? errno : EIO, std::generic_category());
    throw std::system_error(why);
  }
}

std::runtime_error cannot_write(const fs::path& target, const std::error_code& why) {
  return std::runtime_error(fmt::format("cannot write {} ({})", target.string(), why.message()));
}

// The directories on the way that are not there yet, outermost first.
std::vector<fs::path> missing_parts(const fs::path& directory) {
  std::vector<fs::path> missing;
  std::error_code error;
  for (fs::path part = fs::absolute(directory).lexically_normal();
       part.has_relative_path() && !fs::exists(part, error); part = part.parent_path()) {
    missing.insert(missing.begin(), part);
  }
  return missing;
}

}  // namespace

std::string file_stem(std::string case_name) {
  std::ranges::replace_if(
      case_name,
      [](unsigned char c) { return !std::isalnum(c) && c != '-' && c != '_' && c != '.'; }, '_');
  return case_name;
}

MadeDirectories::~MadeDirectories() {
  std::error_code not_empty;
  for (auto part = made_.rbegin(); part != made_.rend(); ++part) fs::remove(*part, not_empty);
}

MadeDirectories make_writable(const fs::path& directory) {
  if (directory.empty()) throw InputError("--out is empty (name a directory)");
  const fs::path figures = directory / "figures";
  MadeDirectories made(missing_parts(figures));
  try {
    fs::create_directories(figures);
    for (const auto& place : {directory, figures}) {
      remove_partial_files(place);
      const fs::path probe = temporary_beside(place / "probe");
      write_plainly(probe, "");
      fs::remove(probe);
    }
    std::error_code not_empty;
    fs::remove(figures, not_empty);  // until there is something to put into it
    return made;
  } catch (const std::exception& error) {
    const auto* system_error = dynamic_cast<const std::system_error*>(&error);
    throw InputError(fmt::format(
        "cannot write into directory '{}' ({}); choose another with --out", directory.string(),
        system_error != nullptr ? system_error->code().message() : error.what()));
  }
}

PendingFiles::~PendingFiles() {
  std::error_code ignored;
  for (const auto& file : pending_) fs::remove(file.temporary, ignored);
}

void PendingFiles::add(const fs::path& target, const Produce& produce) {
  // Noted first: what is half written when `produce` throws goes as well.
  pending_.push_back({temporary_beside(target), target});
  produce(pending_.back().temporary);
}

void PendingFiles::add(const fs::path& target, std::string_view text) {
  add(target, [&](const fs::path& temporary) {
    try {
      write_plainly(temporary, text);
    } catch (const std::system_error& error) {
      throw cannot_write(target, error.code());
    }
  });
}

void PendingFiles::remove(const fs::path& target) { unwanted_.push_back(target); }

void PendingFiles::commit() {
  // All that can be known to go wrong, before the first target is replaced.
  for (const auto& [temporary, target] : pending_) {
    std::error_code error;
    if (!fs::exists(temporary, error)) {
      throw cannot_write(target, std::make_error_code(std::errc::no_such_file_or_directory));
    }
    if (fs::is_directory(target, error)) {
      throw cannot_write(target, std::make_error_code(std::errc::is_a_directory));
    }
  }
  for (const auto& [temporary, target] : pending_) {
    std::error_code error;
    fs::rename(temporary, target, error);
    if (error) throw cannot_write(target, error);
  }
  pending_.clear();
  std::error_code ignored;
  for (const auto& target : unwanted_) fs::remove(target, ignored);
}

void replace_file(const fs::path& target, const PendingFiles::Produce& produce) {
  PendingFiles file;
  file.add(target, produce);
  file.commit();
}

void write_file(const fs::path& target, std::string_view text) {
  PendingFiles file;
  file.add(target, text);
  file.commit();
}

}  // namespace fpkcheck::results
