#include "fd_fpk/linear/klu.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace fpkcheck::fd_fpk {
namespace {

// A five-point operator with advection on a square, large enough that its dissection uses many
// random numbers.
SparseColumnMatrix square(int n) {
  std::vector<Eigen::Triplet<double, SparseColumnMatrix::StorageIndex>> entries;
  const auto at = [n](int i, int j) { return SparseColumnMatrix::StorageIndex{i} * n + j; };
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

}  // namespace
}  // namespace fpkcheck::fd_fpk
