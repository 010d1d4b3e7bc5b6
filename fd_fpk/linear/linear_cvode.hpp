#pragma once

#include <memory>
#include <optional>
#include <string>

#include "fd_fpk/linear/linear_map.hpp"
#include "fd_fpk/linear/preconditioner.hpp"
#include "fd_fpk/operator/operator.hpp"
#include "fd_fpk/stopwatch.hpp"

namespace fpkcheck::fd_fpk {

/// dP/dt = L P, and approximate solves with I - gamma L.
struct LinearSystem {
  LinearMap times;                           ///< L P
  std::function<bool(double gamma)> factor;  ///< called before `solve`; false on failure
  ApproximateSolve solve;                    ///< uses the gamma of the last factorisation
};
/// @param op,preconditioner must outlive the returned system
LinearSystem linear_system(const FokkerPlanckOperator& op, Preconditioner& preconditioner);

/// Thrown inside a step at its deadline: one step may take as long as many products.
struct DeadlineExceeded {};

/// The same system with products that throw DeadlineExceeded after the deadline.
/// @param deadline must outlive the returned system
LinearSystem with_deadline(const Deadline& deadline, LinearSystem system);

/// Step control of CVODE; absent values are the defaults of CVODE.
struct BdfControl {
  /// Order of BDF, 1 .. 5; orders above 2 are unstable on part of the imaginary axis.
  int max_order;
  double relative_tolerance;  ///< for the local error of a cell average, in the RMS over the cells
  double absolute_tolerance;  ///< likewise, in units of the density
  double linear_tolerance;    ///< tolerance of GMRES as a fraction of the local error
  /// Replaces the absolute tolerance by a value for each cell: shape of the start.
  std::optional<Eigen::VectorXd> absolute_tolerances = {};
  std::optional<double> first_step = {};
  std::optional<double> max_step = {};
  std::optional<double> step_growth = {};  ///< largest ratio of successive steps
  std::optional<double> stop_time = {};    ///< upper limit of the time of a step
  std::optional<long> max_steps = {};      ///< maximum number of steps up to a requested time
  std::optional<long> steps_per_factorisation = {};  ///< maximum, for a constant gamma
};

/// CVODE with BDF for dP/dt = L P: GMRES with L itself, preconditioned by factors of an
/// approximation of I - gamma L.
class LinearCvode {
 public:
  /// @throws std::runtime_error when SUNDIALS cannot be set up
  LinearCvode(LinearSystem system, const Eigen::VectorXd& start, const BdfControl& control);
  ~LinearCvode();
  LinearCvode(const LinearCvode&) = delete;
  LinearCvode& operator=(const LinearCvode&) = delete;

  struct StepResult {
    int flag;  ///< flag of CVODE; negative: it stopped, see message()
    double time;
  };
  /// Takes effect from the next step; see BdfControl::linear_tolerance.
  void set_linear_tolerance(double tolerance);
  /// One internal step.
  /// @throws every exception of the system
  StepResult step();
  /// Advances to `time`; the averages are interpolated there.
  /// @throws every exception of the system
  StepResult advance(double time);

  Eigen::Map<const Eigen::VectorXd> averages() const;
  /// The last error message of CVODE.
  const std::string& message() const;

  /// Counters of CVODE since the start.
  long steps() const;
  long factorisations() const;
  long rhs_evaluations() const;
  long krylov_iterations() const;

 private:
  struct Handles;
  StepResult run(double time, int task);
  std::unique_ptr<Handles> handles_;
};

}  // namespace fpkcheck::fd_fpk
