#pragma once

#include <utility>

#include "epc/half_plane/basis.hpp"
#include "epc/half_plane/galerkin.hpp"
#include "epc/half_plane/points.hpp"

namespace fpkcheck::epc::half_plane {

/// Galerkin equations for the members of a basis.
class Equations : public Galerkin {
 public:
  Equations(GalerkinTables tables, Basis basis, Points points)
      : Galerkin(std::move(tables)), basis_(std::move(basis)), points_(std::move(points)) {}

  const Basis& basis() const { return basis_; }
  const Points& points() const { return points_; }

 private:
  Basis basis_;
  Points points_;
};

}  // namespace fpkcheck::epc::half_plane
