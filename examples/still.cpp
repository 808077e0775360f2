// A face file in, a still out:   example_still faces/toon.face.json toon.png
#include <mien/mien.h>
#include <mien/write.h>

#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 3) return 2;

  const auto face = mien::read_face(argv[1]);
  if (!face) return std::puts(sentence(face.error()).c_str()), 1;

  const auto posed = mien::pose_face(*face, {.time = 1.25});
  const auto scene = mien::scene_from_face(posed);
  const auto image = mien::render(scene, {.width = 1920, .height = 1080});

  if (!image) return std::puts(sentence(image.error()).c_str()), 1;

  const auto written = mien::write_image(*image, argv[2]);
  if (!written) return std::puts(sentence(written.error()).c_str()), 1;
}
