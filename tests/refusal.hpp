#pragma once

#include <string>

#include "base/input_error.hpp"

namespace fpkcheck::tests {

/// The message of the InputError that a call of a function throws; `accepted` if the call throws no
/// InputError.
template <class Function>
std::string refusal(const Function& function, const char* accepted = "accepted") {
  try {
    function();
  } catch (const InputError& error) {
    return error.what();
  }
  return accepted;
}

}  // namespace fpkcheck::tests
