#include <mien/morph_file.h>
#include "lib/base/memory_ran_out.h"

#include <mien/face_model.h>
#include "face_draft_private.h"
#include "lib/base/one_line.h"
#include "lib/file/json/json_text.h"
#include "lib/file/json/read_bytes.h"

#include <fmt/format.h>

#include <cstdio>

namespace mien {
namespace {

constexpr double kMostWeight = 100;  // of a target made from files, either way

std::string numbers_text(const FaceVector& vector, const Slice& slice) {
  std::string text;
  for (int i = 0; i < slice.size; ++i)
    text += fmt::format("{}{}", i ? ", " : "", vector[std::size_t(slice.begin + i)]);
  return text;
}

bool same_layout(const Layout& a, const Layout& b) {
  if (a.slices().size() != b.slices().size()) return false;
  for (std::size_t i = 0; i < a.slices().size(); ++i)
    if (a.slices()[i].name != b.slices()[i].name || a.slices()[i].size != b.slices()[i].size ||
        a.slices()[i].kind != b.slices()[i].kind)
      return false;
  return true;
}

std::string first_other(const Layout& a, const Layout& b) {
  for (const Slice& slice : a.slices()) {
    const int found = b.find(slice.name);
    if (found < 0) return fmt::format("it has no {}", in_quotes(slice.name));
    if (b[found].size != slice.size)
      return fmt::format("its {} has {} numbers, not {}", in_quotes(slice.name), b[found].size,
                         slice.size);
  }
  return "it has more of them, or in another order";
}

std::string target_text(const Face& rest, const MorphTarget& target) {
  std::string text;
  for (const Slice& slice : rest.model->layout.slices()) {
    const auto begin = std::size_t(slice.begin), end = begin + std::size_t(slice.size);
    if (std::equal(rest.vector.begin() + long(begin), rest.vector.begin() + long(end),
                   target.face.vector.begin() + long(begin)))
      continue;
    text += fmt::format("{}\n        {}: [{}]", text.empty() ? "" : ",", json_string(slice.name),
                        numbers_text(target.face.vector, slice));
  }
  return fmt::format("    {}: {{\n      \"range\": [-{}, {}],\n      \"slices\": {{{}{}}}\n    }}",
                     json_string(target.name), kMostWeight, kMostWeight, text,
                     text.empty() ? "" : "\n      ");
}

/// A finished face as a draft, so that the reader of poses can add to it.
FaceDraft draft_of(const Face& face) {
  FaceDraft draft;
  draft.model = *face.model;
  draft.vector = face.vector;
  for (std::size_t i = 0; i < draft.model.features.size(); ++i)
    draft.features.enter(draft.model.features[i].name, int(i));
  for (std::size_t i = 0; i < draft.model.controls.size(); ++i)
    draft.controls.enter(draft.model.controls[i].name, int(i));
  // Names in these files are whole, sides and all, so nothing is mirrored.
  draft.mirrored.assign(draft.model.features.size(), 0);
  return draft;
}

Face face_with(Reading& in, const Face& face) {
  const JsonNode& root = in.tree.root();
  in.expect_object(root, {"format", "format_version", "face", "poses"});
  const JsonNode& format = in.need(root, "format");
  if (in.string(format) != "mien-morphs")
    in.refuse(format,
              fmt::format("expected \"mien-morphs\", got {}", in_quotes(in.string(format))));
  if (const JsonNode& version = in.need(root, "format_version"); in.number(version) != 1)
    in.refuse(version, fmt::format("expected the integer 1, got {}", in.number(version)));
  FaceDraft draft = draft_of(face);
  read_poses(in, in.need(root, "poses"), draft);
  return {std::make_shared<const FaceModel>(std::move(draft.model)), face.vector};
}

}  // namespace

Expected<std::string> morph_text(const Face& rest, const std::vector<MorphTarget>& targets) try {
  std::string poses;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const MorphTarget& target = targets[i];
    for (std::size_t j = 0; j < i; ++j)
      if (targets[j].name == target.name)
        return Error{"", fmt::format("two targets are called {}", in_quotes(target.name))};
    if (!same_layout(rest.model->layout, target.face.model->layout))
      return Error{"", fmt::format("{} is another face, not this one in another shape: {}",
                                   in_quotes(target.name),
                                   first_other(rest.model->layout, target.face.model->layout))};
    poses += (poses.empty() ? "\n" : ",\n") + target_text(rest, target);
  }
  std::string text = fmt::format(
      "{{\n  \"format\": \"mien-morphs\",\n  \"format_version\": 1,\n  \"face\": {},\n"
      "  \"poses\": {{{}\n  }}\n}}\n",
      json_string(rest.model->name), poses);
  // What is written must read back. Reading it here keeps the rules for names in one place.
  if (const auto again = read_morphs_text(rest, text); !again) return Error{"", again.error().what};
  return text;
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

Expected<Face> read_morphs_text(const Face& face, std::string_view text,
                                std::string_view name) try {
  const FaceLimits limits;
  if (text.size() > limits.bytes)
    return Error{one_line(name), fmt::format("longer than {} bytes", limits.bytes)};
  try {
    const Expected<JsonTree> tree = JsonTree::read(text, name, limits);
    if (!tree) return tree.error();
    Reading in(*tree, limits, nullptr);
    return face_with(in, face);
  } catch (const Refusal& refusal) {
    return refusal.error;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    return Error{one_line(name), fmt::format("cannot be read: {}", one_line(e.what()))};
  }
} catch (const std::bad_alloc&) {
  return memory_ran_out(name);
}

Expected<Face> read_morphs(const Face& face, const std::filesystem::path& path) try {
  const auto text = read_bytes(path, FaceLimits{}.bytes);
  if (!text) return text.error();
  return read_morphs_text(face, *text, path.string());
} catch (const std::bad_alloc&) {
  return memory_ran_out(path.native());
}

}  // namespace mien
