#pragma once

#include <string>

#include "epc/half_plane/contour.hpp"
#include "epc/half_plane/root.hpp"
#include "epc/summary.hpp"

/// From a root to a result: what the formulations on the half-plane say of it alike.
namespace fpkcheck::epc::half_plane {

/// How the search went; the status is not_converged, for the reason that it failed if it did.
Result reported(const Root& root);

/// All of the density but its coefficients.
Frame frame_of(const Shape& shape, Tail tail, Variables variables);

/// The edge of the support and the contour of the level.
struct Edges {
  Contour support, level;
  double density;  ///< largest on the edge of the support, relative to the peak
};

/// Condition, coefficients, support and tail, once the density has been put into the solution.
/// @param sigma by which the plane is scaled
void describe(const Root& root, Tail tail, const transform::SmoothDensity& density,
              const Deviations& sigma, const Edges& edges, Result& result);

/// The status. A root that the quadrature does not resolve is none; one is not to be relied on
/// where
///  - the formulation objects;
///  - its mass, by a rule of its own, is not 1: moments and marginals would carry the error;
///  - too much of it lies where the confinement begins, or beyond: that shapes it.
/// How far the density is from the truth it does not say: no distance to another order does.
/// @param quadrature_allowed by how much more points may change Q_n, in standard deviations
/// @param objection of the formulation; empty when there is none
void conclude(const Root& root, double quadrature_allowed, const std::string& objection,
              Result& result);

/// The deviations from 0 of a density with such moments.
Deviations deviations(const transform::Moments& moments);

}  // namespace fpkcheck::epc::half_plane
