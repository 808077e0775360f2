#include <mien/npy_basis.h>
#include "lib/base/memory_ran_out.h"

#include <mien/face_model.h>
#include "lib/base/one_line.h"
#include "lib/file/json/json_text.h"
#include "lib/file/json/placed_reader.h"
#include "lib/file/json/reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mien {
namespace {

constexpr char kFormat[] = "mien-basis";

std::string info_text(const BasisFile& file) {
  std::string curve, slices;
  for (const PcaError& e : file.fit.curve)
    curve += fmt::format(
        R"({}{{"count": {}, "variance": {}, "rms": {}, "max": {}, "frame": {}, "vertex": {}}})",
        curve.empty() ? "" : ", ", e.count, json_number(e.variance), json_number(e.rms),
        json_number(e.max), e.frame, e.vertex);
  for (const auto& [name, size] : file.slices)
    slices += fmt::format("{}[{}, {}]", slices.empty() ? "" : ", ", json_string(name), size);
  std::string info = fmt::format(
      R"({{"format": "{}", "format_version": 1, "frames": {}, "vertices": {}, "dimensions": {}, )"
      R"("total_variance": {}, "curve": [{}])",
      kFormat, file.frames, file.vertices, file.dimensions,
      json_number(file.fit.basis.total_variance), curve);
  if (!file.slices.empty())
    info +=
        fmt::format(R"(, "face": {}, "slices": [{}], "fps": {}, "begin": {})",
                    json_string(file.face), slices, json_number(file.fps), json_number(file.begin));
  return info + "}";
}

Expected<Done> put(const ByteSink& sink, NpyType type, std::vector<std::size_t> shape,
                   const std::vector<double>& numbers, std::size_t rows) {
  const std::size_t columns = rows ? numbers.size() / rows : 0;
  return write_npy(sink, type, shape, matrix_in_memory(numbers, rows, columns));
}

/// Thrown where a file cannot be read, which is no fault of what is in it.
struct Unread {
  Error error;
};

/// Arrays of an open file, one after the other. What cannot be read is thrown.
class Arrays {
 public:
  explicit Arrays(const PlacedReader& file) : file_(file) {}

  Expected<NpyHeader> next() {
    const auto read = [&](std::size_t at, std::size_t bytes, void* to) {
      need(at, bytes, to);
      return true;
    };
    auto header = read_npy_header(read, at_, file_.size());
    if (header) at_ = header->end();
    return header;
  }
  bool finished() const { return at_ == file_.size(); }

  /// The numbers of a float array.
  std::vector<double> numbers(const NpyHeader& header) const {
    std::vector<double> all(header.numbers());
    if (header.type == NpyType::float64) {
      need(header.data, all.size() * 8, all.data());
      return all;
    }
    constexpr std::size_t kStep = 1 << 18;
    std::vector<float> part;
    for (std::size_t i = 0; i < all.size(); i += kStep) {
      part.resize(std::min(kStep, all.size() - i));
      need(header.data + i * 4, part.size() * 4, part.data());
      std::copy(part.begin(), part.end(), all.begin() + std::ptrdiff_t(i));
    }
    return all;
  }

  std::string text(const NpyHeader& header) const {
    std::string text(header.numbers(), '\0');
    need(header.data, text.size(), text.data());
    return text;
  }

 private:
  void need(std::size_t at, std::size_t bytes, void* to) const {
    if (auto done = file_.read(at, bytes, to); !done) throw Unread{done.error()};
  }

  const PlacedReader& file_;
  std::size_t at_ = 0;
};

std::size_t count_of(const Reading& in, const JsonNode& node) {
  const double number = in.number(node);
  if (!(number >= 0 && number <= 0x1p53 && number == std::floor(number)))
    in.refuse(node, "expected a count");
  return std::size_t(number);
}

/// Reads what info_text writes; throws a Refusal for anything else.
void read_info(const Reading& in, const JsonNode& info, BasisFile& file) {
  const auto count = [&](const JsonNode& of, const char* key) {
    return count_of(in, in.need(of, key));
  };
  const auto number = [&](const JsonNode& of, const char* key) {
    return in.number(in.need(of, key));
  };
  file.frames = count(info, "frames");
  file.vertices = count(info, "vertices");
  file.dimensions = count(info, "dimensions");
  file.fit.basis.total_variance = number(info, "total_variance");
  const JsonNode& curve = in.need(info, "curve");
  in.expect(curve, JsonKind::array);
  in.for_each(curve, [&](const JsonNode& e, int) {
    file.fit.curve.push_back({count(e, "count"), number(e, "variance"), number(e, "rms"),
                              number(e, "max"), count(e, "frame"), count(e, "vertex")});
  });
  const JsonNode* slices = in.find(info, "slices");
  if (!slices) return;
  in.expect(*slices, JsonKind::array);
  file.face = in.string(in.need(info, "face"));
  in.for_each(*slices, [&](const JsonNode& slice, int) {
    in.expect(slice, JsonKind::array);
    const JsonNode* name = in.tree.first(slice);
    const JsonNode* size = name ? in.tree.next(*name) : nullptr;
    if (!size) in.refuse(slice, "expected a name and a size");
    file.slices.emplace_back(in.string(*name),
                             int(std::min<std::size_t>(count_of(in, *size), 1u << 30)));
  });
  file.fps = number(info, "fps");
  file.begin = number(info, "begin");
  if (!(file.fps > 0)) in.refuse(in.need(info, "fps"), "is not positive");
}

bool all_finite(const std::vector<double>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); });
}

/// Reads the arrays that info announces; throws a std::runtime_error with a sentence.
void read_arrays(Arrays& arrays, BasisFile& file) {
  const auto next = [&](std::vector<std::size_t> shape, const char* what, bool info = false) {
    const auto header = arrays.next();
    if (!header) throw std::runtime_error(header.error().what);
    const bool reals = header->type == NpyType::float32 || header->type == NpyType::float64;
    if ((!info && (header->shape != shape || !reals)) || header->fortran || header->big_endian)
      throw std::runtime_error(fmt::format("its {} have the shape [{}], not [{}]", what,
                                           fmt::join(header->shape, ", "), fmt::join(shape, ", ")));
    return *header;
  };
  PcaBasis& basis = file.fit.basis;
  const std::size_t v = file.vertices, d = file.dimensions;
  const NpyHeader mean = next({v, d}, "mean's numbers");
  file.single = mean.type == NpyType::float32;
  basis.columns = v * d;
  basis.mean = arrays.numbers(mean);
  basis.count = file.fit.curve.empty() ? 0 : file.fit.curve.back().count;
  basis.components = arrays.numbers(next({basis.count, v, d}, "components"));
  basis.variances = arrays.numbers(next({basis.count}, "variances"));
  file.fit.weights = arrays.numbers(next({file.frames, basis.count}, "weights"));
  if (!arrays.finished()) throw std::runtime_error("it has more than five arrays");
  if (!all_finite(basis.mean) || !all_finite(basis.components) || !all_finite(file.fit.weights))
    throw std::runtime_error("it has numbers that are not finite");
}

}  // namespace

Expected<Done> write_basis(const ByteSink& sink, const BasisFile& file) try {
  const std::string info = info_text(file);
  const std::size_t length[] = {info.size()};
  const std::string header = npy_header(NpyType::uint8, length);
  if (auto done = sink(header.data(), header.size()); !done) return done;
  if (auto done = sink(info.data(), info.size()); !done) return done;
  const PcaBasis& basis = file.fit.basis;
  const std::size_t v = file.vertices, d = file.dimensions, n = basis.count;
  const NpyType type = file.single ? NpyType::float32 : NpyType::float64;
  if (auto done = put(sink, type, {v, d}, basis.mean, 1); !done) return done;
  if (auto done = put(sink, type, {n, v, d}, basis.components, n); !done) return done;
  if (auto done = put(sink, NpyType::float64, {n}, basis.variances, 1); !done) return done;
  return put(sink, type, {file.frames, n}, file.fit.weights, file.frames);
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

Expected<BasisFile> read_basis(const std::filesystem::path& path) try {
  const std::string name = one_line(path.string());
  try {
    const auto opened = PlacedReader::open(path);
    if (!opened) return opened.error();
    Arrays arrays(*opened);
    const auto header = arrays.next();
    const std::string text =
        header && header->type == NpyType::uint8 ? arrays.text(*header) : std::string();
    FaceLimits limits;
    limits.magnitude = std::numeric_limits<double>::max();
    const auto tree = JsonTree::read(text, "info", limits);
    if (!tree || tree->root().kind != JsonKind::object)
      return Error{name, "is not a basis: `mien pca fit` makes one"};
    const Reading info(*tree, limits, nullptr);
    const JsonNode* format = info.find(tree->root(), "format");
    if (!format || info.string(*format) != kFormat)
      return Error{name, "is not a basis: `mien pca fit` makes one"};
    if (info.number(info.need(tree->root(), "format_version")) != 1)
      return Error{name, "has a format version that this program does not know; it reads 1"};
    BasisFile file;
    read_info(info, tree->root(), file);
    read_arrays(arrays, file);
    return file;
  } catch (const std::bad_alloc&) {
    return memory_ran_out(name);
  } catch (const Unread& unread) {
    return unread.error;
  } catch (const Refusal& refusal) {
    return Error{name, fmt::format("is a damaged basis: {}", sentence(refusal.error))};
  } catch (const std::exception& e) {
    return Error{name, fmt::format("is a damaged basis: {}", one_line(e.what()))};
  }
} catch (const std::bad_alloc&) {
  return memory_ran_out(path.native());
}

void set_face(BasisFile& file, const Face& face) {
  file.face = face.model->name;
  file.slices.clear();
  for (const Slice& slice : face.model->layout.slices())
    file.slices.emplace_back(slice.name, slice.size);
}

Expected<FaceBasis> face_basis(const BasisFile& file, const Face& face) try {
  if (file.slices.empty()) return Error{"", "the basis is of vertices, not of a face"};
  const std::vector<Slice>& slices = face.model->layout.slices();
  for (std::size_t i = 0; i < std::max(slices.size(), file.slices.size()); ++i) {
    if (i < slices.size() && i < file.slices.size() && slices[i].name == file.slices[i].first &&
        slices[i].size == file.slices[i].second)
      continue;
    return Error{
        "", fmt::format("the basis is of the face {}, whose numbers are others: it has {}, this "
                        "face {}",
                        in_quotes(file.face),
                        i < file.slices.size() ? in_quotes(file.slices[i].first) : "no more",
                        i < slices.size() ? in_quotes(slices[i].name) : "no more")};
  }
  if (file.fit.basis.columns != face.vector.size())
    return Error{"", "the basis has another number of numbers than the face"};
  return FaceBasis{file.fit.basis, file.fit.weights, file.fps, file.begin};
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

}  // namespace mien
