#pragma once

#include <functional>
#include <string>

namespace fpkcheck::base {

/// What is allowed of a number.
struct Range {
  std::function<bool(double)> holds;
  std::string allowed;  ///< after "must be": "a positive number"

  /// The same range with the reason for it: "a positive number: without damping ..."
  Range because(const std::string& reason) const { return {holds, allowed + ": " + reason}; }
};

/// Finite numbers (all of them).
Range any_number();
Range positive();
Range not_negative();
Range between(double least, double greatest);           ///< both ends included
Range strictly_between(double least, double greatest);  ///< neither
Range even_between(int least, int greatest);            ///< integers

}  // namespace fpkcheck::base
