#include "numerics/linear_algebra/subtract_product.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <vector>

namespace fpkcheck::numerics {
namespace {

std::vector<SubtractProductKernel*> all_kinds() {
  std::vector<SubtractProductKernel*> kinds{baseline::subtract_product, subtract_product};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) kinds.push_back(avx2::subtract_product);
  if (__builtin_cpu_supports("avx512f")) kinds.push_back(avx512::subtract_product);
#endif
  return kinds;
}

TEST(SubtractProductKernel, IsTheProductForAnyShapeAndOrder) {
  for (const auto& [m, n, k] : {std::array{1, 1, 1}, {37, 19, 23}, {24, 8, 5}, {50, 3, 1}}) {
    const Eigen::MatrixXd a = Eigen::MatrixXd::Random(m + 2, k), b = Eigen::MatrixXd::Random(k, n);
    const Eigen::MatrixXd c = Eigen::MatrixXd::Random(m + 3, n), bt = b.transpose();
    Eigen::MatrixXd expected = c;
    expected.topRows(m) -= a.bottomRows(m) * b;
    Eigen::MatrixXd first;
    for (SubtractProductKernel* const multiply : all_kinds()) {
      Eigen::MatrixXd by_columns = c, by_rows = c;
      multiply(by_columns.data(), m + 3, {&a(2, 0), 1, m + 2}, {b.data(), 1, k}, m, n, k);
      multiply(by_rows.data(), m + 3, {&a(2, 0), 1, m + 2}, {bt.data(), n, 1}, m, n, k);
      EXPECT_LT((by_columns - expected).cwiseAbs().maxCoeff(), 1e-13);
      EXPECT_EQ(by_columns, by_rows);
      if (first.size() == 0) first = by_columns;
      EXPECT_EQ(by_columns, first);  // bit-identical
    }
  }
}

}  // namespace
}  // namespace fpkcheck::numerics
