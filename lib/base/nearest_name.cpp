#include "lib/base/nearest_name.h"

#include "lib/base/one_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace mien {
namespace {

constexpr std::size_t kLongestWanted = 100;  ///< a longer text is no mistyped name
constexpr int kMostEdits = 8;

}  // namespace

int edit_distance(std::string_view a, std::string_view b, int most) {
  const int n = int(a.size()), m = int(b.size());
  if (std::abs(n - m) > most) return most + 1;
  std::vector<int> before(m + 1), last(m + 1), row(m + 1);  // rows i − 2, i − 1 and i of the table
  for (int j = 0; j <= m; ++j) last[j] = j;
  for (int i = 1; i <= n; ++i) {
    row[0] = i;
    int least = i;
    for (int j = 1; j <= m; ++j) {
      const bool same = a[i - 1] == b[j - 1];
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
      least = std::min(least, row[j]);
    }
    if (least > most) return most + 1;
    before.swap(last);
    last.swap(row);
  }
  return std::min(last[m], most + 1);
}

std::string_view nearest_name(std::string_view wanted, const std::vector<std::string_view>& names) {
  if (wanted.size() > kLongestWanted) return {};
  std::string_view best;
  int most = std::min<int>(kMostEdits, int(wanted.size() + 1) / 2);
  for (const std::string_view name : names) {
    const int edits = edit_distance(wanted, name, most);
    if (edits > most) continue;
    best = name;
    most = edits - 1;
    if (most < 0) break;
  }
  return best;
}

std::string unknown_name(std::string_view what, std::string_view wanted,
                         const std::vector<std::string_view>& names) {
  const std::string_view near = nearest_name(wanted, names);
  if (near.empty()) return fmt::format("no {} named {}", what, in_quotes(wanted));
  return fmt::format("no {} named {}; did you mean {}?", what, in_quotes(wanted), in_quotes(near));
}

}  // namespace mien
