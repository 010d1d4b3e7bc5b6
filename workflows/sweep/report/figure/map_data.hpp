#pragma once

#include <array>
#include <set>
#include <string>
#include <vector>

#include "workflows/sweep/report/figure/key_axis.hpp"
#include "workflows/sweep/report/figure/sweep_view.hpp"

namespace fpkcheck::sweep {

/// The smallest distance that has a colour of its own.
inline constexpr double kLeastColour = 1e-4;

/// The two varied keys as a plane, and what stands in it as data of a script. The design product
/// has cells, the abscissae of which are their numbers; others have points. Refers to the view.
class MapData {
 public:
  explicit MapData(const SweepView& view);

  const SweepView& view() const { return view_; }
  const KeyAxis& x() const { return x_; }
  const KeyAxis& y() const { return y_; }
  bool in_cells() const { return view_.plan().design == Design::product; }

  /// $map_METHOD: x y L1; of cells a block for each y, NaN where there is no distance.
  std::string blocks(std::size_t m) const;

  /// $mark_METHOD_TYPE: x y, by point type (status_mark.hpp). The plane has tiles, of which each
  /// has one of each type at most: marks that run into each other tell nothing. Few points have
  /// all.
  /// @param across, up  how many tiles there are
  /// @param types gets those that there are
  std::string mark_blocks(std::size_t m, std::size_t across, std::size_t up,
                          std::set<int>& types) const;

  /// $outline_METHOD: the borders between cells that are ok and those that are not; empty without.
  std::string outline_block(std::size_t m) const;

  /// Whether some neighbouring cells have distances on both sides of this one, both keys being
  /// numbers.
  bool crosses(std::size_t m, double l1) const;

 private:
  std::size_t columns() const { return x_.values().size(); }
  std::size_t rows() const { return y_.values().size(); }
  std::array<double, 2> place(std::size_t point) const;

  const SweepView& view_;
  KeyAxis x_, y_;
  std::vector<std::vector<std::size_t>> cells_;  // points, by cell of x and y
};

}  // namespace fpkcheck::sweep
