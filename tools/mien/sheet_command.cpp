// mien sheet: a grid of one face at many poses, each with its name.

#include <mien/lib/face/face_model.h>
#include <mien/lib/rig/poser.h>
#include <mien/render/image/write_pieces.h>
#include <mien/render/render.h>
#include <mien/sdf/from_face/caption.h>
#include <mien/sdf/from_face/scene_from_face.h>
#include <mien/tools/mien/commands.h>
#include <mien/tools/mien/image_loader.h>
#include <mien/tools/mien/posed_face.h>
#include <mien/tools/mien/values.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace mien::command {
namespace {

struct Cell {
  std::string caption;
  Pose pose;
};

constexpr int kDefaultCell = 320;  ///< [px] a cell's longer side
constexpr int kMostCell = 4096;

/// The face at rest, then each emotion; then, with `half`, each at half strength.
std::vector<Cell> emotion_cells(const FaceModel& model, bool half) {
  std::vector<Cell> cells;
  for (const double strength : {1.0, 0.5}) {
    if (strength != 1 && !half) break;
    for (const Expression& expression : model.expressions) {
      if (!expression.name.starts_with("emotion.")) continue;
      const auto control =
          std::find_if(model.controls.begin(), model.controls.end(),
                       [&](const Control& c) { return c.name == expression.name; });
      Cell cell{expression.name.substr(8), {}};
      if (strength != 1) cell.caption += " 50%";
      cell.pose.settings.push_back({true, int(control - model.controls.begin()), {strength}});
      cells.push_back(std::move(cell));
    }
  }
  return cells;
}

/// A sheet of pixels that cells are drawn into.
class Sheet {
 public:
  Sheet(int count, int columns, int width, int height)
      : columns_(columns), width_(width), height_(height), strip_(std::max(12, height / 9)) {
    image_.width = columns * width;
    image_.height = (count + columns - 1) / columns * (height + strip_);
    image_.bytes.assign(image_.stride() * std::size_t(image_.height), std::byte{255});
  }

  void draw(int index, const Scene& face, const std::string& caption) {
    const int x = index % columns_ * width_, y = index / columns_ * (height_ + strip_);
    draw_at(face, x, y, height_);
    draw_at(caption_scene(caption, double(width_) / strip_), x, y + height_, strip_);
  }

  const Image& image() const { return image_; }

 private:
  void draw_at(const Scene& scene, int x, int y, int height) {
    std::byte* const first =
        image_.bytes.data() + image_.stride() * std::size_t(y) + std::size_t(x) * 4;
    render_into({first, image_.stride(), Depth::u8}, scene, {.width = width_, .height = height});
  }

  int columns_, width_, height_, strip_;
  Image image_;
};

}  // namespace

int sheet_command(const SheetArguments& arguments) {
  const auto face = read_face_aloud(arguments.face);
  if (!face) return kFailed;
  const FaceModel& model = *face->model;
  const std::vector<Cell> cells = emotion_cells(model, arguments.half);
  if (cells.empty()) return complain({arguments.face, "this face has no emotions"}, kFailed);
  const glm::dvec2 extent = model.canvas.box.size();
  Size size{kDefaultCell, 0};
  const auto read =
      read_size(arguments.cell.value_or(std::to_string(kDefaultCell)), extent.x / extent.y);
  if (!read) return complain({"--cell " + *arguments.cell, read.error().what}, kUsedWrongly);
  size = *read;
  if (size.width > kMostCell || size.height > kMostCell)
    return complain({"--cell", fmt::format("a cell has {} pixels a side at most", kMostCell)},
                    kUsedWrongly);
  Sheet sheet(int(cells.size()), cells.size() < 3 ? int(cells.size()) : 3, size.width, size.height);
  Poser poser(*face);
  for (int i = 0; i < int(cells.size()); ++i)
    sheet.draw(i, scene_from_face(poser.pose(cells[std::size_t(i)].pose)),
               cells[std::size_t(i)].caption);
  const auto done = write_image_by(load_encoder, sheet.image(), arguments.output, {});
  return done ? int(kDone) : complain(done.error(), kFailed);
}

}  // namespace mien::command
