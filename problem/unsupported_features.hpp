#pragma once

#include <span>
#include <string>
#include <string_view>

namespace fpkcheck::problem {

/// A feature that the program does not support, with the words by which keys of case files and
/// commands request the feature.
struct UnsupportedFeature {
  std::string_view subject;  ///< name of the feature: "dry friction"
  /// Words in lower case. Each word is compared with the parts into which '.' and '_' split a key.
  std::span<const std::string_view> words;
};

/// All unsupported features, in agreement with the list in README.md.
std::span<const UnsupportedFeature> unsupported_features();

/// One line that names the unsupported feature which a key or a command requests. Empty if the name
/// requests no unsupported feature.
/// @param name key or command: "system.friction", "passage"
std::string unsupported_feature_message(std::string_view name);

}  // namespace fpkcheck::problem
