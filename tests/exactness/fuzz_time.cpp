// mien_fuzz_time: random small faces of every kind of feature, or people at poses, drawn as long as one likes: none may
// take too long.
#include <mien/composed_face.h>
#include <mien/face_file.h>
#include <mien/pose.h>
#include <mien/render.h>
#include <mien/scene_from_face.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "tests/support/random/random.h"

namespace mien::test {
namespace {

constexpr const char* kUse =
    "mien_fuzz_time [--people] [--first N] [--count N] [--minutes N] [--most SECONDS] [SEED …]\n"
    "Draws random small faces, or people of every style, turned, blinking and with feelings, by\n"
    "their seeds at 16 to 256 px, at 8 and 16 bits, on one thread. Prints the ten slowest. Ends\n"
    "with 1 if one takes longer than --most (10), or is refused without a limit's name.\n";

using Text = std::string;

/// A face's text, thrown by dice that like extremes.
class FaceDice {
 public:
  explicit FaceDice(std::uint64_t seed) : r_(seed) {}

  Text face() {
    Text features;
    const int count = 1 + r_.below(5);
    for (int i = 0; i < count; ++i) features += fmt::format("{}{}", i ? ",\n" : "", feature(i));
    return fmt::format(
        R"({{"format": "mien-face", "format_version": 1, "name": "dice",
"canvas": {{"x": [-1, 1], "y": [-1, 1], "y_axis": "up"}},
"palette": {{"a": "#204080", "b": "#c03010c0", "c": "#30a04080", "ground": "#ffffff"}}, "background": "ground",
"light": {{"direction": [-0.45, 0.65, 0.85], "ambient": 0.35}},
"groups": {{"g": {{"opacity": 0.5, "mix": "{}"}}}}, "features": [
{}]}})",
        pick({"normal", "multiply", "screen"}), features);
  }
  int side() { return int(16.0 * std::pow(16.0, r_.unit())); }
  Depth depth() { return r_.chance(0.7) ? Depth::u8 : Depth::u16; }

 private:
  Text pick(std::vector<Text> of) { return of[std::size_t(r_.below(int(of.size())))]; }
  /// From 1 to `most`, all sizes alike.
  int many(int most) { return int(std::pow(double(most), r_.unit())); }
  double length() { return r_.chance(0.1) ? r_.size(-9, -3) : r_.size(-3, 0.2); }
  Text place() {
    const double step = grid_;
    const auto one = [&] {
      const double v = r_.between(-1, 1);
      return step > 0.0 ? step * std::round(v / step) : v;
    };
    const double x = level_ ? 0.125 : one();
    return fmt::format("[{}, {}]", x, one());
  }
  Text places(int count, bool bends) {
    grid_ = r_.chance(0.5) ? 0.0 : std::ldexp(1.0, -r_.below(6));
    level_ = r_.chance(0.1);
    Text text;
    for (int i = 0; i < count; ++i) {
      Text p = place();
      if (bends && r_.chance(0.5)) p.back() = ',', p += "\"bend\"]";
      text += fmt::format("{}{}", i ? ", " : "", p);
    }
    grid_ = 0.0, level_ = false;
    return text;
  }
  Text width() {
    return r_.chance(0.5) ? fmt::format("{}", length())
                          : fmt::format("[{}, {}, {}]", length(), length(), length());
  }
  Text patch() {
    return fmt::format(R"("patch": [[{}, {}], [{}, {}]])", place(), place(), place(), place());
  }
  Text mark() {
    switch (r_.below(3)) {
      case 0:
        return fmt::format(R"("of": "disc", "radius": {})", length());
      case 1:
        return fmt::format(R"("of": "ellipse", "radii": [{}, {}])", length(), length());
      default:
        return fmt::format(R"("of": "stroke", "length": {}, "half_width": {})", length(), width());
    }
  }
  Text figure() {
    switch (r_.below(9)) {
      case 0:
        return fmt::format(R"("kind": "disc", "center": {}, "radius": {})", place(), length());
      case 1:
        return fmt::format(R"("kind": "ellipse", "center": {}, "radii": [{}, {}], "tilt": {})",
                           place(), length(), length(), r_.between(0, 90));
      case 2:
        return fmt::format(R"("kind": "stroke", "spine": [{}, {}, {}], "half_width": {})", place(),
                           place(), place(), width());
      case 3:
        return fmt::format(R"("kind": "polyline", "points": [{}], "half_width": {}, "smooth": {})",
                           places(many(300), false), length(), r_.chance(0.5));
      case 4:
        return fmt::format(R"("kind": "rounded", "center": {}, "radii": [{}, {}], "corner": {})",
                           place(), length(), length(), length());
      case 5:
        return fmt::format(
            R"("kind": "scatter", {}, "count": {}, "seed": {}, "jitter": 1, "sway": 180, {})",
            patch(), many(800), r_.below(99), mark());
      case 6:
        return fmt::format(R"("kind": "stripes", {}, "count": {}, "half_width": {}, "jitter": 0.5)",
                           patch(), many(400), width());
      default:
        return fmt::format(R"("kind": "path", "fill": "{}", "points": [{}])",
                           pick({"nonzero", "even_odd"}), places(3 + many(600), r_.chance(0.5)));
    }
  }
  Text stops() {
    const int count = 2 + (r_.chance(0.1) ? many(120) : r_.below(4));
    Text text;
    for (int i = 0; i < count; ++i)
      text += fmt::format("{}[{}, \"{}\"]", i ? ", " : "", double(i) / (count - 1),
                          pick({"a", "b", "c"}));
    return text;
  }
  Text paint() {
    const Text end = fmt::format(R"("stops": [{}], "extend": "{}"}})", stops(),
                                 pick({"pad", "pad", "repeat", "reflect"}));
    switch (r_.below(8)) {
      case 0:
        return fmt::format(R"({{"gradient": "linear", "from": {}, "to": {}, )", place(), place()) +
               end;
      case 1:
        return fmt::format(R"({{"gradient": "radial", "center": {}, "radii": [{}, {}], )", place(),
                           r_.size(-1.5, 0), r_.size(-1.5, 0)) +
               end;
      case 2:
        return fmt::format(R"({{"gradient": "distance", "inside": {}, "outside": {}, )",
                           r_.size(-1.5, 0), r_.between(0, 0.1)) +
               end;
      default:
        return fmt::format("\"{}\"", pick({"a", "b", "c"}));
    }
  }
  Text feature(int index) {
    Text text = fmt::format(R"({{"name": "f{}", "paint": {}, {})", index, paint(), figure());
    if (index > 0 && r_.chance(0.3)) text += fmt::format(R"(, "clip": "f{}")", r_.below(index));
    if (r_.chance(0.15))
      text += fmt::format(
          R"(, "relief": {{"profile": "{}", "width": {}, "height": {}, "specular": 0.3}})",
          pick({"bevel", "round"}), r_.size(-2, 0), r_.size(-2, -0.5));
    if (r_.chance(0.1)) text += fmt::format(R"(, "feather": {})", r_.size(-2, -0.5));
    if (r_.chance(0.1))
      text += fmt::format(R"(, "shadow": {{"color": "b", "blur": {}}})", r_.size(-2, -0.5));
    if (r_.chance(0.1))
      text += fmt::format(R"(, "glow": {{"color": "b", "reach": {}}})", r_.size(-2, -0.5));
    if (r_.chance(0.1))
      text += fmt::format(R"(, "contour": {{"color": "b", "half_width": {}}})", r_.size(-3, -1));
    if (r_.chance(0.3)) text += R"(, "group": "g")";
    return text + "}";
  }

  Random r_;
  double grid_ = 0;  ///< of places; 0: none
  bool level_ = false;
};

struct Drawn {
  long seed;
  int side;
  double seconds;
  long long steps, memory;
  Text error;
};

void draw_posed(const Face& face, const Pose& pose, Depth depth, Drawn& drawn) {
  RenderStats stats;
  const auto image =
      render(scene_from_face(pose_face(face, pose)), {.width = drawn.side, .height = drawn.side},
             {.depth = depth, .threads = {.count = 1}}, &stats);
  if (!image) drawn.error = image.error().what;
  drawn.steps = stats.steps, drawn.memory = stats.memory;
}

/// Faces that are refused when read count as drawn at once.
void draw_face(FaceDice& dice, Drawn& drawn) {
  const Text text = dice.face();
  if (std::getenv("MIEN_FUZZED_FACE")) std::puts(text.c_str());
  drawn.side = dice.side();
  if (const auto face = read_face_text(text, "dice"))
    draw_posed(*face, {}, dice.depth(), drawn);
  else if (std::getenv("MIEN_FUZZED_FACE"))
    std::puts(sentence(face.error()).c_str());
}

/// A person of some style, turned, with a feeling, lids somewhere.
void draw_person(FaceDice& dice, Random& random, Drawn& drawn) {
  Recipe recipe = recipe_from_seed(seed_from_word(fmt::format("time/{}", drawn.seed)));
  const std::vector<Text> styles = part_styles();
  recipe.style = styles[std::size_t(random.below(int(styles.size())))];
  const Face face = face_from_recipe(recipe).value();
  Pose pose;
  const auto set = [&](const Text& name, double value) {
    pose.settings.push_back(read_setting(face, fmt::format("{}={}", name, value)).value());
  };
  set("yaw", random.between(-30, 30)), set("pitch", random.between(-25, 25));
  set("roll", random.between(-20, 20)), set("blink", random.unit());
  for (const char* feeling : {"joy", "sadness", "anger", "fear", "disgust", "surprise"})
    if (random.chance(0.2)) set(fmt::format("emotion.{}", feeling), random.unit());
  drawn.side = dice.side();
  draw_posed(face, pose, dice.depth(), drawn);
}

Drawn draw(long seed, bool people) {
  const std::uint64_t word = std::uint64_t(seed) * 0x9e3779b97f4a7c15u;
  FaceDice dice(word);
  Random random(word);
  Drawn drawn{seed, 0, 0, 0, 0, {}};
  const std::clock_t began = std::clock();  // of the processor: others may use it, too
  if (people)
    draw_person(dice, random, drawn);
  else
    draw_face(dice, drawn);
  drawn.seconds = double(std::clock() - began) / CLOCKS_PER_SEC;
  return drawn;
}

struct Asked {
  long first = 1, count = 1'000'000'000;
  double minutes = 1e9, most = 10;
  bool people = false;
  std::vector<long> seeds;
};

bool read(int count, char** words, Asked& asked) {
  for (int i = 1; i < count; ++i) {
    const Text name = words[i];
    char* end = nullptr;
    if (name == "--people") {
      asked.people = true;
    } else if (name.starts_with("--") && i + 1 < count) {
      const double value = std::strtod(words[++i], &end);
      if (*end) return false;
      if (name == "--first")
        asked.first = long(value);
      else if (name == "--count")
        asked.count = long(value);
      else if (name == "--minutes")
        asked.minutes = value;
      else if (name == "--most")
        asked.most = value;
      else
        return false;
    } else {
      asked.seeds.push_back(std::strtol(words[i], &end, 10));
      if (*end || end == words[i]) return false;
    }
  }
  return true;
}

int run(const Asked& asked) {
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  std::vector<Drawn> slowest;
  long count = 0, limits = 0;
  bool all_well = true;
  const auto add = [&](long seed) {
    const Drawn drawn = draw(seed, asked.people);
    ++count;
    const bool limited = drawn.error.find("(limit `") != Text::npos;
    limits += limited;
    if ((!drawn.error.empty() && !limited) || drawn.seconds > asked.most) {
      all_well = false;
      fmt::print("seed {} at {} px: {:.1f} s {}\n", seed, drawn.side, drawn.seconds, drawn.error);
      std::fflush(stdout);
    }
    slowest.push_back(drawn);
    std::sort(slowest.begin(), slowest.end(),
              [](const Drawn& a, const Drawn& b) { return a.seconds > b.seconds; });
    if (slowest.size() > 10) slowest.pop_back();
  };
  for (const long seed : asked.seeds) add(seed);
  const auto in_time = [&] {
    return std::chrono::duration<double>(Clock::now() - began).count() < 60 * asked.minutes;
  };
  if (asked.seeds.empty())
    for (long i = 0; i < asked.count && in_time(); ++i) add(asked.first + i);
  fmt::print("{} faces, {} of them ended by a limit; the slowest:\n", count, limits);
  for (const Drawn& d : slowest)
    fmt::print("seed {:6} at {:3} px: {:6.2f} s, {:7.1f} million steps, {:4} MiB\n", d.seed, d.side,
               d.seconds, double(d.steps) * 1e-6, d.memory >> 20);
  return all_well ? 0 : 1;
}

}  // namespace
}  // namespace mien::test

int main(int count, char** words) {
  mien::test::Asked asked;
  if (!mien::test::read(count, words, asked)) {
    std::fputs(mien::test::kUse, stderr);
    return 2;
  }
  return mien::test::run(asked);
}
