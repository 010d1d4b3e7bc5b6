#include "epc/closed_form_density.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "base/input_error.hpp"
#include "epc/contact/coordinates.hpp"
#include "epc/contact/store_density.hpp"
#include "epc/gaussian/density_support.hpp"
#include "epc/moment/density.hpp"
#include "epc/polar/coordinates.hpp"
#include "problem/walls.hpp"
#include "transform/coordinate_transformation.hpp"
#include "transform/marginal_density.hpp"

namespace fpkcheck::epc {
namespace {

using transform::SmoothDensity;

const problem::Problem& require_problem(const problem::Problem* problem,
                                        const ClosedFormDensityParameters& frame) {
  if (problem != nullptr) return *problem;
  if (frame.variables == ExponentCoordinates::polar ||
      frame.variables == ExponentCoordinates::contact) {
    throw InputError(
        fmt::format("coordinates \"{}\" depend on the oscillator: none was given; name its case",
                    name(frame.variables)));
  }
  throw InputError("\"support.energy\" depends on the oscillator: none was given; name its case");
}

SmoothDensity density_in_plane(const ClosedFormDensity& form) {
  const auto& [q, frame] = form;
  if (frame.deviations) {
    const gaussian::DensitySupport support(q, *frame.deviations);
    return gaussian::density_from_exponent(
        q, support, frame.log_constant.value_or(gaussian::log_normalising_constant(support)));
  }
  const DensityBoundingBox box = frame.box.value();
  return transform::zhuravlev_transform(
      {.value =
           [polynomial = q, box, constant = frame.log_constant.value_or(0)](double x1, double x2) {
             const bool inside = std::abs(x1) <= box.y_max && std::abs(x2) <= box.v_max;
             return inside ? std::exp(polynomial(x1, x2) + constant) : 0;
           },
       .x1_max = box.y_max,
       .x2_max = box.v_max});
}

SmoothDensity density_in_physical_variables(const ClosedFormDensity& form,
                                            const problem::Problem* problem) {
  const auto& [q, frame] = form;
  if (frame.deviations) {
    const gaussian::DensitySupport support(q, *frame.deviations);
    return gaussian::density_without_wall(
        q, support, frame.log_constant.value_or(gaussian::log_normalising_constant(support)));
  }
  const double constant = frame.log_constant.value_or(0);
  if (std::isfinite(frame.support)) {
    return moment::density_from_exponent(
        q, moment::EnergySublevelSet(require_problem(problem, frame), frame.support), {frame.level},
        constant);
  }
  const DensityBoundingBox box = frame.box.value();
  return {.value =
              [polynomial = q, box, constant](double y, double v) {
                const bool inside = y >= box.y_min && y <= box.y_max && std::abs(v) <= box.v_max;
                return inside ? std::exp(polynomial(y, v) + constant) : 0;
              },
          .y_max = box.y_max,
          .v_max = box.v_max,
          .y_min = box.y_min};
}

SmoothDensity density_in_polar_variables(const ClosedFormDensity& form,
                                         const problem::Problem* problem) {
  const auto& [q, frame] = form;
  const polar::AmplitudePhaseCoordinates coordinates(require_problem(problem, frame));
  const double constant = frame.log_constant.value_or(0);
  if (std::isfinite(frame.support)) {
    return amplitude::density_from_exponent(q, coordinates, frame.support, {frame.level}, constant);
  }
  const DensityBoundingBox box = frame.box.value();
  return {.value =
              [polynomial = q, coordinates, box, constant](double y, double v) {
                const bool inside = y >= 0 && y <= box.y_max && std::abs(v) <= box.v_max;
                return inside ? std::exp(polynomial(coordinates.amplitude_of(y, v),
                                                    coordinates.phase_of(y, v)) +
                                         constant)
                              : 0;
              },
          .y_max = box.y_max,
          .v_max = box.v_max};
}

contact::AmplitudeVelocityCoordinates contact_coordinates(const problem::Problem& problem) {
  if (contact::spring_presses_on_single_wall(problem))
    return contact::AmplitudeVelocityCoordinates(problem);
  throw InputError(
      "coordinates \"amplitude,velocity\" need one wall against which the force presses: the case "
      "has none; name its case");
}

SmoothDensity density_in_contact_variables(const ClosedFormDensity& form,
                                           const problem::Problem* problem) {
  const auto& [q, frame] = form;
  const auto coordinates = contact_coordinates(require_problem(problem, frame));
  const double constant = frame.log_constant.value_or(0);
  if (std::isfinite(frame.support)) {
    return amplitude::density_from_exponent(q, coordinates, frame.support, {frame.level}, constant);
  }
  const DensityBoundingBox box = frame.box.value();
  const double far = std::numeric_limits<double>::infinity();
  return {
      .value =
          [whole = amplitude::density_from_exponent(q, coordinates, far, {frame.level}, constant),
           box](double y, double v) {
            return y <= box.y_max && std::abs(v) <= box.v_max ? whole.value(y, v) : 0;
          },
      .y_max = box.y_max,
      .v_max = box.v_max};
}

SmoothDensity density_in_form_coordinates(const ClosedFormDensity& form,
                                          const problem::Problem* problem) {
  switch (form.frame.variables) {
    case ExponentCoordinates::plane:
      return density_in_plane(form);
    case ExponentCoordinates::physical:
      return density_in_physical_variables(form, problem);
    case ExponentCoordinates::polar:
      return density_in_polar_variables(form, problem);
    case ExponentCoordinates::contact:
      return density_in_contact_variables(form, problem);
  }
  return {};
}

std::optional<problem::Problem> problem_in_coordinates(const problem::WallFrame& coordinates,
                                                       const problem::Problem* problem) {
  if (problem == nullptr) return std::nullopt;
  if (coordinates.is_identity() || problem->frame == coordinates) return *problem;
  if (problem::wall_frame(problem->system) == coordinates) {
    return problem::to_wall_coordinates(coordinates, *problem);
  }
  throw InputError(
      fmt::format("\"frame.origin\" = {:g}: the oscillator has no wall there; name the case of "
                  "the solution",
                  coordinates.origin));
}

// Returns the integral of the density of a closed form without constant C, with the atom at rest.
double integrate_with_atom(const ClosedFormDensity& form, const problem::Problem* problem,
                           const SmoothDensity& density) {
  if (form.frame.variables != ExponentCoordinates::contact) {
    return transform::marginals_at_quadrature_points(density, density.y_max, density.v_max,
                                                     transform::QuadraturePanelSpacing::graded)
        .mass;
  }
  return transform::mass(contact::average_on_graded_cells(density)) +
         contact_coordinates(*problem).relative_atom_probability() * std::exp(form.q(0, 0));
}

bool has_support(const ClosedFormDensityParameters& frame) {
  return frame.deviations || std::isfinite(frame.support) || frame.box;
}

}  // namespace

bool can_be_normalised(const ClosedFormDensity& form) {
  return form.frame.log_constant || has_support(form.frame);
}

SmoothDensity density_of_closed_form(const ClosedFormDensity& form,
                                     const problem::Problem* problem) {
  ClosedFormDensity whole = form;
  ClosedFormDensityParameters& frame = whole.frame;
  const auto converted = problem_in_coordinates(frame.coordinates, problem);
  const problem::Problem* form_problem = converted ? &*converted : nullptr;
  const auto on_physical_axes = [&](SmoothDensity density) {
    return std::get<SmoothDensity>(
        transform::to_physical_coordinates(frame.coordinates, std::move(density)));
  };
  const bool bounded = has_support(frame);
  if (!bounded) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    frame.box = DensityBoundingBox{kFar, kFar};
  }
  SmoothDensity result = density_in_form_coordinates(whole, form_problem);
  if (frame.log_constant || frame.deviations || !bounded) {
    return on_physical_axes(std::move(result));
  }
  const double mass = integrate_with_atom(whole, form_problem, result);
  if (!(mass > 0) || !std::isfinite(mass)) {
    throw InputError(
        fmt::format("the integral over the support is {:g} (must be positive and finite)", mass));
  }
  frame.log_constant = -std::log(mass);
  return on_physical_axes(density_in_form_coordinates(whole, form_problem));
}

}  // namespace fpkcheck::epc
