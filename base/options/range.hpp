#pragma once

#include <functional>
#include <string>

namespace fpkcheck::base {

/// The admissible values of a number.
struct Range {
  std::function<bool(double)> contains;
  std::string requirement;  ///< text after "must be": "a positive number"

  /// The same range with a reason added to its text: "a positive number: without damping ..."
  Range with_reason(const std::string& reason) const {
    return {contains, requirement + ": " + reason};
  }
};

/// All finite numbers.
Range finite_number();
Range positive();
Range non_negative();
Range between(double least, double greatest);           ///< both ends included
Range strictly_between(double least, double greatest);  ///< both ends excluded
Range even_between(int least, int greatest);            ///< even integers, both ends included

}  // namespace fpkcheck::base
