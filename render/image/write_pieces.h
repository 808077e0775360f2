#pragma once
// The way of every picture to its file: pieces are made on many threads and put in order, and the file appears
// whole or not at all.

#include <mien/write.h>
#include "render/image/picture_encoder.h"

#include <atomic>
#include <filesystem>
#include <functional>
#include <mutex>

namespace mien {

/// Whether to go on, asked from any thread: passes the question on to the caller's progress, one
/// thread at a time.
class StopWatch {
 public:
  explicit StopWatch(const Progress& progress) : progress_(progress) {}

  /// Asks, if nobody else is asking. True: stop.
  bool ask();
  /// The share done so far; asks for certain.
  bool done(double share);
  void stop() { stopped_ = true; }
  const std::atomic<bool>& stopped() const { return stopped_; }

 private:
  const Progress& progress_;
  std::atomic<bool> stopped_ = false;
  std::mutex asking_;
  double share_ = 0;
};

/// Gives the pixels of a piece, on any thread, several at once, each in its slot; they last until the
/// slot is used again. Data null: stopped.
using PiecePixels = std::function<PixelBuffer(const PixelRect& piece, int slot, StopWatch& watch)>;

struct PiecesToWrite {
  PictureFrame frame;
  PiecePixels pixels;
  std::uint64_t memory = 0;  ///< [bytes] for everything that is held
};

/// [s] of all threads together.
struct PieceTimes {
  double encode = 0, put = 0;
};

/// `make`: the encoders of all types. Errors have their address.
Expected<PieceTimes> write_pieces(const PiecesToWrite& what, const std::filesystem::path& path,
                                  const WriteOptions& how, const MakeEncoder& make);

/// The verbs of image.h, with the encoders given; they throw nothing.
Expected<Done> write_image_by(const MakeEncoder& make, const Image& image,
                              const std::filesystem::path& path, const WriteOptions& how);
Expected<PictureStats> write_picture_by(const MakeEncoder& make, const Scene& scene,
                                        const View& view, const std::filesystem::path& path,
                                        const PictureOptions& how);

}  // namespace mien
