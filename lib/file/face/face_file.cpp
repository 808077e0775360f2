#include <mien/composed_face.h>
#include <mien/face_file.h>
#include <mien/pose.h>
#include "lib/base/memory_ran_out.h"

#include "face_draft_private.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/file/json/read_bytes.h"
#include "lib/parts/compose/compose.h"
#include "lib/parts/recipe/person_seed.h"
#include "lib/parts/recipe/recipe_file.h"

#include <fmt/format.h>

#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <string>

namespace mien {
namespace {

constexpr int kNewestVersion = 2;  // 1: a face in full; 2: a recipe

/// Returns the version.
int check_format(Reading& in, const JsonNode& root) {
  const JsonNode& format = in.need(root, "format");
  if (in.string(format) != "mien-face")
    in.refuse(format, fmt::format("expected \"mien-face\", got {}", in_quotes(in.string(format))));
  const JsonNode& version = in.need(root, "format_version");
  const double number = in.number(version);
  if (number > kNewestVersion && number == double(std::int64_t(number)))
    in.refuse(
        version,
        fmt::format("format version {} is newer than this program, which reads 1 and 2", number));
  if (number != 1 && number != kNewestVersion)
    in.refuse(version, fmt::format("expected the integer 1 or 2, got {}", number));
  return int(number);
}

void read_effects(Reading& in, const JsonNode& node, FaceModel& model) {
  in.expect(node, JsonKind::array);
  in.for_each(node, [&](const JsonNode& child, int) {
    const auto effect = read_effect(in.string(child));
    if (!effect) in.refuse(child, effect.error().what);
    model.effects.push_back(*effect);
  });
}

Index<Motion> clip_named(const Reading& in, const JsonNode& node, const FaceModel& model) {
  std::vector<std::string_view> known;
  for (const Motion& clip : model.clips) known.push_back(clip.name);
  return {int(in.word(node, "clip", known))};
}

/// The face as it rests. `model` is the face's own, which nobody else has yet.
Face in_its_mood(Face neutral, FaceModel& model) {
  Face rest = pose_face(neutral);
  model.mood_shift = rest.vector;
  for (std::size_t i = 0; i < rest.vector.size(); ++i) model.mood_shift[i] -= neutral.vector[i];
  return rest;
}

/// Where a file is from: what its own parts and its seed come of.
struct Origin {
  const std::filesystem::path* folder;  ///< where a recipe's own parts lie; null: there can be none
  std::uint64_t seed;                   ///< of a face in full
};

Face read_root(Reading& in, const Origin& origin, const Letters& letters, SlicePlaces* places);

/// A recipe, put together and read.
Face read_composed(const Recipe& recipe, const FaceLimits& limits, std::vector<Error>* warnings,
                   const Letters& letters) {
  const auto parts = ChosenParts::read(recipe);
  if (!parts) throw Refusal{parts.error()};
  const auto tree = composed_face(*parts);
  if (!tree) throw Refusal{tree.error()};
  if (auto beyond = tree->beyond(limits)) throw Refusal{*std::move(beyond)};
  Reading in(*tree, limits, warnings);
  return read_root(in, {nullptr, person_seed(recipe)}, letters, nullptr);
}

/// `places`: of the slices, which a recipe has none of; null: nobody asks.
Face read_root(Reading& in, const Origin& origin, const Letters& letters, SlicePlaces* places) {
  const JsonNode& root = in.tree.root();
  in.expect(root, JsonKind::object);
  const JsonNode* version = in.find(root, "format_version");
  if (!version || version->kind != JsonKind::number || version->number != 2)
    in.expect_object(
        root, {"$schema",     "format",  "format_version", "name",         "credit",   "canvas",
               "background",  "palette", "light",          "groups",       "features", "controls",
               "poses",       "eyes",    "mouth",          "turn",         "muscles",  "emotions",
               "expressions", "mood",    "clips",          "default_clip", "effects"});
  if (check_format(in, root) == 2)
    return read_composed(read_recipe(in, root, origin.folder), in.limits, in.warnings(), letters);
  FaceDraft draft;
  draft.letters = &letters, draft.places = places;
  FaceModel& model = draft.model;
  model.layout.largest = in.limits.magnitude;
  model.seed = origin.seed;
  if (const JsonNode* name = in.find(root, "name")) model.name = in.string(*name);
  if (const JsonNode* credit = in.find(root, "credit")) model.credit = in.string(*credit);
  read_canvas(in, in.need(root, "canvas"), draft);
  read_palette(in, in.need(root, "palette"), draft);
  model.background = read_paint(in, in.need(root, "background"), draft);
  if (const JsonNode* light = in.find(root, "light")) read_light(in, *light, draft);
  const JsonNode* groups = in.find(root, "groups");
  if (groups) read_groups(in, *groups, draft);
  read_features(in, in.need(root, "features"), draft);
  if (groups) read_group_clips(in, *groups, draft);
  if (const JsonNode* controls = in.find(root, "controls")) read_controls(in, *controls, draft);
  if (const JsonNode* eyes = in.find(root, "eyes")) read_eyes(in, *eyes, draft);
  if (const JsonNode* mouth = in.find(root, "mouth")) read_mouth(in, *mouth, draft);
  if (const JsonNode* turn = in.find(root, "turn")) read_turn(in, *turn, draft);
  if (const JsonNode* poses = in.find(root, "poses")) read_poses(in, *poses, draft);
  if (const JsonNode* muscles = in.find(root, "muscles")) read_muscles(in, *muscles, draft);
  if (const JsonNode* emotions = in.find(root, "emotions")) read_emotions(in, *emotions, draft);
  if (const JsonNode* sets = in.find(root, "expressions")) read_expressions(in, *sets, draft);
  const bool has_mood = read_mood(in, in.find(root, "mood"), draft);
  if (const JsonNode* clips = in.find(root, "clips")) read_clips(in, *clips, draft);
  if (const JsonNode* effects = in.find(root, "effects")) read_effects(in, *effects, model);
  if (const JsonNode* wanted = in.find(root, "default_clip"))
    model.default_clip = clip_named(in, *wanted, model);
  FaceVector rest = draft.vector;
  apply_rules(model.layout, draft.vector, rest);  // wraps angles
  const auto made = std::make_shared<FaceModel>(std::move(model));
  return has_mood ? in_its_mood({made, std::move(rest)}, *made) : Face{made, std::move(rest)};
}

Error too_long(std::string_view name, const FaceLimits& limits) {
  return {one_line(name), fmt::format("longer than {} bytes (limit: bytes)", limits.bytes)};
}

/// Whatever ends the reading as an error.
template <class Made, class Read>
Expected<Made> read_safely(std::string_view name, Read&& read) {
  try {
    return read();
  } catch (const Refusal& refusal) {
    return refusal.error;
  } catch (const std::bad_alloc&) {
    return memory_ran_out(name);
  } catch (const std::exception& e) {
    return Error{one_line(name), fmt::format("cannot be read: {}", one_line(e.what()))};
  }
}

/// The face alone.
Expected<Face> face_of(Expected<PlacedFace> read) {
  if (!read) return read.error();
  return std::move(read->face);
}

}  // namespace

Expected<PlacedFace> read_placed_face(std::string_view text, std::string_view name,
                                      const std::filesystem::path* folder, const FaceLimits& limits,
                                      const Letters& letters, std::vector<Error>* warnings) {
  if (text.size() > limits.bytes || text.size() > std::numeric_limits<std::uint32_t>::max())
    return too_long(name, limits);
  return read_safely<PlacedFace>(name, [&]() -> Expected<PlacedFace> {
    Expected<JsonTree> tree = JsonTree::read(text, name, limits);
    if (!tree) return tree.error();
    Reading in(*tree, limits, warnings);
    SlicePlaces places;
    Face face = read_root(in, {folder, seed_from_word(text)}, letters, &places);
    places.resize(face.model->layout.slices().size());
    return PlacedFace{*std::move(tree), std::move(face), std::move(places)};
  });
}

Expected<Face> read_face(const std::filesystem::path& path, const FaceLimits& limits,
                         std::vector<Error>* warnings, const Letters& letters) try {
  try {
    const Expected<std::string> text = read_bytes(path, limits.bytes);
    if (!text) return text.error();
    const std::filesystem::path folder = path.parent_path();
    return face_of(read_placed_face(*text, path.string(), &folder, limits, letters, warnings));
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    return Error{{}, fmt::format("cannot read the face: {}", one_line(e.what()))};
  }
} catch (const std::bad_alloc&) {
  return memory_ran_out(path.native());
}

Expected<Face> read_face_text(std::string_view text, std::string_view name,
                              const FaceLimits& limits, std::vector<Error>* warnings,
                              const Letters& letters) try {
  return face_of(read_placed_face(text, name, nullptr, limits, letters, warnings));
} catch (const std::bad_alloc&) {
  return memory_ran_out(name);
}

Expected<Face> face_from_recipe(const Recipe& recipe, const Letters& letters) try {
  return read_safely<Face>(
      recipe.name.empty() ? "composed face" : recipe.name,
      [&]() -> Expected<Face> { return read_composed(recipe, {}, nullptr, letters); });
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

}  // namespace mien
