// Any bytes as the target of a request: refused with one sentence, or a picture that is asked for in bounds.

#include "tools/mien/serve/face_request.h"

#include <mien/face_code.h>

#include <algorithm>
#include <cstdint>

#include "fuzz/support/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mien;
  using namespace mien::command;
  const auto read =
      read_face_request({reinterpret_cast<const char*>(data), size}, {.most_side = 300});
  if (const auto* refusal = std::get_if<Refusal>(&read)) {
    fuzz::require(refusal->code == 400 || refusal->code == 404 || refusal->code == 414);
    fuzz::require_sentence(refusal->error);
    return 0;
  }
  const auto& request = std::get<FaceRequest>(read);
  const RenderArguments& asked = request.arguments;
  const auto code = read_face_code(asked.posed.face);
  fuzz::require(code && face_code_text(*code) == asked.posed.face);
  // Nothing that names a file.
  fuzz::require(asked.output.empty() && !asked.error_map && !asked.posed.motion &&
                !asked.posed.speech && !asked.posed.arkit && !asked.posed.basis &&
                asked.posed.morphs.empty());
  fuzz::require(asked.size.has_value() != (request.width || request.height));
  fuzz::require(request.meaning.size() >= asked.posed.face.size());
  return 0;
}
