#include "workflows/sweep/execution/shard.hpp"

#include <fmt/format.h>

#include <charconv>

#include "base/input_error.hpp"
#include "base/text/sanitise.hpp"

namespace fpkcheck::sweep {
namespace {

std::optional<Shard> parse_shard_numbers(std::string_view text, std::string_view separator) {
  Shard shard;
  const char *const begin = text.data(), *const end = begin + text.size();
  const auto [middle, first_error] = std::from_chars(begin, end, shard.number);
  if (first_error != std::errc() || !std::string_view(middle, end).starts_with(separator)) {
    return std::nullopt;
  }
  const auto [stop, error] = std::from_chars(middle + separator.size(), end, shard.of);
  const bool whole = error == std::errc() && stop == end;
  if (!whole || shard.number < 1 || shard.number > shard.of) return std::nullopt;
  return shard;
}

}  // namespace

std::vector<std::size_t> Shard::points(std::size_t total) const {
  std::vector<std::size_t> own_points;
  for (std::size_t p = number - 1; p < total; p += of) own_points.push_back(p);
  return own_points;
}

std::string Shard::journal_name() const {
  return of == 1 ? "journal" : fmt::format("journal.{}-of-{}", number, of);
}

std::optional<Shard> shard_of_journal(std::string_view name) {
  if (name == "journal") return Shard{};
  constexpr std::string_view kBefore = "journal.";
  if (!name.starts_with(kBefore)) return std::nullopt;
  return parse_shard_numbers(name.substr(kBefore.size()), "-of-");
}

Shard parse_shard(std::string_view text) {
  if (const auto shard = parse_shard_numbers(text, "/")) return *shard;
  throw InputError(fmt::format("--shard {} (must be i/N with 1 <= i <= N)", base::in_quotes(text)));
}

}  // namespace fpkcheck::sweep
