#include "render/rows/row_sums.h"

#include <algorithm>

namespace mien {
namespace {

/// Left of the picture x counts as at the border.
PartStretch stretch_of(const CellStretch& c) {
  const auto x = [&](double at) {
    return c.column < 0 ? 0.0f : std::clamp(float(at - c.column), 0.0f, 1.0f);
  };
  const auto y = [&](double at) { return std::clamp(float(at - c.row), 0.0f, 1.0f); };
  return {x(c.xp), y(c.yp), x(c.xm), y(c.ym), x(c.xq), y(c.yq), 1.0f};
}

}  // namespace

void RowSums::begin(int rows, int width) {
  const std::size_t stride = std::size_t(width) + 2, words = (std::size_t(width) + 65) / 64;
  if (stride != stride_ || sums_.size() < stride * std::size_t(rows)) {
    width_ = width, stride_ = stride, mark_words_ = words;
    sums_.assign(stride * std::size_t(rows), {});
    marks_.assign(words * std::size_t(rows), 0);
    hints_.assign(stride * std::size_t(rows), 0);
    first_shares_.assign(stride * std::size_t(rows), -1);
    shares_.resize(std::size_t(rows)), stretches_.resize(std::size_t(rows));
  }
}

void RowSums::share(int row, int column, const CellPart& part, const PartStretch& stretch,
                    int left_varied, int right_varied) {
  int& first = first_shares(row)[std::max(column, 0)];
  std::vector<LookShare>& shares = shares_[std::size_t(row)];
  shares.push_back({first, left_varied, right_varied, part.area, part.height});
  stretches_[std::size_t(row)].push_back(stretch);
  first = int(shares.size()) - 1;
}

void RowSums::add(const OutlinePiece& piece, double top, double bottom, int first, const Rgba& jump,
                  int left_varied, int right_varied, int right_look) {
  const bool varied = left_varied >= 0 || right_varied >= 0;
  const auto add_cell = [&, jump](int row, int at, const CellPart& part) {
    const std::size_t column = std::size_t(std::max(at, 0));
    Rgba* const to = sums(row) + column;
    to[0] = to[0] + part.area * jump;
    to[1] = to[1] + (part.height - part.area) * jump;
    marks(row)[column >> 6] |= std::uint64_t{1} << (column & 63);
    hints_[std::size_t(row) * stride_ + column] = right_look;
    ++cells_;
  };
  const auto add_row = [&](const RowStretch& s) {
    cells_of_row(piece, s, width_, [&](const CellStretch& c) {
      const CellPart part{float(c.area), float(c.yq - c.yp)};
      add_cell(c.row - first, c.column, part);
      if (varied) share(c.row - first, c.column, part, stretch_of(c), left_varied, right_varied);
    });
  };
  ranges_of(top, bottom, width_, [&](const RowRange& range) {
    if (range.rows == 1) return add_row(row_stretch(piece, range));
    RowRoots at;
    row_roots(piece, range, at, varied);
    for (int k = 0; k < range.rows; ++k) {
      const auto i = std::size_t(k);
      const int row = range.first_row + k - first, column = at.column[i], last = at.column[i + 1];
      if (std::abs(last - column) > 1) {
        add_row(row_stretch(range, at, k));
        continue;
      }
      const auto add_part = [&](int in, const RowRoots::Cells& cells) {
        add_cell(row, in, cells.part(i));
        if (varied && in < width_)
          share(row, in, cells.part(i), cells.stretch(i), left_varied, right_varied);
      };
      add_part(column, at.first);
      if (last != column) add_part(last, at.second);
    }
  });
}

}  // namespace mien
