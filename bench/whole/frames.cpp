// Whole frames beside Cairo and beside the floor, in turns in one process.
//
//   frames [--threads N] [--instructions NAME] [--rounds N] [--most PIXELS] [--json]
//
// Scene A is the eyes (faces/seed0, gaze (0.03, −0.02)), B the male face at rest, C and D the faces
// toon and bruno. A frame of mien is
// pose, scene and draw into a warm RGBA8 buffer, mixed as encoded, as Cairo mixes; a frame of Cairo
// is clear and every figure, paths built anew, into a warm surface of the same kind of memory. The
// floor is the faster of filling that buffer with ordinary and with streaming stores. Every round
// takes each once; medians of the rounds are told, and their ratios. Exit 1 if the pictures are not
// of the same thing.

#include <mien/mien.h>
#include <mien/sdf/batch/instruction_sets.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <string_view>

#include "bench/support/fill_floor.h"
#include "bench/whole/peer_drawing.h"
#ifdef MIEN_HAVE_CAIRO
#include "bench/whole/cairo_picture.h"
#endif

namespace mien::bench {
namespace {

struct Options {
  int threads = 1;
  int rounds = 0;  ///< 0: by size
  long long most = 200'000'000;
  bool json = false;
};

struct Case {
  char scene;
  const char* face;
  std::vector<const char*> settings;
  int width, height;
};

const std::vector<const char*> kGaze{"gaze.x=0.03", "gaze.y=-0.02"};
const Case kCases[] = {{'A', "seed0", kGaze, 640, 360},   {'A', "seed0", kGaze, 1920, 1080},
                       {'A', "seed0", kGaze, 7680, 4320}, {'A', "seed0", kGaze, 15360, 8640},
                       {'B', "male", {}, 512, 512},       {'B', "male", {}, 2048, 2048},
                       {'B', "male", {}, 8192, 8192},     {'C', "toon", {}, 640, 360},
                       {'C', "toon", {}, 1920, 1080},     {'C', "toon", {}, 7680, 4320},
                       {'D', "bruno", {}, 640, 360},      {'D', "bruno", {}, 1920, 1080},
                       {'D', "bruno", {}, 7680, 4320}};

/// Memory that a vector store may take: pages touched, 64-byte aligned.
class Pixels {
 public:
  explicit Pixels(std::size_t count)
      : data_(static_cast<std::uint32_t*>(std::aligned_alloc(64, (count * 4 + 63) / 64 * 64))) {
    std::memset(data_.get(), 1, count * 4);
  }
  std::uint32_t* data() const { return data_.get(); }

 private:
  struct Free {
    void operator()(void* p) const { std::free(p); }
  };
  std::unique_ptr<std::uint32_t, Free> data_;
};

double ms_of(const std::function<void()>& work) {
  const auto began = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began)
      .count();
}

double median(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

Pose pose_of(const Face& face, const Case& c) {
  Pose pose;
  for (const char* text : c.settings) pose.settings.push_back(*read_setting(face, text));
  return pose;
}

/// Mean difference of two pictures' red channels, in levels: Cairo's is blue first.
double difference(const std::uint32_t* ours, const std::uint32_t* cairo, std::size_t count) {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i)
    sum += std::abs(int(ours[i] & 255) - int(cairo[i] >> 16 & 255));
  return sum / double(count);
}

int rounds_of(const Options& options, std::size_t pixels) {
  if (options.rounds) return options.rounds;
  return pixels < 500'000 ? 201 : pixels < 5'000'000 ? 41 : pixels < 70'000'000 ? 15 : 7;
}

/// Medians [ms].
struct Times {
  double frame, draw, cairo, floor;
};

void tell(const Options& options, const Case& c, const Times& t) {
  if (options.json) {
    fmt::print(
        "{{\"scene\": \"{}\", \"width\": {}, \"height\": {}, \"threads\": {}, \"frame_ms\": "
        "{:.5f}, "
        "\"draw_ms\": {:.5f}, \"cairo_ms\": {}, \"floor_ms\": {:.5f}}}\n",
        c.scene, c.width, c.height, options.threads, t.frame, t.draw,
        t.cairo > 0 ? fmt::format("{:.5f}", t.cairo) : "null", t.floor);
  } else {
    const auto ratio = [](double a, double b) {
      return b > 0 ? fmt::format("{:.3f}", a / b) : "-";
    };
    fmt::print("{} {:>6} x {:<6}{:10.4f}{:10.4f}{:10.4f}{:10.4f}{:>14}{:>14}{:>14}\n", c.scene,
               c.width, c.height, t.frame, t.draw, t.cairo, t.floor, ratio(t.frame, t.cairo),
               ratio(t.draw, t.cairo), ratio(t.frame, t.floor));
  }
  std::fflush(stdout);
}

bool run(const Options& options, const Case& c) {
  const Face face = *read_face(std::string(MIEN_SOURCE_DIR) + "/faces/" + c.face + ".face.json");
  const Pose pose = pose_of(face, c);
  const View view{.width = c.width, .height = c.height, .blend = Blend::srgb};
  const std::size_t count = std::size_t(c.width) * std::size_t(c.height);
  const Pixels ours(count), theirs(count), floor(count);
  RenderOptions how;
  how.threads.count = options.threads;
  const PixelBuffer buffer{ours.data(), std::size_t(c.width) * 4, Depth::u8};
  const Scene still = scene_from_face(pose_face(face, pose));
  Renderer renderer;
  const auto draw = [&] { renderer.render_into(buffer, still, view, how); };
  const auto frame = [&] {
    renderer.render_into(buffer, scene_from_face(pose_face(face, pose)), view, how);
  };

  std::string why;
  const auto drawing = peer_drawing(still, view, why);
  if (!drawing) fmt::print("scene {}: no peer: {}\n", c.scene, why);
  std::function<void()> cairo;
#ifdef MIEN_HAVE_CAIRO
  std::unique_ptr<CairoPicture> picture;
  if (drawing) {
    picture = std::make_unique<CairoPicture>(*drawing, theirs.data());
    cairo = [&] { picture->draw(); };
  }
#endif

  std::vector<double> frames, draws, cairos, ordinary, streaming;
  const int rounds = rounds_of(options, count), warm = 2;
  for (int i = -warm; i < rounds; ++i) {
    const double f = ms_of(frame), p = cairo ? ms_of(cairo) : 0, d = ms_of(draw);
    const double o = ms_of([&] { fill_ordinary(floor.data(), count, std::uint32_t(i)); });
    const double s = ms_of([&] { fill_streaming(floor.data(), count, std::uint32_t(i)); });
    if (i < 0) continue;
    frames.push_back(f), draws.push_back(d), cairos.push_back(p);
    ordinary.push_back(o), streaming.push_back(s);
  }
  tell(options, c,
       {median(frames), median(draws), median(cairos),
        std::min(median(ordinary), median(streaming))});
  const double off = cairo ? difference(ours.data(), theirs.data(), count) : 0;
  if (off > 0.5)
    fmt::print("scene {}: Cairo drew something else: {:.2f} levels off\n", c.scene, off);
  return off <= 0.5;
}

bool choose_instructions(std::string_view name) {
  for (const batch::InstructionSet& set : batch::instruction_sets()) {
    if (set.name == name) {
      batch::use_instruction_set(set.id);
      return true;
    }
  }
  return false;
}

bool read(int count, char** words, Options& options) {
  for (int i = 1; i < count; ++i) {
    const std::string_view word = words[i];
    if (word == "--json") {
      options.json = true;
      continue;
    }
    const char* const value = i + 1 < count ? words[++i] : "";
    if (word == "--threads")
      options.threads = std::atoi(value);
    else if (word == "--rounds")
      options.rounds = std::atoi(value);
    else if (word == "--most")
      options.most = std::atoll(value);
    else if (word != "--instructions" || !choose_instructions(value))
      return false;
  }
  return true;
}

int main_of(int count, char** words) {
  Options options;
  if (!read(count, words, options)) {
    fmt::print(
        stderr,
        "frames [--threads N] [--instructions NAME] [--rounds N] [--most PIXELS] [--json]\n");
    return 2;
  }
  if (!options.json) {
    fmt::print("{:17}{:>10}{:>10}{:>10}{:>10}{:>14}{:>14}{:>14}\n", "scene, pixels", "frame ms",
               "draw ms", "Cairo ms", "floor ms", "frame/Cairo", "draw/Cairo", "frame/floor");
  }
  bool same = true;
  for (const Case& c : kCases) {
    if ((long long)c.width * c.height <= options.most) same &= run(options, c);
  }
  return same ? 0 : 1;
}

}  // namespace
}  // namespace mien::bench

int main(int count, char** words) {
  return mien::bench::main_of(count, words);
}
