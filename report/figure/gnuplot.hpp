#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace fpkcheck::report {

struct GnuplotOutcome {
  bool found;           ///< whether the program gnuplot was started
  int exit_code;        ///< exit code; -1 if gnuplot was not found or was ended by a signal
  std::string message;  ///< first part of gnuplot's standard output and standard error
};

/// Runs a gnuplot script after assignments of gnuplot variables, such as "format='svg'". The
/// gnuplot settings of the user (initialisation files, GNUTERM) have no effect.
/// @param program name of the program on the PATH, or its path
/// @param time_limit time after which the gnuplot process is killed
GnuplotOutcome run_gnuplot(const std::string& program, const std::vector<std::string>& assignments,
                           const std::filesystem::path& script,
                           std::chrono::milliseconds time_limit = std::chrono::minutes(1));

/// Converts a text to a string constant in a gnuplot script. Control characters become blanks.
std::string quote_for_gnuplot(const std::string& text);

/// Escapes the control characters of gnuplot's enhanced text. A picture shows the escaped text
/// literally.
std::string escape_enhanced_text(const std::string& text);

}  // namespace fpkcheck::report
