#include "lib/file/json/frame_file.h"

#include "lib/base/one_line.h"
#include "lib/file/json/read_bytes.h"
#include "lib/file/json/reading.h"

#include <fmt/format.h>

#include <exception>
#include <limits>

namespace mien {
namespace {

std::vector<FrameNumber> read_root(const Reading& in) {
  const JsonNode* frame = &in.tree.root();
  in.expect(*frame, JsonKind::object);
  for (const std::string_view inside : {"blendShapes", "points"})
    if (const JsonNode* found = in.find(*frame, inside)) {
      frame = found;
      break;
    }
  in.expect(*frame, JsonKind::object);
  std::vector<FrameNumber> numbers;
  in.for_each(*frame, [&](const JsonNode& child, int) {
    if (in.tree.key(child) == "comment") return;
    numbers.push_back(
        {std::string{in.tree.key(child)}, in.numbers(child, 1, 4), in.tree.where(child)});
  });
  return numbers;
}

}  // namespace

Expected<std::vector<FrameNumber>> read_frame_text(std::string_view text, std::string_view name,
                                                   const FaceLimits& limits) {
  if (text.size() > limits.bytes || text.size() > std::numeric_limits<std::uint32_t>::max())
    return Error{one_line(name), fmt::format("longer than {} bytes (limit: bytes)", limits.bytes)};
  try {
    const Expected<JsonTree> tree = JsonTree::read(text, name, limits);
    if (!tree) return tree.error();
    return read_root(Reading(*tree, limits, nullptr));
  } catch (const Refusal& refusal) {
    return refusal.error;
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
