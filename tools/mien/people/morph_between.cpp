#include "tools/mien/people/morph_between.h"

#include <mien/composed_face.h>
#include <mien/face_model.h>
#include <mien/recipe_between.h>
#include <mien/scene_from_face.h>
#include "render/image/load_encoder.h"
#include "render/image/write_pieces.h"
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/commands/posed_face.h"
#include "tools/mien/film/film.h"
#include "tools/mien/film/frame_names.h"
#include "tools/mien/output/captioned_sheet.h"
#include "tools/mien/output/drawn_picture.h"
#include "tools/mien/terminal/messages.h"
#include "tools/mien/terminal/watched_work.h"

#include <fmt/format.h>

#include <algorithm>

namespace mien::command {
namespace {

constexpr int kFewSteps = 9, kManySteps = 90;

/// Everything that is asked for.
struct Morphing {
  Recipe from, to;
  std::optional<double> at, parts_at;
  Size size{};
  long steps = kFewSteps;
  double fps = 30;
  SheetLayout layout;
  std::optional<FrameNames> names;
  std::optional<FilmType> film;

  double place(long step) const {
    return at ? *at : steps > 1 ? double(step) / double(steps - 1) : 0.0;
  }

  Expected<Image> picture(long step) const {
    const auto recipe = recipe_between(from, to, place(step), parts_at);
    if (!recipe) return recipe.error();
    const auto face = face_from_recipe(*recipe);
    if (!face) return face.error();
    return sheet_picture(scene_from_face(*face), {.width = size.width, .height = size.height});
  }
};

Expected<Recipe> read_person(const std::string& person, const MorphArguments& arguments) {
  auto recipe = read_given_recipe(person);
  if (recipe && arguments.style) recipe->style = *arguments.style;
  return recipe;
}

/// What is wrong with the options.
Expected<Done> read_options(const MorphArguments& arguments, Morphing& to) {
  const auto share = [](const char* name, const std::optional<std::string>& text,
                        std::optional<double>& into) -> Expected<Done> {
    if (!text) return Done{};
    const auto read = read_share(name, *text);
    if (!read) return read.error();
    into = *read;
    return Done{};
  };
  if (auto done = share("at", arguments.at, to.at); !done) return done;
  if (auto done = share("parts-at", arguments.parts_at, to.parts_at); !done) return done;
  const auto names = read_frame_names(arguments.output);
  if (!names) return names.error();
  to.names = *names, to.film = film_type(arguments.output);
  if (to.at && (to.names || to.film)) return Error{"--at", "is one picture"};
  if (to.at && arguments.steps) return Error{"--at", "is one picture; --steps are many"};
  if (arguments.fps && !to.film) return Error{"--fps", "is of films"};
  constexpr long kMostOnSheet = 1000, kMostFrames = 100'000;
  const bool frames = to.names || to.film;
  const auto steps = read_whole(
      "--steps", arguments.steps.value_or(std::to_string(frames ? kManySteps : kFewSteps)), 2,
      frames ? kMostFrames : kMostOnSheet);
  if (!steps) return steps.error();
  to.steps = to.at ? 1 : *steps;
  const auto fps = read_fps(arguments.fps.value_or("30"));
  if (!fps) return fps.error();
  to.fps = *fps;
  const auto layout =
      read_sheet_layout(arguments.columns, int(std::min<long>(to.steps, kFewSteps)), arguments.gap);
  if (!layout) return layout.error();
  to.layout = *layout;
  return Done{};
}

Expected<Done> read_picture_size(const MorphArguments& arguments, const Face& face, Morphing& to) {
  constexpr int kMostPictures = 4096;
  const std::string text = arguments.size.value_or("320");
  const auto extent = face.model->canvas.box.size();
  const auto size = read_size(text, extent.x / extent.y);
  if (!size) return size.error();
  if (size->width > kMostPictures || size->height > kMostPictures)
    return Error{"--size " + text,
                 fmt::format("a picture has {} pixels a side at most", kMostPictures)};
  to.size = *size;
  return Done{};
}

Expected<Done> write_sheet(const Morphing& morphing, const std::string& output) {
  std::vector<SheetCell> cells;
  WatchedWork work("steps", std::size_t(morphing.steps));
  for (long step = 0; step < morphing.steps; ++step, work.step()) {
    auto picture = morphing.picture(step);
    if (!picture) return picture.error();
    cells.push_back({"", *std::move(picture)});
  }
  const auto sheet = captioned_sheet(cells, morphing.layout);
  if (!sheet) return sheet.error();
  return write_image_by(load_encoder, *sheet, output, {});
}

Expected<Done> write_frames(const Morphing& morphing) {
  WatchedWork work("steps", std::size_t(morphing.steps));
  for (long step = 0; step < morphing.steps; ++step, work.step()) {
    const auto picture = morphing.picture(step);
    if (!picture) return picture.error();
    if (auto done = write_image_by(load_encoder, *picture, morphing.names->of(step), {}); !done)
      return done;
  }
  return Done{};
}

Expected<Done> write_film(const Morphing& morphing, const std::string& output) {
  const FilmPlan plan{.type = *morphing.film,
                      .width = morphing.size.width,
                      .height = morphing.size.height,
                      .fps = morphing.fps,
                      .frames = morphing.steps,
                      .draw = [&](long step) { return morphing.picture(step); }};
  const auto film = begin_film(output, plan);
  if (!film) return film.error();
  WatchedWork work("steps", std::size_t(morphing.steps));
  for (long step = 0; step < morphing.steps; ++step, work.step()) {
    const auto picture = morphing.picture(step);
    if (!picture) return picture.error();
    if (auto added = (*film)->add(*picture); !added) return added;
  }
  return (*film)->finish();
}

}  // namespace

int morph_between(const MorphArguments& arguments) {
  Morphing morphing;
  if (const auto done = read_options(arguments, morphing); !done)
    return complain(done.error(), kUsedWrongly);
  auto from = read_person(arguments.people[0], arguments),
       to = read_person(arguments.people[1], arguments);
  if (!from) return complain(from.error(), kFailed);
  if (!to) return complain(to.error(), kFailed);
  morphing.from = *std::move(from), morphing.to = *std::move(to);
  const auto middle = recipe_between(morphing.from, morphing.to, 0.5, morphing.parts_at);
  if (!middle) return complain(middle.error(), kUsedWrongly);
  const auto face = face_from_recipe(*middle);
  if (!face) return complain(face.error(), kFailed);
  if (const auto done = read_picture_size(arguments, *face, morphing); !done)
    return complain(done.error(), kUsedWrongly);
  const auto done = morphing.film    ? write_film(morphing, arguments.output)
                    : morphing.names ? write_frames(morphing)
                                     : write_sheet(morphing, arguments.output);
  return done ? int(kDone) : complain(done.error(), kFailed);
}

}  // namespace mien::command
