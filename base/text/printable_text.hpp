#pragma once

#include <string>
#include <string_view>

namespace fpkcheck::base {

/// Makes a text of external origin (an argument, a file name) safe to print within one line of
/// output. Control characters and invalid UTF-8 become escapes such as \x1b, so that a terminal
/// does not execute control sequences. The middle of a text of more than 80 characters is replaced
/// by "...".
std::string to_printable_text(std::string_view text);

/// Returns to_printable_text(text) enclosed in single quotes.
std::string in_quotes(std::string_view text);

/// Replaces control characters and invalid UTF-8 by escapes such as \x1b. The text is not
/// shortened, in contrast to to_printable_text().
std::string escape_control_characters(std::string_view text);

/// Converts a message of a library to one line, truncated to 380 characters.
std::string to_single_line(std::string_view text);

}  // namespace fpkcheck::base
