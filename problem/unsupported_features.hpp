#pragma once

#include <span>
#include <string>
#include <string_view>

namespace fpkcheck::problem {

/// A feature that the program does not treat, with the words that ask for it in keys of case files
/// and in commands.
struct UnsupportedFeature {
  std::string_view subject;  ///< "dry friction"
  /// Lower case; matched with each part of a key between '.' and '_'.
  std::span<const std::string_view> words;
};

/// All unsupported features, as listed in README.md.
std::span<const UnsupportedFeature> unsupported_features();

/// One line naming the unsupported feature that a key or command asks for; empty where there is
/// none.
/// @param name "system.friction", "passage"
std::string unsupported_feature_text(std::string_view name);

}  // namespace fpkcheck::problem
