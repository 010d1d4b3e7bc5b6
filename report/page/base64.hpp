#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace fpkcheck::report {

/// Base64 encoding of bytes (RFC 4648).
std::string encode_base64(std::span<const std::byte> bytes);

}  // namespace fpkcheck::report
