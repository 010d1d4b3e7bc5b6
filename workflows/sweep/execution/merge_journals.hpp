#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "methods/registry.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// The joined results of several journals of one sweep.
struct MergedSweep {
  SweepResults results;
  std::vector<std::string> remarks{};  ///< on missing points and damaged lines
};

/// Reads all journals in the directories and joins their results.
/// @throws InputError with a message of one line if a directory has no journal, or if the journals
///         have different plans
MergedSweep merge_journals(const std::vector<std::filesystem::path>& directories,
                           const methods::Registry& registry);

}  // namespace fpkcheck::sweep
