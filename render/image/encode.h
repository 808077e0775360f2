#pragma once
// Image to bytes of a file format, by OpenImageIO's writers.

#include <mien/image.h>

namespace mien {

class DescriptorProxy;

/// Writes the whole file through `out`. Errors and the progress' cancel come back with an empty
/// `where`.
Expected<Done> encode(const Image& image, FileType type, const WriteOptions& how,
                      DescriptorProxy& out);

}  // namespace mien
