#include "sweep/execution/shard.hpp"

#include <fmt/format.h>

#include <charconv>

#include "parameters/input_error.hpp"
#include "parameters/shown.hpp"

namespace fpkcheck::sweep {

std::vector<std::size_t> Shard::points(std::size_t total) const {
  std::vector<std::size_t> own;
  for (std::size_t p = number - 1; p < total; p += of) own.push_back(p);
  return own;
}

std::string Shard::journal_name() const {
  return of == 1 ? "journal" : fmt::format("journal.{}-of-{}", number, of);
}

Shard shard_from(std::string_view text) {
  Shard shard;
  const char *const begin = text.data(), *const end = begin + text.size();
  const auto [slash, first_error] = std::from_chars(begin, end, shard.number);
  if (first_error == std::errc() && slash != end && *slash == '/') {
    const auto [stop, error] = std::from_chars(slash + 1, end, shard.of);
    if (error == std::errc() && stop == end && shard.number >= 1 && shard.number <= shard.of) {
      return shard;
    }
  }
  throw InputError(
      fmt::format("--shard {} (must be i/N with 1 <= i <= N)", parameters::in_quotes(text)));
}

}  // namespace fpkcheck::sweep
