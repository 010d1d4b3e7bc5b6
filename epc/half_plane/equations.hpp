#pragma once

#include <utility>

#include "epc/half_plane/basis.hpp"
#include "epc/half_plane/galerkin_system.hpp"
#include "epc/half_plane/quadrature_points.hpp"

namespace fpkcheck::epc::half_plane {

/// Galerkin equations for the functions of a basis, with the basis and the quadrature points.
class ClosureEquations : public GalerkinSystem {
 public:
  ClosureEquations(GalerkinTables tables, Basis basis, QuadraturePoints points)
      : GalerkinSystem(std::move(tables)), basis_(std::move(basis)), points_(std::move(points)) {}

  const Basis& basis() const { return basis_; }
  const QuadraturePoints& points() const { return points_; }

 private:
  Basis basis_;
  QuadraturePoints points_;
};

}  // namespace fpkcheck::epc::half_plane
