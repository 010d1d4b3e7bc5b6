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

/// A shard: a subset of the points of a plan that is solved independently of the other shards.
struct Shard {
  std::size_t number = 1, of = 1;  ///< number 1 .. of

  /// The points of this shard: every `of`-th point, so that neighbouring points, which have similar
  /// times, are in different shards.
  std::vector<std::size_t> points(std::size_t total) const;
  /// The shard that contains a point, if the plan is divided into `of` shards.
  static Shard containing(std::size_t point, std::size_t of) { return {point % of + 1, of}; }
  /// The file name of the shard's journal: "journal", or "journal.3-of-16".
  std::string journal_name() const;
};

/// The shard that writes the journal with the given file name; empty if the name is not the name of
/// a shard's journal.
std::optional<Shard> shard_of_journal(std::string_view name);

/// Parses the text i/N of a shard.
/// @throws InputError if the text has another form
Shard parse_shard(std::string_view text);

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
