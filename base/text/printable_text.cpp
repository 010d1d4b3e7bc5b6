#include "base/text/printable_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace fpkcheck::base {
namespace {

constexpr std::string_view kEllipsis = "...";

/// Returns the length in bytes of the first UTF-8 character of a text; 0 for invalid UTF-8, control
/// characters and marks of bidirectional text.
std::size_t printable_length(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned first = byte(0);
  if (first < 0x80) return first < 0x20 || first == 0x7f ? 0 : 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < length) return 0;
  unsigned code = first & (0x7fU >> length);
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(k) & 0xc0U) != 0x80) return 0;
    code = code << 6U | (byte(k) & 0x3fU);
  }
  const bool shortest = code >= (length == 4 ? 0x10000U : length == 3 ? 0x800U : 0xa0U);
  const bool surrogate = code >= 0xd800 && code <= 0xdfff;
  // Unicode marks of the bidirectional algorithm, which change the direction of the following text.
  const bool turns = (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
  const bool line_end = code == 0x2028 || code == 0x2029;
  return shortest && !surrogate && !turns && !line_end && code <= 0x10ffff ? length : 0;
}

/// Removes the first character from a text and returns the character, or an escape for an
/// unprintable byte.
std::string take_printable(std::string_view& text) {
  const std::size_t length = printable_length(text);
  std::string character = length > 0
                              ? std::string(text.substr(0, length))
                              : fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
  text.remove_prefix(length > 0 ? length : 1);
  return character;
}

/// Returns the first characters of a text that fit into `max_columns` columns, with unprintable
/// bytes as escapes of four columns.
std::string leading_columns(std::string_view text, std::size_t max_columns) {
  std::string result;
  for (std::size_t used = 0; !text.empty();) {
    const std::string character = take_printable(text);
    used += character.front() == '\\' ? character.size() : 1;
    if (used > max_columns) break;
    result += character;
  }
  return result;
}

std::size_t characters(std::string_view text) {
  std::size_t count = 0;
  for (const char c : text) count += (static_cast<unsigned char>(c) & 0xc0U) != 0x80 ? 1 : 0;
  return count;
}

}  // namespace

std::string escape_control_characters(std::string_view text) {
  std::string result;
  while (!text.empty()) result += take_printable(text);
  return result;
}

std::string to_printable_text(std::string_view text) {
  constexpr std::size_t kMaxColumns = 80, kHead = 40,
                        kTail = kMaxColumns - kHead - kEllipsis.size();
  // Only the beginning and the end of a long text are processed and shown.
  constexpr std::size_t kBytes = 4 * kMaxColumns;
  if (text.size() <= kBytes) {
    std::string whole = escape_control_characters(text);
    if (characters(whole) <= kMaxColumns) return whole;
  }
  // The end of a long text is kept, since the end of a path is the name of the file.
  std::string_view tail = text.substr(text.size() - std::min(text.size(), kTail));
  while (!tail.empty() && (static_cast<unsigned char>(tail.front()) & 0xc0U) == 0x80) {
    tail.remove_prefix(1);
  }
  std::string end = escape_control_characters(tail);
  while (characters(end) > kTail) {
    const std::size_t drop = end.find_first_of('\\', 1);
    end.erase(0, drop == std::string::npos ? end.size() - kTail : drop);
  }
  return leading_columns(text, kHead) + std::string(kEllipsis) + end;
}

std::string in_quotes(std::string_view text) { return '\'' + to_printable_text(text) + '\''; }

std::string to_single_line(std::string_view text) {
  constexpr std::size_t kMaxColumns = 380;
  if (text.size() <= kMaxColumns) {
    std::string whole = escape_control_characters(text);
    if (characters(whole) <= kMaxColumns) return whole;
  }
  return leading_columns(text, kMaxColumns - kEllipsis.size()) + std::string(kEllipsis);
}

}  // namespace fpkcheck::base
