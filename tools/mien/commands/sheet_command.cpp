// mien sheet: a grid of one face at many poses, of people or of parts, each with its name.

#include <mien/composed_face.h>
#include <mien/crowd.h>
#include <mien/face_model.h>
#include <mien/poser.h>
#include <mien/render.h>
#include <mien/scene_from_face.h>
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/parts/code/keyed_chance.h"
#include "lib/parts/recipe/own_part.h"
#include "render/image/load_encoder.h"
#include "render/image/write_pieces.h"
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/cli/sheet_options.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/commands/posed_face.h"
#include "tools/mien/commands/render_plan.h"
#include "tools/mien/output/captioned_sheet.h"
#include "tools/mien/output/drawn_picture.h"
#include "tools/mien/output/letters.h"
#include "tools/mien/people/people_statistics.h"
#include "tools/mien/terminal/watched_work.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <iterator>

namespace mien::command {
namespace {

constexpr double kTurned = 12;  // [degrees] how far a crowd's heads turn unless it is said

using Cells = std::vector<SheetCell>;

struct CellsOrCode {
  Cells cells;
  int code = kDone;
};

/// A sheet, or what ended it.
struct SheetOrCode {
  std::optional<Image> sheet;
  int code = kDone;
};

SheetOrCode finished(CaptionedSheet sheet) {
  auto image = std::move(sheet).finish();
  if (!image) return {{}, complain(image.error(), kFailed)};
  return {*std::move(image)};
}

constexpr int kDefaultCell = 320;  ///< [px] a cell's longer side
constexpr int kMostCell = 4096;
constexpr int kDefaultColumns = 3;

/// A crowd's sheet is about as many pictures high as wide, each person's pictures side by side.
int columns_for(int people, int pictures) {
  const int most = std::max(kDefaultColumns, int(std::ceil(std::sqrt(double(people) * pictures))));
  return std::max(1, most / pictures) * pictures;
}

/// So that the sheet is no wider than that, if cells need not be smaller than a thumbnail.
int cell_for(int columns) {
  constexpr int kWidest = 4096, kThumbnail = 64;  // [px]
  return std::clamp(kWidest / columns, kThumbnail, kDefaultCell);
}

/// Each emotion; then, with --half, each at half strength.
CellsOrCode emotion_cells(const SheetArguments& arguments, const Face& face, Size size) {
  const FaceModel& model = *face.model;
  Poser poser(face);
  Cells cells;
  for (const double strength : {1.0, 0.5}) {
    if (strength != 1 && !arguments.half) break;
    for (const Expression& expression : model.expressions) {
      if (!expression.name.starts_with("emotion.")) continue;
      const auto control =
          std::find_if(model.controls.begin(), model.controls.end(),
                       [&](const Control& c) { return c.name == expression.name; });
      Pose pose;
      pose.settings.push_back({true, int(control - model.controls.begin()), {strength}});
      cells.push_back({fmt::format("{}{}", expression.name.substr(8), strength != 1 ? " 50%" : ""),
                       sheet_picture(scene_from_face(poser.pose(pose)),
                                     {.width = size.width, .height = size.height})});
    }
  }
  if (cells.empty()) return {{}, complain({*arguments.face, "this face has no emotions"}, kFailed)};
  return {std::move(cells)};
}

/// A --picture: its text, and what it asks for.
struct AskedPicture {
  std::string text;
  SheetPicture picture;
};

Expected<std::vector<AskedPicture>> read_pictures(const std::vector<std::string>& texts) {
  std::vector<AskedPicture> asked;
  for (const std::string& text : texts) {
    auto picture = read_sheet_picture(text);
    if (!picture) return picture.error();
    asked.push_back({text, *std::move(picture)});
  }
  return asked;
}

/// Each of some pictures of a face that is called so.
CellsOrCode picture_cells(const std::string& name, const std::vector<AskedPicture>& asked,
                          const Face& face, Size size) {
  Cells cells;
  for (const auto& [text, picture] : asked) {
    RenderArguments how = picture.render;
    how.posed.face = name;
    how.size = fmt::format("{}x{}", size.width, size.height);
    auto plan = plan_frame(how);
    if (!plan) return {{}, complain(plan.error(), kUsedWrongly)};
    const PosedOrCode posed = read_posed_face(how.posed, &face);
    if (!posed.face) return {{}, posed.code};
    const Scene scene = scene_from_face(*posed.face);
    if (auto done = plan_view(*plan, how, scene.canvas()); !done)
      return {{}, complain(done.error(), kUsedWrongly)};
    const auto effects = read_effects(how, *posed.face, plan->view.width);
    if (!effects) return {{}, complain(effects.error(), kUsedWrongly)};
    auto drawn = drawn_picture(scene, plan->view, {}, *effects);
    if (!drawn) return {{}, complain({"--picture " + text, drawn.error().what}, kFailed)};
    cells.push_back({picture.name, *std::move(drawn)});
    const Image &first = cells[0].image, &last = cells.back().image;
    if (last.width != first.width || last.height != first.height)
      return {{},
              complain({"--picture " + text,
                        fmt::format("has {} x {} pixels, the first one {} x {}", last.width,
                                    last.height, first.width, first.height)},
                       kUsedWrongly)};
  }
  return {std::move(cells)};
}

/// Each --picture.
CellsOrCode picture_cells(const SheetArguments& arguments, const Face& face, Size size) {
  const auto asked = read_pictures(arguments.pictures);
  if (!asked) return {{}, complain(asked.error(), kUsedWrongly)};
  return picture_cells(*arguments.face, *asked, face, size);
}

/// --people.
Expected<std::vector<FaceCode>> read_people(const SheetArguments& arguments) {
  constexpr int kMostPeople = 10000;
  const auto count = read_whole("--people", *arguments.people, 1, kMostPeople);
  if (!count) return count.error();
  return crowd(arguments.seed.value_or("1"), int(*count));
}

/// --turned: how far a person's head is turned and tilted, by chances of their own; empty: not at all.
std::vector<std::string> own_turn(const FaceCode& person, double most) {
  constexpr std::uint64_t kYaw = 2010, kPitch = 2011, kRoll = 2012;  // questions that no law asks
  if (most == 0) return {};
  const KeyedChance chance(person.seed);
  const auto angle = [&](std::uint64_t question, double share) {
    return most * share * (2 * chance.share(question) - 1);
  };
  return {fmt::format("yaw={:.3f}", angle(kYaw, 1)),
          fmt::format("pitch={:.3f}", angle(kPitch, 0.25)),
          fmt::format("roll={:.3f}", angle(kRoll, 0.5))};
}

/// --people: each at each --picture; without one each at rest, with --emotions each with a feeling.
SheetOrCode people_sheet(const SheetArguments& arguments, const std::vector<FaceCode>& people,
                         Size size, const SheetLayout& layout) {
  const auto turned = arguments.turned ? read_real("--turned", *arguments.turned, 0, 30)
                                       : Expected<double>(arguments.neutral ? 0.0 : kTurned);
  if (!turned) return {{}, complain(turned.error(), kUsedWrongly)};
  constexpr std::array<std::string_view, 6> kFeelings{"joy",  "sadness", "anger",
                                                      "fear", "disgust", "surprise"};
  const bool own = arguments.pictures.empty();
  const auto asked = read_pictures(own ? std::vector<std::string>{""} : arguments.pictures);
  if (!asked) return {{}, complain(asked.error(), kUsedWrongly)};
  const auto cells_of = [&](std::size_t person) {
    const std::string name = face_code_text(people[person]);
    std::vector<AskedPicture> pictures = *asked;
    PosedFace& posed = pictures[0].picture.render.posed;
    if (own && arguments.emotions)
      posed.emotions.emplace_back(kFeelings[person % kFeelings.size()]);
    else if (own)
      posed.settings = own_turn(people[person], *turned);
    const auto face = read_face_or_report(name, arguments.style, arguments.neutral);
    return face ? picture_cells(name, pictures, *face, size) : CellsOrCode{{}, kFailed};
  };
  // What is wrong with the arguments is wrong for everybody: the first person reports it, once.
  CellsOrCode first = cells_of(0);
  if (first.code != kDone) return {{}, first.code};
  const std::size_t each = first.cells.size();
  const auto named =
      std::ranges::find_if(first.cells, [](const SheetCell& c) { return !c.caption.empty(); });
  auto sheet = CaptionedSheet::begin(int(people.size() * each),
                                     named == first.cells.end() ? first.cells[0] : *named, layout);
  if (!sheet) return {{}, complain(sheet.error(), kFailed)};
  const auto lay = [&](std::size_t person, Cells cells) {
    for (std::size_t i = 0; i < cells.size(); ++i)
      sheet->put(int(person * each + i), std::move(cells[i]));
  };
  lay(0, std::move(first.cells));
  std::atomic<int> failed = kDone;
  watched_for("people", int(people.size()) - 1, {}, [&](int i) {
    CellsOrCode made = cells_of(std::size_t(i) + 1);
    if (made.code == kDone)
      lay(std::size_t(i) + 1, std::move(made.cells));
    else
      failed = made.code;
  });
  if (failed != kDone) return {{}, failed};
  return finished(*std::move(sheet));
}

/// A plain head, all at rest, no glasses or hats, hair that shows the ears; or FACE's.
Expected<Recipe> head_for_parts(const SheetArguments& arguments) {
  auto recipe = arguments.face ? read_given_recipe(*arguments.face)
                               : Recipe{.name = {}, .parts = {{"hair", "crop"}}};
  if (recipe && arguments.style) recipe->style = *arguments.style;
  return recipe;
}

/// One part's pictures on a head, named after it. `wrong`: whose fault it is if they do not go together.
CellsOrCode part_pictures(const SheetArguments& arguments, const Recipe& recipe,
                          const std::string& part, Size size, ExitCode wrong) {
  const auto face = face_from_recipe(recipe, face_letters());
  if (!face) return {{}, complain(face.error(), wrong)};
  SheetArguments one = arguments;
  if (one.pictures.empty()) one.pictures.push_back("");
  one.face = part;
  CellsOrCode made = picture_cells(one, *face, size);
  for (SheetCell& cell : made.cells)
    cell.caption = part + (cell.caption.empty() ? "" : " ") + cell.caption;
  return made;
}

/// --parts FILE or FOLDER: parts of one's own, each on one head.
CellsOrCode own_part_cells(const SheetArguments& arguments, Size size) {
  std::vector<FoundPart> parts;
  if (std::filesystem::is_directory(*arguments.parts)) {
    auto found = read_part_folder(*arguments.parts);
    if (!found) return {{}, complain(found.error(), kFailed)};
    parts = *std::move(found);
  } else {
    auto found = read_part_file(*arguments.parts);
    if (!found) return {{}, complain(found.error(), kFailed)};
    parts.push_back(*std::move(found));
  }
  const auto head = head_for_parts(arguments);
  if (!head) return {{}, complain(head.error(), kFailed)};
  // The head first: what is wrong with it is wrong with the arguments, and not with the parts' files.
  if (const auto plain = face_from_recipe(*head, face_letters()); !plain)
    return {{}, complain(plain.error(), arguments.face ? kFailed : kUsedWrongly)};
  Cells cells;
  WatchedWork work("parts", parts.size());
  for (const FoundPart& part : parts) {
    Recipe recipe = *head;
    wear(recipe, part);
    const std::string file = std::filesystem::path(part.part.path).filename().string();
    CellsOrCode made =
        part_pictures(arguments, recipe, file.substr(0, file.find(".part.json")), size, kFailed);
    if (made.code != kDone) return made;
    std::ranges::move(made.cells, std::back_inserter(cells));
    work.step();
  }
  return {std::move(cells)};
}

/// --parts: each part of the family on one head, with its name; with --picture, each part at each of them.
CellsOrCode part_cells(const SheetArguments& arguments, Size size) {
  std::error_code none;  // set if there is no such file, too
  if (std::filesystem::exists(*arguments.parts, none)) return own_part_cells(arguments, size);
  auto given = head_for_parts(arguments);
  if (!given) return {{}, complain(given.error(), arguments.face ? kFailed : kUsedWrongly)};
  const std::vector<PartFamily> families = part_families();
  const auto family = std::ranges::find(families, *arguments.parts, &PartFamily::name);
  if (family == families.end()) {
    std::vector<std::string_view> names;
    for (const PartFamily& one : families) names.push_back(one.name);
    return {{},
            complain({"--parts", unknown_name("family", one_line(*arguments.parts, 60), names)},
                     kUsedWrongly)};
  }
  Recipe recipe = *std::move(given);
  std::vector<std::string> parts = family->parts;
  if (family->optional) parts.push_back("none");
  Cells cells;
  WatchedWork work("parts", parts.size());
  for (const std::string& part : parts) {
    recipe.parts[family->name] = part;
    if (part == "none" && family->optional) recipe.parts.erase(family->name);
    CellsOrCode made = part_pictures(arguments, recipe, part, size, kUsedWrongly);
    if (made.code != kDone) return made;
    std::ranges::move(made.cells, std::back_inserter(cells));
    work.step();
  }
  return {std::move(cells)};
}

/// --cell.
Expected<Size> read_cell(const SheetArguments& arguments, glm::dvec2 extent, int otherwise) {
  auto size = read_size(arguments.cell.value_or(std::to_string(otherwise)), extent.x / extent.y);
  if (!size) return Error{"--cell " + *arguments.cell, size.error().what};
  if (size->width > kMostCell || size->height > kMostCell)
    return Error{"--cell", fmt::format("a cell has {} pixels a side at most", kMostCell)};
  return size;
}

/// What does not go together; nothing if all does.
std::optional<Error> wrongly_used(const SheetArguments& arguments) {
  const auto says = [](std::string what) { return Error{{}, std::move(what)}; };
  if (!arguments.pictures.empty() && (arguments.emotions || arguments.half))
    return says("--picture: a sheet has pictures or emotions, not both");
  if (arguments.people && arguments.parts) return says("a sheet has --people or --parts, not both");
  if (arguments.parts && (arguments.emotions || arguments.half))
    return says("--parts: a sheet has parts or emotions, not both");
  if (!arguments.parts && arguments.people.has_value() == arguments.face.has_value())
    return says("a sheet needs a FACE, --people or --parts, one of them");
  if (arguments.turned && !arguments.people) return says("--turned: needs --people");
  if (arguments.statistics && !arguments.people) return says("--statistics: needs --people");
  if (arguments.json && !arguments.statistics) return says("--json: needs --statistics");
  if (arguments.statistics && arguments.output == "-")
    return says("-o -: the statistics are on standard output already");
  if (!arguments.statistics && !arguments.output) return says("sheet: --output is required");
  return {};
}

/// The sheet that is asked for.
SheetOrCode asked_sheet(const SheetArguments& arguments, const std::vector<FaceCode>& people,
                        const SheetLayout& layout) {
  std::optional<Face> face;
  if (arguments.face && !arguments.parts) {
    face = read_face_or_report(*arguments.face, arguments.style, arguments.neutral);
    if (!face) return {{}, kFailed};
  } else {
    auto first = face_from_recipe(recipe_from_seed(0));  // all have one canvas
    if (!first) return {{}, complain(first.error(), kFailed)};
    face = *std::move(first);
  }
  const auto size = read_cell(arguments, face->model->canvas.box.size(),
                              arguments.people ? cell_for(layout.columns) : kDefaultCell);
  if (!size) return {{}, complain(size.error(), kUsedWrongly)};
  if (arguments.people) return people_sheet(arguments, people, *size, layout);
  const CellsOrCode made = arguments.parts              ? part_cells(arguments, *size)
                           : arguments.pictures.empty() ? emotion_cells(arguments, *face, *size)
                                                        : picture_cells(arguments, *face, *size);
  if (made.code != kDone) return {{}, made.code};
  auto sheet = captioned_sheet(made.cells, layout);
  if (!sheet) return {{}, complain(sheet.error(), kFailed)};
  return {*std::move(sheet)};
}

}  // namespace

int sheet_command(const SheetArguments& arguments) {
  if (const auto wrong = wrongly_used(arguments)) return complain(*wrong, kUsedWrongly);
  std::vector<FaceCode> people;
  int columns = kDefaultColumns;
  if (arguments.people) {
    auto read = read_people(arguments);
    if (!read) return complain(read.error(), kUsedWrongly);
    people = *std::move(read);
    columns = columns_for(int(people.size()), std::max(1, int(arguments.pictures.size())));
  }
  const auto layout = read_sheet_layout(arguments.columns, columns, arguments.gap);
  if (!layout) return complain(layout.error(), kUsedWrongly);
  if (arguments.output) {
    const SheetOrCode made = asked_sheet(arguments, people, *layout);
    if (made.code != kDone) return made.code;
    const auto done = write_image_by(load_encoder, *made.sheet, *arguments.output, {});
    if (!done) return complain(done.error(), kFailed);
  }
  if (!arguments.statistics) return kDone;
  const PeopleStatistics statistics = people_statistics(people);
  return print(arguments.json ? statistics_json(statistics) : statistics_table(statistics));
}

}  // namespace mien::command
