#include "fd_fpk/linear/klu.hpp"

#include <cholmod.h>
#include <klu.h>

#include <algorithm>
#include <boost/container_hash/hash.hpp>
#include <cstddef>
#include <cstdint>
#include <list>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace fpkcheck::fd_fpk {
namespace {

// METIS uses one sequence of random numbers of the C library for the whole process. If two threads
// called METIS at the same time, matrix orderings, and thus the last digits of solutions, would
// depend on the timing of the threads.
std::mutex dissection_mutex;

std::vector<int> nested_dissection(const SparseColumnMatrix& matrix) {
  const SparseColumnMatrix symmetric = SparseColumnMatrix(matrix.transpose()) + matrix;
  const auto n = static_cast<std::size_t>(matrix.cols());
  cholmod_sparse graph{};
  graph.nrow = graph.ncol = n;
  graph.nzmax = static_cast<std::size_t>(symmetric.nonZeros());
  // CHOLMOD does not modify the index arrays, despite the non-const interface.
  graph.p = const_cast<SparseColumnMatrix::StorageIndex*>(symmetric.outerIndexPtr());
  graph.i = const_cast<SparseColumnMatrix::StorageIndex*>(symmetric.innerIndexPtr());
  graph.stype = 1;  // a symmetric matrix, of which CHOLMOD reads the upper triangle
  graph.itype = CHOLMOD_INT;
  graph.xtype = CHOLMOD_PATTERN;
  graph.sorted = graph.packed = 1;
  cholmod_common common;
  if (!cholmod_start(&common)) return {};
  common.print = 0;
  // METIS aborts the program when memory is exhausted. CHOLMOD therefore checks in advance that
  // twice the memory that METIS needs is available.
  common.metis_memory = 2;
  std::vector<int> order(n), parents(n), components(n);
  const std::lock_guard alone(dissection_mutex);
  const std::int64_t found = cholmod_nested_dissection(&graph, nullptr, 0, order.data(),
                                                       parents.data(), components.data(), &common);
  cholmod_finish(&common);
  if (found < 0) order.clear();
  return order;
}

/// Key of the sparsity pattern of a matrix. If two sparsity patterns of equal size had equal
/// hashes, one matrix would receive an ordering that is valid but causes more fill-in.
struct MatrixSparsityPattern {
  std::int64_t unknowns, entries;
  std::size_t hash;

  explicit MatrixSparsityPattern(const SparseColumnMatrix& matrix)
      : unknowns(matrix.cols()), entries(matrix.nonZeros()), hash(0) {
    boost::hash_range(hash, matrix.outerIndexPtr(), matrix.outerIndexPtr() + unknowns + 1);
    boost::hash_range(hash, matrix.innerIndexPtr(), matrix.innerIndexPtr() + entries);
  }
  bool operator==(const MatrixSparsityPattern&) const = default;
};

/// Thread-safe cache of the most recently used fill-reducing orderings of matrices.
class MatrixOrderingCache {
 public:
  std::vector<int> find(const MatrixSparsityPattern& pattern) {
    const std::lock_guard lock(mutex_);
    const auto found = std::ranges::find(orders_, pattern, &Entry::first);
    if (found == orders_.end()) return {};
    orders_.splice(orders_.begin(), orders_, found);
    return found->second;
  }
  void put(const MatrixSparsityPattern& pattern, const std::vector<int>& order) {
    const std::lock_guard lock(mutex_);
    orders_.emplace_front(pattern, order);
    unknowns_ += order.size();
    while (unknowns_ > kMostUnknowns && orders_.size() > 1) {
      unknowns_ -= orders_.back().second.size();
      orders_.pop_back();
    }
  }

 private:
  // memory limit of the cached matrix orderings, 32 MB
  static constexpr std::size_t kMostUnknowns = 4'000'000;

  using Entry = std::pair<MatrixSparsityPattern, std::vector<int>>;
  std::mutex mutex_;
  std::list<Entry> orders_;  // most recently used ordering first
  std::size_t unknowns_ = 0;
};

}  // namespace

std::vector<int> fill_reducing_ordering(const SparseColumnMatrix& matrix) {
  static MatrixOrderingCache& cache =
      // the cache of matrix orderings is never destroyed, since threads may use the cache at exit
      *new MatrixOrderingCache;
  const MatrixSparsityPattern pattern(matrix);
  auto order = cache.find(pattern);
  if (!order.empty()) return order;
  order = nested_dissection(matrix);
  if (!order.empty()) cache.put(pattern, order);
  return order;
}

namespace {

// Arrays of a sparse matrix as arguments for KLU, whose interface is not const-correct although KLU
// does not modify the arrays.
struct CompressedColumnArrays {
  SparseColumnMatrix::StorageIndex* columns;
  SparseColumnMatrix::StorageIndex* rows;
  double* values;

  explicit CompressedColumnArrays(const SparseColumnMatrix& matrix)
      : columns(const_cast<SparseColumnMatrix::StorageIndex*>(matrix.outerIndexPtr())),
        rows(const_cast<SparseColumnMatrix::StorageIndex*>(matrix.innerIndexPtr())),
        values(const_cast<double*>(matrix.valuePtr())) {}
};

}  // namespace

struct KluFactorisation::Handles {
  klu_common common{};
  klu_symbolic* symbolic = nullptr;
  klu_numeric* numeric = nullptr;

  Handles() {
    klu_defaults(&common);
    common.btf = 0;  // the operator is irreducible: every cell is reachable from every other cell
  }
  ~Handles() {
    klu_free_numeric(&numeric, &common);
    klu_free_symbolic(&symbolic, &common);
  }
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;
};

KluFactorisation::KluFactorisation() : handles_(std::make_unique<Handles>()) {}
KluFactorisation::~KluFactorisation() = default;
KluFactorisation::KluFactorisation(KluFactorisation&&) noexcept = default;
KluFactorisation& KluFactorisation::operator=(KluFactorisation&&) noexcept = default;

bool KluFactorisation::factorise(const SparseColumnMatrix& matrix) {
  if (factorise_with_old_pivots(matrix)) return true;
  const CompressedColumnArrays arrays(matrix);
  auto& [common, symbolic, numeric] = *handles_;
  klu_free_numeric(&numeric, &common);
  if (symbolic == nullptr) {
    const auto n = static_cast<int>(matrix.cols());
    auto found = fill_reducing_ordering(matrix);
    symbolic = found.empty() ? klu_analyze(n, arrays.columns, arrays.rows, &common)
                             : klu_analyze_given(n, arrays.columns, arrays.rows, found.data(),
                                                 found.data(), &common);
  }
  if (symbolic != nullptr) {
    numeric = klu_factor(arrays.columns, arrays.rows, arrays.values, symbolic, &common);
  }
  return numeric != nullptr && common.status == KLU_OK;
}

// Factors the matrix with the pivots of the last factorisation. Returns false if no earlier
// factorisation exists, or if pivot growth makes the LU factors inaccurate.
bool KluFactorisation::factorise_with_old_pivots(const SparseColumnMatrix& matrix) {
  constexpr double kLeastReciprocalGrowth = 1e-8;
  auto& [common, symbolic, numeric] = *handles_;
  if (numeric == nullptr) return false;
  const CompressedColumnArrays arrays(matrix);
  return klu_refactor(arrays.columns, arrays.rows, arrays.values, symbolic, numeric, &common) &&
         common.status == KLU_OK &&
         klu_rgrowth(arrays.columns, arrays.rows, arrays.values, symbolic, numeric, &common) &&
         common.rgrowth > kLeastReciprocalGrowth;
}

void KluFactorisation::solve_in_place(Eigen::Ref<Eigen::VectorXd> b) const {
  auto& [common, symbolic, numeric] = *handles_;
  if (numeric == nullptr ||
      !klu_solve(symbolic, numeric, static_cast<int>(b.size()), 1, b.data(), &common)) {
    throw std::logic_error("KLU solve without a factorisation");
  }
}

void KluFactorisation::solve_transposed_in_place(Eigen::Ref<Eigen::VectorXd> b) const {
  auto& [common, symbolic, numeric] = *handles_;
  if (numeric == nullptr ||
      !klu_tsolve(symbolic, numeric, static_cast<int>(b.size()), 1, b.data(), &common)) {
    throw std::logic_error("KLU solve without a factorisation");
  }
}

long KluFactorisation::factor_entry_count() const {
  const auto* numeric = handles_->numeric;
  return numeric == nullptr ? 0 : static_cast<long>(numeric->lnz + numeric->unz);
}

std::string KluFactorisation::failure_reason() const {
  if (handles_->numeric != nullptr && handles_->common.status == KLU_OK) return "";
  switch (handles_->common.status) {
    case KLU_OUT_OF_MEMORY:
    case KLU_TOO_LARGE:
      return "the operator cannot be factored: not enough memory; use a coarser grid or a smaller "
             "box";
    default:
      return "the operator cannot be factored: KLU reports a singular matrix; use a finer grid";
  }
}

}  // namespace fpkcheck::fd_fpk
