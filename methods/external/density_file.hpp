#pragma once

#include <filesystem>
#include <string>

namespace fpkcheck::methods {

/// The format of a file with a density, detected from the contents of the file.
enum class DensityFileFormat {
  text,   ///< columns of numbers
  json,   ///< a closed form, or the summary of a run
  netcdf  ///< a joint density
};

/// The contents of a file with a density, and their format.
struct DensityFileContent {
  DensityFileFormat form;
  std::string bytes;
};

/// Reads a file with a density and detects its format.
/// @throws InputError with a message of one line, if the file is unreadable or too large, or is
///         neither text nor netCDF-4
DensityFileContent read_density_file(const std::filesystem::path& file);

}  // namespace fpkcheck::methods
