#pragma once

#include <cstdlib>

namespace fpkcheck::tests {

/// Whether a test over many problems takes all of them: where FPKCHECK_THOROUGH is set, as by
/// `ctest -C slow -R thorough`. Otherwise it takes a part.
inline bool thorough() { return std::getenv("FPKCHECK_THOROUGH") != nullptr; }

template <class Number>
Number usually(Number part, Number all) {
  return thorough() ? all : part;
}

}  // namespace fpkcheck::tests
