#include "results/directory.hpp"

#include <fmt/format.h>

#include <cctype>
#include <system_error>
#include <vector>

#include "base/files/atomic_file.hpp"
#include "base/files/journal.hpp"
#include "base/input_error.hpp"

namespace fpkcheck::results {
namespace {

namespace fs = std::filesystem;

// The missing directories of a path, outermost first.
std::vector<fs::path> missing_parts(const fs::path& directory) {
  std::vector<fs::path> missing;
  std::error_code error;
  for (fs::path part = fs::absolute(directory).lexically_normal();
       part.has_relative_path() && !fs::exists(part, error); part = part.parent_path()) {
    missing.insert(missing.begin(), part);
  }
  return missing;
}

void tidy(const fs::path& directory) {
  base::complete_interrupted_commit(directory);
  base::remove_abandoned_partials(directory);
}

// Creates an empty hidden file, to test that the directory is writable. Removes a file that an
// earlier process with the same process id may have left.
fs::path written_into(const fs::path& directory) {
  fs::path file = base::partial_path(directory / "run");
  fs::remove(file);
  base::write_new_file(file, "");
  return file;
}

PreparedDirectory prepared(const fs::path& directory) {
  const fs::path figures = directory / "figures";
  std::vector<fs::path> missing = missing_parts(directory);
  const PreparedDirectory made({}, missing);  // removes empty directories if the next lines throw
  fs::create_directories(directory);
  tidy(directory);
  PreparedDirectory held(written_into(directory), std::move(missing));
  if (fs::exists(figures)) {
    fs::create_directories(figures);  // throws if `figures` is a file
    tidy(figures);
    fs::remove(written_into(figures));
  }
  return held;
}

}  // namespace

std::string file_stem(const std::string& case_name) {
  std::string stem;
  bool replaced = false;
  for (const unsigned char c : case_name) {
    const bool kept = std::isalnum(c) || c == '-' || c == '_' || c == '.';
    if (kept || !replaced) stem += kept ? static_cast<char>(c) : '_';
    replaced = !kept;
  }
  return stem;
}

PreparedDirectory::~PreparedDirectory() {
  std::error_code not_empty;
  if (!hold_.empty()) fs::remove(hold_, not_empty);
  for (auto part = made_.rbegin(); part != made_.rend(); ++part) fs::remove(*part, not_empty);
}

PreparedDirectory make_writable(const fs::path& directory) {
  if (directory.empty()) throw InputError("--out is empty; give a directory");
  try {
    // Another run that ends may remove directories that it created, until the hidden file of this
    // run exists. Hence the repeated attempts.
    for (int others = 0; others < 20; ++others) {
      try {
        return prepared(directory);
      } catch (const std::system_error& error) {
        if (error.code() != std::errc::no_such_file_or_directory) throw;
      }
    }
    return prepared(directory);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    const auto* system_error = dynamic_cast<const std::system_error*>(&error);
    throw InputError(fmt::format(
        "cannot write into directory '{}': {}; choose another with --out", directory.string(),
        system_error != nullptr ? system_error->code().message() : error.what()));
  }
}

}  // namespace fpkcheck::results
