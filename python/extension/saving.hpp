#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "results/run.hpp"

namespace fpkcheck::python {

/// Writes the same files as `fpkcheck run --out` into a directory. A separate thread writes the
/// files.
/// @param poll function that the calling thread calls about twenty times a second. After an
///        exception of `poll`, the files are completed but figures are omitted
/// @return warnings about figures that could not be drawn, each of one line
/// @throws InputError when the directory cannot be used
/// @throws std::runtime_error when a file cannot be written
/// @throws the exceptions of `poll`
std::vector<std::string> save(const std::filesystem::path& directory, const results::Run& run,
                              const std::function<void()>& poll);

/// Reads the files of a run that save() or `fpkcheck run --out` wrote.
/// @throws InputError as results::load_run()
results::Run load(const std::filesystem::path& directory);

}  // namespace fpkcheck::python
