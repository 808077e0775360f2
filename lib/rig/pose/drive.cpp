#include "lib/rig/pose/drive.h"

#include <algorithm>

namespace mien {
namespace {

/// Where `value` lies in a table of keys: `u` of the way from key `i` to key `j`.
struct Between {
  std::size_t i, j;
  double u;
};

Between between_keys(const std::vector<double>& at, double value) {
  const auto next = std::upper_bound(at.begin(), at.end(), value);
  if (next == at.begin()) return {0, 0, 0};
  const auto i = std::size_t(next - at.begin()) - 1;
  if (next == at.end()) return {i, i, 0};
  return {i, i + 1, (value - at[i]) / (at[i + 1] - at[i])};
}

void act(const Offset& offset, double value, const Channel& channel, const Layout& layout,
         FaceVector& vector, std::vector<double>&) {
  const Slice& slice = layout[offset.slice];
  for (int i = 0; i < slice.size; ++i)
    vector[std::size_t(slice.begin + i)] += (value - channel.rest) * offset.by[std::size_t(i)];
}

void act(const Scale& scale, double value, const Channel&, const Layout& layout, FaceVector& vector,
         std::vector<double>&) {
  const Slice& slice = layout[scale.slice];
  for (int i = 0; i < slice.size; ++i) vector[std::size_t(slice.begin + i)] *= value;
}

/// Tracks may look at each other's slices, so all are read before any is written.
void act(const KeyShapes& table, double value, const Channel&, const Layout& layout,
         FaceVector& vector, std::vector<double>& mixed) {
  const Between b = between_keys(table.at, value);
  const auto number = [&](const KeyValue& key, int i) {
    return key.from >= 0 ? vector[std::size_t(layout[key.from].begin + i)]
                         : key.numbers[std::size_t(i)];
  };
  mixed.clear();
  for (const KeyTrack& track : table.tracks)
    for (int i = 0; i < layout[track.slice].size; ++i) {
      const double from = number(track.values[b.i], i), to = number(track.values[b.j], i);
      mixed.push_back(from + b.u * (to - from));
    }
  auto next = mixed.begin();
  for (const KeyTrack& track : table.tracks)
    for (int i = 0; i < layout[track.slice].size; ++i)
      vector[std::size_t(layout[track.slice].begin + i)] = *next++;
}

/// At a share of 1 the sum could miss `to` by a rounding error, but a shape asked for alone is exactly that
/// shape.
void act(const Toward& toward, double value, const Channel& channel, const Layout& layout,
         FaceVector& vector, std::vector<double>&) {
  const double share = value - channel.rest;
  const auto begin = std::size_t(layout[toward.slice].begin);
  for (std::size_t i = 0; i < toward.to.size(); ++i) {
    double& now = vector[begin + i];
    const double from = toward.from[i], to = toward.to[i];
    now = share == 1 && now == from ? to : now + share * (to - from);
  }
}

}  // namespace

void drive(const Channel& channel, double value, const Layout& layout, FaceVector& vector,
           std::vector<double>& scratch) {
  for (const Drive& d : channel.drives)
    std::visit([&](const auto& one) { act(one, value, channel, layout, vector, scratch); }, d);
}

void drive(const Channel& channel, double value, const Layout& layout, FaceVector& vector) {
  std::vector<double> scratch;
  drive(channel, value, layout, vector, scratch);
}

}  // namespace mien
