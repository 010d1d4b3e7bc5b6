#pragma once

#include <string>
#include <string_view>

namespace fpkcheck::base {

/// What others wrote (an argument, a file's name or its contents), as a part of a line for people:
/// control characters and bytes that are not UTF-8 as \x1b, what is longer than 80 characters cut
/// in its middle, so that no terminal obeys it and no message drowns in it.
std::string shown(std::string_view text);

/// shown() between quotes.
std::string in_quotes(std::string_view text);

/// The same escapes, and nothing cut.
std::string without_controls(std::string_view text);

/// A whole message as one line of at most 380 characters, cut at its end: the last resort for what
/// libraries say.
std::string one_line(std::string_view text);

}  // namespace fpkcheck::base
