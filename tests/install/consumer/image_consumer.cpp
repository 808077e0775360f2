// A program of somebody else's that writes a picture.
#include <mien/mien.h>
#include <mien/write.h>

#include <cstdio>

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const auto face = mien::read_face(argv[1]);
  if (!face) return std::puts(sentence(face.error()).c_str()), 1;
  const auto image = mien::render(mien::scene_from_face(*face), {.width = 64, .height = 36});
  if (!image) return 1;
  const auto written = mien::write_image(*image, argv[2]);
  if (!written) std::puts(sentence(written.error()).c_str());
  return written ? 0 : 1;
}
