#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "methods/registry.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// Subset of the points of a sweep plan, which one process solves independently of the other
/// shards.
struct SweepShard {
  std::size_t number = 1, of = 1;  ///< number of this shard (1 .. of), and number of shards

  /// Returns the numbers of the points in a shard, which are every `of`-th point of the plan.
  /// Neighbouring points of the plan, which have similar solve times, are therefore in different
  /// shards.
  std::vector<std::size_t> shard_point_numbers(std::size_t total_points) const;
  /// Returns the shard that contains a sweep point, if the plan is divided into `of` shards.
  static SweepShard shard_containing_point(std::size_t point, std::size_t of) {
    return {point % of + 1, of};
  }
  /// Returns the file name of the journal of a shard, e.g. "journal" or "journal.3-of-16".
  std::string shard_journal_name() const;
};

/// Returns the shard to which a journal with the given file name belongs; empty for other file
/// names.
std::optional<SweepShard> shard_of_journal(std::string_view name);

/// Parses the text "i/N", which denotes shard i of N shards.
/// @throws InputError if the text has another form
SweepShard parse_shard(std::string_view text);

struct MergedSweep {
  SweepResults results;
  std::vector<std::string> remarks{};  ///< remarks on missing points and damaged lines
};

/// Joins the results of all sweep journals in the given directories.
/// @throws InputError with a message of one line if a directory has no journal, or if the journals
///         have different plans
MergedSweep merge_sweep_journals(const std::vector<std::filesystem::path>& directories,
                                 const methods::SolverRegistry& registry);

}  // namespace fpkcheck::sweep
