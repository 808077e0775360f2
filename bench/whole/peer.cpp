#include "bench/whole/peer.h"

#include <cstdlib>

#ifdef MIEN_HAVE_CAIRO
#include "bench/whole/cairo_picture.h"
#endif

namespace mien::bench {

#ifdef MIEN_HAVE_CAIRO

Peer::Peer(const Scene& scene, const View& view)
    : count_(std::size_t(view.width) * std::size_t(view.height)),
      pixels_(4 * count_),
      drawing_(peer_drawing(scene, view, why_)) {
  if (drawing_) picture_ = std::make_unique<CairoPicture>(*drawing_, pixels_.data());
}

double Peer::draw() {
  return picture_ ? ms_of([&] { picture_->draw(); }) : 0;
}

#else

class CairoPicture {};

Peer::Peer(const Scene&, const View&) : count_(0), pixels_(0), why_("built without Cairo") {}

double Peer::draw() {
  return 0;
}

#endif

Peer::~Peer() = default;

double Peer::difference(const std::uint32_t* ours) const {
  double sum = 0;
  // Cairo's blue comes first.
  for (std::size_t i = 0; i < count_; ++i)
    sum += std::abs(int(ours[i] & 255) - int(pixels_.data()[i] >> 16 & 255));
  return sum / double(count_);
}

}  // namespace mien::bench
