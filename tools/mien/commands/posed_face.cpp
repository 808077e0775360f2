#include "tools/mien/commands/posed_face.h"
#include <mien/bound_motion.h>
#include <mien/composed_face.h>
#include <mien/face_code.h>
#include <mien/face_file.h>
#include <mien/face_model.h>
#include <mien/morph_file.h>
#include <mien/motion_file.h>
#include <mien/npy_basis.h>
#include <mien/poser.h>
#include <mien/scene_from_face.h>
#include "lib/base/one_line.h"
#include "lib/file/json/frame_file.h"
#include "lib/file/motion/take_names.h"
#include "lib/parts/recipe/recipe_file.h"
#include "lib/rig/pose/expression_setting.h"
#include "sdf/from_face/debug_view.h"
#include "tools/mien/cli/option_words.h"
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/commands/sample_face.h"
#include "tools/mien/output/letters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

namespace mien::command {

namespace {

/// Whether something is called so: a link that leads nowhere, or back to itself, too.
bool is_there(const std::string& name) {
  std::error_code too_long;  // codes that hold much are longer than a file's name may be
  return std::filesystem::exists(std::filesystem::symlink_status(name, too_long));
}

/// The error about a FACE that cannot be read. A word that is no file's name stands for a person elsewhere.
Error with_word_explained(Error error, const std::string& text) {
  if (text == "-") return {text, "faces are read from files; /dev/stdin is standard input's"};
  if (text.find_first_of("./\\") != std::string::npos || is_there(text)) return error;
  const bool plain = std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '-' || c == '_' || c >= 128;
  });
  const std::string word = one_line(text, 60);
  return {error.where,
          fmt::format("there is no such file; `mien new --seed {}` prints the code of a "
                      "person for any word",
                      plain ? word : in_quotes(word))};
}

}  // namespace

bool is_given_as_code(const std::string& text) {
  return looks_like_face_code(text) && !is_there(text);
}

Expected<Recipe> read_given_recipe(const std::string& given, std::vector<Error>* warnings) {
  const std::string text = sample_face_path(given);
  if (!is_given_as_code(text)) {
    auto recipe = read_recipe_file(text, warnings);
    if (!recipe) return with_word_explained(recipe.error(), text);
    return recipe;
  }
  const auto code = read_face_code(text);
  if (!code) return code.error();
  return recipe_from_code(*code);
}

Expected<Face> face_of_recipe(Recipe recipe, const std::optional<std::string>& style,
                              bool neutral) {
  if (style) recipe.style = *style;
  if (neutral) recipe = neutral_recipe(std::move(recipe));
  return face_from_recipe(recipe, face_letters());
}

Expected<Face> read_face_or_code(const std::string& given, const std::optional<std::string>& style,
                                 std::vector<Error>* warnings, bool neutral) {
  const std::string text = sample_face_path(given);
  if (style || is_given_as_code(text)) {
    auto recipe = read_given_recipe(text, warnings);
    if (!recipe) return recipe.error();
    return face_of_recipe(*std::move(recipe), style, neutral);
  }
  if (neutral)
    if (auto recipe = read_recipe_file(text, warnings))
      return face_of_recipe(*std::move(recipe), style, neutral);
  auto face = read_face(text, {}, warnings, face_letters());
  if (!face) return with_word_explained(face.error(), text);
  return neutral ? without_mood(*face) : *std::move(face);
}

std::optional<Face> read_face_or_report(const std::string& path,
                                        const std::optional<std::string>& style, bool neutral) {
  if (path.empty()) {
    complain(Error{"face file", "its name is empty"}, kFailed);
    return {};
  }
  std::vector<Error> warnings;
  auto face = read_face_or_code(path, style, &warnings, neutral);
  warn(warnings);
  if (face) return *std::move(face);
  complain(face.error(), kFailed);
  return {};
}

namespace {

/// The setting of a control from an option like --blink 0.5; the address of an error is the option.
Expected<Setting> read_control(const Face& face, const std::string& name,
                               const std::string& value) {
  const std::string where = "--" + name + " " + one_line(value, 60);
  const auto& controls = face.model->controls;
  if (std::none_of(controls.begin(), controls.end(),
                   [&](const Control& control) { return control.name == name; }))
    return Error{where, fmt::format("this face has no control \"{}\"", name)};
  auto setting = read_setting(face, name + "=" + value);
  if (setting) return setting;
  return Error{where, setting.error().what};
}

/// Lays a file's motion on top of the others. What the file and the face do not agree in is told.
Expected<Done> add_motion_file(const std::string& file, const Face& face, Pose& pose) {
  std::vector<Error> told;
  auto motion = read_motion(file, &told);
  if (!motion) return motion.error();
  const BoundMotion bound = bind_motion(*std::move(motion), face);
  if (!bound.unfollowed.empty())
    told.push_back(
        {file, fmt::format("this face does not follow {}", fmt::join(bound.unfollowed, ", "))});
  warn(told);
  pose.motions.push_back({.motion = bound.motion});
  return Done{};
}

/// The settings of --arkit, or the motion, if it is a take. Errors are addressed to the place in the file.
Expected<Pose> read_arkit(const Face& face, const PosedFace& arguments) {
  const OutOfRange out = arguments.clamp ? OutOfRange::clamp : OutOfRange::refuse;
  Pose pose;
  if (!arguments.arkit) return pose;
  const auto frame = read_frame(*arguments.arkit);
  if (!frame) {
    if (arguments.time && add_motion_file(*arguments.arkit, face, pose)) return pose;
    return frame.error();
  }
  for (const FrameNumber& number : *frame) {
    if (is_turn_of_head_or_eye(number.name))
      continue;  // what stands beside the shapes in many files
    if (number.values.size() != 1)
      return Error{number.where, fmt::format("expected 1 number, got {}", number.values.size())};
    auto setting =
        read_expression(face, "arkit", fmt::format("{}={}", number.name, number.values[0]), out);
    if (!setting) return Error{number.where, setting.error().what};
    pose.settings.push_back(*std::move(setting));
  }
  return pose;
}

/// Adds the settings of --emotion and --muscle.
Expected<Done> read_expressions(const Face& face, const PosedFace& arguments, Pose& pose) {
  const OutOfRange out = arguments.clamp ? OutOfRange::clamp : OutOfRange::refuse;
  for (const auto& [set, texts] :
       {std::pair{"emotion", &arguments.emotions}, {"muscle", &arguments.muscles}})
    for (const std::string& text : *texts) {
      auto setting = read_expression(face, set, text, out);
      if (!setting)
        return Error{fmt::format("--{} {}", set, setting.error().where), setting.error().what};
      pose.settings.push_back(*std::move(setting));
    }
  return Done{};
}

/// A number from 0 to `most`, if one is given.
Expected<Done> read_share_of(const char* option, const std::optional<std::string>& text,
                             double most, double& to) {
  if (!text) return Done{};
  const auto number = read_real(option, *text, 0, most);
  if (!number) return number.error();
  to = *number;
  return Done{};
}

/// Adds --clip, --motion, --speech, --seed, --liveliness, --gestures and --pose.
Expected<Done> read_moves(const Face& face, const PosedFace& arguments, Pose& pose) {
  if (arguments.seed) pose.seed = seed_from_word(*arguments.seed);
  if (auto read = read_share_of("--liveliness", arguments.liveliness, kMostLively, pose.liveliness);
      !read)
    return read;
  if (auto read = read_share_of("--gestures", arguments.gestures, kMostGestures, pose.gestures);
      !read)
    return read;
  for (const std::string& text : arguments.clips) {
    const auto layer = read_clip_layer(face, text);
    if (!layer) return Error{"--clip " + layer.error().where, layer.error().what};
    pose.motions.push_back(*layer);
  }
  if (arguments.motion)
    if (auto added = add_motion_file(*arguments.motion, face, pose); !added) return added;
  if (arguments.speech) {
    // Speech moves the mouth alone: the face lives on.
    const Index<Motion> idle = face.model->default_clip;
    if (pose.motions.empty() && idle) pose.motions.push_back({.clip = idle});
    if (auto added = add_motion_file(*arguments.speech, face, pose); !added) return added;
  }
  for (const std::string& text : arguments.poses) {
    auto weight = mien::read_pose(face, text);
    if (!weight) return Error{"--pose " + weight.error().where, weight.error().what};
    pose.settings.push_back(*std::move(weight));
  }
  return Done{};
}

/// Adds --unwrap and --unwrap-mode.
Expected<Done> read_unwrap(const PosedFace& arguments, Pose& pose) {
  if (arguments.unwrap) {
    const auto share = read_share("unwrap", *arguments.unwrap);
    if (!share) return share.error();
    pose.unwrap = *share;
  }
  if (arguments.unwrap_mode) {
    const auto mode = read_choice("--unwrap-mode", *arguments.unwrap_mode, kUnwrapModes);
    if (!mode) return mode.error();
    pose.unwrap_mode = UnwrapMode(*mode);
  }
  return Done{};
}

/// The moment of --time. What runs needs one.
Expected<std::optional<double>> read_moment(const PosedFace& arguments) {
  if (arguments.time) {
    const auto time = read_time(*arguments.time);
    if (!time) return time.error();
    return std::optional(*time);
  }
  if (!arguments.clips.empty())
    return Error{"--clip " + one_line(arguments.clips[0], 60),
                 "a clip runs at a moment: say --time"};
  if (const auto& file = arguments.motion ? arguments.motion : arguments.speech)
    return Error{one_line(*file, 60), "a motion runs at a moment: say --time"};
  return std::optional<double>();
}

/// The pose of the options. Later settings beat earlier ones, so the order here is their precedence.
Expected<Pose> read_pose(const Face& face, const PosedFace& arguments, const Pose& arkit) {
  const auto at = read_moment(arguments);
  if (!at) return at.error();
  Pose pose;
  pose.time = *at;
  if (auto moved = read_moves(face, arguments, pose); !moved) return moved.error();
  if (arguments.look_at) {
    const auto target = read_look_at(face, *arguments.look_at);
    if (!target) return Error{"--look-at " + target.error().where, target.error().what};
    pose.look_at = *target;
  }
  if (auto chart = read_unwrap(arguments, pose); !chart) return chart.error();
  for (const auto& [name, value] :
       {std::pair{"blink", &arguments.blink}, {"bias", &arguments.bias}})
    if (*value) {
      auto setting = read_control(face, name, **value);
      if (!setting) return setting.error();
      pose.settings.push_back(*std::move(setting));
    }
  pose.motions.insert(pose.motions.end(), arkit.motions.begin(), arkit.motions.end());
  pose.settings.insert(pose.settings.end(), arkit.settings.begin(), arkit.settings.end());
  if (auto pulled = read_expressions(face, arguments, pose); !pulled) return pulled.error();
  for (const std::string& text : arguments.settings) {
    auto setting = read_setting(face, text);
    if (!setting) return setting.error();
    pose.settings.push_back(*std::move(setting));
  }
  if (arguments.neutral) pose.liveliness = 0;
  return pose;
}

/// Adds --basis and --weights.
int take_basis(const PosedFace& arguments, const Face& face, Pose& pose) {
  if (arguments.weights && !arguments.basis)
    return complain("--weights are those of a --basis", kUsedWrongly);
  if (!arguments.basis) return kDone;
  const auto file = read_basis(*arguments.basis);
  if (!file) return complain(file.error(), kFailed);
  const auto basis = face_basis(*file, face);
  if (!basis) return complain(Error{*arguments.basis, basis.error().what}, kFailed);
  pose.basis = std::make_shared<const FaceBasis>(*basis);
  std::string_view text = arguments.weights ? *arguments.weights : std::string_view{};
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    const auto weight = read_real("--weights", text.substr(0, comma), -1e9, 1e9);
    if (!weight) return complain(weight.error(), kUsedWrongly);
    pose.basis_weights.push_back(*weight);
    text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
  }
  if (pose.basis_weights.size() > pose.basis->basis.count)
    return complain(fmt::format("--weights: the basis has {} components, not {}",
                                pose.basis->basis.count, pose.basis_weights.size()),
                    kUsedWrongly);
  return kDone;
}

}  // namespace

Expected<Pose> read_pose_options(const Face& face, const PosedFace& arguments) {
  return read_pose(face, arguments, {});
}

FaceAndPoseOrCode read_face_and_pose(const PosedFace& arguments, const Face* known) {
  // Before the face is read.
  if (const auto at = read_moment(arguments); !at)
    return {{}, {}, complain(at.error(), kUsedWrongly)};
  auto face =
      known ? *known : read_face_or_report(arguments.face, arguments.style, arguments.neutral);
  if (!face) return {{}, {}, kFailed};
  for (const std::string& file : arguments.morphs) {
    auto more = read_morphs(*face, file);
    if (!more) return {{}, {}, complain(more.error(), kFailed)};
    face = *std::move(more);
  }
  const auto arkit = read_arkit(*face, arguments);
  if (!arkit) return {{}, {}, complain(arkit.error(), kFailed)};
  auto pose = read_pose(*face, arguments, *arkit);
  if (!pose) return {{}, {}, complain(pose.error(), kUsedWrongly)};
  if (const int code = take_basis(arguments, *face, *pose); code != kDone) return {{}, {}, code};
  return {std::move(face), *std::move(pose), kDone};
}

SceneOrCode read_scene(const PosedFace& arguments, const std::optional<std::string>& debug) {
  int view = -1;
  if (debug) {
    const auto chosen = read_choice("--debug", *debug, kFaceDebugs);
    if (!chosen) return {{}, complain(chosen.error(), kUsedWrongly)};
    view = *chosen;
  }
  const auto began = std::chrono::steady_clock::now();
  FaceAndPoseOrCode read = read_face_and_pose(arguments);
  if (!read.face) return {{}, read.code};
  if (view == 0 && read.face->model->muscles.muscles.empty())
    return {{}, complain(Error{"--debug muscles", "this face has no muscles"}, kUsedWrongly)};
  Poser poser(*std::move(read.face));
  const Face& posed = poser.pose(read.pose);
  const auto between = std::chrono::steady_clock::now();
  SceneOrCode made{view == 0   ? debug_muscles(posed, poser.pulls(), letters())
                   : view == 1 ? debug_points(posed, letters())
                               : scene_from_face(posed)};
  made.read = std::chrono::duration<double>(between - began).count();
  made.made = std::chrono::duration<double>(std::chrono::steady_clock::now() - between).count();
  return made;
}

PosedOrCode read_posed_face(const PosedFace& arguments, const Face* known) {
  const FaceAndPoseOrCode read = read_face_and_pose(arguments, known);
  if (!read.face) return {{}, read.code};
  return {pose_face(*read.face, read.pose), kDone};
}

}  // namespace mien::command
