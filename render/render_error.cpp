#include "render/render_error.h"
#include "lib/base/bytes_text.h"
#include "lib/base/memory_ran_out.h"

#include <fmt/format.h>

namespace mien {

bool drawable(const View& view) {
  const auto valid = [](int side) { return side >= 1 && side <= View::kMaxSide; };
  return valid(view.width) && valid(view.height);
}

Error invalid_size(const View& view) {
  return {"", fmt::format("a picture of {} x {} pixels: sides are 1 ... {}", view.width,
                          view.height, View::kMaxSide)};
}

Error out_of_memory(const PixelRect& rect) {
  return {"", fmt::format("{}: the picture has {} x {} pixels", kMemoryRanOut, rect.width,
                          rect.height)};
}

Error why_stopped(const Watch& watch) {
  if (watch.why() == Stopped::Why::cancelled) return drawing_cancelled();
  if (watch.why() == Stopped::Why::steps)
    return {"", fmt::format("drawing takes more than {} steps of work (limit `steps`)",
                            watch.limits().steps)};
  const bool foreseen = watch.why() == Stopped::Why::foreseen;
  return {"", fmt::format("outlines and their order need {} (limit `memory`)",
                          foreseen ? fmt::format("at least {}, more than the {} allowed",
                                                 bytes_text(watch.foreseen()),
                                                 bytes_text(watch.limits().memory))
                                   : "more than " + bytes_text(watch.limits().memory))};
}

Error drawing_cancelled() {
  return {"", std::string(kCancelled)};
}

}  // namespace mien
