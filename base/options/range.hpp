#pragma once

#include <functional>
#include <string>

namespace fpkcheck::base {

/// The admissible values of a number.
struct Range {
  std::function<bool(double)> holds;
  std::string allowed;  ///< text after "must be": "a positive number"

  /// The same range with a reason added to its text: "a positive number: without damping ..."
  Range because(const std::string& reason) const { return {holds, allowed + ": " + reason}; }
};

/// All finite numbers.
Range any_number();
Range positive();
Range not_negative();
Range between(double least, double greatest);           ///< both ends included
Range strictly_between(double least, double greatest);  ///< both ends excluded
Range even_between(int least, int greatest);            ///< even integers, both ends included

}  // namespace fpkcheck::base
