#pragma once

#include <string>
#include <string_view>

namespace fpkcheck::base {

/// Makes a text from outside the program (an argument, a file name, the contents of a file) safe to
/// print within one line of output. Control characters and bytes that are not UTF-8 become escapes
/// such as \x1b, so that a terminal does not execute them as control sequences. From a text of more
/// than 80 characters the middle part is removed.
std::string sanitise(std::string_view text);

/// The result of sanitise(), enclosed in quotes.
std::string in_quotes(std::string_view text);

/// Replaces control characters and bytes that are not UTF-8 by escapes, as sanitise() does, but
/// without a limit of the length.
std::string escape_control_characters(std::string_view text);

/// Converts a message to one line of at most 380 characters; the end of a longer message is cut
/// off. Used for messages of libraries, since their length and contents are unknown.
std::string to_single_line(std::string_view text);

}  // namespace fpkcheck::base
