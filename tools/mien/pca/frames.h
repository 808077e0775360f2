#pragma once
// The frames that `mien pca` works on, from a NumPy file or from a posed face.

#include <mien/face.h>
#include <mien/npy.h>
#include <mien/pca.h>
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/cli/pca_arguments.h"

#include <memory>
#include <optional>
#include <vector>

namespace mien::command {

struct PcaFrames {
  std::size_t vertices = 0, dimensions = 1;
  bool single = false;
  VertexGroups groups;
  std::optional<Face> face;  ///< whose frames they are
  FrameRange range;
  double fps = 30;
  MatrixSource source;

  std::shared_ptr<std::vector<double>> rows;  ///< of a face's frames: what `source` reads
};

/// Reads the frames, and --frames, --fps, --set and --size. Errors are printed and give an exit code.
struct PcaFramesOrCode {
  std::optional<PcaFrames> frames;
  int code;
};
PcaFramesOrCode read_pca_frames(const PcaArguments& arguments);

}  // namespace mien::command
