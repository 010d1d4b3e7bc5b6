#pragma once

#include <optional>
#include <string>

#include "epc/form/closed_form.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::methods {

/// Which of the solutions of a saved run is asked for.
struct SolutionChoice {
  std::optional<std::string> solution = {};
  std::optional<std::string> case_name = {};
  /// The case that is meant where the run has one of this name and none is asked for.
  std::string usual_case = {};
};

/// A closed form from a JSON file.
struct FormFile {
  epc::ClosedForm form;
  /// Of a solution of a saved run: its problem, itself without its density.
  std::optional<problem::Problem> problem = {};
  std::optional<transform::Solution> solution = {};
};

/// Reads a closed form that was written down (epc::read_closed_form), or the one of a solution in the
/// summary of a run.
/// @param where how messages name the file
/// @throws InputError on one line: not JSON, a choice that there is not or that has to be made, a
///         solution without a closed form, a form that is not whole
FormFile read_form(const std::string& text, const std::string& where, const SolutionChoice& choice);

/// The one that is asked for of the names that there are; the only one where none is asked for.
/// @param what "case", "solution"
/// @throws InputError on one line
std::size_t chosen(const std::vector<std::string>& names, const std::optional<std::string>& asked,
                   const std::string& what, const std::string& where);

}  // namespace fpkcheck::methods
