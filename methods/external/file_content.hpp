#pragma once

#include <filesystem>
#include <string>

namespace fpkcheck::methods {

/// What a file of a density is, by its contents.
enum class ContentForm {
  text,   ///< columns of numbers
  json,   ///< a closed form, or the summary of a run
  netcdf  ///< a joint density
};

struct FileContent {
  ContentForm form;
  std::string bytes;
};

/// @throws InputError on one line: no readable file, a larger one than any density needs, bytes
///         that are neither text nor netCDF-4
FileContent read_content(const std::filesystem::path& file);

}  // namespace fpkcheck::methods
