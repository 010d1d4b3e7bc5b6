#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace fpkcheck::report {

/// The outcome of a run of gnuplot.
struct GnuplotOutcome {
  bool found;           ///< the program was started
  int exit_code;        ///< -1 if the program was not found or was ended by a signal
  std::string message;  ///< the beginning of its standard output and standard error
};

/// Runs a gnuplot script after assignments such as "format='svg'". The user's settings of gnuplot
/// (initialisation files, GNUTERM) are ignored.
/// @param program name on the PATH, or a path
/// @param time_limit a process that runs longer is killed; the message then states the limit
GnuplotOutcome run_gnuplot(const std::string& program, const std::vector<std::string>& assignments,
                           const std::filesystem::path& script,
                           std::chrono::milliseconds time_limit = std::chrono::minutes(1));

/// A text as a gnuplot string constant; control characters become blanks.
std::string gnuplot_string(const std::string& text);

/// Escapes the control characters of gnuplot's enhanced text, so that the text appears literally.
std::string escape_enhanced_text(const std::string& text);

}  // namespace fpkcheck::report
