#pragma once

#include <cstdlib>

namespace fpkcheck::tests {

/// True if a test over many problems is to run all of them: FPKCHECK_THOROUGH is set, as by
/// `ctest -C slow -R thorough`. Otherwise the test runs a part.
inline bool is_thorough() { return std::getenv("FPKCHECK_THOROUGH") != nullptr; }

template <class Number>
Number part_unless_thorough(Number part, Number all) {
  return is_thorough() ? all : part;
}

}  // namespace fpkcheck::tests
