# One CMake library per folder. The headers of a folder are visible only to targets that link its
# library: each library exports an include directory that contains only a link to its folder. Thus
# `#include "fd_fpk/operator.hpp"` compiles only in targets that link fpkcheck_fd_fpk.
add_library(fpkcheck_flags INTERFACE)
target_compile_options(fpkcheck_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                                -Wno-sign-conversion)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 warns wrongly of overlapping copies in `"text" + std::string` (GCC bug 105651).
  target_compile_options(fpkcheck_flags INTERFACE -Wno-restrict)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
  # GCC 13 and 14 warn of a dangling reference for every function that takes a temporary and returns
  # a reference, whatever its referent (GCC bug 107532).
  target_compile_options(fpkcheck_flags INTERFACE -Wno-dangling-reference)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Without garbage collections GCC needs 5 to 9 % less time, and up to 250 MB more memory than 0.9 GB per process.
  target_compile_options(fpkcheck_flags INTERFACE --param=ggc-min-heapsize=2000000)
endif()
if(FPKCHECK_WARNINGS_AS_ERRORS)
  target_compile_options(fpkcheck_flags INTERFACE -Werror)
endif()
# Compile options for sanitizers and fuzzers. The first report of a sanitizer ends the program, so that
# the test fails.
add_library(fpkcheck_watch INTERFACE)
set(FPKCHECK_UNWATCHED "") # libraries without these options
if(FPKCHECK_SANITIZE)
  set(sanitizers -fsanitize=${FPKCHECK_SANITIZE} -fno-sanitize-recover=all)
  target_compile_options(fpkcheck_watch INTERFACE ${sanitizers} -fno-omit-frame-pointer)
  target_link_options(fpkcheck_flags INTERFACE ${sanitizers})
endif()
if(FPKCHECK_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "FPKCHECK_FUZZ needs Clang (-DCMAKE_CXX_COMPILER=clang++)")
  endif()
  # The fuzzers measure the branch coverage of the readers. They never solve a problem: the solvers,
  # which take most of the build time, are compiled without these options.
  target_compile_options(fpkcheck_watch INTERFACE -fsanitize=fuzzer-no-link)
  set(FPKCHECK_UNWATCHED epc fd_fpk backward control_variates)
endif()

# Compiles code that only formats, reads or checks with -O1, to save build time. At -O1 GCC inlines too
# little and warns wrongly of uninitialised variables.
function(fpkcheck_compile_fast target)
  target_compile_options(
    ${target} PRIVATE $<$<CONFIG:Release>:-O1>
                      $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>)
endfunction()

# fpkcheck_precompile(TARGET MODEL): TARGET uses the precompiled headers of the target MODEL, an empty library, if both
# have the same compile options. Otherwise a fifth of the build would parse these headers. A source must still include
# what it uses: scripts/compile-alone compiles without them.
function(fpkcheck_precompile target model)
  set(headers <algorithm> <array> <cmath> <filesystem> <functional> <map> <numbers> <optional> <set> <span> <sstream>
              <string> <string_view> <variant> <vector> <fmt/format.h> <fmt/ranges.h>)
  if(model STREQUAL "tests")
    list(APPEND headers <gtest/gtest.h>)
  endif()
  if(NOT TARGET fpkcheck_headers_${model})
    set(empty "${PROJECT_BINARY_DIR}/headers_${model}.cpp")
    file(WRITE "${empty}" "")
    add_library(fpkcheck_headers_${model} OBJECT "${empty}")
    target_compile_features(fpkcheck_headers_${model} PUBLIC cxx_std_20)
    target_link_libraries(fpkcheck_headers_${model} PRIVATE fpkcheck_flags fpkcheck_watch fmt::fmt)
    if(model STREQUAL "tests")
      target_link_libraries(fpkcheck_headers_${model} PRIVATE GTest::gtest_main)
    endif()
    if(NOT model STREQUAL "optimised")
      fpkcheck_compile_fast(fpkcheck_headers_${model})
    endif()
    target_precompile_headers(fpkcheck_headers_${model} PRIVATE ${headers})
  endif()
  # The folder of the target may add options after this call.
  cmake_language(EVAL CODE "cmake_language(DEFER DIRECTORY [[${PROJECT_SOURCE_DIR}]] CALL
    fpkcheck_reuse_headers [[${target}]] [[fpkcheck_headers_${model}]])")
endfunction()

function(fpkcheck_reuse_headers target model)
  get_property(of_target TARGET ${target} PROPERTY COMPILE_OPTIONS)
  get_property(of_model TARGET ${model} PROPERTY COMPILE_OPTIONS)
  if("${of_target}" STREQUAL "${of_model}")
    target_precompile_headers(${target} REUSE_FROM ${model})
  endif()
endfunction()

# fpkcheck_library(NAME [PLAIN] [NOT_INSTALLED] SOURCES file... USES library... EXTERNAL target... INTERNAL target...)
#   NOT_INSTALLED  library for tests and benchmarks only
#   PLAIN     library without long computations: compiled with -O1
#   USES      folders of this project whose headers the folder may include
#   EXTERNAL  third-party targets that appear in its headers
#   INTERNAL  third-party targets that appear in its sources only
function(fpkcheck_library name)
  cmake_parse_arguments(arg "PLAIN;NOT_INSTALLED" "" "SOURCES;USES;EXTERNAL;INTERNAL" ${ARGN})
  add_library(fpkcheck_${name} STATIC ${arg_SOURCES})
  add_library(fpkcheck::${name} ALIAS fpkcheck_${name})
  set_target_properties(fpkcheck_${name} PROPERTIES EXPORT_NAME ${name})
  set(folder ${name})
  if(NOT arg_NOT_INSTALLED)
    file(RELATIVE_PATH folder "${PROJECT_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}")
    set_property(GLOBAL APPEND PROPERTY FPKCHECK_LIBRARIES fpkcheck_${name})
    set_property(GLOBAL APPEND PROPERTY FPKCHECK_FOLDERS ${folder})
  endif()
  set(view "${PROJECT_BINARY_DIR}/include/${name}")
  # The second link is for other projects, which include <fpkcheck/FOLDER/...>, installed or not.
  foreach(link IN ITEMS "${view}/${folder}" "${view}/fpkcheck/${folder}")
    get_filename_component(parent "${link}" DIRECTORY)
    file(MAKE_DIRECTORY "${parent}")
    file(CREATE_LINK "${CMAKE_CURRENT_SOURCE_DIR}" "${link}" SYMBOLIC)
  endforeach()
  target_include_directories(
    fpkcheck_${name} PUBLIC "$<BUILD_INTERFACE:${view}>"
                            "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
  target_compile_features(fpkcheck_${name} PUBLIC cxx_std_20)
  list(TRANSFORM arg_USES PREPEND fpkcheck_)
  target_link_libraries(fpkcheck_${name} PUBLIC ${arg_USES} ${arg_EXTERNAL}
                                         PRIVATE ${arg_INTERNAL} "$<BUILD_INTERFACE:fpkcheck_flags>")
  if(NOT name IN_LIST FPKCHECK_UNWATCHED)
    target_link_libraries(fpkcheck_${name} PRIVATE "$<BUILD_INTERFACE:fpkcheck_watch>")
  endif()
  if(arg_PLAIN)
    fpkcheck_compile_fast(fpkcheck_${name})
    fpkcheck_precompile(fpkcheck_${name} plain)
  elseif(NOT name IN_LIST FPKCHECK_UNWATCHED)
    fpkcheck_precompile(fpkcheck_${name} optimised)
  endif()
endfunction()
