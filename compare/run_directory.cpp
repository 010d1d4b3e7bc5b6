#include "compare/run_directory.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>
#include <vector>

#include "problem/input_error.hpp"

namespace fpkcheck::compare {
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
    throw std::runtime_error(fmt::format("cannot write {} ({})", path.string(), why.message()));
  }
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

void make_writable(const fs::path& directory) {
  if (directory.empty()) throw InputError("--out is empty (name a directory)");
  const fs::path figures = directory / "figures";
  const auto missing = missing_parts(figures);
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
  } catch (const std::exception& error) {
    std::error_code ignored;
    for (auto part = missing.rbegin(); part != missing.rend(); ++part) fs::remove(*part, ignored);
    const auto* system_error = dynamic_cast<const std::system_error*>(&error);
    throw InputError(fmt::format(
        "cannot write into directory '{}' ({}); choose another with --out", directory.string(),
        system_error != nullptr ? system_error->code().message() : error.what()));
  }
}

void replace_file(const fs::path& target,
                  const std::function<void(const fs::path& temporary)>& produce) {
  const fs::path temporary = temporary_beside(target);
  std::error_code ignored;
  try {
    produce(temporary);
    fs::rename(temporary, target);
  } catch (const fs::filesystem_error& error) {
    fs::remove(temporary, ignored);
    throw std::runtime_error(
        fmt::format("cannot write {} ({})", target.string(), error.code().message()));
  } catch (...) {
    fs::remove(temporary, ignored);
    throw;
  }
}

void write_file(const fs::path& target, std::string_view text) {
  replace_file(target, [&](const fs::path& temporary) { write_plainly(temporary, text); });
}

}  // namespace fpkcheck::compare
