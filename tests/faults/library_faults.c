// Library for LD_PRELOAD that makes a function of the libraries of the solvers, or the allocation
// of memory, fail. FAULT_FUNCTION is the name of the function, FAULT_AT the number of the first
// call that fails, FAULT_COUNT a file for the number of calls.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <klu.h>

static atomic_long count;
static long fault_at;
static const char* function = "";

__attribute__((constructor)) static void begin(void) {
  const char* at = getenv("FAULT_AT");
  fault_at = at ? atol(at) : 0;
  if (getenv("FAULT_FUNCTION")) function = getenv("FAULT_FUNCTION");
  unsetenv("LD_PRELOAD");  // child processes are not affected
}

__attribute__((destructor)) static void end(void) {
  const char* to = getenv("FAULT_COUNT");
  const long calls = atomic_load(&count);
  function = "";
  FILE* const out = to ? fopen(to, "w") : NULL;
  if (!out) return;
  fprintf(out, "%ld", calls);
  fclose(out);
}

static int fails(const char* name) {
  if (strcmp(name, function) != 0) return 0;
  const long number = atomic_fetch_add(&count, 1) + 1;
  return fault_at > 0 && number >= fault_at;
}

#define REAL(name) dlsym(RTLD_NEXT, #name)

// Functions of KLU fail as they do without memory.
#define KLU_FAULT(type, name, failure, parameters, arguments)   \
  type name parameters {                                        \
    if (fails(#name)) {                                         \
      common->status = KLU_OUT_OF_MEMORY;                       \
      return failure;                                           \
    }                                                           \
    return ((type(*) parameters)REAL(name))arguments;           \
  }
KLU_FAULT(klu_symbolic*, klu_analyze, NULL, (int n, int* p, int* i, klu_common* common),
          (n, p, i, common))
KLU_FAULT(klu_symbolic*, klu_analyze_given, NULL,
          (int n, int* p, int* i, int* rows, int* columns, klu_common* common),
          (n, p, i, rows, columns, common))
KLU_FAULT(klu_numeric*, klu_factor, NULL,
          (int* p, int* i, double* x, klu_symbolic* symbolic, klu_common* common),
          (p, i, x, symbolic, common))
KLU_FAULT(int, klu_refactor, 0,
          (int* p, int* i, double* x, klu_symbolic* symbolic, klu_numeric* numeric,
           klu_common* common),
          (p, i, x, symbolic, numeric, common))
KLU_FAULT(int, klu_solve, 0,
          (klu_symbolic* symbolic, klu_numeric* numeric, int n, int columns, double* b,
           klu_common* common),
          (symbolic, numeric, n, columns, b, common))
KLU_FAULT(int, klu_rgrowth, 0,
          (int* p, int* i, double* x, klu_symbolic* symbolic, klu_numeric* numeric,
           klu_common* common),
          (p, i, x, symbolic, numeric, common))

// Other functions, with at most six pointer or integer arguments.
#define FAULT(type, name, failure)                                                   \
  type name(void* a, void* b, void* c, void* d, void* e, void* f) {                  \
    if (fails(#name)) return (type)failure;                                          \
    return ((type(*)(void*, void*, void*, void*, void*, void*))REAL(name))(a, b, c, d, e, f); \
  }
FAULT(int, cholmod_start, 0)
FAULT(long, cholmod_nested_dissection, -1)
FAULT(int, CVodeInit, -20)
FAULT(int, CVodeSetLinearSolver, -20)
FAULT(int, CVodeSetJacTimes, -30)
FAULT(int, CVodeSetPreconditioner, -30)
FAULT(int, SUNLinSolInitialize, -808)
FAULT(int, SUNLinSolSetup, -806)

// Functions with floating-point arguments or other signatures.
void* CVodeCreate(int method, void* context) {
  return fails("CVodeCreate") ? NULL : ((void* (*)(int, void*))REAL(CVodeCreate))(method, context);
}
int CVode(void* memory, double to, void* y, double* reached, int task) {
  if (fails("CVode")) return -3;  // CV_ERR_FAILURE
  return ((int (*)(void*, double, void*, double*, int))REAL(CVode))(memory, to, y, reached, task);
}
void* SUNLinSol_SPGMR(void* y, int side, int size, void* context) {
  if (fails("SUNLinSol_SPGMR")) return NULL;
  return ((void* (*)(void*, int, int, void*))REAL(SUNLinSol_SPGMR))(y, side, size, context);
}
int SUNLinSolSolve(void* solver, void* matrix, void* x, void* b, double tolerance) {
  if (fails("SUNLinSolSolve")) return -807;
  return ((int (*)(void*, void*, void*, void*, double))REAL(SUNLinSolSolve))(solver, matrix, x, b,
                                                                             tolerance);
}

// Small allocations always succeed.
static int no_memory(size_t size) { return size >= 32768 && fails("malloc"); }
void* malloc(size_t size) {
  static void* (*real)(size_t);
  if (!real) real = (void* (*)(size_t))REAL(malloc);
  if (no_memory(size)) {
    errno = ENOMEM;
    return NULL;
  }
  return real(size);
}
void* realloc(void* old, size_t size) {
  static void* (*real)(void*, size_t);
  if (!real) real = (void* (*)(void*, size_t))REAL(realloc);
  if (no_memory(size)) {
    errno = ENOMEM;
    return NULL;
  }
  return real(old, size);
}
void* aligned_alloc(size_t alignment, size_t size) {
  static void* (*real)(size_t, size_t);
  if (!real) real = (void* (*)(size_t, size_t))REAL(aligned_alloc);
  if (no_memory(size)) {
    errno = ENOMEM;
    return NULL;
  }
  return real(alignment, size);
}
