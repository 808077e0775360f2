#pragma once
// What a file format's writer is: it chooses how the picture is cut, prepares pieces on any
// thread, and puts them into the file in order.

#include <mien/view.h>
#include <mien/write.h>
#include "render/image/file/file_output.h"
#include "render/image/file_type.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace mien {

/// A piece made ready: bytes as the encoder likes them, kept for the next piece to use again.
struct PreparedPiece {
  std::vector<std::byte> bytes;
  std::vector<std::size_t> ends;      ///< of parts in it, where it has any
  std::vector<std::uint32_t> tokens;  ///< in their stead, of bytes that are packed in order
  std::uint64_t note[2] = {};         ///< what else there is to say
};

/// Whether to stop; asked every few milliseconds of work.
using AskStop = std::function<bool()>;

class PictureEncoder {
 public:
  virtual ~PictureEncoder() = default;

  /// How many pieces may be held at once: as many as the budget said, or fewer.
  virtual int slots() const = 0;
  /// The pieces in file order; together they are the picture.
  virtual int pieces() const = 0;
  virtual PixelRect piece(int i) const = 0;

  /// On any thread, several pieces at once, each in a slot of its own. `pixels` are the piece's, in
  /// the frame's depth. What it leaves when it stops is not put.
  virtual void prepare(int i, int slot, const PixelBuffer& pixels, PreparedPiece& to,
                       const AskStop& stop) = 0;

  /// In order, one at a time. The error's `where` is left empty.
  virtual Expected<Done> put(int i, const PreparedPiece& piece) = 0;
  /// After the last piece: nothing is left to be written when it comes back.
  virtual Expected<Done> finish() = 0;
};

/// How much may be held at once.
struct PieceBudget {
  int slots = 1;            ///< pieces, at most
  std::uint64_t bytes = 0;  ///< all of them together, with their pixels
};

/// As many slots of so many bytes each, beside the `fixed` bytes, as the budget allows; 0 if not one.
int slots_within(const PieceBudget& budget, std::uint64_t fixed, std::uint64_t each);

/// All that an encoder is made of.
struct EncoderRequest {
  PictureFrame frame;
  FileType type;
  const WriteOptions& how;
  PieceBudget budget;
  FileOutput& out;
};

using MadeEncoder = Expected<std::unique_ptr<PictureEncoder>>;
using MakeEncoder = std::function<MadeEncoder(const EncoderRequest&)>;

/// "needs at least 3 MiB of memory, more than the 2 MiB allowed".
Error too_little_memory(std::uint64_t needed, std::uint64_t allowed);

}  // namespace mien
