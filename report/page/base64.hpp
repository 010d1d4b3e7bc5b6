#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace fpkcheck::report {

/// Bytes as they may stand in a text.
std::string base64(std::span<const std::byte> bytes);

}  // namespace fpkcheck::report
