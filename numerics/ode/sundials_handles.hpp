#pragma once

#include <cvode/cvode.h>
#include <fmt/format.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_spgmr.h>

#include <sundials/sundials_matrix.h>
#include <Eigen/Core>
#include <exception>
#include <memory>
#include <new>
#include <stdexcept>
#include <sundials/sundials_context.hpp>
#include <utility>

/// Owning handles of SUNDIALS objects, and a check of the flags that SUNDIALS returns. Only
/// sundials_handles.hpp depends on the differences between SUNDIALS 6 and 7.
namespace fpkcheck::numerics::sundials_owned {

/// Flag of success: SUN_SUCCESS of SUNDIALS 7, CV_SUCCESS and SUNLS_SUCCESS of SUNDIALS 6.
inline constexpr int kSuccess = 0;

/// SUNDIALS context that prints nothing; SUNDIALS 7 prints errors and warnings to standard error by
/// default.
struct SilentSundialsContext : sundials::Context {
  SilentSundialsContext() {
#if SUNDIALS_VERSION_MAJOR >= 7
    SUNContext_ClearErrHandlers(*this);
    SUNLogger logger = nullptr;
    if (SUNContext_GetLogger(*this, &logger) == SUN_SUCCESS) {
      SUNLogger_SetErrorFilename(logger, "");
      SUNLogger_SetWarningFilename(logger, "");
    }
#endif
  }
};

/// Stores an exception that a callback of SUNDIALS throws. Exceptions must not propagate through
/// the C stack frames of SUNDIALS. The callback of SUNDIALS therefore returns a flag, and the
/// caller of SUNDIALS rethrows the exception.
class CallbackExceptionStore {
 public:
  /// Negative flag of a callback, which SUNDIALS treats as an unrecoverable error
  static constexpr int kUnrecoverable = -1;

  /// Calls the function `callback` and returns its flag, or kUnrecoverable after an exception.
  template <class Callback>
  int call_and_store_exception(const Callback& callback) noexcept {
    try {
      return callback();
    } catch (...) {
      // Only the first exception is kept, since later exceptions may be consequences of the first.
      if (!thrown_) thrown_ = std::current_exception();
      return kUnrecoverable;
    }
  }

  void rethrow_stored_exception() {
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  }

 private:
  std::exception_ptr thrown_;
};

struct SundialsHandleDeleter {
  void operator()(N_Vector v) const { N_VDestroy(v); }
  void operator()(SUNLinearSolver s) const { SUNLinSolFree(s); }
  void operator()(SUNMatrix m) const { SUNMatDestroy(m); }
  void operator()(void* cvode) const { CVodeFree(&cvode); }
};
template <class Handle>
using OwnedHandle = std::unique_ptr<std::remove_pointer_t<Handle>, SundialsHandleDeleter>;

/// @throws std::runtime_error when `handle` is null
template <class Handle>
OwnedHandle<Handle> make_owned_handle(Handle handle, const char* object_name) {
  if (handle == nullptr)
    throw std::runtime_error(fmt::format("SUNDIALS cannot create {}: out of memory?", object_name));
  return OwnedHandle<Handle>(handle);
}

/// @throws std::runtime_error when `flag` is negative
inline void require_success(int flag, const char* function_name) {
  if (flag < 0) throw std::runtime_error(fmt::format("{} returned {}", function_name, flag));
}

/// Makes the CVODE object report errors to `handler(function, text, data)`, which must not throw.
template <void (*handler)(const char* function, const char* text, void* data)>
void set_error_handler([[maybe_unused]] void* cvode,
                       [[maybe_unused]] SilentSundialsContext& context, void* data) {
#if SUNDIALS_VERSION_MAJOR >= 7
  const SUNErrHandlerFn forward = [](int, const char* function, const char*, const char* text,
                                     SUNErrCode, void* handed,
                                     SUNContext) { handler(function, text, handed); };
  require_success(SUNContext_PushErrHandler(context, forward, data), "SUNContext_PushErrHandler");
#else
  const CVErrHandlerFn forward = [](int, const char*, const char* function, char* text,
                                    void* handed) { handler(function, text, handed); };
  require_success(CVodeSetErrHandlerFn(cvode, forward, data), "CVodeSetErrHandlerFn");
#endif
}

inline Eigen::Map<Eigen::VectorXd> vector_view(N_Vector v) {
  return {N_VGetArrayPointer(v), static_cast<Eigen::Index>(N_VGetLength(v))};
}

/// Returns a SUNDIALS vector with two changed operations: a failed clone throws an exception, and
/// Eigen computes inner products with SIMD instructions. Inner products take a tenth of the time of
/// a solution.
inline OwnedHandle<N_Vector> make_sundials_vector(const Eigen::VectorXd& values,
                                                  SilentSundialsContext& context) {
  auto v = make_owned_handle(N_VNew_Serial(static_cast<sunindextype>(values.size()), context),
                             "a vector");
  v->ops->nvdotprod = [](N_Vector a, N_Vector b) noexcept {
    return vector_view(a).dot(vector_view(b));
  };
  // SUNDIALS 6 does not check whether a clone of a vector is null. SUNDIALS does not support
  // exceptions: if the clone of a vector fails, the memory of earlier clones is leaked.
  v->ops->nvclone = [](N_Vector like) {
    const N_Vector clone = N_VClone_Serial(like);
    return clone != nullptr ? clone : throw std::bad_alloc();
  };
  vector_view(v.get()) = values;
  return v;
}

}  // namespace fpkcheck::numerics::sundials_owned
