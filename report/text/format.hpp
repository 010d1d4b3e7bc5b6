#pragma once

#include <cstddef>

namespace fpkcheck::report {

/// How text is laid out for whoever reads it.
struct TextFormat {
  // Not explicit: most callers care for the width alone.
  TextFormat(std::size_t characters = 100, bool with_colour = false)  // NOLINT
      : width(characters), colour(with_colour) {}

  std::size_t width;  ///< characters per line
  bool colour;        ///< ANSI colours: for a terminal that wants them
};

}  // namespace fpkcheck::report
