#pragma once

#include <stdexcept>

namespace fpkcheck {

/// Exception for invalid input of the user. The message is one line of the form "problem: cause;
/// action", or "NAME = VALUE (must be RANGE)" for a value out of range.
class InputError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

}  // namespace fpkcheck
