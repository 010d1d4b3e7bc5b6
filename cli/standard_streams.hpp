#pragma once

#include <string_view>

namespace fpkcheck::cli {

/// Makes the standard streams safe to write to, before any file is opened: one that is closed is
/// joined to /dev/null, else the next file that is opened would get its number and what is printed
/// would go into it; and a reader that goes away (`fpkcheck run | head -1`) does not end the program
/// before its files are written.
void prepare_standard_streams();

/// Writes to standard output. What could not be written is told in the end, by run_program: it is no
/// reason to lose the files.
void put_out(std::string_view text);

/// Writes "fpkcheck: MESSAGE" to standard error, in one line, where there is somebody to read it.
void complain(std::string_view message);

}  // namespace fpkcheck::cli
