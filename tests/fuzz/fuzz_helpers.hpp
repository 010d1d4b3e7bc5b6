#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/input_error.hpp"

/// Functions shared by the fuzzers.
namespace fpkcheck::fuzz {

inline std::string_view as_text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Calls read(). An InputError is the expected refusal of an input; other exceptions end the
/// fuzzer.
template <class Read>
int catch_input_errors(Read read) {
  try {
    read();
  } catch (const InputError&) {
  }
  return 0;
}

/// Ends the fuzzer, with a finding, if the condition is false.
inline void require(bool holds) {
  if (!holds) std::abort();
}

/// A temporary directory of this process, for readers of files. The caller of the fuzzer removes
/// the contents of $TMPDIR.
inline const std::filesystem::path& directory() {
  static const std::filesystem::path made = [] {
    std::string name = (std::filesystem::temp_directory_path() / "fuzz-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary directory");
    return name;
  }();
  return made;
}

/// Writes a file to directory() and returns its path.
inline std::filesystem::path write_file(const std::string& name, std::string_view contents) {
  const auto file = directory() / name;
  std::ofstream out(file, std::ios::binary);
  out.write(contents.data(), static_cast<std::streamsize>(contents.size()));
  return file;
}

}  // namespace fpkcheck::fuzz
