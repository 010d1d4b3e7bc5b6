#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace fpkcheck::numerics {

/// System of ordinary differential equations dx/dt = f(t, x) with its Jacobian df/dx. If f or df/dx
/// returns false, since the state x is outside of the domain of f, CVODE repeats the step with a
/// smaller step size.
struct OdeSystem {
  std::function<bool(double t, const Eigen::VectorXd& x, Eigen::Ref<Eigen::VectorXd> rate)> rate;
  std::function<bool(double t, const Eigen::VectorXd& x, Eigen::Ref<Eigen::MatrixXd> jacobian)>
      jacobian;
};

struct BdfSettings {
  double relative_tolerance;
  double absolute_tolerance;  ///< absolute tolerance of every component of the state
  std::optional<double> max_step = {};
  std::optional<double> stop_time = {};  ///< time that no step exceeds
};

/// Integrator of a stiff system by CVODE with BDF of variable order 1 .. 5. The linear systems of
/// Newton's method are solved by LU factors of the dense matrix I - gamma df/dx.
class BdfIntegrator {
 public:
  /// @param initial_state state of the system at the time 0
  /// @throws std::runtime_error when SUNDIALS cannot be set up
  BdfIntegrator(OdeSystem system, const Eigen::VectorXd& initial_state,
                const BdfSettings& settings);
  ~BdfIntegrator();
  BdfIntegrator(const BdfIntegrator&) = delete;
  BdfIntegrator& operator=(const BdfIntegrator&) = delete;

  /// Advances the integration to `time`, at which the state is interpolated.
  /// @return whether `time` was reached; otherwise see error_message()
  /// @throws every exception of the functions of the system of equations
  bool advance_to_time(double time);

  Eigen::VectorXd current_state() const;
  const std::string& error_message() const;
  long step_count() const;

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace fpkcheck::numerics
