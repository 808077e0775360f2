// A face on a small display: 240 x 240 pixels of RGB565, frame after frame, as a device would send them to its controller.
//
//   example_display FACE.json [FRAMES]
//
// Prints how fast frames come, and what the program held at most.

#include <mien/device_pixels.h>
#include <mien/face_file.h>
#include <mien/pose.h>
#include <mien/scene_from_face.h>

#include <sys/resource.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

int main(int argc, char** argv) {
  if (argc < 2) return std::fprintf(stderr, "example_display FACE.json [FRAMES]\n"), 2;
  constexpr int kSide = 240;
  const int frames = argc > 2 ? std::atoi(argv[2]) : 20;
  const auto face = mien::read_face(argv[1]);
  if (!face) return std::fprintf(stderr, "%s\n", sentence(face.error()).c_str()), 1;

  std::vector<std::uint16_t> pixels(kSide * kSide);
  const mien::DeviceBuffer display{pixels.data(), 2 * kSide, mien::DeviceFormat::rgb565_swapped};
  const auto begin = std::chrono::steady_clock::now();
  for (int frame = 0; frame < frames; ++frame) {
    const mien::Scene scene = mien::scene_from_face(mien::pose_face(*face, {.time = frame / 25.0}));
    const auto done = mien::render_for_device(display, scene, {.width = kSide, .height = kSide},
                                              {.threads = {.count = 1}});
    if (!done) return std::fprintf(stderr, "%s\n", sentence(done.error()).c_str()), 1;
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;

  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  std::printf("%d frames of %d x %d, %.1f a second, %.1f MB at most, first pixel %04x\n", frames,
              kSide, kSide, frames / took.count(), double(used.ru_maxrss) / 1000, pixels[0]);
}
