#pragma once

#include <string>
#include <string_view>

namespace fpkcheck::report {

/// Compresses a text by gzip (RFC 1952) and encodes the result in base64; page.js unpacks the
/// result by DecompressionStream. Equal texts give equal results.
/// @throws std::bad_alloc
std::string gzip_base64(std::string_view text);

}  // namespace fpkcheck::report
