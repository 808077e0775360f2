// One buffer, many frames: how much of the picture a blink changes, frame by frame, as a bar chart.
//
//   example_blink faces/toon.face.json
#include <mien/mien.h>

#include <cstdio>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const auto face = mien::read_face(argv[1]);
  if (!face) return std::puts(sentence(face.error()).c_str()), 1;

  constexpr int kWidth = 320, kHeight = 180;
  std::vector<unsigned char> open(kWidth * kHeight * 4), frame(open.size());
  const auto draw = [&](std::vector<unsigned char>& into, const mien::Face& posed) {
    const auto done =
        mien::render_into({.data = into.data(), .stride = kWidth * 4}, mien::scene_from_face(posed),
                          {.width = kWidth, .height = kHeight});
    if (!done) std::puts(sentence(done.error()).c_str());
  };

  draw(open, *face);
  for (int percent = 0; percent <= 100; percent += 5) {
    const auto blink = mien::read_setting(*face, "blink=" + std::to_string(percent / 100.0));
    if (!blink) return std::puts(sentence(blink.error()).c_str()), 1;
    draw(frame, mien::pose_face(*face, {.settings = {*blink}}));

    int changed = 0;
    for (std::size_t i = 0; i < frame.size(); ++i) changed += frame[i] != open[i];
    std::printf("blink %3d %% %s\n", percent,
                std::string(std::size_t(changed) / 1000, '#').c_str());
  }
}
