// A face says a track of speech: how far its mouth is open, 25 times a second, as a bar chart.
//
//   example_talk faces/toon.face.json examples/talk/hello.TextGrid
#include <mien/bound_motion.h>
#include <mien/face_file.h>
#include <mien/face_model.h>
#include <mien/motion_file.h>
#include <mien/motion_length.h>
#include <mien/poser.h>

#include <cstdio>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const auto face = mien::read_face(argv[1]);
  if (!face) return std::puts(sentence(face.error()).c_str()), 1;
  std::vector<mien::Error> told;
  const auto track = mien::read_motion(argv[2], &told);
  if (!track) return std::puts(sentence(track.error()).c_str()), 1;
  for (const mien::Error& one : told) std::puts(sentence(one).c_str());

  const mien::BoundMotion bound = mien::bind_motion(*track, *face);
  for (const std::string& name : bound.unfollowed)
    std::printf("this face has no %s\n", name.c_str());

  const mien::Layout& layout = face->model->layout;
  const int upper = layout.find("upper_edge.left/spine/0"),
            lower = layout.find("lower_edge.left/spine/0");
  if (upper < 0 || lower < 0) return std::puts("this face has no mouth of two lips"), 1;

  mien::Poser poser(*face);
  const double length = mien::motion_length(*track);
  for (int frame = 0; frame / 25.0 <= length; ++frame) {
    const mien::Face& posed =
        poser.pose({.time = frame / 25.0, .motions = {{.motion = bound.motion}}});
    const auto y = [&](int slice) { return posed.vector[std::size_t(layout[slice].begin) + 1]; };
    const double open = y(upper) - y(lower);
    std::printf("%4.2f s %s\n", frame / 25.0,
                open == 0 ? "|" : std::string(std::size_t(100 * open), '#').c_str());
  }
}
