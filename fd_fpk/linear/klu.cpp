#include "fd_fpk/linear/klu.hpp"

#include <cholmod.h>
#include <klu.h>

#include <mutex>
#include <stdexcept>
#include <vector>

namespace fpkcheck::fd_fpk {
namespace {

// KLU takes SuiteSparse_long indices; SparseColumns stores std::int64_t.
static_assert(sizeof(SuiteSparse_long) == sizeof(SparseColumns::StorageIndex));

// The three arrays of a matrix. KLU's interface is not const-correct; it only reads them.
struct Arrays {
  SuiteSparse_long* columns;
  SuiteSparse_long* rows;
  double* values;

  explicit Arrays(const SparseColumns& matrix)
      : columns(reinterpret_cast<SuiteSparse_long*>(
            const_cast<SparseColumns::StorageIndex*>(matrix.outerIndexPtr()))),
        rows(reinterpret_cast<SuiteSparse_long*>(
            const_cast<SparseColumns::StorageIndex*>(matrix.innerIndexPtr()))),
        values(const_cast<double*>(matrix.valuePtr())) {}
};

// METIS draws from the C library's random numbers, one sequence for the whole process: it seeds them
// for each dissection, but two dissections at once would draw from one another's, and their orders
// (and the last digits of all that is solved by them) would depend on who came when.
std::mutex dissection_mutex;

// Order of unknowns by nested dissection of the graph of A + A^T; empty when it cannot be found.
std::vector<SuiteSparse_long> nested_dissection(const SparseColumns& matrix) {
  const SparseColumns symmetric = SparseColumns(matrix.transpose()) + matrix;
  const Arrays arrays(symmetric);
  const auto n = static_cast<std::size_t>(matrix.cols());
  cholmod_sparse graph{};
  graph.nrow = graph.ncol = n;
  graph.nzmax = static_cast<std::size_t>(symmetric.nonZeros());
  graph.p = arrays.columns;
  graph.i = arrays.rows;
  graph.stype = 1;  // symmetric, the upper triangle counts
  graph.itype = CHOLMOD_LONG;
  graph.xtype = CHOLMOD_PATTERN;
  graph.sorted = graph.packed = 1;
  cholmod_common common;
  cholmod_l_start(&common);
  common.print = 0;
  // Without memory METIS ends the program: CHOLMOD looks first whether there is twice what it needs.
  common.metis_memory = 2;
  std::vector<SuiteSparse_long> order(n), parents(n), components(n);
  const std::lock_guard alone(dissection_mutex);
  const SuiteSparse_long found = cholmod_l_nested_dissection(
      &graph, nullptr, 0, order.data(), parents.data(), components.data(), &common);
  cholmod_l_finish(&common);
  if (found < 0) order.clear();
  return order;
}

}  // namespace

struct KluFactorisation::Handles {
  klu_l_common common{};
  klu_l_symbolic* symbolic = nullptr;
  klu_l_numeric* numeric = nullptr;

  Handles() {
    klu_l_defaults(&common);
    common.btf = 0;  // the operator is irreducible: every cell is reached from every other
  }
  ~Handles() {
    klu_l_free_numeric(&numeric, &common);
    klu_l_free_symbolic(&symbolic, &common);
  }
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;
};

KluFactorisation::KluFactorisation() : handles_(std::make_unique<Handles>()) {}
KluFactorisation::~KluFactorisation() = default;
KluFactorisation::KluFactorisation(KluFactorisation&&) noexcept = default;
KluFactorisation& KluFactorisation::operator=(KluFactorisation&&) noexcept = default;

bool KluFactorisation::factor(const SparseColumns& matrix) {
  if (refactor(matrix)) return true;
  const Arrays arrays(matrix);
  auto& [common, symbolic, numeric] = *handles_;
  klu_l_free_numeric(&numeric, &common);
  if (symbolic == nullptr) {
    auto order = nested_dissection(matrix);
    symbolic = order.empty() ? klu_l_analyze(matrix.cols(), arrays.columns, arrays.rows, &common)
                             : klu_l_analyze_given(matrix.cols(), arrays.columns, arrays.rows,
                                                   order.data(), order.data(), &common);
  }
  if (symbolic != nullptr) {
    numeric = klu_l_factor(arrays.columns, arrays.rows, arrays.values, symbolic, &common);
  }
  return numeric != nullptr && common.status == KLU_OK;
}

// Factors with the pivots of the last factorisation. False when there are none, or when the factors
// grow so much that they would be worth little.
bool KluFactorisation::refactor(const SparseColumns& matrix) {
  constexpr double kLeastReciprocalGrowth = 1e-8;
  auto& [common, symbolic, numeric] = *handles_;
  if (numeric == nullptr) return false;
  const Arrays arrays(matrix);
  return klu_l_refactor(arrays.columns, arrays.rows, arrays.values, symbolic, numeric, &common) &&
         common.status == KLU_OK &&
         klu_l_rgrowth(arrays.columns, arrays.rows, arrays.values, symbolic, numeric, &common) &&
         common.rgrowth > kLeastReciprocalGrowth;
}

void KluFactorisation::solve_in_place(Eigen::Ref<Eigen::VectorXd> b) const {
  auto& [common, symbolic, numeric] = *handles_;
  if (numeric == nullptr || !klu_l_solve(symbolic, numeric, b.size(), 1, b.data(), &common)) {
    throw std::logic_error("KLU solve without a factorisation");
  }
}

long KluFactorisation::entries() const {
  const auto* numeric = handles_->numeric;
  return numeric == nullptr ? 0 : static_cast<long>(numeric->lnz + numeric->unz);
}

std::string KluFactorisation::failure() const {
  if (handles_->numeric != nullptr && handles_->common.status == KLU_OK) return "";
  switch (handles_->common.status) {
    case KLU_OUT_OF_MEMORY:
    case KLU_TOO_LARGE:
      return "not enough memory to factor the operator (take a coarser grid or a smaller box)";
    default:
      return "KLU found the operator singular beyond its null vector (take a finer grid)";
  }
}

}  // namespace fpkcheck::fd_fpk
