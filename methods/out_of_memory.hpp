#pragma once

#include <new>
#include <system_error>

namespace fpkcheck::methods {

/// The `reason` of a solution, or of guaranteed bounds, that could not be computed for lack of
/// memory.
inline constexpr const char* kOutOfMemory =
    "out of memory: the machine or the limit of this process has too little; use coarser grids or "
    "fewer threads";

/// Calls a function, one of the tasks of a run, and catches exceptions due to a lack of memory. The
/// other tasks of the run can then continue, since unwinding the stack frees the memory of this
/// task. The failure to start a thread, whose stack cannot be allocated, is also a lack of memory.
/// @return whether the function returned without a lack of memory
/// @throws any other exception of the function
template <class Function>
bool try_within_memory(const Function& function) {
  try {
    function();
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
