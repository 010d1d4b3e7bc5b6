#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "methods/registry.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// Joined content of several journals.
struct MergedSweep {
  SweepResults results;
  std::vector<std::string> remarks{};  ///< on missing points and damaged lines
};

/// Reads and joins all journals in the directories.
/// @throws InputError with a message of one line, where a directory has no journal or the plans
///         differ
MergedSweep merge_journals(const std::vector<std::filesystem::path>& directories,
                           const methods::Registry& registry);

}  // namespace fpkcheck::sweep
