#pragma once

#include <new>
#include <system_error>

namespace fpkcheck::methods {

/// What is said of a solution, or of bounds, for which memory did not suffice.
inline constexpr const char* kOutOfMemory =
    "out of memory (this machine's, or what this process may have) coarser grids and fewer threads "
    "need less";

/// Does one part of a run, so that the others go on where there is no memory for this one: what it
/// had is given back on the way here. A thread that has no room for its stack counts too.
/// @return whether the part was done
/// @throws whatever else the part throws
template <class Part>
bool unless_out_of_memory(const Part& part) {
  try {
    part();
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  } catch (const std::system_error& error) {
    if (error.code() != std::errc::resource_unavailable_try_again &&
        error.code() != std::errc::not_enough_memory) {
      throw;
    }
    return false;
  }
}

}  // namespace fpkcheck::methods
