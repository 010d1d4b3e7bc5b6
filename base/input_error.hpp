#pragma once

#include <stdexcept>

namespace fpkcheck {

/// Input that cannot be used. The text reads: problem (why) what to do, on one line.
class InputError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

}  // namespace fpkcheck
