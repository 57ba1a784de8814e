#include "dem2d/step/pairs.hpp"

#include <algorithm>
#include <cmath>

namespace dem2d {

namespace {

/// Discs sorted into square cells: `first` has one entry a cell and one more, `disc` holds the discs of each cell.
struct CellGrid {
  double x_low, y_low, size;
  int columns, rows;
  std::vector<int> first, disc;

  int column(double x) const { return std::clamp(static_cast<int>((x - x_low) / size), 0, columns - 1); }
  int row(double y) const { return std::clamp(static_cast<int>((y - y_low) / size), 0, rows - 1); }
};

CellGrid sort_into_cells(const Discs& discs, double reach) {
  CellGrid grid{};
  const auto [x_low, x_high] = std::minmax_element(discs.x.begin(), discs.x.end());
  const auto [y_low, y_high] = std::minmax_element(discs.y.begin(), discs.y.end());
  grid.x_low = *x_low;
  grid.y_low = *y_low;
  // A few discs flung far away would make a huge grid of empty cells: cells grow until there are about four a disc.
  const double width = *x_high - *x_low, height = *y_high - *y_low;
  const double discs_count = static_cast<double>(discs.x.size());
  grid.size =
      std::max({reach, std::sqrt(width * height / (4.0 * discs_count)), std::max(width, height) / (4.0 * discs_count)});
  grid.columns = static_cast<int>(width / grid.size) + 1;
  grid.rows = static_cast<int>(height / grid.size) + 1;
  const auto cell_of = [&](std::size_t i) {
    return static_cast<std::size_t>(grid.row(discs.y[i])) * static_cast<std::size_t>(grid.columns) +
           static_cast<std::size_t>(grid.column(discs.x[i]));
  };
  grid.first.assign(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows) + 1, 0);
  for (std::size_t i = 0; i < discs.x.size(); ++i) ++grid.first[cell_of(i) + 1];
  for (std::size_t c = 1; c < grid.first.size(); ++c) grid.first[c] += grid.first[c - 1];
  grid.disc.resize(discs.x.size());
  std::vector<int> next(grid.first.begin(), grid.first.end() - 1);
  for (std::size_t i = 0; i < discs.x.size(); ++i) {
    grid.disc[static_cast<std::size_t>(next[cell_of(i)]++)] = static_cast<int>(i);
  }
  return grid;
}

}  // namespace

Pairs pairs_within(const Discs& discs, double gap, std::size_t most) {
  Pairs pairs;
  if (discs.x.empty()) return pairs;
  const double largest = *std::max_element(discs.radius.begin(), discs.radius.end());
  const CellGrid grid = sort_into_cells(discs, 2.0 * largest + gap);
  std::vector<int> found;
  for (int i = 0; i < discs.count() && pairs.disc1.size() <= most; ++i) {
    const auto a = static_cast<std::size_t>(i);
    found.clear();
    const int column = grid.column(discs.x[a]), row = grid.row(discs.y[a]);
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, grid.rows - 1); ++r) {
      // the three cells of one row are neighbours in memory
      const auto left = static_cast<std::size_t>(r * grid.columns + std::max(column - 1, 0));
      const auto right = static_cast<std::size_t>(r * grid.columns + std::min(column + 1, grid.columns - 1));
      for (int entry = grid.first[left]; entry < grid.first[right + 1]; ++entry) {
        const int j = grid.disc[static_cast<std::size_t>(entry)];
        if (j <= i) continue;
        const auto b = static_cast<std::size_t>(j);
        const double dx = discs.x[b] - discs.x[a], dy = discs.y[b] - discs.y[a];
        const double reach = discs.radius[a] + discs.radius[b] + gap;
        if (dx * dx + dy * dy <= reach * reach) found.push_back(j);
      }
    }
    std::sort(found.begin(), found.end());
    for (const int j : found) {
      pairs.disc1.push_back(i);
      pairs.disc2.push_back(j);
    }
  }
  return pairs;
}

}  // namespace dem2d
