#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "methods/registry.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// What several journals have together.
struct Merged {
  SweepResults results;
  std::vector<std::string> remarks{};  ///< points that are missing, lines that were damaged
};

/// Reads every journal in the directories.
/// @throws InputError on one line where there is none, or where they are of different plans
Merged merged(const std::vector<std::filesystem::path>& directories,
              const methods::Registry& registry);

}  // namespace fpkcheck::sweep
