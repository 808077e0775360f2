#pragma once

#include <memory>
#include <string>

#include "bench/whole/peer_drawing.h"
#include "bench/whole/timing.h"

namespace mien::bench {

class CairoPicture;

/// The peer, Cairo, drawing one scene: where it can, and where it is installed.
class Peer {
 public:
  Peer(const Scene& scene, const View& view);
  ~Peer();

  bool draws() const { return picture_ != nullptr; }
  const std::string& why_not() const { return why_; }

  /// A whole picture [ms]; 0 if it draws none.
  double draw();

  /// Mean difference of the red channels of that picture and ours, in levels.
  double difference(const std::uint32_t* ours) const;

 private:
  std::size_t count_;  ///< pixels
  Pixels pixels_;
  std::string why_;
  std::optional<PeerDrawing> drawing_;
  std::unique_ptr<CairoPicture> picture_;
};

}  // namespace mien::bench
