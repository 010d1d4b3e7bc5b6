#pragma once

#include <string>
#include <string_view>

namespace fpkcheck::report {

/// The text broken between words into lines of at most `width` characters, each ended by a newline;
/// lines after the first start with `indent` spaces. A word that is longer than a line stays whole.
std::string wrapped(std::string_view text, std::size_t width, std::size_t indent = 0);

}  // namespace fpkcheck::report
