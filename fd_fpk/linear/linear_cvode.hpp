#pragma once

#include <memory>
#include <optional>
#include <string>

#include "fd_fpk/linear/linear_map.hpp"
#include "fd_fpk/linear/preconditioner.hpp"
#include "fd_fpk/operator/operator.hpp"
#include "fd_fpk/stopwatch.hpp"

namespace fpkcheck::fd_fpk {

/// dP/dt = L P, and a way to solve with I - gamma L approximately.
struct LinearSystem {
  LinearMap times;                           ///< L P
  std::function<bool(double gamma)> factor;  ///< before `solve`; false when it failed
  ApproximateSolve solve;                    ///< with the gamma of the last factorisation
};
/// @param op,preconditioner must outlive the system
LinearSystem linear_system(const FokkerPlanckOperator& op, Preconditioner& preconditioner);

/// Thrown out of a step that is under way at a deadline: one step may take as long as many products.
struct OutOfTime {};

/// The same system, whose products throw OutOfTime after the deadline.
/// @param deadline must outlive it
LinearSystem within(const Deadline& deadline, LinearSystem system);

/// How CVODE steps; what is left out is as CVODE has it.
struct BdfControl {
  int max_order;  ///< of BDF, 1 .. 5; above 2 it is not stable on the whole imaginary axis
  double relative_tolerance;  ///< of the local error of a cell's average, in the RMS over the cells
  double absolute_tolerance;  ///< likewise, in units of the density
  double linear_tolerance;    ///< of GMRES, as a fraction of the local error
  /// In place of the absolute one, cell by cell: shape of the start.
  std::optional<Eigen::VectorXd> absolute_tolerances = {};
  std::optional<double> first_step = {};
  std::optional<double> longest_step = {};
  std::optional<double> step_growth = {};            ///< largest factor from one step to the next
  std::optional<double> stop_time = {};              ///< no step goes beyond it
  std::optional<long> most_steps = {};               ///< on the way to one time
  std::optional<long> steps_per_factorisation = {};  ///< at most, while gamma does not change
};

/// CVODE, BDF, on dP/dt = L P: GMRES with L itself, preconditioned by factors of something close to
/// I - gamma L.
class LinearCvode {
 public:
  /// @throws std::runtime_error when SUNDIALS cannot be set up
  LinearCvode(LinearSystem system, const Eigen::VectorXd& start, const BdfControl& control);
  ~LinearCvode();
  LinearCvode(const LinearCvode&) = delete;
  LinearCvode& operator=(const LinearCvode&) = delete;

  struct Reached {
    int flag;  ///< of CVODE; negative: it stopped, see message()
    double time;
  };
  /// From the next step on; see BdfControl::linear_tolerance.
  void set_linear_tolerance(double tolerance);
  /// One internal step.
  /// @throws what the system throws
  Reached step();
  /// Steps on to `time`; the averages are interpolated there.
  /// @throws what the system throws
  Reached advance(double time);

  Eigen::Map<const Eigen::VectorXd> averages() const;
  /// What CVODE last complained of.
  const std::string& message() const;

  /// Counts of CVODE since the start.
  long steps() const;
  long factorisations() const;
  long rhs_evaluations() const;
  long krylov_iterations() const;

 private:
  struct Handles;
  Reached run(double time, int task);
  std::unique_ptr<Handles> handles_;
};

}  // namespace fpkcheck::fd_fpk
