// Bases of animations: read, fitted, asked, and faces that are posed by them.

#include <mien/basis.h>
#include <mien/face_model.h>
#include <mien/npy_basis.h>
#include "bind/c/door_private.h"
#include "bind/c/handles_private.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace mien::c {
namespace {

/// Of frames: 2 GiB of those that are made here; others are in the caller's memory, which has no more.
constexpr std::size_t kMostMade = std::size_t(1) << 28,
                      kMostNumbers = std::numeric_limits<std::size_t>::max() / sizeof(double);

std::size_t product(std::size_t a, std::size_t b, std::string_view argument) {
  if (b != 0 && a > kMostNumbers / b) refuse(std::string(argument), "so many numbers are none");
  return a * b;
}

std::span<const double> need_finite(const double* numbers, std::size_t count,
                                    std::string_view argument) {
  if (count > 0) need(numbers, argument);
  for (std::size_t i = 0; i < count; ++i)
    if (!std::isfinite(numbers[i]))
      refuse(fmt::format("{}[{}]", argument, i), "expected a finite number");
  return {numbers, count};
}

void need_size(std::size_t given, std::size_t wanted, std::string_view argument) {
  if (given != wanted)
    misuse(argument, fmt::format("is {}, and there are {} of them", given, wanted));
}

PcaWish wish_of(int32_t wish, double wished) {
  if (wish == MIEN_BASIS_VARIANCE) return {.variance = wished};
  if (wish == MIEN_BASIS_MAX_ERROR) return {.max_error = wished};
  if (wish != MIEN_BASIS_COUNT) misuse("wish", "is " + std::to_string(wish) + ", not 0 to 2");
  if (!(wished >= 1 && wished <= double(kMostNumbers)) || wished != std::floor(wished))
    refuse("wished", "expected a whole number of components, 1 or more");
  return {.count = std::size_t(wished)};
}

/// Fits what `file` lacks of a basis.
mien_basis* fitted(BasisFile file, std::span<const double> numbers, const PcaWish& wish,
                   const VertexGroups& groups) {
  const auto source = matrix_in_memory(numbers, file.frames, file.vertices * file.dimensions);
  file.fit = must(fit_pca(source, wish, {.vertices = groups}), MIEN_REFUSED);
  return new mien_basis{std::move(file)};
}

const std::vector<double>& numbers_of(const PcaFit& fit, int32_t which) {
  switch (which) {
    case MIEN_BASIS_MEAN:
      return fit.basis.mean;
    case MIEN_BASIS_COMPONENTS:
      return fit.basis.components;
    case MIEN_BASIS_VARIANCES:
      return fit.basis.variances;
    case MIEN_BASIS_WEIGHTS:
      return fit.weights;
    default:
      misuse("which", "is " + std::to_string(which) + ", not 0 to 3");
  }
}

}  // namespace
}  // namespace mien::c

using namespace mien::c;

extern "C" {

mien_status mien_basis_read(const char* path, size_t path_length, mien_basis** out,
                            mien_error** error) {
  return pass("mien_basis_read", error, [&] {
    mien_basis*& made = place(out);
    made = new mien_basis{must(mien::read_basis(path_of(path, path_length)), MIEN_UNREADABLE)};
  });
}

void mien_basis_free(mien_basis* basis) {
  delete basis;
}

mien_status mien_basis_of_frames(const double* frames, size_t frame_count, size_t vertices,
                                 size_t dimensions, int32_t wish, double wished, mien_basis** out,
                                 mien_error** error) {
  return pass("mien_basis_of_frames", error, [&] {
    mien_basis*& made = place(out);
    const std::size_t columns = product(vertices, dimensions, "vertices");
    const auto numbers =
        need_finite(frames, product(frame_count, columns, "frame_count"), "frames");
    if (numbers.empty()) refuse("frames", "there are none");
    mien::BasisFile file;
    file.frames = frame_count, file.vertices = vertices, file.dimensions = dimensions;
    made = fitted(std::move(file), numbers, wish_of(wish, wished),
                  mien::equal_vertices(vertices, dimensions));
  });
}

mien_status mien_basis_of_pose(const mien_pose* pose, int64_t first, size_t frame_count, double fps,
                               int32_t wish, double wished, mien_basis** out, mien_error** error) {
  return pass("mien_basis_of_pose", error, [&] {
    mien_basis*& made = place(out);
    const mien::Face& face = need(pose, "pose").face;
    if (!(fps > 0 && std::isfinite(fps))) refuse("fps", "expected a number above 0");
    if (frame_count < 1) refuse("frame_count", "is 0");
    constexpr int64_t kFarthest = 1'000'000'000;
    if (first < -kFarthest || first > kFarthest) refuse("first", "is out of range");
    if (product(frame_count, face.vector.size(), "frame_count") > kMostMade)
      refuse("frame_count", "so many frames of a face take more than 2 GiB");
    mien::BasisFile file;
    file.frames = frame_count, file.vertices = face.vector.size();
    mien::set_face(file, face);
    file.fps = fps, file.begin = double(first) / fps;
    const auto numbers = mien::frames_of_face(face, pose->pose, long(first), frame_count, fps);
    made = fitted(std::move(file), numbers, wish_of(wish, wished),
                  mien::face_vertices(face.model->layout, 1.0));
  });
}

mien_status mien_basis_about(const mien_basis* basis, mien_basis_info* out, mien_error** error) {
  return pass("mien_basis_about", error, [&] {
    const mien::BasisFile& file = need(basis, "basis").file;
    give_struct(out, mien_basis_info{0, !file.slices.empty(), file.frames, file.vertices,
                                     file.dimensions, file.fit.basis.count,
                                     file.fit.basis.total_variance, file.fps, file.begin});
  });
}

mien_status mien_basis_numbers(const mien_basis* basis, int32_t which, double* values, size_t count,
                               mien_error** error) {
  return pass("mien_basis_numbers", error, [&] {
    const std::vector<double>& numbers = numbers_of(need(basis, "basis").file.fit, which);
    need_size(count, numbers.size(), "count");
    if (count > 0) need(values, "values");
    std::copy(numbers.begin(), numbers.end(), values);
  });
}

mien_status mien_basis_decode(const mien_basis* basis, const double* weights, size_t weight_count,
                              double* values, size_t count, mien_error** error) {
  return pass("mien_basis_decode", error, [&] {
    const mien::PcaBasis& pca = need(basis, "basis").file.fit.basis;
    if (weight_count > pca.count)
      misuse("weight_count", fmt::format("is {}, of {} components", weight_count, pca.count));
    need_size(count, pca.columns, "count");
    mien::decode_pca(pca, need_finite(weights, weight_count, "weights"),
                     {&need(values, "values"), count});
  });
}

mien_status mien_basis_encode(const mien_basis* basis, const double* frames, size_t frame_count,
                              double* weights, size_t count, mien_error** error) {
  return pass("mien_basis_encode", error, [&] {
    const mien::PcaBasis& pca = need(basis, "basis").file.fit.basis;
    need_size(count, product(frame_count, pca.count, "frame_count"), "count");
    const auto numbers =
        need_finite(frames, product(frame_count, pca.columns, "frame_count"), "frames");
    if (numbers.empty()) return;
    need(weights, "weights");
    const auto found =
        must(mien::encode_pca(pca, mien::matrix_in_memory(numbers, frame_count, pca.columns)),
             MIEN_REFUSED);
    std::copy(found.begin(), found.end(), weights);
  });
}

size_t mien_basis_file_size(const mien_basis* basis) {
  size_t bytes = 0;
  pass("mien_basis_file_size", nullptr, [&] {
    must(mien::write_basis(
             [&](const void*, std::size_t size) -> mien::Expected<mien::Done> {
               bytes += size;
               return mien::Done{};
             },
             need(basis, "basis").file),
         MIEN_UNEXPECTED);
  });
  return bytes;
}

mien_status mien_basis_file(const mien_basis* basis, void* bytes, size_t count,
                            mien_error** error) {
  return pass("mien_basis_file", error, [&] {
    need_size(count, mien_basis_file_size(&need(basis, "basis")), "count");
    auto* at = static_cast<unsigned char*>(bytes);
    need(at, "bytes");
    must(mien::write_basis(
             [&](const void* from, std::size_t size) -> mien::Expected<mien::Done> {
               std::memcpy(at, from, size);
               at += size;
               return mien::Done{};
             },
             basis->file),
         MIEN_UNEXPECTED);
  });
}

mien_status mien_pose_basis(mien_pose* pose, const mien_basis* basis, const double* weights,
                            size_t weight_count, mien_error** error) {
  return pass("mien_pose_basis", error, [&] {
    need(pose, "pose");
    std::shared_ptr<const mien::FaceBasis> moves;
    std::vector<double> held;
    if (basis) {
      auto of_face = mien::face_basis(basis->file, pose->face);
      if (!of_face) refuse("basis", of_face.error().what);
      moves = std::make_shared<const mien::FaceBasis>(*std::move(of_face));
      if (weight_count > moves->basis.count)
        refuse("weights", fmt::format("the basis has {} components, not {}", moves->basis.count,
                                      weight_count));
      const auto given = need_finite(weights, weight_count, "weights");
      held.assign(given.begin(), given.end());
    }
    pose->pose.basis = std::move(moves), pose->pose.basis_weights = std::move(held);
  });
}
}
