#pragma once

#include <optional>
#include <string>

#include "epc/form/closed_form.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::methods {

/// The selection of a solution of a saved run.
struct SolutionChoice {
  std::optional<std::string> solution = {};
  std::optional<std::string> case_name = {};
  /// The case to use where `case_name` is not set and the run has a case of this name.
  std::string default_case = {};
};

/// A closed form from a JSON file.
struct ClosedFormFile {
  epc::ClosedForm form;
  /// Where the file is a saved run: the problem, and the selected solution without its density.
  std::optional<problem::Problem> problem = {};
  std::optional<transform::Solution> solution = {};
};

/// Reads a closed form from JSON (epc::read_closed_form), or the closed form of a solution in the
/// summary of a run.
/// @param where the file's name in messages
/// @throws InputError on one line: not JSON, a selection that is missing or matches nothing, a
///         solution without a closed form, an incomplete closed form
ClosedFormFile read_closed_form_file(const std::string& text, const std::string& where,
                                     const SolutionChoice& choice);

/// The index of the requested name in `names`; without a request, of the only name.
/// @param item_kind "case" or "solution", for messages
/// @throws InputError on one line
std::size_t select_index(const std::vector<std::string>& names,
                         const std::optional<std::string>& requested, const std::string& item_kind,
                         const std::string& where);

}  // namespace fpkcheck::methods
