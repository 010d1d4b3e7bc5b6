#pragma once

#include <string>
#include <string_view>

namespace fpkcheck::report {

/// A text compressed by gzip (RFC 1952) and encoded in base64; page.js unpacks it by
/// DecompressionStream. Equal texts give equal results.
/// @throws std::bad_alloc
std::string gzip_base64(std::string_view text);

}  // namespace fpkcheck::report
