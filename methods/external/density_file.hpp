#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "epc/form/closed_form.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

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

/// The request for a solution of a saved run.
struct SolutionSelection {
  std::optional<std::string> solution = {};   ///< id of the solution
  std::optional<std::string> case_name = {};  ///< name of the case
  /// Name of the case to use if `case_name` is empty and the run has a case of this name.
  std::string default_case = {};
};

/// The contents of a JSON file with a closed form.
struct ClosedFormFile {
  epc::ClosedForm form;
  std::optional<problem::Problem> problem = {};  ///< problem, if the file is a saved run
  /// Solution with this closed form, without its density, if the file is a saved run.
  std::optional<transform::Solution> solution = {};
};

/// Reads a closed form from JSON (epc::read_closed_form), or the closed form of a solution from the
/// summary of a run.
/// @param where name of the file, for messages
/// @throws InputError with a message of one line, if the text is not JSON, if the closed form is
///         incomplete, if `choice` selects no solution or lacks a name among several, or if the
///         selected solution has no closed form
ClosedFormFile read_closed_form_file(const std::string& text, const std::string& where,
                                     const SolutionSelection& choice);

/// The index of the requested name in `names`. Without a requested name, the index of the only
/// name.
/// @param item_kind "case" or "solution", for messages
/// @param where name of the file, for messages
/// @throws InputError with a message of one line, if `names` does not contain the requested name,
///         or if no name is requested and `names` has several
std::size_t select_index(const std::vector<std::string>& names,
                         const std::optional<std::string>& requested, const std::string& item_kind,
                         const std::string& where);

}  // namespace fpkcheck::methods
