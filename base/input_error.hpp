#pragma once

#include <stdexcept>

namespace fpkcheck {

/// Invalid input. The message is one line, "problem: cause; action". A value outside its range
/// reads "NAME = VALUE (must be RANGE)".
class InputError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

}  // namespace fpkcheck
