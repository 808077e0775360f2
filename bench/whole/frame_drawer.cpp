#include "bench/whole/frame_drawer.h"

namespace mien::bench {

FrameDrawer::FrameDrawer(const FrameCase& c, const Subject& subject, int threads, Blend blend,
                         Depth depth)
    : subject_(subject),
      view_{.width = c.width, .height = c.height, .blend = blend},
      pixel_count_(std::size_t(c.width) * std::size_t(c.height)),
      pixels_(pixel_count_ * 4 * bytes_per_channel(depth)),
      buffer_{pixels_.data(), std::size_t(c.width) * 4 * bytes_per_channel(depth), depth} {
  how_.threads.count = threads;
}

double FrameDrawer::frame(const Face& face, const Pose& pose) {
  const double began = now_ms();
  Scene scene = scene_from_face(pose_face(face, pose));
  const double made = now_ms();
  const Scene wanted = subject_.as_wanted(std::move(scene));
  return made - began + draw(wanted);
}

double FrameDrawer::draw(const Scene& scene) {
  return ms_of([&] { renderer_.render_into(buffer_, scene, view_, how_).value(); });
}

}  // namespace mien::bench
