#pragma once
// What a format of animated pictures is to `picture_film`: pictures that follow one another, each for a number of ticks.

#include <mien/expected.h>
#include <mien/image.h>
#include <mien/view.h>
#include "render/image/file/file_output.h"
#include "tools/mien/film/film.h"

#include <memory>

namespace mien::command {

/// A format's time.
struct FrameTicks {
  int a_second;
  long shortest, longest;  ///< that one frame may be shown
};

class PictureSeries {
 public:
  virtual ~PictureSeries() = default;
  virtual FrameTicks ticks() const = 0;
  /// The next picture, whole; `changed` is where it differs from the one before, at least a pixel. Errors leave `where` empty.
  virtual Expected<Done> put(const Image& picture, const PixelRect& changed, long ticks) = 0;
  /// After the last one.
  virtual Expected<Done> finish() = 0;
};

using MadeSeries = Expected<std::unique_ptr<PictureSeries>>;

MadeSeries apng_series(FileOutput& out, const FilmPlan& plan);

}  // namespace mien::command
