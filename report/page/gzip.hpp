#pragma once

#include <string>
#include <string_view>

namespace fpkcheck::report {

/// A text in gzip's format (RFC 1952) and base64: what page.js unpacks by DecompressionStream. The
/// same text gives the same bytes.
/// @throws std::bad_alloc
std::string gzip_base64(std::string_view text);

}  // namespace fpkcheck::report
