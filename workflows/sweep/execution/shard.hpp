#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fpkcheck::sweep {

/// A part of a plan that is solved independently of the other parts.
struct Shard {
  std::size_t number = 1, of = 1;  ///< number 1 .. of

  /// Points of this shard: each `of`-th point, so that neighbours, which have similar times, are in
  /// different shards.
  std::vector<std::size_t> points(std::size_t total) const;
  /// The shard, out of `of` shards, that contains this point.
  static Shard containing(std::size_t point, std::size_t of) { return {point % of + 1, of}; }
  /// Name of the journal: "journal", or "journal.3-of-16".
  std::string journal_name() const;
};

/// The shard that writes the journal of this name; empty where the name is no journal of a shard.
std::optional<Shard> shard_of_journal(std::string_view name);

/// @throws InputError where the text is not i/N
Shard parse_shard(std::string_view text);

}  // namespace fpkcheck::sweep
