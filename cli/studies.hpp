#pragma once

#include <string>
#include <vector>

#include "cli/commands.hpp"

namespace fpkcheck::cli {

/// What may follow `fpkcheck study`.
struct StudySubject {
  std::string name;
  std::string summary;  ///< what `fpkcheck study --help` says of it
  int (*run)(const Call&);
};
const std::vector<StudySubject>& study_subjects();

/// One function per subject, each in a file of its name.
/// @param call with what follows the subject
/// @return an ExitCode
/// @throws InputError for bad input or usage, before anything is solved or written
int study_grid(const Call& call);
int study_order(const Call& call);
int study_regularisation(const Call& call);

}  // namespace fpkcheck::cli
