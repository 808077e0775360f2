#pragma once
// A slice's numbers as a face file writes them.

#include <mien/slice.h>
#include "lib/file/json/json_tree.h"
#include "lib/file/json/text_edits.h"

#include <optional>
#include <span>
#include <vector>

namespace mien {

/// What the file has for the other side, so that it reads back as exactly these values; none: rounding is in the way.
std::optional<std::vector<double>> written_mirrored(SliceKind kind, std::span<const double> values,
                                                    double twice_axis);

/// Puts numbers where a slice stands; those that are there already stay as they are written. A colour becomes "#rrggbb"
/// where one was and where it is one exactly, else a list of channels.
void write_slice(const JsonTree& tree, const JsonNode& node, const Slice& slice,
                 std::span<const double> values, TextEdits& to);

}  // namespace mien
