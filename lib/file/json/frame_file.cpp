#include "lib/file/json/frame_file.h"

#include "lib/base/memory_ran_out.h"
#include "lib/base/one_line.h"
#include "lib/file/json/frame_members.h"
#include "lib/file/json/read_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <limits>

namespace mien {
namespace {

/// The members of a frame: what stands beside it is said.
class FrameReader {
 public:
  FrameReader(const Reading& in, std::vector<FrameMember>* beside) : in_(in), beside_(beside) {}

  std::vector<FrameMember> read(const JsonNode& node) {
    const JsonNode* frame = &node;
    while (const JsonNode* inside = wrapped(*frame)) frame = inside;
    if (frame->kind == JsonKind::array && frame->count > 0)
      read_categories(*frame);
    else
      read_members(*frame);
    return std::move(members_);
  }

 private:
  /// What MediaPipe and others put frames into: {"faceBlendshapes": [{"categories": […]}]}, {"blendShapes": {…}}. A
  /// wrapper holds nothing else but what is known to be about it.
  const JsonNode* wrapped(const JsonNode& node) const {
    if (node.kind == JsonKind::array) return only_face(node);
    if (node.kind != JsonKind::object) return nullptr;
    const JsonNode* found = nullptr;
    for (const std::string_view key : {"blendShapes", "blendshapes", "points", "faceBlendshapes",
                                       "face_blendshapes", "categories", "visemes"})
      if (const JsonNode* one = in_.find(node, key)) {
        if (found) refuse_beside(*one, *found);
        found = one;
      }
    if (!found) return nullptr;
    in_.for_each(node, [&](const JsonNode& child, int) {
      if (&child != found && !is_about_frames(in_.tree.key(child))) stands_beside(child, *found);
    });
    if (found->kind != JsonKind::object && found->kind != JsonKind::array)
      in_.expect(*found, JsonKind::object);
    return found;
  }

  void stands_beside(const JsonNode& child, const JsonNode& found) const {
    if (!beside_) refuse_beside(child, found);
    beside_->push_back({in_.tree.key(child), &child});
  }

  [[noreturn]] void refuse_beside(const JsonNode& child, const JsonNode& found) const {
    in_.refuse(child,
               fmt::format("stands beside {}, which is the frame: put it inside, or leave it out",
                           in_quotes(in_.tree.key(found))));
  }

  static bool is_about_frames(std::string_view key) {
    constexpr std::string_view kKnown[] = {
        "comment",    "headIndex",     "headName",
        "head_index", "head_name",     "timestamp",
        "time",       "timestampMs",   "timestamp_ms",
        "timecode",   "faceLandmarks", "face_landmarks",
        "frame",      "index",         "facialTransformationMatrixes",
        "frameIndex", "frame_index",   "facial_transformation_matrixes",
        "isTracked",  "is_tracked",    "success"};
    return std::find(std::begin(kKnown), std::end(kKnown), key) != std::end(kKnown);
  }

  /// The face of a list of faces; null: a list of categories.
  const JsonNode* only_face(const JsonNode& list) const {
    const JsonNode* first = in_.tree.first(list);
    if (!first || (first->kind == JsonKind::object && in_.find(*first, "categoryName")) ||
        (first->kind == JsonKind::object && in_.find(*first, "category_name")))
      return nullptr;
    if (list.count > 1)
      in_.refuse(list, fmt::format("holds {} faces; a frame is of one", list.count));
    return first;
  }

  /// [{"categoryName": "jawOpen", "score": 0.4}, …]
  void read_categories(const JsonNode& list) {
    in_.for_each(list, [&](const JsonNode& child, int) {
      in_.expect(child, JsonKind::object);
      const JsonNode* name = in_.find(child, "categoryName");
      if (!name)
        name =
            &in_.need(child, in_.find(child, "category_name") ? "category_name" : "categoryName");
      take(in_.string(*name), in_.need(child, "score"));
    });
  }

  void read_members(const JsonNode& frame) {
    in_.expect(frame, JsonKind::object);
    in_.for_each(frame, [&](const JsonNode& child, int) { take(in_.tree.key(child), child); });
  }

  void take(std::string_view name, const JsonNode& value) {
    // MediaPipe's share of "none of them" moves nothing.
    if (name != "_neutral" && !is_about_frames(name)) members_.push_back({name, &value});
  }

  const Reading& in_;
  std::vector<FrameMember>* beside_;
  std::vector<FrameMember> members_;
};

}  // namespace

std::vector<FrameMember> frame_members(const Reading& in, const JsonNode& node,
                                       std::vector<FrameMember>* beside) {
  return FrameReader(in, beside).read(node);
}

Expected<std::vector<FrameNumber>> read_frame_text(std::string_view text, std::string_view name,
                                                   const FaceLimits& limits) {
  if (text.size() > limits.bytes || text.size() > std::numeric_limits<std::uint32_t>::max())
    return Error{one_line(name), fmt::format("longer than {} bytes (limit: bytes)", limits.bytes)};
  try {
    const Expected<JsonTree> tree = JsonTree::read(text, name, limits);
    if (!tree) return tree.error();
    const Reading in(*tree, limits, nullptr);
    std::vector<FrameNumber> numbers;
    for (const auto& [member, value] : frame_members(in, tree->root()))
      numbers.push_back({std::string(member), in.numbers(*value, 1, 4), tree->where(*value)});
    return numbers;
  } catch (const Refusal& refusal) {
    return refusal.error;
  } catch (const std::bad_alloc&) {
    return memory_ran_out(name);
  } catch (const std::exception& e) {
    return Error{one_line(name), fmt::format("cannot be read: {}", one_line(e.what()))};
  }
}

Expected<std::vector<FrameNumber>> read_frame(const std::filesystem::path& path,
                                              const FaceLimits& limits) {
  const auto text = read_bytes(path, limits.bytes);
  if (!text) return text.error();
  return read_frame_text(*text, path.string(), limits);
}

}  // namespace mien
