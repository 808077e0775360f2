#include "bench/whole/old_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

#include "bench/whole/frame_drawer.h"

namespace mien::bench {
namespace {

constexpr int kTurns = 7;
constexpr int kWarmUp = 3;        // frames: as many as `mien bench` takes
constexpr double kRunMs = 300;    // about what one run's frames take
constexpr int kMostFrames = 200;  // of one run
constexpr const char* kMedianKey = "\"median_ms\": ";

/// For the shell: nothing in it means anything.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string output_of(const std::string& command) {
  std::string said;
  FILE* const pipe = popen(command.c_str(), "r");
  if (!pipe) return said;
  std::array<char, 4096> part;
  for (std::size_t n; (n = std::fread(part.data(), 1, part.size(), pipe)) > 0;)
    said.append(part.data(), n);
  pclose(pipe);
  return said;
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

/// Median of a run of this build's frames, cold ones.
double run_new(FrameDrawer& drawer, const Subject& subject, int frames) {
  std::vector<double> times;
  for (int i = -kWarmUp; i < frames; ++i) {
    const double took = drawer.frame(subject.face(i + kWarmUp), subject.pose());
    if (i >= 0) times.push_back(took);
  }
  return median(times);
}

/// Frames of a run, so that the slower build's takes about kRunMs.
int frames_of_a_run(const Options& options, double ms) {
  if (options.rounds) return options.rounds;
  return std::clamp(int(kRunMs / std::max(ms, 1e-3)), 1, kMostFrames);
}

/// Medians of the runs, turn by turn, and of their ratios: what slows a whole turn down is in both.
void tell(const Options& options, const FrameCase& c, const std::vector<double>& news,
          const std::vector<double>& olds) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < news.size(); ++i) ratios.push_back(olds[i] / news[i]);
  const double now = median(news), old = median(olds), ratio = median(ratios);
  if (options.json) {
    fmt::print(
        "{{\"scene\": \"{}\", \"width\": {}, \"height\": {}, \"threads\": {}, \"frame_ms\": "
        "{:.5f}, \"old_ms\": {:.5f}, \"old_over_new\": {:.4f}, \"face\": \"{}\", \"turns\": {}}}\n",
        c.scene, c.width, c.height, options.threads, now, old, ratio, c.face, news.size());
  } else {
    fmt::print("{} {:>6} x {:<6}{:12.4f}{:12.4f}{:>12}\n", c.scene, c.width, c.height, now, old,
               ratio_text(ratio, 1));
  }
}

}  // namespace

OldRun run_old(const Options& options, const FrameCase& c, int frames) {
  std::string command = fmt::format(
      "{} bench {} --size {}x{} --blend srgb --depth 8 --effect none --threads {} --repeat {} "
      "--json",
      quoted(options.old), quoted(face_path(c)), c.width, c.height, options.threads, frames);
  for (const char* setting : c.settings) command += " --set " + quoted(setting);
  const std::string said = output_of(command + " 2>&1");
  const std::size_t at = said.find(kMedianKey);
  if (at == std::string::npos) return {0, said.empty() ? "it said nothing" : first_line(said)};
  return {std::atof(said.c_str() + at + std::string(kMedianKey).size()), {}};
}

bool beside_old(const Options& options, const FrameCase& c) {
  if (!c.reliefs) {
    if (!options.json)
      fmt::print("{} - (the old command draws faces with their reliefs)\n", c.scene);
    return true;
  }
  const OldRun first = run_old(options, c, 1);
  if (!first.why.empty()) {
    fmt::print(stderr, "scene {}: {}: {}\n", c.scene, options.old, first.why);
    return false;
  }
  const Subject subject(c);
  FrameDrawer drawer(c, subject, options.threads);
  const int frames =
      frames_of_a_run(options, std::max(first.median_ms, run_new(drawer, subject, 1)));
  std::vector<double> news, olds;
  const Rounds turns(kTurns, options.seconds, drawer.pixel_count());
  for (int i = 0; turns.go_on(i); ++i) {
    // Who begins changes, too.
    if (i % 2) news.push_back(run_new(drawer, subject, frames));
    olds.push_back(run_old(options, c, frames).median_ms);
    if (i % 2 == 0) news.push_back(run_new(drawer, subject, frames));
  }
  tell(options, c, news, olds);
  return true;
}

std::string beside_old_head() {
  return fmt::format("{:17}{:>12}{:>12}{:>12}\n", "scene, pixels", "new ms", "old ms", "old/new");
}

}  // namespace mien::bench
