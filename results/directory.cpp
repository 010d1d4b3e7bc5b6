#include "results/directory.hpp"

#include <fmt/format.h>

#include <cctype>
#include <system_error>
#include <vector>

#include "files/journal.hpp"
#include "files/whole_file.hpp"
#include "parameters/input_error.hpp"

namespace fpkcheck::results {
namespace {

namespace fs = std::filesystem;

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
      files::finish_interrupted(place);
      files::remove_abandoned(place);
      const fs::path probe = files::partial_beside(place / "probe");
      files::write_new(probe, "");
      fs::remove(probe);
    }
    std::error_code not_empty;
    fs::remove(figures, not_empty);  // until there is something to put into it
    return made;
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    const auto* system_error = dynamic_cast<const std::system_error*>(&error);
    throw InputError(fmt::format(
        "cannot write into directory '{}' ({}); choose another with --out", directory.string(),
        system_error != nullptr ? system_error->code().message() : error.what()));
  }
}

}  // namespace fpkcheck::results
