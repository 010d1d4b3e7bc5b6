#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "results/run.hpp"

namespace fpkcheck::python {

/// Writes the files of `fpkcheck run --out` in a separate thread.
/// @param poll called by the calling thread about twenty times a second. After an
///        exception from it, the files are completed and figures are omitted
/// @return warnings, one line each, about figures that could not be drawn
/// @throws InputError when the directory cannot be used; std::runtime_error when a file cannot be
///         written; the exceptions of `poll`
std::vector<std::string> save(const std::filesystem::path& directory, const results::Run& run,
                              const std::function<void()>& poll);

/// Reads the files of save() or of `fpkcheck run --out`.
/// @throws InputError as results::load_run
results::Run load(const std::filesystem::path& directory);

}  // namespace fpkcheck::python
