#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace fpkcheck::report {

/// How a run of gnuplot ended.
struct GnuplotOutcome {
  bool found;           ///< the program could be started
  int exit_code;        ///< -1 when it was not found or a signal ended it
  std::string message;  ///< what it said on standard error, as far as that is short
};

/// Runs a script, with assignments such as "format='svg'" made before it. What its user has set up
/// for gnuplot (initialisation files, GNUTERM) has no part in it.
/// @param program name on the PATH, or a path
/// @param longest time, whatever it does with its output; then it is ended, and the message says so
GnuplotOutcome run_gnuplot(const std::string& program, const std::vector<std::string>& assignments,
                           const std::filesystem::path& script,
                           std::chrono::milliseconds longest = std::chrono::minutes(1));

/// A text as a gnuplot string constant; control characters become blanks.
std::string gnuplot_string(const std::string& text);

/// A text with the marks of enhanced text escaped, as a part of one: it is shown letter by letter.
std::string without_marks(const std::string& text);

}  // namespace fpkcheck::report
