#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/bind/c/check.h"

static mien_basis_info about(const mien_basis* basis) {
  mien_error* error = NULL;
  mien_basis_info info;
  memset(&info, 0, sizeof info), info.size = sizeof info;
  OK(mien_basis_about(basis, &info, &error));
  return info;
}

/* Four frames of two vertices in the plane, which move along one direction alone. */
static void test_frames(void) {
  mien_error* error = NULL;
  mien_basis *basis = NULL, *none = NULL;
  const double frames[16] = {0, 1, 2, 3, 2, 1, 2, 5, 4, 1, 2, 7, 6, 1, 2, 9};
  double values[4], weights[4], again[4];
  mien_basis_info info;
  int i, j;
  OK(mien_basis_of_frames(frames, 4, 2, 2, MIEN_BASIS_VARIANCE, 0.999, &basis, &error));
  info = about(basis);
  CHECK(!info.of_face && info.frames == 4 && info.vertices == 2 && info.dimensions == 2);
  CHECK(info.components == 1 && fabs(info.total_variance - 40.0 / 3) < 1e-9);
  OK(mien_basis_numbers(basis, MIEN_BASIS_MEAN, values, 4, &error));
  CHECK(fabs(values[0] - 3) < 1e-12 && fabs(values[3] - 6) < 1e-12);
  OK(mien_basis_numbers(basis, MIEN_BASIS_WEIGHTS, weights, 4, &error));
  OK(mien_basis_encode(basis, frames, 4, again, 4, &error));
  for (i = 0; i < 4; ++i) {
    CHECK(fabs(weights[i] - again[i]) < 1e-9);
    OK(mien_basis_decode(basis, weights + i, 1, values, 4, &error));
    for (j = 0; j < 4; ++j) CHECK(fabs(values[j] - frames[4 * i + j]) < 1e-9);
  }
  OK(mien_basis_decode(basis, NULL, 0, values, 4, &error)); /* without weights the mean */
  CHECK(fabs(values[0] - 3) < 1e-12);
  FAILS(MIEN_MISUSE, "count", mien_basis_numbers(basis, MIEN_BASIS_MEAN, values, 3, &error));
  FAILS(MIEN_MISUSE, "which", mien_basis_numbers(basis, 4, values, 4, &error));
  FAILS(MIEN_MISUSE, "weight_count", mien_basis_decode(basis, weights, 2, values, 4, &error));
  FAILS(MIEN_MISUSE, "count", mien_basis_encode(basis, frames, 4, again, 3, &error));
  FAILS(MIEN_REFUSED, NULL, mien_basis_of_frames(frames, 4, 2, 2, 0, 5, &none, &error));
  FAILS(MIEN_REFUSED, "whole", mien_basis_of_frames(frames, 4, 2, 2, 0, 0.5, &none, &error));
  FAILS(MIEN_MISUSE, "wish", mien_basis_of_frames(frames, 4, 2, 2, 3, 1, &none, &error));
  FAILS(MIEN_REFUSED, "none", mien_basis_of_frames(frames, 0, 2, 2, 0, 1, &none, &error));
  FAILS(MIEN_MISUSE, "frames", mien_basis_of_frames(NULL, 4, 2, 2, 0, 1, &none, &error));
  FAILS(MIEN_REFUSED, NULL,
        mien_basis_of_frames(frames, (size_t)-1, (size_t)-1, 2, 0, 1, &none, &error));
  FAILS(MIEN_UNREADABLE, "nowhere", mien_basis_read("nowhere.basis", END, &none, &error));
  FAILS(MIEN_MISUSE, "basis", mien_basis_numbers(NULL, 0, values, 4, &error));
  CHECK(none == NULL && mien_basis_file_size(NULL) == 0);
  mien_basis_free(basis), mien_basis_free(NULL);
}

/* Writes a basis to a file and reads it again. */
static mien_basis* through_a_file(const mien_basis* basis, const char* folder) {
  mien_error* error = NULL;
  mien_basis* again = NULL;
  const size_t size = mien_basis_file_size(basis);
  char path[1000], *bytes = malloc(size + 1);
  FILE* file;
  FAILS(MIEN_MISUSE, "count", mien_basis_file(basis, bytes, size + 1, &error));
  OK(mien_basis_file(basis, bytes, size, &error));
  snprintf(path, sizeof path, "%s/toon.basis", folder);
  file = fopen(path, "wb");
  CHECK(fwrite(bytes, 1, size, file) == size);
  fclose(file), free(bytes);
  OK(mien_basis_read(path, END, &again, &error));
  return again;
}

static double* vector_of(mien_pose* pose, int32_t count) {
  mien_error* error = NULL;
  double* values = malloc(sizeof *values * (size_t)count);
  OK(mien_pose_vector(pose, values, count, &error));
  return values;
}

static double farthest(const double* a, const double* b, int32_t count) {
  double most = 0;
  int32_t i;
  for (i = 0; i < count; ++i) most = fmax(most, fabs(a[i] - b[i]));
  return most;
}

/* A face's clip, and the face posed by its components at a frame's time. */
static void test_faces_by_bases(const char* folder) {
  mien_error* error = NULL;
  mien_face* face = any_face();
  mien_pose *pose = NULL, *other = NULL;
  mien_basis *made = NULL, *basis, *numbers = NULL;
  const int32_t count = mien_face_vector_size(face);
  const double frame[2] = {1, 2}, many[8] = {0}, wrong[1] = {HUGE_VAL};
  double *rest, *wanted, *got, *mean;
  OK(mien_pose_new(face, &pose, &error));
  OK(mien_pose_new(face, &other, &error));
  rest = vector_of(pose, count);
  OK(mien_basis_of_pose(pose, 30, 6, 10, MIEN_BASIS_COUNT, 5, &made, &error));
  basis = through_a_file(made, folder);
  CHECK(about(basis).of_face && about(basis).vertices == (uint64_t)count);
  CHECK(about(basis).fps == 10 && about(basis).begin == 3 && about(basis).components == 5);
  OK(mien_pose_time(pose, 3.2, &error));
  wanted = vector_of(pose, count);
  OK(mien_pose_basis(other, basis, NULL, 0, &error));
  OK(mien_pose_time(other, 3.2, &error));
  got = vector_of(other, count);
  CHECK(farthest(got, wanted, count) < 1e-6 && farthest(rest, wanted, count) > 1e-6);
  free(got);
  OK(mien_pose_basis(other, basis, many, 5, &error));
  got = vector_of(other, count), mean = malloc(sizeof *mean * (size_t)count);
  OK(mien_basis_numbers(basis, MIEN_BASIS_MEAN, mean, (size_t)count, &error));
  CHECK(farthest(got, mean, count) < 1e-6);
  free(got);
  OK(mien_pose_basis(other, NULL, NULL, 0, &error)); /* no longer */
  got = vector_of(other, count);
  CHECK(farthest(got, wanted, count) == 0);
  OK(mien_basis_of_frames(frame, 2, 1, 1, MIEN_BASIS_COUNT, 1, &numbers, &error));
  FAILS(MIEN_REFUSED, "not of a face", mien_pose_basis(other, numbers, NULL, 0, &error));
  FAILS(MIEN_REFUSED, "5 components", mien_pose_basis(other, basis, many, 8, &error));
  FAILS(MIEN_REFUSED, "weights[0]", mien_pose_basis(other, basis, wrong, 1, &error));
  FAILS(MIEN_MISUSE, "pose", mien_pose_basis(NULL, basis, NULL, 0, &error));
  mien_basis_free(made), made = NULL;
  FAILS(MIEN_REFUSED, "fps", mien_basis_of_pose(pose, 0, 6, 0, 0, 1, &made, &error));
  FAILS(MIEN_REFUSED, "GiB", mien_basis_of_pose(pose, 0, 1u << 30, 30, 0, 1, &made, &error));
  FAILS(MIEN_REFUSED, "frame_count", mien_basis_of_pose(pose, 0, 0, 30, 0, 1, &made, &error));
  free(got), free(rest), free(wanted), free(mean);
  mien_basis_free(basis), mien_basis_free(numbers), mien_pose_free(pose), mien_pose_free(other);
  mien_face_free(face);
}

void test_bases(const char* folder) {
  test_frames();
  test_faces_by_bases(folder);
}
