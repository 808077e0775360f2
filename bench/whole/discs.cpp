// Pictures of 10 to 100 000 shapes beside Cairo, in turns in one process: see `discs --help`.

#include <mien/renderer.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "bench/whole/command_words.h"
#include "bench/whole/crowd.h"
#include "bench/whole/peer.h"

namespace mien::bench {
namespace {

constexpr std::string_view kHelp =
    R"(discs [--kinds NAMES] [--most SHAPES] [--seed N] [--threads N] [--instructions NAME]
      [--rounds N] [--seconds S] [--json]

10 to 100 000 shapes in 512 x 512 pixels beside Cairo, in turns in one process: medians and their
ratio. A picture of mien is scene to pixels, mixed as encoded; one of Cairo is clear and every
shape, paths built anew. Every picture of mien is of a scene whose places and lengths are all a little
smaller than in the one before, so nothing made for one is of use for the next.

  --kinds NAMES        discs,translucent,strokes,text: those only
  --most SHAPES        no scene of more
  --seed N             of the scenes (1)
  --threads N          threads that mien draws with (1); Cairo has one
  --instructions NAME  AVX3, AVX2, SSE4, …: instead of the best there is
  --rounds N           rounds of a scene, instead of 51 at most
  --seconds S          no further round of a scene after that time (20), one round aside; and no
                       larger scene of a kind once a single picture takes that long
  --json               a line of JSON for each scene
)";

constexpr int kCounts[] = {10, 100, 1000, 10'000, 100'000};
constexpr int kMostRounds = 51;

/// Mean difference of pictures of the same thing, in levels. Where shapes lie over shapes by the
/// hundred, every pixel of Cairo's is an edge that others shine through.
constexpr double kMostDifference = 8;

struct Options {
  std::string kinds = "discs,translucent,strokes,text";
  int most = 100'000, threads = 1, rounds = 0;
  unsigned seed = 1;
  double seconds = 20;
  bool json = false, help = false;
};

bool read(int count, char** words, Options& o) {
  const Words alone{{"--json", [&] { o.json = true; }}, {"--help", [&] { o.help = true; }}};
  const WordsWithValue with_value{
      {"--kinds", [&](const char* v) { return !(o.kinds = v).empty(); }},
      {"--most", [&](const char* v) { return (o.most = std::atoi(v)) > 0; }},
      {"--seed", [&](const char* v) { return (o.seed = unsigned(std::atoi(v))) > 0; }},
      {"--threads", [&](const char* v) { return (o.threads = std::atoi(v)) >= 0; }},
      {"--rounds", [&](const char* v) { return (o.rounds = std::atoi(v)) > 0; }},
      {"--seconds", [&](const char* v) { return (o.seconds = std::atof(v)) > 0; }},
      {"--instructions", choose_instructions}};
  return read_words(count, words, alone, with_value);
}

void tell(const Options& o, Crowd crowd, int count, double draw, double cairo, std::size_t rounds,
          double off) {
  if (o.json) {
    fmt::print(
        "{{\"kind\": \"{}\", \"shapes\": {}, \"width\": {}, \"height\": {}, \"threads\": {}, "
        "\"seed\": {}, \"draw_ms\": {:.5f}, \"cairo_ms\": {}, \"rounds\": {}, \"levels_off\": "
        "{:.3f}}}\n",
        crowd_name(crowd), count, kCrowdSide, kCrowdSide, o.threads, o.seed, draw,
        json_number(cairo), rounds, off);
  } else {
    fmt::print("{:12}{:>8}{:12.4f}{:12.4f}{:>14}{:>12.3f}\n", crowd_name(crowd), count, draw, cairo,
               ratio_text(draw, cairo), off);
  }
  std::fflush(stdout);
}

/// How a scene went.
struct Ran {
  bool same;     ///< Cairo drew the same thing
  double first;  ///< [ms] of mien's first picture
};

Ran run(const Options& o, Crowd crowd, int count) {
  const View view{.width = kCrowdSide, .height = kCrowdSide, .blend = Blend::srgb};
  const Pixels pixels(std::size_t(4 * kCrowdSide * kCrowdSide));
  const PixelBuffer buffer{pixels.data(), std::size_t(4 * kCrowdSide), Depth::u8};
  RenderOptions how;
  how.threads.count = o.threads;
  Renderer renderer;
  const Scene still = crowd_scene(crowd, count, o.seed);
  Peer peer(still, view);
  const double end = now_ms() + 1000 * o.seconds;
  // The first of each warms up, and is compared.
  const double first = ms_of([&] { renderer.render_into(buffer, still, view, how).value(); });
  peer.draw();
  const double off = peer.draws() ? peer.difference(pixels.data()) : 0;
  std::vector<double> draws, cairos;
  for (int i = 0; i < (o.rounds ? o.rounds : kMostRounds); ++i) {
    if (i > 0 && !o.rounds && now_ms() > end) break;
    const Scene scene = crowd_scene(crowd, count, o.seed, i + 1);
    draws.push_back(ms_of([&] { renderer.render_into(buffer, scene, view, how).value(); }));
    cairos.push_back(peer.draw());
  }
  tell(o, crowd, count, median(draws), median(cairos), draws.size(), off);
  if (off > kMostDifference)
    fmt::print(stderr, "{} {}: Cairo drew something else\n", count, crowd_name(crowd));
  return {off <= kMostDifference, first};
}

/// All scenes of a kind; once a picture takes longer than a scene may, no larger ones.
bool run_all(const Options& o, Crowd crowd) {
  bool same = true;
  for (const int count : kCounts) {
    if (count > o.most) break;
    const Ran ran = run(o, crowd, count);
    same &= ran.same;
    if (ran.first > 1000 * o.seconds) break;
  }
  return same;
}

int main_of(int count, char** words) {
  Options o;
  const bool understood = read(count, words, o);
  if (!understood || o.help) {
    fmt::print(understood ? stdout : stderr, "{}", kHelp);
    return understood ? 0 : 2;
  }
  if (!o.json)
    fmt::print("{:12}{:>8}{:>12}{:>12}{:>14}{:>12}\n", "seed " + std::to_string(o.seed), "shapes",
               "draw ms", "Cairo ms", "draw/Cairo", "levels off");
  bool same = true;
  for (const Crowd crowd : crowds())
    if (o.kinds.find(crowd_name(crowd)) != std::string::npos) same &= run_all(o, crowd);
  return same ? 0 : 1;
}

}  // namespace
}  // namespace mien::bench

int main(int count, char** words) {
  return mien::bench::main_of(count, words);
}
