#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/process/stopwatch.hpp"
#include "fd_fpk/linear/gmres.hpp"
#include "fd_fpk/linear/preconditioner.hpp"
#include "fd_fpk/operator/fokker_planck_operator.hpp"

namespace fpkcheck::fd_fpk {

/// Linear system of differential equations dP/dt = L(t) P, given by functions for products with the
/// matrix L(t) and for approximate solutions of systems with the matrix I - gamma L.
struct LinearOdeSystem {
  using Product = std::function<Eigen::VectorXd(double t, const Eigen::VectorXd& p)>;
  Product apply_operator;
  /// Factors the matrix I - gamma L for the function `solve`; returns false on failure
  std::function<bool(double gamma)> factor_shifted_matrix;
  ApproximateLinearSolver
      approximate_solve;  ///< function that solves the system with the matrix factored last
};
/// @param preconditioner must outlive the returned system
LinearOdeSystem make_linear_ode_system(LinearOdeSystem::Product apply_operator,
                                       Preconditioner& preconditioner);

/// Exception that a matrix-vector product throws after the deadline. The matrix-vector products
/// check the deadline, because one time step of CVODE may contain many matrix-vector products.
struct DeadlineExceeded {};

/// Returns the given linear system of differential equations with matrix-vector products that throw
/// DeadlineExceeded after the deadline.
/// @param deadline deadline, which must outlive the returned system
LinearOdeSystem with_deadline_check(const base::Deadline& deadline, LinearOdeSystem system);

/// Settings of the step control of CVODE; absent settings have the default values of CVODE.
struct BdfSettings {
  /// Highest order of BDF, 1 .. 5
  int max_order;
  /// Relative tolerance of the local error of the cell averages, as root mean square over all cells
  double relative_tolerance;
  double absolute_tolerance;  ///< absolute tolerance of the local error, in units of the density
  double linear_tolerance;    ///< tolerance of GMRES as a fraction of the local error
  /// Absolute tolerance of the local error of each cell average, instead of absolute_tolerance
  std::optional<Eigen::VectorXd> absolute_tolerances = {};
  std::optional<double> first_step = {};
  std::optional<double> max_step = {};
  std::optional<double> stop_time = {};  ///< time that no step exceeds
  std::optional<long> max_steps = {};    ///< maximum number of steps up to a requested time
  /// Maximum number of BDF time steps with one factorisation of the matrix I - gamma L while the
  /// step coefficient gamma is constant
  std::optional<long> steps_per_factorisation = {};
};

/// Integrator of dP/dt = L(t) P by CVODE with BDF. GMRES solves the linear systems of the BDF time
/// steps with the exact operator L, preconditioned by a factored approximation of I - gamma L.
class LinearCvodeIntegrator {
 public:
  /// @throws std::runtime_error when SUNDIALS cannot be set up
  LinearCvodeIntegrator(LinearOdeSystem system, const Eigen::VectorXd& initial_averages,
                        const BdfSettings& settings);
  ~LinearCvodeIntegrator();
  LinearCvodeIntegrator(const LinearCvodeIntegrator&) = delete;
  LinearCvodeIntegrator& operator=(const LinearCvodeIntegrator&) = delete;

  struct StepResult {
    int flag;  ///< return flag of CVODE; negative if CVODE stopped, see error_message()
    double time;
  };
  void set_linear_tolerance(double tolerance);
  /// @throws every exception of the functions of the linear system
  StepResult take_step();
  /// Advances the integration to `time`, at which the cell averages are interpolated.
  /// @throws every exception of the functions of the linear system
  StepResult advance_to_time(double time);

  Eigen::Map<const Eigen::VectorXd> cell_averages() const;
  const std::string& error_message() const;

  long step_count() const;
  long factorisation_count() const;
  long rhs_evaluation_count() const;
  long krylov_iteration_count() const;

 private:
  struct Handles;
  StepResult call_cvode(double time, int cvode_task);
  std::unique_ptr<Handles> handles_;
};

}  // namespace fpkcheck::fd_fpk
