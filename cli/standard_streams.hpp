#pragma once

#include <string_view>

namespace fpkcheck::cli {

/// Makes the standard streams safe to write to; call before any file is opened. A closed stream is
/// connected to /dev/null; otherwise the next opened file would get its descriptor and receive the
/// output. SIGPIPE is ignored, so that a closed pipe (`fpkcheck run | head -1`) does not end the
/// program before its files are written.
void prepare_standard_streams();

/// Writes to standard output. After a write error the program still writes its files, and
/// run_program reports the error at the end.
void print_output(std::string_view text);

/// Writes "fpkcheck: MESSAGE" to standard error, in one line. The function ignores write errors.
void print_message(std::string_view message);

}  // namespace fpkcheck::cli
