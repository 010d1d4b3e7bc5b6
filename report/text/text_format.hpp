#pragma once

#include <cstddef>

namespace fpkcheck::report {

struct TextFormat {
  // This constructor is not explicit, since most callers set only the text width.
  TextFormat(std::size_t characters = 100, bool with_colour = false)  // NOLINT
      : width(characters), colour(with_colour) {}

  std::size_t width;
  bool colour;  ///< whether to use ANSI colours, for a terminal that supports them
};

}  // namespace fpkcheck::report
