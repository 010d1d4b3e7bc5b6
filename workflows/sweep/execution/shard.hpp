#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fpkcheck::sweep {

/// A shard: a subset of the points of a plan that is solved independently of the other shards.
struct Shard {
  std::size_t number = 1, of = 1;  ///< number 1 .. of

  /// The points of this shard: every `of`-th point, so that neighbouring points, which have similar
  /// times, are in different shards.
  std::vector<std::size_t> points(std::size_t total) const;
  /// The shard, out of `of` shards, that contains the given point.
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

}  // namespace fpkcheck::sweep
