#pragma once

#include <functional>
#include <string>

namespace fpkcheck::base {

/// The set of admissible values of a numerical parameter.
struct AdmissibleRange {
  std::function<bool(double)> contains;
  std::string requirement;  ///< text that follows "must be": "a positive number"

  /// The same set of values, with a reason appended to the requirement: "a positive number: without
  /// damping ..."
  AdmissibleRange with_appended_reason(const std::string& reason) const {
    return {contains, requirement + ": " + reason};
  }
};

/// The range of all finite numbers.
AdmissibleRange finite_numbers();
AdmissibleRange positive_numbers();
AdmissibleRange non_negative_numbers();
AdmissibleRange closed_interval(double least, double greatest);  ///< closed interval
AdmissibleRange open_interval(double least, double greatest);    ///< open interval
AdmissibleRange even_integers_between(int least,
                                      int greatest);  ///< even integers from least to greatest

}  // namespace fpkcheck::base
