#pragma once

#include <array>
#include <set>
#include <string>
#include <vector>

#include "workflows/sweep/report/figure/key_axis.hpp"
#include "workflows/sweep/report/figure/sweep_view.hpp"

namespace fpkcheck::sweep {

/// The smallest L1 distance with a distinct colour; all smaller distances have the colour of this
/// distance.
inline constexpr double kMinColourDistance = 1e-4;

/// The data of a map over the two varied keys, for a gnuplot script. A map of the design product
/// has cells, with the indices of the values as coordinates; a map of another design has points. A
/// MapData object keeps a reference to the view.
class MapData {
 public:
  explicit MapData(const SweepView& view);

  const SweepView& view() const { return view_; }
  const KeyAxis& x() const { return x_; }
  const KeyAxis& y() const { return y_; }
  bool has_cells() const { return view_.plan().design == PlanDesign::product; }

  /// The data block $map_METHOD of a method with the columns x, y and L1. A map with cells has a
  /// sub-block for each y, with NaN for missing distances.
  std::string blocks(std::size_t m) const;

  /// The data blocks $mark_METHOD_TYPE of a method with the columns x and y, a block for each point
  /// type (status_mark.hpp). The plane is divided into tiles with at most one mark of each type,
  /// since overlapping marks are illegible. A map with few points shows all marks.
  /// @param tiles_across, tiles_up  numbers of tiles in x and y
  /// @param types set to which the point types that occur are added
  std::string mark_blocks(std::size_t m, std::size_t tiles_across, std::size_t tiles_up,
                          std::set<int>& types) const;

  /// The data block $outline_METHOD of a method with the borders between cells that are ok and
  /// cells that are not ok. The data block is omitted (empty text) if the map has no such border.
  std::string outline_block(std::size_t m) const;

  /// Whether the map of a method has a contour at `l1`: neighbouring cells have distances on both
  /// sides of `l1`. Both keys must be numeric.
  bool has_contour(std::size_t m, double l1) const;

 private:
  std::size_t columns() const { return x_.values().size(); }
  std::size_t rows() const { return y_.values().size(); }
  std::array<double, 2> coordinates_of(std::size_t point) const;

  const SweepView& view_;
  KeyAxis x_, y_;
  std::vector<std::vector<std::size_t>> cells_;  // point of each cell, by x and y
};

}  // namespace fpkcheck::sweep
