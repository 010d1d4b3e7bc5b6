#pragma once

#include <cstddef>

namespace fpkcheck::report {

/// Layout of text output.
struct TextFormat {
  // The constructor is not explicit, since most callers set only the width.
  TextFormat(std::size_t characters = 100, bool with_colour = false)  // NOLINT
      : width(characters), colour(with_colour) {}

  std::size_t width;  ///< characters per line
  bool colour;        ///< ANSI colours, for a terminal with colour support
};

}  // namespace fpkcheck::report
