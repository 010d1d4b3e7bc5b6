#include "fd_fpk/linear/klu.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <thread>
#include <vector>

namespace fpkcheck::fd_fpk {
namespace {

// A five-point operator with advection on a square, large enough that its dissection uses many
// random numbers.
SparseColumnMatrix square(int n) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto at = [n](int i, int j) { return i * n + j; };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      entries.emplace_back(at(i, j), at(i, j), 4.1);
      if (i > 0) entries.emplace_back(at(i, j), at(i - 1, j), -1.3);
      if (i + 1 < n) entries.emplace_back(at(i, j), at(i + 1, j), -0.7);
      if (j > 0) entries.emplace_back(at(i, j), at(i, j - 1), -1.1);
      if (j + 1 < n) entries.emplace_back(at(i, j), at(i, j + 1), -0.9);
    }
  }
  SparseColumnMatrix matrix(n * n, n * n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

struct Solved {
  Eigen::VectorXd x;
  long entries;
};

Solved solved(int n) {
  const SparseColumnMatrix matrix = square(n);
  KluFactorisation klu;
  EXPECT_TRUE(klu.factorise(matrix)) << klu.failure_reason();
  Solved result{Eigen::VectorXd::LinSpaced(matrix.cols(), 1, 2), klu.factor_entry_count()};
  klu.solve_in_place(result.x);
  return result;
}

TEST(Klu, SolvesTheSystemsOfTheMatrixAndOfItsTranspose) {
  const SparseColumnMatrix matrix = square(12);
  KluFactorisation klu;
  ASSERT_TRUE(klu.factorise(matrix)) << klu.failure_reason();
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(matrix.cols(), 1, 2);
  Eigen::VectorXd x = right, transposed = right;
  klu.solve_in_place(x);
  klu.solve_transposed_in_place(transposed);
  EXPECT_LT((matrix * x - right).norm(), 1e-11 * right.norm());
  EXPECT_LT((matrix.transpose() * transposed - right).norm(), 1e-11 * right.norm());
  EXPECT_GT((x - transposed).norm(), 1e-3 * x.norm());
}

// METIS uses random numbers that the whole process shares.
TEST(Klu, GivesTheSameBitsInParallelAsAlone) {
  constexpr int kCells = 90, kRounds = 5;
  const Solved alone = solved(kCells);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Solved> beside(4);
    {
      std::vector<std::jthread> threads;
      for (std::size_t t = 0; t < beside.size(); ++t) {
        // Every second matrix has a different size, and so a different run time.
        threads.emplace_back([&, t] { beside[t] = solved(t % 2 == 0 ? kCells : kCells - 17); });
      }
    }
    for (const std::size_t t : {0, 2}) {
      EXPECT_EQ(beside[t].entries, alone.entries);
      EXPECT_TRUE(beside[t].x == alone.x);
    }
  }
}

// The five-point operator on n x n cells, times a factor.
SparseColumnMatrix five_points(int n, double factor = 1, bool with_corner = false) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto cell = [n](int i, int j) { return i * n + j; };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      entries.emplace_back(cell(i, j), cell(i, j), 4 * factor);
      if (i > 0) entries.emplace_back(cell(i, j), cell(i - 1, j), -factor);
      if (i + 1 < n) entries.emplace_back(cell(i, j), cell(i + 1, j), -factor);
      if (j > 0) entries.emplace_back(cell(i, j), cell(i, j - 1), -factor);
      if (j + 1 < n) entries.emplace_back(cell(i, j), cell(i, j + 1), -factor);
    }
  }
  if (with_corner) entries.emplace_back(0, n * n - 1, factor);
  SparseColumnMatrix matrix(n * n, n * n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

TEST(Ordering, IsAPermutation) {
  auto order = fill_reducing_ordering(five_points(31));
  ASSERT_EQ(order.size(), 31 * 31);
  std::ranges::sort(order);
  std::vector<int> all(order.size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(order, all);
}

// The ordering depends on the pattern alone, for repeated calls and for several threads.
TEST(Ordering, DependsOnThePatternAlone) {
  const auto order = fill_reducing_ordering(five_points(30));
  EXPECT_EQ(fill_reducing_ordering(five_points(30, 7)), order);
  EXPECT_NE(fill_reducing_ordering(five_points(30, 1, true)), order);
  EXPECT_NE(fill_reducing_ordering(five_points(29)).size(), order.size());
  std::vector<std::vector<int>> found(4);
  {
    std::vector<std::jthread> threads;
    for (auto& one : found)
      threads.emplace_back([&one] { one = fill_reducing_ordering(five_points(30, 2)); });
  }
  for (const auto& one : found) EXPECT_EQ(one, order);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
