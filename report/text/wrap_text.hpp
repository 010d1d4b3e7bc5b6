#pragma once

#include <string>
#include <string_view>

namespace fpkcheck::report {

/// Breaks a text between words into lines of at most `width` characters, each ended by a newline.
/// All lines after the first line begin with `indent` spaces. A word longer than a line is not
/// broken.
std::string wrap_text(std::string_view text, std::size_t width, std::size_t indent = 0);

}  // namespace fpkcheck::report
