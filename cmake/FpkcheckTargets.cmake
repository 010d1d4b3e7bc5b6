# One CMake library per folder. A folder's headers are visible only to the targets that link it: each
# library exports one directory that contains nothing but a link to its own folder, so that
# `#include "fd_fpk/operator.hpp"` compiles only where the link line allows it.
add_library(fpkcheck_flags INTERFACE)
target_compile_options(fpkcheck_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                                -Wno-sign-conversion)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 sees overlapping copies in `"text" + std::string` (GCC bug 105651).
  target_compile_options(fpkcheck_flags INTERFACE -Wno-restrict)
endif()
if(FPKCHECK_WARNINGS_AS_ERRORS)
  target_compile_options(fpkcheck_flags INTERFACE -Werror)
endif()
if(FPKCHECK_SANITIZE)
  target_compile_options(fpkcheck_flags INTERFACE -fsanitize=address,undefined
                                                  -fno-omit-frame-pointer)
  target_link_options(fpkcheck_flags INTERFACE -fsanitize=address,undefined)
endif()

# What only formats, reads or checks need not be optimised hard. At -O1 GCC sees too little of what is
# inlined to know what is initialized.
function(fpkcheck_compile_fast target)
  target_compile_options(
    ${target} PRIVATE $<$<CONFIG:Release>:-O1>
                      $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>)
endfunction()

# fpkcheck_library(NAME [PLAIN] SOURCES file... USES library... EXTERNAL target... INTERNAL target...)
#   PLAIN     nothing in it computes for long: compiled fast rather than for speed
#   USES      folders of this project that the folder may use (their headers become visible)
#   EXTERNAL  third-party targets that appear in its headers
#   INTERNAL  third-party targets that appear in its sources only
function(fpkcheck_library name)
  cmake_parse_arguments(arg "PLAIN" "" "SOURCES;USES;EXTERNAL;INTERNAL" ${ARGN})
  add_library(fpkcheck_${name} STATIC ${arg_SOURCES})
  add_library(fpkcheck::${name} ALIAS fpkcheck_${name})
  set_target_properties(fpkcheck_${name} PROPERTIES EXPORT_NAME ${name})
  set_property(GLOBAL APPEND PROPERTY FPKCHECK_ROOMS ${name})
  set(view "${PROJECT_BINARY_DIR}/include/${name}")
  # The second link is for other projects: they include <fpkcheck/NAME/...>, installed or not.
  file(MAKE_DIRECTORY "${view}/fpkcheck")
  file(CREATE_LINK "${CMAKE_CURRENT_SOURCE_DIR}" "${view}/${name}" SYMBOLIC)
  file(CREATE_LINK "${CMAKE_CURRENT_SOURCE_DIR}" "${view}/fpkcheck/${name}" SYMBOLIC)
  target_include_directories(
    fpkcheck_${name} PUBLIC "$<BUILD_INTERFACE:${view}>"
                            "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
  target_compile_features(fpkcheck_${name} PUBLIC cxx_std_20)
  list(TRANSFORM arg_USES PREPEND fpkcheck_)
  target_link_libraries(fpkcheck_${name} PUBLIC ${arg_USES} ${arg_EXTERNAL}
                                         PRIVATE ${arg_INTERNAL} "$<BUILD_INTERFACE:fpkcheck_flags>")
  if(arg_PLAIN)
    fpkcheck_compile_fast(fpkcheck_${name})
  endif()
endfunction()
