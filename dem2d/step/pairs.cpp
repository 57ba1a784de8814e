#include "dem2d/step/pairs.hpp"

#include <algorithm>
#include <cmath>

namespace bitrock::dem2d {

namespace {

using Values = std::vector<double>;

/// Discs sorted into square cells: `first` has one entry a cell and one more, `disc` holds the discs of each cell.
struct CellGrid {
  double x_low, y_low, size;
  int columns, rows;
  std::vector<int> first, disc;

  int column(double x) const { return std::clamp(static_cast<int>((x - x_low) / size), 0, columns - 1); }
  int row(double y) const { return std::clamp(static_cast<int>((y - y_low) / size), 0, rows - 1); }
};

CellGrid sort_into_cells(const Values& x, const Values& y, double reach) {
  CellGrid grid{};
  const auto [x_low, x_high] = std::minmax_element(x.begin(), x.end());
  const auto [y_low, y_high] = std::minmax_element(y.begin(), y.end());
  grid.x_low = *x_low;
  grid.y_low = *y_low;
  // A few discs flung far away would make a huge grid of empty cells: cells grow until there are about four a disc.
  const double width = *x_high - *x_low, height = *y_high - *y_low;
  const double discs_count = static_cast<double>(x.size());
  grid.size =
      std::max({reach, std::sqrt(width * height / (4.0 * discs_count)), std::max(width, height) / (4.0 * discs_count)});
  grid.columns = static_cast<int>(width / grid.size) + 1;
  grid.rows = static_cast<int>(height / grid.size) + 1;
  grid.first.assign(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows) + 1, 0);
  std::vector<int> cell(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    cell[i] = grid.row(y[i]) * grid.columns + grid.column(x[i]);
    ++grid.first[static_cast<std::size_t>(cell[i]) + 1];
  }
  for (std::size_t c = 1; c < grid.first.size(); ++c) grid.first[c] += grid.first[c - 1];
  grid.disc.resize(x.size());
  std::vector<int> next(grid.first.begin(), grid.first.end() - 1);
  for (std::size_t i = 0; i < x.size(); ++i) {
    grid.disc[static_cast<std::size_t>(next[static_cast<std::size_t>(cell[i])]++)] = static_cast<int>(i);
  }
  return grid;
}

/// Calls `visit(j)` for every disc j whose centre is at most the reach of both and a gap away from that of disc a.
template <class Visit>
void visit_near(const CellGrid& grid, const Values& x, const Values& y, const Values& reach, double gap, std::size_t a,
                const Visit& visit) {
  const int column = grid.column(x[a]), row = grid.row(y[a]);
  for (int r = std::max(row - 1, 0); r <= std::min(row + 1, grid.rows - 1); ++r) {
    // the three cells of one row are neighbours in memory
    const auto left = static_cast<std::size_t>(r * grid.columns + std::max(column - 1, 0));
    const auto right = static_cast<std::size_t>(r * grid.columns + std::min(column + 1, grid.columns - 1));
    for (int entry = grid.first[left]; entry < grid.first[right + 1]; ++entry) {
      const int j = grid.disc[static_cast<std::size_t>(entry)];
      const auto b = static_cast<std::size_t>(j);
      const double dx = x[b] - x[a], dy = y[b] - y[a], most = reach[a] + reach[b] + gap;
      if (dx * dx + dy * dy <= most * most && b != a) visit(j);
    }
  }
}

CellGrid grid_for(const Values& x, const Values& y, const Values& reach, double gap) {
  return sort_into_cells(x, y, 2.0 * *std::max_element(reach.begin(), reach.end()) + gap);
}

}  // namespace

Pairs pairs_within(const Discs& discs, double gap, std::size_t most) {
  Pairs pairs;
  if (discs.x.empty()) return pairs;
  const CellGrid grid = grid_for(discs.x, discs.y, discs.radius, gap);
  std::vector<int> found;
  for (int i = 0; i < discs.count() && pairs.disc1.size() <= most; ++i) {
    found.clear();
    visit_near(grid, discs.x, discs.y, discs.radius, gap, static_cast<std::size_t>(i), [&found, i](int j) {
      if (j > i) found.push_back(j);
    });
    std::sort(found.begin(), found.end());
    for (const int j : found) {
      pairs.disc1.push_back(i);
      pairs.disc2.push_back(j);
    }
  }
  return pairs;
}

Pairs marked_pairs(const Values& x, const Values& y, const Values& reach, const std::vector<char>& marked) {
  std::vector<std::pair<int, int>> found;
  const CellGrid grid = grid_for(x, y, reach, 0.0);
  for (std::size_t a = 0; a < x.size(); ++a) {
    if (marked[a] == 0) continue;
    visit_near(grid, x, y, reach, 0.0, a, [&found, &marked, i = static_cast<int>(a)](int j) {
      const bool seen_from_both = marked[static_cast<std::size_t>(j)] != 0;
      if (!seen_from_both || i < j) found.emplace_back(std::min(i, j), std::max(i, j));
    });
  }
  std::sort(found.begin(), found.end());
  Pairs pairs;
  for (const auto& [i, j] : found) {
    pairs.disc1.push_back(i);
    pairs.disc2.push_back(j);
  }
  return pairs;
}

}  // namespace bitrock::dem2d
