// A program of somebody else's: a face, drawn into its own buffer, and distances in bulk.
#include <mien/distance.h>
#include <mien/mien.h>

#include <cstdio>
#include <vector>

int main(int argc, char** argv) {
  const auto face = mien::read_face(argc > 1 ? argv[1] : "no such file");
  if (!face) return std::puts(sentence(face.error()).c_str()), 1;

  const mien::Scene scene = mien::scene_from_face(mien::pose_face(*face, {.time = 1.25}));
  const mien::View view{.width = 64, .height = 36};
  std::vector<unsigned char> pixels(64 * 36 * 4);
  if (!mien::render_into({.data = pixels.data(), .stride = 64 * 4}, scene, view)) return 1;

  const float x[] = {3, 0}, y[] = {4, 0};
  float d[2];
  mien::distances(mien::QuadBezier{{0, 0}, {-1, 0}, {-2, 0}}, x, y, d);
  if (d[0] != 5 || d[1] != 0) return 1;

  long long sum = 0;
  for (unsigned char byte : pixels) sum += byte;
  std::printf("mien %s: %lld\n", MIEN_VERSION_STRING, sum);
  return sum > 0 ? 0 : 1;
}
