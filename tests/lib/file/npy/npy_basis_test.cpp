// Items P1, P2, P7: a basis as a file, and as what a face is posed by.

#include <gtest/gtest.h>

#include <mien/face_file.h>
#include <mien/face_model.h>
#include <mien/npy_basis.h>
#include <mien/pose.h>

#include "tests/support/faces/face_path.h"
#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

using test::ScratchFolder;

Face toon() {
  auto face = read_face(test::face_path("toon"));
  EXPECT_TRUE(face);
  return *face;
}

BasisFile basis_of_clip(const Face& face, std::size_t frames, std::size_t count) {
  const std::vector<double> rows = frames_of_face(face, {}, 0, frames, 30);
  auto fit = fit_pca(matrix_in_memory(rows, frames, face.vector.size()), {.count = count},
                     {.vertices = face_vertices(face.model->layout, 1)});
  EXPECT_TRUE(fit);
  BasisFile file{*fit, frames, face.vector.size(), 1, false};
  set_face(file, face);
  file.fps = 30;
  return file;
}

std::string written(const BasisFile& file) {
  std::string bytes;
  EXPECT_TRUE(write_basis(
      [&](const void* from, std::size_t size) -> Expected<Done> {
        bytes.append(static_cast<const char*>(from), size);
        return Done{};
      },
      file));
  return bytes;
}

TEST(NpyBasis, ReadsBackWhatWasWritten) {
  const ScratchFolder folder;
  const BasisFile file = basis_of_clip(toon(), 40, 3);
  test::write_text(folder / "a.basis", written(file));
  const auto back = read_basis(folder / "a.basis");
  ASSERT_TRUE(back) << sentence(back.error());
  EXPECT_EQ(back->fit.basis.mean, file.fit.basis.mean);
  EXPECT_EQ(back->fit.basis.components, file.fit.basis.components);
  EXPECT_EQ(back->fit.basis.variances, file.fit.basis.variances);
  EXPECT_EQ(back->fit.weights, file.fit.weights);
  EXPECT_EQ(back->slices, file.slices);
  EXPECT_EQ(back->fit.curve.size(), file.fit.curve.size());
  EXPECT_EQ(back->fit.curve.back().max, file.fit.curve.back().max);
  // P2
  const std::size_t n = toon().vector.size();
  EXPECT_EQ(back->bytes_before(), 40 * n * 8);
  EXPECT_EQ(back->bytes_after(), (4 * n + 40 * 3) * 8);
}

TEST(NpyBasis, DamagedFilesAreRefused) {
  const ScratchFolder folder;
  const std::string good = written(basis_of_clip(toon(), 10, 2));
  for (const std::size_t size :
       {std::size_t(0), std::size_t(40), std::size_t(300), good.size() / 2, good.size() - 1}) {
    test::write_text(folder / "a.basis", good.substr(0, size));
    const auto back = read_basis(folder / "a.basis");
    ASSERT_FALSE(back) << size;
    EXPECT_NE(back.error().what.find(' '), std::string::npos) << back.error().what;
    EXPECT_EQ(back.error().what.find('\n'), std::string::npos) << back.error().what;
  }
  test::write_text(folder / "a.basis", good + "x");
  EXPECT_FALSE(read_basis(folder / "a.basis"));
  test::write_text(folder / "a.basis", "{}");
  EXPECT_EQ(read_basis(folder / "a.basis").error().what,
            "is not a basis: `mien pca fit` makes one");
}

// P7: decoded at pose time, the face is the one of the clip; beyond the rank exactly enough.
TEST(NpyBasis, AFacePosedByItsBasisIsTheClip) {
  const Face face = toon();
  const BasisFile file = basis_of_clip(face, 120, 8);
  const auto basis = face_basis(file, face);
  ASSERT_TRUE(basis);
  const auto shared = std::make_shared<const FaceBasis>(*basis);
  const double bound = file.fit.curve.back().max;
  const VertexGroups vertices = face_vertices(face.model->layout, 1);
  for (const int frame : {0, 57, 60, 119}) {
    Pose plain{.time = frame / 30.0}, by_basis{.time = frame / 30.0};
    by_basis.basis = shared;
    const FaceVector a = pose_face(face, plain).vector, b = pose_face(face, by_basis).vector;
    for (std::size_t v = 0; v < vertices.count(); ++v) {
      double square = 0;
      for (std::size_t i = vertices.begin[v]; i < vertices.begin[v + 1]; ++i)
        square += (a[i] - b[i]) * (a[i] - b[i]);
      EXPECT_LE(vertices.scale[v] * std::sqrt(square), bound + 1e-12);
    }
  }
}

TEST(NpyBasis, AnotherFacesBasisIsRefused) {
  const BasisFile file = basis_of_clip(toon(), 10, 2);
  auto other = read_face(test::face_path("seed0"));
  ASSERT_TRUE(other);
  const auto basis = face_basis(file, *other);
  ASSERT_FALSE(basis);
  EXPECT_EQ(basis.error().what.find("the basis is of the face \"toon\""), 0u);
  EXPECT_FALSE(face_basis(BasisFile{}, *other));
}

}  // namespace
}  // namespace mien
