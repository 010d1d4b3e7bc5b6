#pragma once

#include <memory>
#include <optional>
#include <string>

#include "fd_fpk/linear/gmres.hpp"
#include "fd_fpk/linear/preconditioner.hpp"
#include "fd_fpk/operator/operator.hpp"
#include "fd_fpk/stopwatch.hpp"

namespace fpkcheck::fd_fpk {

/// The linear system dP/dt = L P: products with L, and approximate solutions of systems
/// with I - gamma L.
struct LinearOdeSystem {
  LinearMap times;  ///< returns L P
  /// factors I - gamma L for `solve`; returns false on failure
  std::function<bool(double gamma)> factor;
  ApproximateSolve solve;  ///< solves the system factored by the last call of `factor`
};
/// @param op,preconditioner must outlive the returned system
LinearOdeSystem linear_ode_system(const FokkerPlanckOperator& op, Preconditioner& preconditioner);

/// Exception that a matrix-vector product throws if the deadline passes within a time step.
/// Products must check the deadline, because one time step of CVODE may contain many products.
struct DeadlineExceeded {};

/// Returns the given system with products L P that throw DeadlineExceeded after the deadline.
/// @param deadline must outlive the returned system
LinearOdeSystem with_deadline(const Deadline& deadline, LinearOdeSystem system);

/// Settings of CVODE's step control. An absent setting has the default value of CVODE.
struct BdfControl {
  /// Highest order of BDF, 1 .. 5. BDF of an order above 2 is unstable on part of the imaginary
  /// axis.
  int max_order;
  /// relative tolerance of the local error of the cell averages, in the RMS over the cells
  double relative_tolerance;
  double absolute_tolerance;  ///< absolute tolerance of the local error, in units of the density
  double linear_tolerance;    ///< tolerance of GMRES as a fraction of the local error
  /// Absolute tolerance of the local error of each cell average, in place of absolute_tolerance;
  /// shape of the initial vector.
  std::optional<Eigen::VectorXd> absolute_tolerances = {};
  std::optional<double> first_step = {};
  std::optional<double> max_step = {};
  std::optional<double> step_growth = {};  ///< largest ratio of the lengths of successive steps
  std::optional<double> stop_time = {};    ///< time that no step exceeds
  std::optional<long> max_steps = {};      ///< maximum number of steps up to a requested time
  /// maximum number of steps with one factorisation while gamma is constant
  std::optional<long> steps_per_factorisation = {};
};

/// Integrator of dP/dt = L P by CVODE with BDF. GMRES solves the linear systems with the exact
/// operator L; the preconditioner factors an approximation of I - gamma L.
class LinearCvode {
 public:
  /// @throws std::runtime_error when SUNDIALS cannot be set up
  LinearCvode(LinearOdeSystem system, const Eigen::VectorXd& start, const BdfControl& control);
  ~LinearCvode();
  LinearCvode(const LinearCvode&) = delete;
  LinearCvode& operator=(const LinearCvode&) = delete;

  struct StepResult {
    int flag;  ///< flag of CVODE; negative if CVODE stopped, see error_message()
    double time;
  };
  /// Sets the value of BdfControl::linear_tolerance for all later steps.
  void set_linear_tolerance(double tolerance);
  /// Takes one internal step of CVODE.
  /// @throws every exception of the system
  StepResult take_step();
  /// Advances to `time`; the averages at this time are interpolated.
  /// @throws every exception of the system
  StepResult advance(double time);

  Eigen::Map<const Eigen::VectorXd> averages() const;
  /// The last error message that CVODE reported.
  const std::string& error_message() const;

  /// Counters of CVODE since the initial time.
  long step_count() const;
  long factorisation_count() const;
  long rhs_evaluation_count() const;
  long krylov_iteration_count() const;

 private:
  struct Handles;
  StepResult run(double time, int task);
  std::unique_ptr<Handles> handles_;
};

}  // namespace fpkcheck::fd_fpk
