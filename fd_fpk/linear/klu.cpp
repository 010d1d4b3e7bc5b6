#include "fd_fpk/linear/klu.hpp"

#include <klu.h>

#include <stdexcept>

#include "fd_fpk/linear/fill_reducing_ordering.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// The three arrays of a sparse matrix, as arguments for KLU. The interface of KLU is not
// const-correct, but KLU does not modify them.
struct MatrixArrays {
  SparseColumnMatrix::StorageIndex* columns;
  SparseColumnMatrix::StorageIndex* rows;
  double* values;

  explicit MatrixArrays(const SparseColumnMatrix& matrix)
      : columns(const_cast<SparseColumnMatrix::StorageIndex*>(matrix.outerIndexPtr())),
        rows(const_cast<SparseColumnMatrix::StorageIndex*>(matrix.innerIndexPtr())),
        values(const_cast<double*>(matrix.valuePtr())) {}
};

}  // namespace

struct KluFactorisation::Handles {
  klu_l_common common{};
  klu_l_symbolic* symbolic = nullptr;
  klu_l_numeric* numeric = nullptr;

  Handles() {
    klu_l_defaults(&common);
    common.btf = 0;  // the operator is irreducible: every cell is reachable from every other cell
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

bool KluFactorisation::factorise(const SparseColumnMatrix& matrix) {
  if (refactor(matrix)) return true;
  const MatrixArrays arrays(matrix);
  auto& [common, symbolic, numeric] = *handles_;
  klu_l_free_numeric(&numeric, &common);
  if (symbolic == nullptr) {
    auto found = fill_reducing_ordering(matrix);
    symbolic = found.empty() ? klu_l_analyze(matrix.cols(), arrays.columns, arrays.rows, &common)
                             : klu_l_analyze_given(matrix.cols(), arrays.columns, arrays.rows,
                                                   found.data(), found.data(), &common);
  }
  if (symbolic != nullptr) {
    numeric = klu_l_factor(arrays.columns, arrays.rows, arrays.values, symbolic, &common);
  }
  return numeric != nullptr && common.status == KLU_OK;
}

// Factors the matrix with the pivots of the last factorisation. Returns false if there was no
// factorisation, or if the pivot growth makes the factors inaccurate.
bool KluFactorisation::refactor(const SparseColumnMatrix& matrix) {
  constexpr double kLeastReciprocalGrowth = 1e-8;
  auto& [common, symbolic, numeric] = *handles_;
  if (numeric == nullptr) return false;
  const MatrixArrays arrays(matrix);
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
