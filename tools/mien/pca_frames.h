#pragma once
// The frames that `mien pca` works on: of a file of NumPy's, or of a face.

#include <mien/lib/face/face.h>
#include <mien/lib/file/npy.h>
#include <mien/lib/math/pca.h>
#include <mien/tools/mien/motion_values.h>
#include <mien/tools/mien/pca_arguments.h>

#include <memory>
#include <optional>
#include <vector>

namespace mien::command {

struct PcaFrames {
  std::size_t vertices = 0, dimensions = 1;
  bool single = false;
  VertexGroups groups;
  std::optional<Face> face;  ///< of which they are
  FrameRange range;
  double fps = 30;
  MatrixSource source;

  std::shared_ptr<std::vector<double>> rows;  ///< of a face: what `source` reads
};

/// Reads what --frames, --fps, --set and --size say as well. Errors are told and give an exit code.
struct PcaFramesOrCode {
  std::optional<PcaFrames> frames;
  int code;
};
PcaFramesOrCode read_pca_frames(const PcaArguments& arguments);

}  // namespace mien::command
