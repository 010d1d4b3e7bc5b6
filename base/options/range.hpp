#pragma once

#include <functional>
#include <string>

namespace fpkcheck::base {

/// The set of admissible values of a numerical parameter.
struct Range {
  std::function<bool(double)> contains;
  std::string requirement;  ///< text that follows "must be": "a positive number"

  /// The same set of values, with a reason appended to the requirement: "a positive number: without
  /// damping ..."
  Range with_reason(const std::string& reason) const {
    return {contains, requirement + ": " + reason};
  }
};

/// The range of all finite numbers.
Range finite_number();
Range positive();
Range non_negative();
Range between(double least, double greatest);           ///< closed interval
Range strictly_between(double least, double greatest);  ///< open interval
Range even_between(int least, int greatest);            ///< even integers from least to greatest

}  // namespace fpkcheck::base
