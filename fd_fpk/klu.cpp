#include "fd_fpk/klu.hpp"

#include <klu.h>

#include <stdexcept>

namespace fpkcheck::fd_fpk {

// KLU takes SuiteSparse_long indices; SparseColumns stores std::int64_t.
static_assert(sizeof(SuiteSparse_long) == sizeof(SparseColumns::StorageIndex));

struct KluFactorisation::Handles {
  klu_l_common common{};
  klu_l_symbolic* symbolic = nullptr;
  klu_l_numeric* numeric = nullptr;

  Handles() { klu_l_defaults(&common); }
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
  // KLU's interface is not const-correct; it only reads the three arrays.
  auto* columns = reinterpret_cast<SuiteSparse_long*>(
      const_cast<SparseColumns::StorageIndex*>(matrix.outerIndexPtr()));
  auto* rows = reinterpret_cast<SuiteSparse_long*>(
      const_cast<SparseColumns::StorageIndex*>(matrix.innerIndexPtr()));
  auto* values = const_cast<double*>(matrix.valuePtr());
  auto& [common, symbolic, numeric] = *handles_;
  klu_l_free_numeric(&numeric, &common);
  if (symbolic == nullptr) symbolic = klu_l_analyze(matrix.cols(), columns, rows, &common);
  if (symbolic != nullptr) numeric = klu_l_factor(columns, rows, values, symbolic, &common);
  return numeric != nullptr && common.status == KLU_OK;
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
