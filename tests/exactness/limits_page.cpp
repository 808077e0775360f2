// mien_limits_page: writes docs/limits.md from the limits as they are compiled in, or compares it.
//
//   mien_limits_page > docs/limits.md
//   mien_limits_page --draw 256                 draws what it promises; ends with 1 if something is refused
//   mien_limits_page --check docs/limits.md     ends with 1 if the page says anything else

#include <mien/face_limits.h>
#include <mien/limits.h>
#include <mien/pattern.h>
#include <mien/render.h>
#include <mien/view.h>
#include "render/rows/crowd.h"
#include "tests/support/scenes/hostile_scenes.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string>

namespace mien::test {
namespace {

/// 1 000 000.
std::string number(std::uint64_t n) {
  std::string text = std::to_string(n);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, 1, ' ');
  return text;
}

std::string page() {
  const FaceLimits face;
  const RenderLimits render;
  std::string text =
      "# Limits\n\n"
      "`mien_limits_page` writes this page from the limits that are compiled in, and a test "
      "compares the two.\n\n"
      "## What always draws\n\n"
      "Each of these draws within the default limits, in at most ten seconds and 1 GiB on the "
      "machine that mien is made on,\n"
      "at 256 px, at 8 and 16 bits, cut to areas and in groups "
      "(`tests/golden/bounded_work_test.cpp`):\n\n";
  const auto row = [&](const std::string& what, const std::string& most) {
    text += fmt::format("| {} | {} |\n", what, most);
  };
  text += "| what | how many |\n|---|---|\n";
  row("figures of all patterns of a face: discs, ellipses, long strokes (these at 64 px)",
      number(kMostPatternFigures));
  row("points of a path without crossings, or without area", number(100'000));
  row("points of a path on a lattice, crossing itself at will", number(1000));
  row("points of a path without crossings with a gradient along its distance, or a feather",
      number(1000));
  row("points of a path that crosses itself at will, with such a gradient", number(300));
  row("points of a path that crosses itself at will, with a feather", number(200));
  row("points of a path, with or without crossings, with a relief", number(300));
  row("layers", number(10'000));
  text +=
      "\n## What ends drawing\n\n"
      "Drawing counts its work while it runs, in *steps*. A pair of pieces of outline that are "
      "compared, a crossing of two,\n"
      "a proof of their order, a region, a distance, a part of a pixel: each is weighed by what it "
      "costs, a step for one or two\n"
      "nanoseconds. So lengths of strokes, points of paths, sides of pictures and crossings all "
      "count by what they cost.\n"
      "`mien render --stats json` prints `steps` and `memory`. An error names the limit that was "
      "exceeded.\n\n"
      "| limit | default | of |\n|---|---|---|\n";
  text += fmt::format(
      "| `steps` | {}, and {} for each pixel | steps of one picture, or of one of its pieces in a "
      "file; "
      "what `--most-steps` gives, if it is given |\n",
      number(std::uint64_t(default_steps(0))),
      number(std::uint64_t(default_steps(1) - default_steps(0))));
  text += fmt::format(
      "| `memory` | {} MiB | bytes of outlines, their order and regions, beside the pixels; "
      "what `--memory` says, if it is given |\n",
      render.memory >> 20);
  text +=
      "\nThey are `RenderLimits` (`<mien/limits.h>`) in `RenderOptions`, `PictureOptions` and "
      "`PieceDrawer::of`, and `most_steps` and\n"
      "`most_memory` in C. What a progress cancels ends within 50 ms in mien's own work and within "
      "half a second while a file is\n"
      "compressed.\n\n"
      "The sides of a scene's paths tell how much memory their outlines need at least, before one "
      "of them is made. Where that\n"
      "is more than `memory`, nothing is drawn, and the error tells how much it is: \"outlines and "
      "their order need at least\n"
      "80.1 MiB, more than the 16 MiB allowed (limit `memory`)\". What crossings and strokes need "
      "is known only while it is\n"
      "counted.\n\n"
      "## What is refused when a file is read\n\n"
      "`FaceLimits` (`<mien/face_limits.h>`):\n\n| limit | default | of |\n|---|---|---|\n";
  const auto limit = [&](const char* name, const std::string& most, const char* of) {
    text += fmt::format("| `{}` | {} | {} |\n", name, most, of);
  };
  limit("bytes", fmt::format("{} MiB", face.bytes >> 20), "text");
  limit("nesting", number(std::uint64_t(face.nesting)),
        "arrays and objects in each other; features clipped to each other");
  limit("values", number(face.values), "JSON values of any kind");
  limit("numbers", number(face.numbers), "the face vector");
  limit("features", number(face.features),
        "features, left and right counted; figures of areas made of patterns and of other areas");
  limit("magnitude", number(std::uint64_t(face.magnitude)), "any number, in absolute value");
  text += fmt::format(
      "\nSides of pictures are 1 to {} pixels. Scenes of {} layers or shapes, or more, are drawn "
      "window by window.\n",
      number(View::kMaxSide), number(Crowd::kMany));
  return text;
}

/// Draws each of what is promised, and tells what it takes.
int draw(int side) {
  int refused = 0;
  for (const HostileScene& hostile : hostile_scenes(1.0))
    for (const Depth depth : {Depth::u8, Depth::u16}) {
      RenderStats stats;
      const std::clock_t began = std::clock();
      const auto image = render(hostile.scene, {.width = side, .height = side},
                                {.depth = depth, .threads = {.count = 1}}, &stats);
      fmt::print("{:6.2f} s {:6.0f} million steps {:5} MiB {:6} resolved  {}, {} bits{}\n",
                 double(std::clock() - began) / CLOCKS_PER_SEC, double(stats.steps) / 1e6,
                 stats.memory >> 20, stats.resolved_pixels, hostile.name,
                 depth == Depth::u8 ? 8 : 16, image ? "" : ": " + image.error().what);
      std::fflush(stdout);
      refused += !image;
    }
  return refused > 0;
}

int check(const char* path) {
  std::ifstream in(path, std::ios::binary);
  const std::string there{std::istreambuf_iterator<char>(in), {}};
  if (there == page()) return 0;
  fmt::print(stderr, "{} is not what mien_limits_page writes\n", path);
  return 1;
}

}  // namespace
}  // namespace mien::test

int main(int count, char** words) {
  if (count == 3 && std::string(words[1]) == "--check") return mien::test::check(words[2]);
  if (count == 3 && std::string(words[1]) == "--draw") return mien::test::draw(std::atoi(words[2]));
  std::fputs(mien::test::page().c_str(), stdout);
  return 0;
}
