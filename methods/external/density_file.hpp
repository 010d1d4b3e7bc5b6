#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "epc/form/closed_form_parameters.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::methods {

/// The format of a file with a density, detected from the contents of the file.
enum class DensityFileFormat {
  text,  ///< text with columns of numbers
  json,  ///< JSON with a closed form or with the summary of a run
  netcdf
};

struct DensityFileContent {
  DensityFileFormat form;
  std::string bytes;
};

/// @throws InputError with a message of one line, if the file is unreadable, too large, or neither
/// text nor netCDF-4
DensityFileContent read_density_file(const std::filesystem::path& file);

/// Selection of a case and of a solution of a saved run.
struct SavedSolutionSelection {
  std::optional<std::string> solution = {};
  std::optional<std::string> case_name = {};
  /// Name of the case that is selected if `case_name` is empty and the run has a case with the name
  /// default_case.
  std::string default_case = {};
};

/// The contents of a JSON file with the closed form of a density.
struct ClosedFormDensityFile {
  epc::ClosedFormDensity form;
  std::optional<problem::Problem> problem = {};  ///< problem of the saved run, if any
  /// Solution of a saved run that has the closed form; the solution has no density.
  std::optional<transform::Solution> solution = {};
};

/// Reads the closed form of a density from a JSON file, which contains one closed form
/// (epc::read_closed_form) or is the summary of a run with a closed form.
/// @param file_name name of the file, for messages
/// @throws InputError with a message of one line, if the text is not JSON, or `choice` does not
///         select exactly one complete closed form
ClosedFormDensityFile read_closed_form_file(const std::string& text, const std::string& file_name,
                                            const SavedSolutionSelection& choice);

/// Returns the index of the requested name in `names`. If no name is requested, `names` must have
/// exactly one element, whose index 0 is returned.
/// @param item_kind "case" or "solution", for messages
/// @param file_name name of the file, for messages
/// @throws InputError with a message of one line, if `names` lacks the requested name, or if no
/// name is requested and `names` has several elements
std::size_t index_of_requested_name(const std::vector<std::string>& names,
                                    const std::optional<std::string>& requested,
                                    const std::string& item_kind, const std::string& file_name);

}  // namespace fpkcheck::methods
