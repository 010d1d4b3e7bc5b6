#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fpkcheck::sweep {

/// One of several parts of a plan that are solved apart from one another.
struct Shard {
  std::size_t number = 1, of = 1;  ///< 1 .. of

  /// Its points: each `of`-th, so that neighbours, which take as long, are in different shards.
  std::vector<std::size_t> points(std::size_t total) const;
  /// The shard, of so many, that has this point.
  static Shard holding(std::size_t point, std::size_t of) { return {point % of + 1, of}; }
  /// "journal", or "journal.3-of-16".
  std::string journal_name() const;
};

/// The shard that writes a journal of this name; nothing where no shard does.
std::optional<Shard> shard_of_journal(std::string_view name);

/// @throws InputError where the text is not i/N
Shard shard_from(std::string_view text);

}  // namespace fpkcheck::sweep
