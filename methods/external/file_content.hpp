#pragma once

#include <filesystem>
#include <string>

namespace fpkcheck::methods {

/// The format of a density file, detected from its contents.
enum class ContentForm {
  text,   ///< columns of numbers
  json,   ///< a closed form, or the summary of a run
  netcdf  ///< a joint density
};

struct FileContent {
  ContentForm form;
  std::string bytes;
};

/// Reads a file and detects its format.
/// @throws InputError on one line: the file is unreadable or too large, or neither text nor
///         netCDF-4
FileContent read_file_content(const std::filesystem::path& file);

}  // namespace fpkcheck::methods
