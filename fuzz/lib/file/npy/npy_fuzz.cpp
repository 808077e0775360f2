// Any bytes as NumPy's arrays: as an animation, every number of which is then read, and as a basis.

#include <mien/npy.h>
#include <mien/npy_basis.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "fuzz/support/bytes_as_file.h"
#include "fuzz/support/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mien;
  const fuzz::BytesAsFile file(data, size);
  if (const auto frames = FrameFile::open(file.path()); !frames) {
    fuzz::require_sentence(frames.error());
  } else {
    const MatrixSource source = frames->source();
    fuzz::require(source.rows * source.columns <= size / 4);
    std::vector<double> row(source.columns);
    for (std::size_t r = 0; r < source.rows; ++r) {
      if (const auto read = source.read({r, 1, 0, source.columns}, row.data()); !read) {
        fuzz::require_sentence(read.error());
        break;
      }
      for (const double number : row) fuzz::require(std::isfinite(number));
    }
  }
  if (const auto basis = read_basis(file.path()); !basis)
    fuzz::require_sentence(basis.error());
  else
    fuzz::require(basis->fit.basis.components.size() <= size);
  return 0;
}
