#include <mien/npy.h>
#include "lib/base/memory_ran_out.h"

#include "lib/base/one_line.h"
#include "lib/file/json/placed_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include "lib/base/bit_cast.h"

namespace mien {
namespace {

constexpr std::size_t kMostSides = 8;
constexpr std::size_t kLongestHeader = 1 << 16;
constexpr std::string_view kMagic{"\x93NUMPY", 6};

/// The value after 'KEY': in a Python dictionary as numpy writes it, up to a comma or a bracket's
/// end.
std::optional<std::string_view> value_of(std::string_view text, std::string_view key) {
  for (const char quote : {'\'', '"'}) {
    const std::string quoted = quote + std::string(key) + quote;
    const std::size_t at = text.find(quoted);
    if (at == std::string_view::npos) continue;
    text.remove_prefix(at + quoted.size());
    const std::size_t begin = text.find_first_not_of(" :");
    if (begin == std::string_view::npos) return {};
    text.remove_prefix(begin);
    const std::size_t end = text[0] == '(' ? text.find(')') + 1 : text.find_first_of(",}");
    if (end == 0 || end == std::string_view::npos) return {};
    return text.substr(0, end);
  }
  return {};
}

std::optional<std::vector<std::size_t>> shape_of(std::string_view text) {
  std::vector<std::size_t> shape;
  if (text.size() < 2 || text.front() != '(' || text.back() != ')') return {};
  text = text.substr(1, text.size() - 2);
  while (text.find_first_not_of(" ,") != std::string_view::npos) {
    text.remove_prefix(text.find_first_not_of(" ,"));
    std::size_t side = 0;
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), side);
    if (failed != std::errc{} || shape.size() == kMostSides) return {};
    shape.push_back(side);
    text.remove_prefix(std::size_t(end - text.data()));
    if (text.starts_with('L')) text.remove_prefix(1);  // Python 2's long numbers: (9L, 10L)
  }
  return shape;
}

/// As NumPy names them, without the byte order; by NpyType.
constexpr std::string_view kKinds[] = {"f4", "f8", "u1", "f2", "i1", "i2",
                                       "u2", "i4", "u4", "i8", "u8", "b1"};

std::string wrong_type(std::string_view type) {
  const bool longer = type.size() > 2 && type.substr(1) == "f16";
  return fmt::format(
      "expected reals or integers ('<f2' to '<f8', '<i1' to '<u8'), got the type {}{}",
      in_quotes(type), longer ? "; .astype('f8') makes it one of them" : "");
}

Expected<Done> read_type(std::string_view text, NpyHeader& header) {
  if (text.size() >= 2) text = text.substr(1, text.size() - 2);  // the quotes
  const std::string_view order = text.substr(0, 1), kind = text.substr(order.size());
  const auto* known = std::find(std::begin(kKinds), std::end(kKinds), kind);
  if (known == std::end(kKinds) || std::string_view("<>|=").find(order) == std::string_view::npos)
    return Error{"", wrong_type(text)};
  header.type = NpyType(known - kKinds);
  header.big_endian = order == ">";
  return Done{};
}

/// The size of the array in bytes; nothing if no file can be that large.
std::optional<std::size_t> bytes_needed(const NpyHeader& header) {
  std::size_t bytes = bytes_of(header.type);
  for (const std::size_t side : header.shape)
    if (__builtin_mul_overflow(bytes, side, &bytes)) return {};
  return bytes <= std::numeric_limits<std::size_t>::max() / 4 ? std::optional{bytes} : std::nullopt;
}

template <class Bits>
Bits swapped(Bits bits) {
  if constexpr (sizeof(Bits) == 1)
    return bits;
  else if constexpr (sizeof(Bits) == 2)
    return __builtin_bswap16(bits);
  else if constexpr (sizeof(Bits) == 4)
    return __builtin_bswap32(bits);
  else
    return __builtin_bswap64(bits);
}

/// IEEE 754's binary16: one bit of sign, five of exponent, ten of fraction.
double from_half(std::uint16_t bits) {
  const int exponent = bits >> 10 & 31, fraction = bits & 1023;
  const double size = exponent == 31  ? (fraction ? NAN : INFINITY)
                      : exponent == 0 ? std::ldexp(fraction, -24)
                                      : std::ldexp(1024 + fraction, exponent - 25);
  return bits & 0x8000 ? -size : size;
}

/// The number that so many bits mean.
template <class Number, class Bits>
double meant(Bits bits) {
  return double(mien::bit_cast<Number>(bits));
}

double is_set(std::uint8_t bits) {
  return bits != 0;
}

/// Where numbers go: every `step`th place from `to` on.
struct Doubles {
  double* to;
  std::size_t count, step;
};

template <class Bits>
void to_doubles(const std::byte* bytes, const Doubles& out, bool swap, double (*meaning)(Bits)) {
  for (std::size_t i = 0; i < out.count; ++i, bytes += sizeof(Bits)) {
    Bits bits;
    std::memcpy(&bits, bytes, sizeof bits);
    out.to[i * out.step] = meaning(swap ? swapped(bits) : bits);
  }
}

void convert(const NpyHeader& header, const std::byte* bytes, const Doubles& out) {
  const bool swap = header.big_endian != (std::endian::native == std::endian::big);
  switch (header.type) {
    case NpyType::float16:
      return to_doubles(bytes, out, swap, from_half);
    case NpyType::float32:
      return to_doubles(bytes, out, swap, meant<float, std::uint32_t>);
    case NpyType::float64:
      return to_doubles(bytes, out, swap, meant<double, std::uint64_t>);
    case NpyType::boolean:
      return to_doubles(bytes, out, swap, is_set);
    case NpyType::int8:
      return to_doubles(bytes, out, swap, meant<std::int8_t, std::uint8_t>);
    case NpyType::uint8:
      return to_doubles(bytes, out, swap, meant<std::uint8_t, std::uint8_t>);
    case NpyType::int16:
      return to_doubles(bytes, out, swap, meant<std::int16_t, std::uint16_t>);
    case NpyType::uint16:
      return to_doubles(bytes, out, swap, meant<std::uint16_t, std::uint16_t>);
    case NpyType::int32:
      return to_doubles(bytes, out, swap, meant<std::int32_t, std::uint32_t>);
    case NpyType::uint32:
      return to_doubles(bytes, out, swap, meant<std::uint32_t, std::uint32_t>);
    case NpyType::int64:
      return to_doubles(bytes, out, swap, meant<std::int64_t, std::uint64_t>);
    case NpyType::uint64:
      return to_doubles(bytes, out, swap, meant<std::uint64_t, std::uint64_t>);
  }
}

}  // namespace

std::size_t NpyHeader::numbers() const {
  std::size_t product = 1;
  for (const std::size_t side : shape) product *= side;
  return product;
}

Expected<NpyHeader> read_npy_header(const ByteSource& read, std::size_t offset,
                                    std::size_t size) try {
  Error no_file{"", "is not a .npy file"};
  unsigned char begin[12] = {};
  if (size < offset + 10 || !read(offset, 10, begin) ||
      std::string_view(reinterpret_cast<char*>(begin), 6) != kMagic) {
    if (std::string_view(reinterpret_cast<char*>(begin), 4) == std::string_view("PK\3\4", 4))
      no_file.what +=
          "; it looks like an .npz, an archive of them: np.save('a.npy', np.load(FILE)[NAME]) "
          "makes a .npy of one";
    return no_file;
  }
  if (begin[6] < 1 || begin[6] > 3)
    return Error{
        "", fmt::format("has .npy format version {}.{}; known are 1 to 3", begin[6], begin[7])};
  const std::size_t prefix = begin[6] == 1 ? 10 : 12;
  if (prefix == 12 && (size < offset + 12 || !read(offset, 12, begin))) return no_file;
  const std::size_t length = prefix == 10
                                 ? std::size_t(begin[8] | begin[9] << 8)
                                 : begin[8] | std::size_t(begin[9]) << 8 |
                                       std::size_t(begin[10]) << 16 | std::size_t(begin[11]) << 24;
  if (length > kLongestHeader || size < offset + prefix + length)
    return Error{"", "ends inside its header"};
  std::string text(length, '\0');
  if (!read(offset + prefix, length, text.data())) return Error{"", "ends inside its header"};
  const auto type = value_of(text, "descr"), order = value_of(text, "fortran_order"),
             shape_text = value_of(text, "shape");
  const auto shape = shape_text ? shape_of(*shape_text) : std::nullopt;
  if (!type || !order || !shape)
    return Error{"", fmt::format("has a header that is none: {}", in_quotes(text))};
  NpyHeader header{
      .fortran = order->starts_with("True"), .shape = *shape, .data = offset + prefix + length};
  if (auto known = read_type(*type, header); !known) return known.error();
  const auto bytes = bytes_needed(header);
  if (!bytes) return Error{"", fmt::format("has an impossible shape {}", in_quotes(*shape_text))};
  if (*bytes > size - header.data)
    return Error{"", fmt::format("is cut off: its shape {} takes {} bytes, and {} are there",
                                 *shape_text, *bytes, size - header.data)};
  return header;
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

Expected<FrameFile> FrameFile::open(const std::filesystem::path& path) try {
  auto opened = PlacedReader::open(path);
  if (!opened) return opened.error();
  const auto file = std::make_shared<const PlacedReader>(*std::move(opened));
  FrameFile frames;
  frames.name_ = file->name();
  std::optional<Error> unread;
  const auto read = [&](std::size_t at, std::size_t bytes, void* to) {
    if (auto done = file->read(at, bytes, to); !done) unread = done.error();
    return !unread;
  };
  const auto header = read_npy_header(read, 0, file->size());
  if (unread) return *unread;
  if (!header) return Error{frames.name_, header.error().what};
  frames.header_ = *header;
  const std::vector<std::size_t>& shape = frames.header_.shape;
  if ((shape.size() != 2 && shape.size() != 3) || frames.header_.numbers() == 0)
    return Error{frames.name_,
                 fmt::format("expected the shape [frames, vertices, dimensions] or [frames, "
                             "numbers] with nothing 0, got [{}]",
                             fmt::join(shape, ", "))};
  if (file->size() > frames.header_.end())
    return Error{frames.name_, fmt::format("has {} bytes more than its shape takes",
                                           file->size() - frames.header_.end())};
  frames.file_ = file;
  return frames;
} catch (const std::bad_alloc&) {
  return memory_ran_out(path.native());
}

MatrixSource FrameFile::source() const {
  const std::size_t rows = frames(), columns = vertices() * dimensions();
  const auto read = [file = file_, name = name_, header = header_, rows, columns, v = vertices(),
                     d = dimensions()](const MatrixBlock& block, double* out) -> Expected<Done> {
    const std::size_t size = bytes_of(header.type);
    std::vector<std::byte> bytes;
    // A run is contiguous in the file: numbers of one frame or, in Fortran order, one number of many
    // frames.
    const auto run = [&](std::size_t first, std::size_t count, double* to,
                         std::size_t step) -> Expected<Done> {
      bytes.resize(count * size);
      auto done = file->read(header.data + first * size, bytes.size(), bytes.data());
      if (done) convert(header, bytes.data(), {to, count, step});
      return done;
    };
    Expected<Done> whole = Done{};
    if (header.fortran) {
      for (std::size_t c = 0; c < block.columns && whole; ++c) {
        const std::size_t column = block.column + c, place = column / d + v * (column % d);
        whole = run(block.row + rows * place, block.rows, out + c, block.columns);
      }
    } else if (block.columns == columns) {
      whole = run(block.row * columns, block.rows * columns, out, 1);
    } else {
      for (std::size_t r = 0; r < block.rows && whole; ++r)
        whole = run((block.row + r) * columns + block.column, block.columns,
                    out + r * block.columns, 1);
    }
    if (!whole) return whole;
    for (std::size_t i = 0; i < block.rows * block.columns; ++i)
      if (!std::isfinite(out[i])) {
        const std::size_t column = block.column + i % block.columns;
        return Error{name, fmt::format("frame {}, vertex {}: {} is not a finite number",
                                       block.row + i / block.columns, column / d, out[i])};
      }
    return Done{};
  };
  return {rows, columns, read};
}

std::string npy_header(NpyType type, std::span<const std::size_t> shape) {
  std::string text = fmt::format("{{'descr': '{}{}', 'fortran_order': False, 'shape': ({}{}), }}",
                                 bytes_of(type) == 1 ? '|' : '<', kKinds[int(type)],
                                 fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
  while ((text.size() + 11) % 64 != 0) text += ' ';  // numbers begin at a multiple of 64
  text += '\n';
  std::string header(kMagic);
  header += '\1';
  header += '\0';
  header += char(text.size() & 0xff);
  header += char(text.size() >> 8);
  return header + text;
}

Expected<Done> write_npy(const ByteSink& sink, NpyType type, std::span<const std::size_t> shape,
                         const MatrixSource& source) try {
  static_assert(std::endian::native == std::endian::little, "numbers are written as they lie");
  if (type != NpyType::float32 && type != NpyType::float64)
    return Error{"", "arrays are written as float32 or float64"};
  const std::string header = npy_header(type, shape);
  if (auto done = sink(header.data(), header.size()); !done) return done;
  const std::size_t step =
      std::max<std::size_t>((1 << 20) / std::max<std::size_t>(source.columns, 1), 1);
  std::vector<double> numbers;
  std::vector<float> rounded;
  for (std::size_t r = 0; r < source.rows; r += step) {
    const std::size_t rows = std::min(step, source.rows - r);
    numbers.resize(rows * source.columns);
    if (auto done = source.read({r, rows, 0, source.columns}, numbers.data()); !done) return done;
    if (type == NpyType::float32) rounded.assign(numbers.begin(), numbers.end());
    const auto done = type == NpyType::float32 ? sink(rounded.data(), rounded.size() * 4)
                                               : sink(numbers.data(), numbers.size() * 8);
    if (!done) return done;
  }
  return Done{};
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

}  // namespace mien
