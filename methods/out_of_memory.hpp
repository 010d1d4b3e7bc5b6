#pragma once

#include <new>
#include <system_error>

namespace fpkcheck::methods {

/// The reason of a solution, or of bounds, for which memory did not suffice.
inline constexpr const char* kOutOfMemory =
    "out of memory: the machine or the limit of this process has too little; use coarser grids or "
    "fewer threads";

/// Runs one task of a run and catches a lack of memory, so that the other tasks continue. Unwinding
/// the stack frees the memory of the task. A thread that cannot allocate its stack counts as well.
/// @return whether the task was completed
/// @throws any other exception of the task
template <class Part>
bool try_within_memory(const Part& part) {
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
