#include "results/output_directory.hpp"

#include <fmt/format.h>

#include <regex>
#include <system_error>
#include <vector>

#include "base/files/atomic_file.hpp"
#include "base/files/file_transaction.hpp"
#include "base/input_error.hpp"

namespace fpkcheck::results {
namespace {

namespace fs = std::filesystem;

// Returns the missing directories of a path, from the outermost to the innermost.
std::vector<fs::path> missing_directories(const fs::path& directory) {
  std::vector<fs::path> missing;
  std::error_code error;
  for (fs::path part = fs::absolute(directory).lexically_normal();
       part.has_relative_path() && !fs::exists(part, error); part = part.parent_path()) {
    missing.insert(missing.begin(), part);
  }
  return missing;
}

void recover_interrupted_run(const fs::path& directory) {
  base::recover_interrupted_commit(directory);
  base::remove_abandoned_partial_files(directory);
}

// Creates an empty hidden file to test that a directory is writable. An existing hidden file of the
// same name, from an earlier process with the same process id, is removed first.
fs::path create_probe_file(const fs::path& directory) {
  fs::path file = base::partial_file_path(directory / "run");
  fs::remove(file);
  base::write_new_file(file, "");
  return file;
}

OutputDirectoryLock try_prepare_directory(const fs::path& directory) {
  const fs::path figures = directory / "figures";
  std::vector<fs::path> missing = missing_directories(directory);
  const OutputDirectoryLock made({}, missing);  // removes empty directories after an exception
  fs::create_directories(directory);
  recover_interrupted_run(directory);
  OutputDirectoryLock held(create_probe_file(directory), std::move(missing));
  if (fs::exists(figures)) {
    fs::create_directories(figures);  // throws if `figures` is a file
    recover_interrupted_run(figures);
    fs::remove(create_probe_file(figures));
  }
  return held;
}

}  // namespace

std::string case_file_stem(const std::string& case_name) {
  static const std::regex replaced("[^A-Za-z0-9._-]+");
  return std::regex_replace(case_name, replaced, "_");
}

OutputDirectoryLock::~OutputDirectoryLock() {
  std::error_code not_empty;
  if (!lock_file_.empty()) fs::remove(lock_file_, not_empty);
  for (auto part = created_.rbegin(); part != created_.rend(); ++part) fs::remove(*part, not_empty);
}

OutputDirectoryLock prepare_output_directory(const fs::path& directory) {
  if (directory.empty()) throw InputError("--out is empty; give a directory");
  try {
    // Since another run may remove its empty directories at the same time, the preparation of the
    // directory is repeated until the hidden file of the present run exists.
    for (int attempt = 0; attempt < 20; ++attempt) {
      try {
        return try_prepare_directory(directory);
      } catch (const std::system_error& error) {
        if (error.code() != std::errc::no_such_file_or_directory) throw;
      }
    }
    return try_prepare_directory(directory);
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
