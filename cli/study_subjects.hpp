#pragma once

#include <string>
#include <vector>

#include "cli/commands.hpp"

namespace fpkcheck::cli {

/// A subject of `fpkcheck study`.
struct StudySubject {
  std::string name;
  std::string summary;  ///< description in `fpkcheck study --help`
  int (*run)(const CommandCall&);
};
const std::vector<StudySubject>& study_subjects();

/// Functions that run the subjects of `study`.
/// @param call call of the command, with the arguments after the subject
/// @return an ExitCode
/// @throws InputError for bad input or usage, before anything is solved or written
int study_grid(const CommandCall& call);
int study_order(const CommandCall& call);
int study_regularisation(const CommandCall& call);

}  // namespace fpkcheck::cli
