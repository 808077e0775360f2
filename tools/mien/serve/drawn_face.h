#pragma once
// A picture of a face for a request, as bytes.

#include "tools/mien/http/http_answer.h"
#include "tools/mien/serve/face_request.h"

#include <functional>
#include <string_view>

namespace mien::command {

/// What a request is answered, however often it comes: a picture, or a sentence about what is wrong with it.
struct DrawnFace {
  int code = kOk;
  HttpBytes bytes;  ///< a picture, or a sentence
};

/// Draws on this thread, or says why not. `go_on` is asked every few milliseconds; what it ends is told by `late`, with
/// kUnavailable.
DrawnFace drawn_face(const FaceRequest& request, const RequestLimits& limits,
                     const std::function<bool()>& go_on, std::string_view late);

}  // namespace mien::command
