#pragma once
// Reads and writes animations as NumPy's .npy files: [frames, vertices, dimensions] or [frames, numbers].
//
//   const auto frames = FrameFile::open("head.npy");
//   const auto fit = fit_pca(frames->source(), {.count = 7});
//
// Reading accepts float16, float32, float64, truth values and integers of 8 to 64 bits, in either byte order, C and
// Fortran order, and format versions 1 to 3, also as Python 2 wrote them. Integers beyond 2^53 become the nearest
// double. It reads in blocks, so a file may be larger than memory. Writing does what np.save does: C order, little
// endian. Source: numpy.lib.format, the format's definition.

#include <mien/api.h>
#include <mien/expected.h>
#include <mien/matrix_source.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

class PlacedReader;

enum class NpyType {
  float32,
  float64,
  uint8,
  float16,
  int8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  boolean
};

inline std::size_t bytes_of(NpyType type) {
  constexpr std::size_t kBytes[] = {4, 8, 1, 2, 1, 2, 2, 4, 4, 8, 8, 1};
  return kBytes[int(type)];
}

/// An array's type and shape, and where its numbers are in the file.
struct NpyHeader {
  NpyType type = NpyType::float64;
  bool big_endian = false;
  bool fortran = false;            ///< the first index runs fastest
  std::vector<std::size_t> shape;  ///< at most 8 dimensions
  std::size_t data = 0;            ///< offset of the first number in the file
  std::size_t numbers() const;     ///< product of the shape
  std::size_t end() const { return data + numbers() * bytes_of(type); }
};

/// Reads the header that begins at `offset` of a file of `size` bytes; `read(offset, size, to)`
/// gives bytes. The error's `where` is empty.
using ByteSource = std::function<bool(std::size_t offset, std::size_t size, void* to)>;
MIEN_API Expected<NpyHeader> read_npy_header(const ByteSource& read, std::size_t offset,
                                             std::size_t size);

/// An open file of frames.
class MIEN_API FrameFile {
 public:
  /// Errors name the file and the fault: it is no .npy file, has an unsupported type or shape, or
  /// has fewer or more bytes than its shape asks for.
  static Expected<FrameFile> open(const std::filesystem::path& path);

  std::size_t frames() const { return header_.shape[0]; }
  std::size_t vertices() const { return header_.shape[1]; }
  std::size_t dimensions() const { return header_.shape.size() == 3 ? header_.shape[2] : 1; }
  const NpyHeader& header() const { return header_; }

  /// The frames as rows, read from the file on demand. A number that is not finite is an error with
  /// its place. The source may outlive this object.
  MatrixSource source() const;

 private:
  std::shared_ptr<const PlacedReader> file_;
  std::string name_;
  NpyHeader header_;
};

/// Takes bytes, in order.
using ByteSink = std::function<Expected<Done>(const void* bytes, std::size_t size)>;

/// The header that np.save would write.
MIEN_API std::string npy_header(NpyType type, std::span<const std::size_t> shape);

/// Writes an array of that shape, of float32 or float64 (another type is an error); its numbers come from `source` row
/// by row (rows · columns of them).
MIEN_API Expected<Done> write_npy(const ByteSink& sink, NpyType type,
                                  std::span<const std::size_t> shape, const MatrixSource& source);

}  // namespace mien
