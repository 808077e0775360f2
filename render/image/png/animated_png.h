#pragma once
// An animated PNG (APNG, PNG 3rd edition 11.3.4): a PNG whose first frame is what readers that know no animation show.
//
// A frame is a part of the picture that takes the place of what was there before. How many there are stands at the file's
// beginning and is known at its end: it is filled in there, so the file has to be one that can be written anywhere.

#include <mien/expected.h>
#include <mien/view.h>
#include "render/image/file/file_output.h"
#include "render/image/png/png_chunks.h"

#include <cstdint>

namespace mien {

/// How long a frame is seen: ticks / ticks_a_second.
struct FrameDelay {
  std::uint16_t ticks, ticks_a_second;
};

class AnimatedPng {
 public:
  /// `pixels` are of the whole picture. Plays without end.
  AnimatedPng(FileOutput& out, const PngPixels& pixels, int height);

  /// The next frame; the first one is the whole picture. `rows` is RGBA, where the part begins. The error's `where` is left
  /// empty.
  Expected<Done> add(const PixelRect& part, const std::byte* rows, std::size_t stride,
                     FrameDelay delay);
  Expected<Done> finish();

 private:
  void begin_frame(const PixelRect& part, FrameDelay delay);
  void add_data(const PngBytes& stream);
  Expected<Done> write();

  FileOutput& out_;
  const PngPixels pixels_;
  PngBytes bytes_;          // to be written next
  std::size_t control_at_;  // where the count stands, in the file
  std::uint32_t frames_ = 0;
  std::uint32_t numbered_ = 0;  // chunks of animation have numbers
};

}  // namespace mien
