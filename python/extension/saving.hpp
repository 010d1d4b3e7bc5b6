#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "results/run.hpp"

namespace fpkcheck::python {

/// Writes what `fpkcheck run --out` writes, in a thread of its own.
/// @param look called by the calling thread about twenty times a second; after what it throws the
///             files are written to their end, and pictures left out
/// @return warnings, one line each, about pictures that could not be drawn
/// @throws InputError when the directory cannot be used, std::runtime_error when a file cannot be
///         written, and what `look` throws
std::vector<std::string> save(const std::filesystem::path& directory, const results::Run& run,
                              const std::function<void()>& look);

/// Reads what save() or `fpkcheck run --out` wrote.
/// @throws InputError as results::load_run
results::Run load(const std::filesystem::path& directory);

}  // namespace fpkcheck::python
