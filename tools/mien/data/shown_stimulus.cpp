#include "tools/mien/data/shown_stimulus.h"
#include <mien/pose.h>
#include "render/image/load_encoder.h"
#include "render/image/write_pieces.h"
#include "tools/mien/output/sha256.h"

namespace mien::command {
namespace {

struct ComposedAndPosed {
  Face composed, posed;
};

Expected<ComposedAndPosed> pose_stimulus(const Stimulus& stimulus) {
  auto composed = composed_stimulus(stimulus);
  if (!composed) return composed.error();
  auto posed = posed_stimulus(*composed, stimulus);
  if (!posed) return posed.error();
  return ComposedAndPosed{*std::move(composed), *std::move(posed)};
}

ShownStimulus told(const Stimulus& stimulus, const ComposedAndPosed& faces,
                   const std::string& hash) {
  return {stimulus, displacement(faces.posed, pose_face(faces.composed, {})), hash};
}

}  // namespace

Expected<ShownStimulus> show_stimulus(const Stimulus& stimulus, int size,
                                      const std::filesystem::path& path) {
  const auto faces = pose_stimulus(stimulus);
  if (!faces) return faces.error();
  const auto image = stimulus_picture(faces->posed, stimulus.picture, size);
  if (!image) return image.error();
  if (const auto done = write_image_by(load_encoder, *image, path, {}); !done) return done.error();
  const auto hash = sha256_of_file(path);
  if (!hash) return hash.error();
  return told(stimulus, *faces, *hash);
}

Expected<ShownStimulus> shown_before(const Stimulus& stimulus, const std::string& sha256) {
  const auto faces = pose_stimulus(stimulus);
  if (!faces) return faces.error();
  return told(stimulus, *faces, sha256);
}

}  // namespace mien::command
