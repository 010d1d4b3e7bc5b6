#pragma once

#include <string>
#include <string_view>

namespace fpkcheck::base {

/// Makes foreign text (an argument, a file name, file contents) safe within a line of output.
/// Control characters and bytes that are not UTF-8 become escapes such as \x1b, so that a terminal
/// does not obey them. Text of more than 80 characters loses its middle.
std::string sanitise(std::string_view text);

/// The result of sanitise() between quotes.
std::string in_quotes(std::string_view text);

/// The same escapes without the limit of length.
std::string escape_controls(std::string_view text);

/// A whole message as one line of at most 380 characters, truncated at its end. For messages of
/// libraries, whose length and contents are unknown.
std::string to_single_line(std::string_view text);

}  // namespace fpkcheck::base
