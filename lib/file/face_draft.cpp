#include <mien/lib/base/nearest_name.h>
#include <mien/lib/base/one_line.h>
#include "face_draft_private.h"

#include <fmt/format.h>

namespace mien {
namespace {

/// "brow.left/spine/0" as its author names it: "brow/spine/0".
std::string author_name(const Slice& slice) {
  std::string name = slice.name;
  const std::size_t slash = name.find('/');
  for (const std::string_view side : {".left", ".right"})
    if (slash >= side.size() && slash != std::string::npos &&
        name.compare(slash - side.size(), side.size(), side) == 0)
      return name.erase(slash - side.size(), side.size());
  return name;
}

}  // namespace

int FaceDraft::add_slice(const Reading& in, const JsonNode& node, std::string name, SliceKind kind,
                         std::span<const double> values) {
  if (vector.size() + values.size() > in.limits.numbers)
    in.refuse(node,
              fmt::format("more than {} numbers in the face (limit: numbers)", in.limits.numbers));
  vector.insert(vector.end(), values.begin(), values.end());
  return model.layout.add(std::move(name), kind, int(values.size()));
}

int FaceDraft::find_slice(std::string_view name, Side side) const {
  if (side != Side::none) {
    const std::size_t slash = name.find('/');
    std::string sided = feature_of_side(name.substr(0, slash), side);
    if (slash != std::string_view::npos) sided += name.substr(slash);
    if (const int found = model.layout.find(sided); found >= 0) return found;
  }
  return model.layout.find(name);
}

int FaceDraft::find_feature(std::string_view name, Side side) const {
  auto found = feature_by_name.find(feature_of_side(name, side));
  if (found == feature_by_name.end()) found = feature_by_name.find(std::string{name});
  return found == feature_by_name.end() ? -1 : found->second;
}

int FaceDraft::slice_named(const Reading& in, const JsonNode& node, std::string_view name,
                           Side side) const {
  const int found = find_slice(name, side);
  if (found >= 0) return found;
  std::vector<std::string> known;
  for (const Slice& slice : model.layout.slices())
    known.push_back(model.layout.find(name) < 0 ? author_name(slice) : slice.name);
  in.refuse(node, unknown_name("number", name, {known.begin(), known.end()}));
}

int FaceDraft::reference(const Reading& in, const JsonNode& node, Side side, SliceKind kind,
                         int size) const {
  const std::string_view text = in.string(node);
  if (!text.starts_with('@'))
    in.refuse(node, fmt::format("expected numbers or a reference like \"@opening/upper\", got {}",
                                in_quotes(text)));
  const int found = slice_named(in, node, text.substr(1), side);
  const Slice& slice = model.layout[found];
  if (slice.kind != kind || slice.size != size)
    in.refuse(node, fmt::format("{} is a {} of {}, but a {} of {} is needed here", in_quotes(text),
                                kind_name(slice.kind), slice.size, kind_name(kind), size));
  return found;
}

bool FaceDraft::is_mirrored(int slice) const {
  const std::string_view name = model.layout[slice].name;
  const auto found = feature_by_name.find(std::string{name.substr(0, name.find('/'))});
  return found != feature_by_name.end() && mirrored[std::size_t(found->second)];
}

std::vector<double> read_slice_values(const Reading& in, const JsonNode& node, SliceKind kind,
                                      int least, int most, const FaceCanvas& canvas,
                                      bool mirrored) {
  std::vector<double> values = in.numbers(node, least, most);
  if (kind == SliceKind::length || kind == SliceKind::ratio)
    for (const double value : values)
      if (value < 0)
        in.refuse(node, fmt::format("a {} must not be negative, got {}", kind_name(kind), value));
  if (mirrored) mirror_values(kind, values, canvas.twice_axis());
  return values;
}

}  // namespace mien
