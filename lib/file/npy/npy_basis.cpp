#include <mien/npy_basis.h>

#include <mien/face_model.h>
#include "lib/base/one_line.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <system_error>

namespace mien {
namespace {

using Json = nlohmann::json;

constexpr char kFormat[] = "mien-basis";

std::string info_text(const BasisFile& file) {
  Json curve = Json::array();
  for (const PcaError& e : file.fit.curve)
    curve.push_back({{"count", e.count},
                     {"variance", e.variance},
                     {"rms", e.rms},
                     {"max", e.max},
                     {"frame", e.frame},
                     {"vertex", e.vertex}});
  Json info{{"format", kFormat},
            {"format_version", 1},
            {"frames", file.frames},
            {"vertices", file.vertices},
            {"dimensions", file.dimensions},
            {"total_variance", file.fit.basis.total_variance},
            {"curve", std::move(curve)}};
  if (!file.slices.empty()) {
    info["face"] = file.face;
    info["slices"] = file.slices;
    info["fps"] = file.fps;
    info["begin"] = file.begin;
  }
  return info.dump(-1, ' ', true, Json::error_handler_t::replace);
}

Expected<Done> put(const ByteSink& sink, NpyType type, std::vector<std::size_t> shape,
                   const std::vector<double>& numbers, std::size_t rows) {
  const std::size_t columns = rows ? numbers.size() / rows : 0;
  return write_npy(sink, type, shape, matrix_in_memory(numbers, rows, columns));
}

/// Arrays of an open file, one after the other.
class Arrays {
 public:
  Arrays(std::ifstream& in, std::size_t size) : in_(in), size_(size) {}

  Expected<NpyHeader> next() {
    const auto read = [&](std::size_t at, std::size_t bytes, void* to) {
      in_.clear();
      in_.seekg(std::streamoff(at));
      in_.read(static_cast<char*>(to), std::streamsize(bytes));
      return bool(in_);
    };
    auto header = read_npy_header(read, at_, size_);
    if (header) at_ = header->end();
    return header;
  }
  bool finished() const { return at_ == size_; }

  /// The numbers of a float array.
  std::vector<double> numbers(const NpyHeader& header) {
    std::vector<double> all(header.numbers());
    in_.clear();
    in_.seekg(std::streamoff(header.data));
    constexpr std::size_t kStep = 1 << 18;
    std::vector<float> part;
    for (std::size_t i = 0; i < all.size(); i += kStep) {
      const std::size_t count = std::min(kStep, all.size() - i);
      if (header.type == NpyType::float64) {
        in_.read(reinterpret_cast<char*>(&all[i]), std::streamsize(count * 8));
      } else {
        part.resize(count);
        in_.read(reinterpret_cast<char*>(part.data()), std::streamsize(count * 4));
        std::copy(part.begin(), part.end(), all.begin() + std::ptrdiff_t(i));
      }
    }
    return all;
  }

  std::string text(const NpyHeader& header) {
    std::string text(header.numbers(), '\0');
    in_.clear();
    in_.seekg(std::streamoff(header.data));
    in_.read(text.data(), std::streamsize(text.size()));
    return text;
  }

 private:
  std::ifstream& in_;
  std::size_t size_, at_ = 0;
};

void read_info(const Json& info, BasisFile& file) {
  file.frames = info.at("frames").get<std::size_t>();
  file.vertices = info.at("vertices").get<std::size_t>();
  file.dimensions = info.at("dimensions").get<std::size_t>();
  file.fit.basis.total_variance = info.at("total_variance").get<double>();
  for (const Json& e : info.at("curve"))
    file.fit.curve.push_back({e.at("count").get<std::size_t>(), e.at("variance").get<double>(),
                              e.at("rms").get<double>(), e.at("max").get<double>(),
                              e.at("frame").get<std::size_t>(), e.at("vertex").get<std::size_t>()});
  if (!info.contains("slices")) return;
  file.face = info.at("face").get<std::string>();
  file.slices = info.at("slices").get<std::vector<std::pair<std::string, int>>>();
  file.fps = info.at("fps").get<double>();
  file.begin = info.at("begin").get<double>();
  if (!(file.fps > 0)) throw std::runtime_error("fps is not positive");
}

bool all_finite(const std::vector<double>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); });
}

/// Reads what info promises; throws a sentence.
void read_arrays(Arrays& arrays, BasisFile& file) {
  const auto next = [&](std::vector<std::size_t> shape, const char* what, bool info = false) {
    const auto header = arrays.next();
    if (!header) throw std::runtime_error(header.error().what);
    if ((!info && (header->shape != shape || header->type == NpyType::uint8)) || header->fortran ||
        header->big_endian)
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

Expected<Done> write_basis(const ByteSink& sink, const BasisFile& file) {
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
}

Expected<BasisFile> read_basis(const std::filesystem::path& path) {
  const std::string name = one_line(path.string());
  try {
    std::error_code failed;
    const auto size = std::filesystem::file_size(path, failed);
    if (failed) return Error{name, fmt::format("cannot be read: {}", failed.message())};
    std::ifstream in(path, std::ios::binary);
    if (!in) return Error{name, fmt::format("cannot be read: {}", std::strerror(errno))};
    Arrays arrays(in, std::size_t(size));
    const auto header = arrays.next();
    const Json info = header && header->type == NpyType::uint8
                          ? Json::parse(arrays.text(*header), nullptr, false)
                          : Json();
    if (!info.is_object() || info.value("format", "") != kFormat)
      return Error{name, "is not a basis: `mien pca fit` makes one"};
    if (info.value("format_version", 0) != 1)
      return Error{name, "has a format version that this program does not know; it reads 1"};
    BasisFile file;
    read_info(info, file);
    read_arrays(arrays, file);
    return file;
  } catch (const std::bad_alloc&) {
    return Error{name, "not enough memory to read it"};
  } catch (const std::exception& e) {
    return Error{name, fmt::format("is a damaged basis: {}", one_line(e.what()))};
  }
}

void set_face(BasisFile& file, const Face& face) {
  file.face = face.model->name;
  file.slices.clear();
  for (const Slice& slice : face.model->layout.slices())
    file.slices.emplace_back(slice.name, slice.size);
}

Expected<FaceBasis> face_basis(const BasisFile& file, const Face& face) {
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
}

}  // namespace mien
