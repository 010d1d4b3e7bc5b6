#include <benchmark/benchmark.h>
#include <cholmod.h>
#include <klu.h>
#include <umfpack.h>

#include <cmath>
#include <string>
#include <vector>

#include "case_on_grid.hpp"
#include "fd_fpk/linear/klu.hpp"
#include "fd_fpk/linear/null_vector_and_eigenvalues.hpp"
#include "problem/equivalent_linearisation.hpp"

/// Fill-reducing orderings and sparse LU libraries on the matrix of the preconditioner.
namespace fpkcheck::benchmarks {
namespace {

using namespace fd_fpk;
using Integer = int;

/// I - M/10, with M similar to the matrix that the preconditioner factorises, and of the same
/// sparsity pattern.
SparseColumnMatrix low_order_matrix(const CaseOnGrid& problem_on_grid) {
  const auto& impulses = problem_on_grid.problem.impulses;
  const DiscretisedExcitation weak{
      .drift = 0, .diffusion = impulses.rate_times_moment(2) / 8, .exchange = {}};
  SparseColumnMatrix unit(problem_on_grid.grid().size(), problem_on_grid.grid().size());
  unit.setIdentity();
  return unit - 0.1 * fokker_planck_operator(problem_on_grid.problem.system, weak,
                                             problem_on_grid.options.impact, problem_on_grid.grid(),
                                             3, CellAverageProductRule::lumped)
                          .local;
}

struct CompressedColumns {
  Integer n;
  Integer* columns;
  Integer* rows;
  double* values;
  explicit CompressedColumns(SparseColumnMatrix& a)
      : n(static_cast<Integer>(a.cols())),
        columns(a.outerIndexPtr()),
        rows(a.innerIndexPtr()),
        values(a.valuePtr()) {}
};

enum class Ordering { amd, colamd, metis, nested_dissection };

std::vector<Integer> nested_dissection_ordering(SparseColumnMatrix& matrix, Ordering order) {
  SparseColumnMatrix symmetric = SparseColumnMatrix(matrix.transpose()) + matrix;
  const CompressedColumns arrays(symmetric);
  cholmod_common common;
  cholmod_start(&common);
  cholmod_sparse graph{};
  graph.nrow = graph.ncol = arrays.n;
  graph.nzmax = symmetric.nonZeros();
  graph.p = arrays.columns;
  graph.i = arrays.rows;
  graph.stype = 1;
  graph.itype = CHOLMOD_INT;
  graph.xtype = CHOLMOD_PATTERN;
  graph.sorted = graph.packed = 1;
  std::vector<Integer> found(arrays.n), parents(arrays.n), members(arrays.n);
  if (order == Ordering::metis) {
    cholmod_metis(&graph, nullptr, 0, 1, found.data(), &common);
  } else {
    cholmod_nested_dissection(&graph, nullptr, 0, found.data(), parents.data(), members.data(),
                              &common);
  }
  cholmod_finish(&common);
  return found;
}

class Klu {
 public:
  Klu(SparseColumnMatrix& matrix, Ordering order) : a_(matrix) {
    klu_defaults(&common_);
    if (order == Ordering::amd || order == Ordering::colamd) {
      common_.ordering = order == Ordering::amd ? 0 : 1;
      symbolic_ = klu_analyze(a_.n, a_.columns, a_.rows, &common_);
    } else {
      common_.btf = 0;
      auto found = nested_dissection_ordering(matrix, order);
      symbolic_ =
          klu_analyze_given(a_.n, a_.columns, a_.rows, found.data(), found.data(), &common_);
    }
  }
  ~Klu() {
    klu_free_numeric(&numeric_, &common_);
    klu_free_symbolic(&symbolic_, &common_);
  }
  Klu(const Klu&) = delete;
  Klu& operator=(const Klu&) = delete;
  void factor() {
    klu_free_numeric(&numeric_, &common_);
    numeric_ = klu_factor(a_.columns, a_.rows, a_.values, symbolic_, &common_);
  }
  void refactor() { klu_refactor(a_.columns, a_.rows, a_.values, symbolic_, numeric_, &common_); }
  void solve(Eigen::VectorXd& b) { klu_solve(symbolic_, numeric_, a_.n, 1, b.data(), &common_); }
  double entries() const { return static_cast<double>(numeric_->lnz + numeric_->unz); }

 private:
  CompressedColumns a_;
  klu_common common_{};
  klu_symbolic* symbolic_ = nullptr;
  klu_numeric* numeric_ = nullptr;
};

class Umfpack {
 public:
  Umfpack(SparseColumnMatrix& matrix, Ordering order) : a_(matrix) {
    umfpack_di_defaults(control_);
    control_[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;
    control_[UMFPACK_ORDERING] =
        order == Ordering::amd ? UMFPACK_ORDERING_AMD : UMFPACK_ORDERING_METIS;
    control_[UMFPACK_IRSTEP] = 0;
    umfpack_di_symbolic(a_.n, a_.n, a_.columns, a_.rows, a_.values, &symbolic_, control_, info_);
  }
  ~Umfpack() {
    umfpack_di_free_numeric(&numeric_);
    umfpack_di_free_symbolic(&symbolic_);
  }
  Umfpack(const Umfpack&) = delete;
  Umfpack& operator=(const Umfpack&) = delete;
  void factor() {
    if (numeric_ != nullptr) umfpack_di_free_numeric(&numeric_);
    umfpack_di_numeric(a_.columns, a_.rows, a_.values, symbolic_, &numeric_, control_, info_);
    entries_ = info_[UMFPACK_LNZ] + info_[UMFPACK_UNZ];
  }
  void solve(Eigen::VectorXd& b) {
    Eigen::VectorXd x(b.size());
    umfpack_di_solve(UMFPACK_A, a_.columns, a_.rows, a_.values, x.data(), b.data(), numeric_,
                     control_, info_);
    b = x;
  }
  double entries() const { return entries_; }

 private:
  CompressedColumns a_;
  double control_[UMFPACK_CONTROL], info_[UMFPACK_INFO], entries_ = 0;
  void* symbolic_ = nullptr;
  void* numeric_ = nullptr;
};

template <class Code>
void analyse(benchmark::State& state, Ordering order) {
  const CaseOnGrid problem_on_grid(state.range(0));
  SparseColumnMatrix matrix = low_order_matrix(problem_on_grid);
  for (auto _ : state) Code code(matrix, order);
}

template <class Code>
void factor(benchmark::State& state, Ordering order) {
  const CaseOnGrid problem_on_grid(state.range(0));
  SparseColumnMatrix matrix = low_order_matrix(problem_on_grid);
  Code code(matrix, order);
  for (auto _ : state) code.factor();
  state.counters["factor_entries"] = code.entries();
}

template <class Code>
void solve(benchmark::State& state, Ordering order) {
  const CaseOnGrid problem_on_grid(state.range(0));
  SparseColumnMatrix matrix = low_order_matrix(problem_on_grid);
  Code code(matrix, order);
  code.factor();
  Eigen::VectorXd b = Eigen::VectorXd::Ones(matrix.cols());
  for (auto _ : state) {
    b.setOnes();
    code.solve(b);
  }
}

void refactor(benchmark::State& state, Ordering order) {
  const CaseOnGrid problem_on_grid(state.range(0));
  SparseColumnMatrix matrix = low_order_matrix(problem_on_grid);
  Klu klu(matrix, order);
  klu.factor();
  for (auto _ : state) klu.refactor();
}

void register_on_grids(const std::string& name, void (*measure)(benchmark::State&, Ordering),
                       Ordering order) {
  benchmark::RegisterBenchmark(name.c_str(), measure, order)
      ->Arg(4000)
      ->Arg(16000)
      ->Arg(64000)
      ->Unit(benchmark::kMillisecond);
}

template <class Code>
void register_code(const std::string& name, Ordering order) {
  register_on_grids("analyse/" + name, analyse<Code>, order);
  register_on_grids("factor/" + name, factor<Code>, order);
  register_on_grids("triangular_solve/" + name, solve<Code>, order);
}

const bool kRegistered = [] {
  register_code<Klu>("klu_amd", Ordering::amd);
  register_code<Klu>("klu_colamd", Ordering::colamd);
  register_code<Klu>("klu_metis", Ordering::metis);
  register_code<Klu>("klu_nested_dissection", Ordering::nested_dissection);
  register_code<Umfpack>("umfpack_amd", Ordering::amd);
  register_code<Umfpack>("umfpack_metis", Ordering::metis);
  register_on_grids("refactor/klu_nested_dissection", refactor, Ordering::nested_dissection);
  return true;
}();

// The null vector by GMRES with one factorisation of the preconditioner.
void null_vector_by_gmres(benchmark::State& state) {
  const CaseOnGrid problem_on_grid(state.range(0));
  const FokkerPlanckOperator op = problem_on_grid.op();
  const Eigen::VectorXd start =
      initial_gaussian(problem_on_grid.grid(), problem::motion_scales(problem_on_grid.problem));
  for (auto _ : state) {
    Preconditioner preconditioner = problem_on_grid.preconditioner();
    const NullVectorResult null = find_null_vector(op, preconditioner, start);
    state.counters["krylov_iterations"] = static_cast<double>(null.iterations);
    state.counters["factor_entries"] = static_cast<double>(preconditioner.factor_entry_count());
  }
}
BENCHMARK(null_vector_by_gmres)->Arg(1000)->Arg(2000)->Arg(4000)->Unit(benchmark::kMillisecond);

// The null vector by inverse iteration, with a KLU factorisation of the whole operator including
// jumps.
void null_vector_by_whole_factors(benchmark::State& state) {
  const CaseOnGrid problem_on_grid(state.range(0));
  const FokkerPlanckOperator op = problem_on_grid.op();
  const Eigen::VectorXd start =
      initial_gaussian(problem_on_grid.grid(), problem::motion_scales(problem_on_grid.problem));
  const double frequency =
      std::sqrt(problem::equivalent_linearisation(problem_on_grid.problem).stiffness);
  for (auto _ : state) {
    const NullVectorResult null = find_null_vector_by_inverse_iteration(op, start, frequency);
    if (!null.averages) state.SkipWithError(null.failure.c_str());
  }
}
BENCHMARK(null_vector_by_whole_factors)
    ->Arg(1000)
    ->Arg(2000)
    ->Arg(4000)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fpkcheck::benchmarks
