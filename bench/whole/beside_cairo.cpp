#include "bench/whole/beside_cairo.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/support/fill_floor.h"
#include "bench/whole/frame_drawer.h"
#include "bench/whole/peer.h"

namespace mien::bench {
namespace {

constexpr int kWarmUp = 2;  // rounds

/// Most that pictures of the same thing differ by in the mean, in levels. Cairo's edges are a few
/// levels off, and in small pictures more of the pixels are edges.
double most_difference(const View& view) {
  return 0.5 * std::max(1.0, 256.0 / view.width);
}

/// [ms] of every round.
struct Times {
  std::vector<double> frame, draw, cairo, given, ordinary, streaming;

  double floor() const { return std::min(median(ordinary), median(streaming)); }
};

Times take_rounds(const Options& options, const Subject& subject, FrameDrawer& drawer, Peer& peer) {
  const std::size_t count = drawer.pixel_count();
  const Pixels floor(count * 4);
  const Pose pose = subject.pose();
  Times times;
  GivenOutlines outlines;
  const Rounds rounds(options.rounds, options.seconds, count);
  for (int i = -kWarmUp; rounds.go_on(i); ++i) {
    const int step = 2 * (i + kWarmUp);
    const Face face = subject.face(step);
    const Scene scene = subject.scene(step + 1);
    const double f = drawer.frame(face, pose), p = peer.draw(), d = drawer.draw(scene);
    // What mien's frame makes and the peer is given.
    const double g =
        ms_of([&] { outlines.fit(scene_from_face(pose_face(face, pose)), drawer.view()); });
    const double o = ms_of([&] { fill_ordinary(floor.data(), count, std::uint32_t(i)); });
    const double s = ms_of([&] { fill_streaming(floor.data(), count, std::uint32_t(i)); });
    if (i < 0) continue;
    times.frame.push_back(f), times.draw.push_back(d), times.cairo.push_back(p);
    times.given.push_back(g);
    times.ordinary.push_back(o), times.streaming.push_back(s);
  }
  return times;
}

void tell(const Options& options, const FrameCase& c, const Times& times,
          const std::string& why_no_peer) {
  const double frame = median(times.frame), draw = median(times.draw), cairo = median(times.cairo);
  const double equal = cairo > 0 ? cairo + median(times.given) : 0;
  if (options.json) {
    fmt::print(
        "{{\"scene\": \"{}\", \"width\": {}, \"height\": {}, \"threads\": {}, \"frame_ms\": "
        "{:.5f}, \"draw_ms\": {:.5f}, \"cairo_ms\": {}, \"given_ms\": {:.5f}, \"floor_ms\": "
        "{:.5f}, "
        "\"face\": \"{}\", "
        "\"rounds\": {}}}\n",
        c.scene, c.width, c.height, options.threads, frame, draw, json_number(cairo),
        median(times.given), times.floor(), c.face, times.frame.size());
  } else {
    fmt::print("{} {:>6} x {:<6}{:10.4f}{:10.4f}{:>10}{:10.4f}{:10.4f}{:>14}{:>14}{:>14}{:>14}{}\n",
               c.scene, c.width, c.height, frame, draw,
               cairo > 0 ? fmt::format("{:.4f}", cairo) : "-", median(times.given), times.floor(),
               ratio_text(frame, cairo), ratio_text(frame, equal), ratio_text(draw, cairo),
               ratio_text(frame, times.floor()),
               why_no_peer.empty() ? "" : "  no peer: " + why_no_peer);
  }
}

}  // namespace

bool beside_cairo(const Options& options, const FrameCase& c) {
  const Subject subject(c);
  FrameDrawer drawer(c, subject, options.threads);
  Peer peer(subject.scene(0), drawer.view());
  tell(options, c, take_rounds(options, subject, drawer, peer), peer.why_not());
  if (!peer.draws()) return true;
  drawer.draw(subject.scene(0));
  const double off = peer.difference(drawer.pixels());
  if (off <= most_difference(drawer.view())) return true;
  fmt::print(stderr, "scene {}: Cairo drew something else: {:.2f} levels off\n", c.scene, off);
  return false;
}

std::string beside_cairo_head() {
  return fmt::format("{:17}{:>10}{:>10}{:>10}{:>10}{:>10}{:>14}{:>14}{:>14}{:>14}\n",
                     "scene, pixels", "frame ms", "draw ms", "Cairo ms", "given ms", "floor ms",
                     "frame/Cairo", "equal work", "draw/Cairo", "frame/floor");
}

}  // namespace mien::bench
