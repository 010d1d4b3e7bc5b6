#pragma once

#include <stdexcept>

namespace fpkcheck {

/// Exception for invalid input of the user. The message is one line, "problem: cause; action". For
/// a value out of range, the message is "NAME = VALUE (must be RANGE)".
class InputError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

}  // namespace fpkcheck
