// mien check --nonsense: whether faces stay faces in every pose, as a table of what is wrong how often.

#include <mien/composed_face.h>
#include <mien/parallel.h>
#include <mien/pose.h>
#include <mien/scene_from_face.h>
#include "lib/base/one_line.h"
#include "lib/base/watch.h"
#include "lib/file/json/json_text.h"
#include "lib/parts/recipe/own_part.h"
#include "render/image/load_encoder.h"
#include "render/image/write_pieces.h"
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/commands/posed_face.h"
#include "tools/mien/output/captioned_sheet.h"
#include "tools/mien/output/drawn_picture.h"
#include "tools/mien/output/letters.h"
#include "tools/mien/people/nonsense.h"
#include "tools/mien/people/parts_at_fault.h"
#include "tools/mien/terminal/interrupt.h"
#include "tools/mien/terminal/messages.h"
#include "tools/mien/terminal/watched_work.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace mien::command {
namespace {

constexpr long kMostTried = 100'000;

/// A face under test by what people call it, and what is wrong with it.
struct TriedFace {
  std::string name;
  Recipe recipe;
  std::optional<Face> face;  ///< none: of the recipe
  std::vector<NonsenseFault> faults;
  std::optional<Error> failed;
};

/// "300", "-3", "1e9": meant as a number, well or badly, rather than as a face.
bool looks_like_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789+-.,_e") == std::string_view::npos;
}

struct TriedOrCode {
  std::vector<TriedFace> faces;
  int code = kDone;
};

TriedOrCode people_of(std::string_view count_text, const CheckArguments& arguments) {
  const std::string seed = arguments.seed.value_or("1");
  std::vector<FoundPart> parts;
  for (const std::string& file : arguments.worn) {
    auto part = read_part_file(file);
    if (!part) return {{}, complain(part.error(), kFailed)};
    parts.push_back(*std::move(part));
  }
  const auto count = read_whole("--nonsense", count_text, 1, kMostTried);
  if (!count) return {{}, complain(count.error(), kUsedWrongly)};
  TriedOrCode tried;
  for (long i = 0; i < *count; ++i) {
    Recipe recipe = recipe_from_seed(seed_from_word(fmt::format("{}/{}", seed, i)));
    std::string name = recipe.code;
    for (const FoundPart& part : parts) wear(recipe, part);
    recipe.style = arguments.style.value_or(recipe.style);
    tried.faces.push_back({.name = std::move(name), .recipe = std::move(recipe)});
  }
  return tried;
}

TriedOrCode faces_to_try(const CheckArguments& arguments) {
  std::vector<std::string> names = arguments.people;
  std::erase(names, "");  // --nonsense alone
  if (!names.empty() && looks_like_number(names[0])) {
    if (arguments.faces.empty()) return people_of(names[0], arguments);
    return {{}, complain("--nonsense: takes N people or faces, not both", kUsedWrongly)};
  }
  if (arguments.seed) return {{}, complain("--seed: only with N people", kUsedWrongly)};
  if (arguments.style) return {{}, complain("--style: only with N people", kUsedWrongly)};
  names.insert(names.end(), arguments.faces.begin(), arguments.faces.end());
  if (names.empty()) return {{}, complain("--nonsense: needs N people, or a face", kUsedWrongly)};
  TriedOrCode tried;
  for (const std::string& name : names) {
    auto face = read_face_or_report(name);
    if (!face) return {{}, kFailed};
    tried.faces.push_back({.name = name, .face = std::move(face)});
  }
  return tried;
}

/// Of one check: in how many poses of how many faces something is wrong, the first of them, and what
/// parts the people share.
struct Wrong {
  int poses = 0, faces = 0;
  const TriedFace* face = nullptr;
  const NonsenseFault* first = nullptr;
  std::vector<PartAtFault> parts;
};

Wrong wrong_by(std::string_view check, const std::vector<TriedFace>& faces) {
  Wrong wrong;
  std::vector<const Recipe*> people;
  std::vector<char> faulty;
  for (const TriedFace& face : faces) {
    const std::string* last = nullptr;
    for (const NonsenseFault& fault : face.faults) {
      if (fault.check != check || (last && fault.pose == *last)) continue;
      wrong.faces += last == nullptr, ++wrong.poses;
      last = &fault.pose;
      if (!wrong.first) wrong.face = &face, wrong.first = &fault;
    }
    people.push_back(&face.recipe), faulty.push_back(last != nullptr);
  }
  wrong.parts = parts_at_fault(people, faulty);
  return wrong;
}

std::string as_json(const std::vector<TriedFace>& faces, std::size_t poses) {
  std::string text =
      fmt::format("{{\"faces\": {}, \"poses\": {}, \"checks\": [", faces.size(), poses);
  for (const NonsenseCheck& check : nonsense_checks()) {
    const Wrong wrong = wrong_by(check.name, faces);
    text += fmt::format("{}\n {{\"check\": \"{}\", \"faulty_poses\": {}, \"faulty_faces\": {}",
                        text.ends_with('[') ? "" : ",", check.name, wrong.poses, wrong.faces);
    if (wrong.first)
      text += fmt::format(
          ", \"first\": {{\"face\": {}, \"pose\": {}, \"what\": {}, \"measured\": {}, \"allowed\": "
          "{}}}",
          json_string(wrong.face->name), json_string(wrong.first->pose),
          json_string(wrong.first->what), json_number(wrong.first->measured),
          json_number(wrong.first->allowed));
    for (std::size_t i = 0; i < wrong.parts.size(); ++i)
      text +=
          fmt::format("{}{{\"family\": {}, \"part\": {}, \"faulty_faces\": {}, \"faces\": {}}}{}",
                      i ? ", " : ", \"parts\": [", json_string(wrong.parts[i].family),
                      json_string(wrong.parts[i].part), wrong.parts[i].faulty, wrong.parts[i].all,
                      i + 1 == wrong.parts.size() ? "]" : "");
    text += "}";
  }
  return text + "]}\n";
}

std::string as_table(const std::vector<TriedFace>& faces, std::size_t poses) {
  std::string text = fmt::format("{} faces, {} poses\n\n{:18}{:>7}{:>7}  first\n", faces.size(),
                                 poses, "check", "poses", "faces");
  for (const NonsenseCheck& check : nonsense_checks()) {
    const Wrong wrong = wrong_by(check.name, faces);
    text += fmt::format("{:18}{:7}{:7}", check.name, wrong.poses, wrong.faces);
    if (wrong.first)
      text += fmt::format("  {}  {}{}{}: {:.4g}, allowed {:.4g}", one_line(wrong.face->name, 60),
                          wrong.first->pose, wrong.first->what.empty() ? "" : ", ",
                          wrong.first->what, wrong.first->measured, wrong.first->allowed);
    for (std::size_t i = 0; i < wrong.parts.size(); ++i)
      text += fmt::format("{}{}={} {} of {}", i ? ", " : "; most with ", wrong.parts[i].family,
                          wrong.parts[i].part, wrong.parts[i].faulty, wrong.parts[i].all);
    text += "\n";
  }
  return text;
}

/// How far a fault is beyond what is allowed, as a share of that.
double excess(const NonsenseFault& fault) {
  constexpr double kLeast = 0.01;
  return std::abs(fault.measured - fault.allowed) / std::max(std::abs(fault.allowed), kLeast);
}

/// The face at the pose in which something is wrong, named after what is.
Expected<SheetCell> faulty_cell(const TriedFace& tried, const NonsenseFault& fault) {
  constexpr int kCell = 320;  // [px]
  const auto face =
      tried.face ? Expected<Face>(*tried.face) : face_from_recipe(tried.recipe, face_letters());
  if (!face) return face.error();
  Pose pose;
  std::string_view left = fault.pose;
  if (left == "rest") left = {};
  while (!left.empty()) {
    const std::size_t space = std::min(left.find(' '), left.size());
    const auto setting = read_setting(*face, left.substr(0, space));
    if (!setting) return setting.error();
    pose.settings.push_back(*setting);
    left.remove_prefix(std::min(space + 1, left.size()));
  }
  const Scene scene = scene_from_face(pose_face(*face, pose));
  const glm::dvec2 extent = scene.canvas().box.size();
  const auto size = read_size(std::to_string(kCell), extent.x / extent.y);
  if (!size) return size.error();
  return SheetCell{fmt::format("{} {}", fault.check, fault.pose),
                   sheet_picture(scene, {.width = size->width, .height = size->height})};
}

/// Of each check the case that is farthest beyond what is allowed, in one picture.
int draw_worst(const std::vector<TriedFace>& faces, const std::string& output) {
  std::vector<SheetCell> cells;
  for (const NonsenseCheck& check : nonsense_checks()) {
    const TriedFace* of = nullptr;
    const NonsenseFault* worst = nullptr;
    for (const TriedFace& face : faces)
      for (const NonsenseFault& fault : face.faults)
        if (fault.check == check.name && (!worst || excess(fault) > excess(*worst)))
          of = &face, worst = &fault;
    if (!worst) continue;
    auto cell = faulty_cell(*of, *worst);
    if (!cell) return complain(cell.error(), kFailed);
    if (!cells.empty() && cells[0].image.height != cell->image.height) continue;
    cells.push_back(*std::move(cell));
  }
  if (cells.empty()) return print("nothing is wrong: no picture is written\n");
  const auto sheet = captioned_sheet(cells, {std::min(4, int(cells.size())), 0});
  if (!sheet) return complain(sheet.error(), kFailed);
  const auto done = write_image_by(load_encoder, *sheet, output, {});
  return done ? int(kDone) : complain(done.error(), kFailed);
}

void try_face(const NonsenseTest& test, TriedFace& tried, std::size_t& poses) {
  std::optional<Face> face = tried.face;
  if (!face) {
    auto made = face_from_recipe(tried.recipe, face_letters());
    if (!made) {
      tried.failed = made.error();
      return;
    }
    face = *std::move(made);
  }
  poses = nonsense_poses(*face).size();
  tried.faults = test.faults(*face);
}

int try_and_tell(std::vector<TriedFace>& faces, const CheckArguments& arguments) {
  const NonsenseTest test;
  std::vector<std::size_t> poses(faces.size());
  watched_for("faces", int(faces.size()), {},
              [&](int i) { try_face(test, faces[std::size_t(i)], poses[std::size_t(i)]); });
  std::size_t all = 0;
  bool wrong = false;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (faces[i].failed) return complain(*faces[i].failed, kFailed);
    all += poses[i], wrong = wrong || !faces[i].faults.empty();
  }
  const int printed = print(arguments.json ? as_json(faces, all) : as_table(faces, all));
  if (arguments.output && printed == kDone)
    if (const int drawn = draw_worst(faces, *arguments.output); drawn != kDone) return drawn;
  return printed != kDone ? printed : wrong ? int(kFailed) : int(kDone);
}

}  // namespace

int nonsense_command(const CheckArguments& arguments) {
  TriedOrCode tried = faces_to_try(arguments);
  if (tried.code != kDone) return tried.code;
  try {
    return try_and_tell(tried.faces, arguments);
  } catch (const Stopped&) {
    // Here, since giving thousands of people back takes longer than anybody should wait.
    complain("interrupted", kFailed);
    die_of_interrupt();
  }
}

}  // namespace mien::command
