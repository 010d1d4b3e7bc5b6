#pragma once

#include <cstdlib>

namespace fpkcheck::tests {

/// True if a test over many problems is to run all of them: FPKCHECK_THOROUGH is set, as by
/// `ctest -C slow -R thorough`. Otherwise the test runs a part.
inline bool thorough() { return std::getenv("FPKCHECK_THOROUGH") != nullptr; }

template <class Number>
Number usually(Number part, Number all) {
  return thorough() ? all : part;
}

}  // namespace fpkcheck::tests
