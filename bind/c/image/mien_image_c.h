/* mien's pictures as files, in C. Link libmien_image_c and libmien_c.
 *
 *   mien_write_picture(scene, &view, "toon.png", MIEN_NUL_ENDED, NULL, &error);
 *
 * It is a library of its own, so that programs that only draw do not depend on those that know files. The rules are
 * those of <mien_c.h>. TIFF, EXR and JPEG are written by modules that are loaded when they are needed. */
#ifndef MIEN_IMAGE_C_H
#define MIEN_IMAGE_C_H

#include <mien_c.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
  MIEN_FILE_BY_NAME = 0, /* .png .tif .tiff .exr .jpg .jpeg */
  MIEN_FILE_PNG = 1,     /* 8 or 16 bits */
  MIEN_FILE_TIFF = 2,    /* 8, 16 bits or floats */
  MIEN_FILE_EXR = 3,     /* half or whole floats */
  MIEN_FILE_JPEG = 4     /* 8 bits, opaque */
};

typedef struct mien_write_options {
  uint32_t size;          /* sizeof(mien_write_options) */
  int32_t type;           /* MIEN_FILE_...; by name */
  int32_t half;           /* EXR: half floats; yes */
  int32_t jpeg_quality;   /* 1 ... 100; 95 */
  int32_t threads;        /* as in mien_render_options; they change no byte; 0 */
  int32_t depth;          /* mien_write_picture: MIEN_U8 ..., -1: as fits the type; -1 */
  uint64_t memory;        /* mien_write_picture: how many bytes it may hold at once; 256 MiB */
  const char* recipe;     /* what made the picture, for the file's metadata; NULL: nothing */
  size_t recipe_length;   /* [bytes], or MIEN_NUL_ENDED */
  mien_progress progress; /* may cancel: then nothing is written; NULL */
  void* progress_data;    /* for `progress` */
  double dpi; /* [pixels per inch] the size on paper, 1 ... 100000; 0: none, in TIFF 72; 0 */
} mien_write_options;

/* The defaults, and the size. `size` is sizeof(mien_write_options). False sizes are left alone. */
MIEN_C_API void mien_write_options_init(mien_write_options* options, size_t size);

/* Checks before a long work that a file can be written there: the format is known, and the folder exists and
 * is writable. Changes nothing. NULL options are the defaults, here and below. */
MIEN_C_API mien_status mien_check_output_path(const char* path, size_t path_length,
                                              const mien_write_options* options,
                                              mien_error** error);

/* Writes pixels, width x height. The file appears whole or not at all: it is written beside its target, flushed
 * and renamed. Pixels that are all opaque are stored without alpha. */
MIEN_C_API mien_status mien_write_image(const mien_pixels* pixels, int32_t width, int32_t height,
                                        const char* path, size_t path_length,
                                        const mien_write_options* options, mien_error** error);

/* Draws a scene and writes it piece by piece, at any size, in bounded memory. */
MIEN_C_API mien_status mien_write_picture(const mien_scene* scene, const mien_view* view,
                                          const char* path, size_t path_length,
                                          const mien_write_options* options, mien_error** error);

#ifdef __cplusplus
}
#endif
#endif
