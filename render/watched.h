#pragma once
// Work under a watch of its own: what ends it is the error.

#include "render/render_error.h"

#include <mien/progress.h>

#include <optional>
#include <type_traits>
#include <utility>

namespace mien {

/// What `work()` makes, which draws so many `pixels`. Errors: cancelled, or a limit by its name. `done()` tells progress the share done. What ends the
/// watched work around it passes through.
template <class Work, class Share>
auto watched(const Progress& progress, const RenderLimits& limits, std::int64_t pixels,
             const Work& work, const Share& done) -> Expected<std::invoke_result_t<Work>> {
  std::function<bool()> go_on;
  if (progress) go_on = [&] { return progress(done()); };
  Watch watch(std::move(go_on), limits, pixels);
  try {
    std::optional<std::invoke_result_t<Work>> made;
    {
      const Watching here(&watch);
      made.emplace(work());
    }
    if (watch.stopped()) return why_stopped(watch);  // by its last steps
    return *std::move(made);
  } catch (const Stopped&) {
    if (!watch.stopped()) throw;
    return why_stopped(watch);
  }
}

}  // namespace mien
