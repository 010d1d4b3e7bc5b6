#pragma once

#include <array>
#include <set>
#include <string>
#include <vector>

#include "workflows/sweep/report/figure/key_axis.hpp"
#include "workflows/sweep/report/figure/sweep_view.hpp"

namespace fpkcheck::sweep {

/// The smallest distance with a distinct colour; smaller distances have the same colour.
inline constexpr double kMinColourDistance = 1e-4;

/// Data of a map over the two varied keys, for a script. The design product has cells, whose
/// abscissae are their indices; other designs have points. Keeps a reference to the view.
class MapData {
 public:
  explicit MapData(const SweepView& view);

  const SweepView& view() const { return view_; }
  const KeyAxis& x() const { return x_; }
  const KeyAxis& y() const { return y_; }
  bool has_cells() const { return view_.plan().design == Design::product; }

  /// Data block $map_METHOD: x y L1. For cells a block for each y, with NaN where there is no
  /// distance.
  std::string blocks(std::size_t m) const;

  /// Data blocks $mark_METHOD_TYPE: x y, by point type (status_mark.hpp). The plane is divided into
  /// tiles with at most one mark of each type, since overlapping marks are illegible. Plans with
  /// few points show all marks.
  /// @param tiles_across, tiles_up  numbers of tiles in x and y
  /// @param types receives the point types that occur
  std::string mark_blocks(std::size_t m, std::size_t tiles_across, std::size_t tiles_up,
                          std::set<int>& types) const;

  /// Data block $outline_METHOD: the borders between cells that are ok and cells that are not;
  /// empty without such borders.
  std::string outline_block(std::size_t m) const;

  /// True where neighbouring cells have distances on both sides of `l1`; both keys must be numbers.
  bool has_contour(std::size_t m, double l1) const;

 private:
  std::size_t columns() const { return x_.values().size(); }
  std::size_t rows() const { return y_.values().size(); }
  std::array<double, 2> place(std::size_t point) const;

  const SweepView& view_;
  KeyAxis x_, y_;
  std::vector<std::vector<std::size_t>> cells_;  // point of each cell, by x and y
};

}  // namespace fpkcheck::sweep
