/* mien in C: a face goes in, pixels come out. Link libmien_c.
 * Longer than other files: the interface is one header, as C programs expect.
 *
 *   #include <mien_c.h>
 *   #include <stdio.h>
 *   #include <stdlib.h>
 *
 *   int main(void) {
 *     mien_error* error = NULL;
 *     mien_face* face = NULL;
 *     mien_pose* pose = NULL;
 *     mien_scene* scene = NULL;
 *     mien_renderer* renderer = NULL;
 *     mien_view view;
 *     mien_pixels pixels;
 *     mien_view_init(&view, sizeof view);
 *     view.width = 640, view.height = 360;
 *     mien_pixels_init(&pixels, sizeof pixels);
 *     pixels.stride = 640 * 4, pixels.bytes = 360 * pixels.stride;
 *     pixels.data = malloc(pixels.bytes);
 *
 *     if (mien_face_read("faces/toon.face.json", MIEN_NUL_ENDED, &face, &error) ||
 *         mien_pose_new(face, &pose, &error) || mien_pose_time(pose, 1.25, &error) ||
 *         mien_pose_set(pose, "gaze.x=0.04", MIEN_NUL_ENDED, &error) ||
 *         mien_scene_new(pose, &scene, &error) || mien_renderer_new(&renderer, &error) ||
 *         mien_render(renderer, scene, &view, &pixels, NULL, &error))
 *       fprintf(stderr, "%s: %s\n", mien_error_where(error), mien_error_what(error));
 *     else
 *       fwrite(pixels.data, 1, pixels.bytes, stdout);
 *
 *     mien_error_free(error), mien_renderer_free(renderer), mien_scene_free(scene);
 *     mien_pose_free(pose), mien_face_free(face), free(pixels.data);
 *     return error != NULL;
 *   }
 *
 * Rules for every function
 *
 *   Ownership.  What a function gives through `out` belongs to the caller, who frees it with the
 *               function of its kind. Freeing NULL does nothing. No handle needs another one to live:
 *               a face may be freed before its poses, a pose before its scenes. Texts that are
 *               returned as const char* belong to the handle that was asked.
 *   Failure.    What can fail returns a mien_status: MIEN_OK, or why not. `error` may be NULL; otherwise
 *               it is always written: NULL for success, or an error with an address and a sentence,
 *               which the caller frees. `*out` is NULL after a failure. A NULL handle, a wrong size, an
 *               index out of range are MIEN_MISUSE and crash nothing. Numbers that must be finite and
 *               are not are MIEN_REFUSED. Functions without a status give NULL handles' names as "", and
 *               their counts as 0. No C++ exception comes out, nothing is printed, no global state is
 *               kept.
 *   Texts.      UTF-8. Those that go in have a length in bytes, without the final NUL;
 *               MIEN_NUL_ENDED lets the library find the end. Those that come out end with a NUL.
 *   Structs.    Each begins with its size, which the caller sets (the _init functions do): a struct of an
 *               older header is shorter, and what it lacks has its default. One of a newer header than the
 *               library is MIEN_MISUSE. Switches are int32_t: 0 is no, anything else is yes.
 *   Threads.    Faces and scenes never change: threads may share them. A pose, a renderer and an error
 *               are used by one thread at a time. mien_face_retain and _free may be called from any.
 *   Units.      Face units are the face's own (mien_face_canvas). Pixels are squares: pixel (x, y) goes from
 *               (x, y) to (x + 1, y + 1), y down, from the picture's top left corner. Times are in seconds.
 *               Colours are linear red, green, blue (sRGB primaries) and opacity, not premultiplied.
 *
 * The interface is pure C99, of opaque handles, and its symbols have a version (MIEN_C_0): programs need
 * not be built again for a newer libmien_c.so.0. Image files are in <mien_image_c.h>. */
#ifndef MIEN_C_H
#define MIEN_C_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define MIEN_C_API __attribute__((visibility("default")))
#else
#define MIEN_C_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* The length of a text that ends with a NUL. */
#define MIEN_NUL_ENDED ((size_t)-1)

/* Why a function did not do what it was asked for; the sentence is in the error. */
typedef int32_t mien_status;
enum {
  MIEN_OK = 0,
  MIEN_MISUSE = 1,     /* the program is wrong: a NULL, a size, an index */
  MIEN_UNREADABLE = 2, /* a file, a face or a code that cannot be read */
  MIEN_REFUSED = 3,    /* an unknown name, a number out of range, an impossible size */
  MIEN_CANCELLED = 4,  /* the caller asked for it */
  MIEN_NO_MEMORY = 5,
  MIEN_NOT_WRITTEN = 6, /* a picture's file: <mien_image_c.h> */
  MIEN_UNEXPECTED = 7   /* a bug of mien's; the sentence helps to report it */
};

typedef struct mien_error mien_error; /* why something failed */
typedef struct mien_texts mien_texts; /* a list of texts */
typedef struct mien_face mien_face;   /* a face at rest, with names and clips */
typedef struct mien_pose mien_pose;   /* how a face is to look */
typedef struct mien_scene mien_scene; /* a posed face as painted layers */
typedef struct mien_renderer
    mien_renderer;                        /* draws; keeps memory and finished rows between frames */
typedef struct mien_pieces mien_pieces;   /* one picture that is drawn piece by piece */
typedef struct mien_effects mien_effects; /* what is done to a finished picture */
typedef struct mien_basis mien_basis;     /* the principal components of an animation */
typedef struct mien_motion mien_motion;   /* a take of an actor or a track of speech */
typedef struct mien_steadier mien_steadier; /* a filter for frames that come live */

/* ---- Version ---------------------------------------------------------------------------------- */

/* The version of the library that runs: major << 16 | minor << 8 | patch. */
MIEN_C_API uint32_t mien_version(void);

/* The same as a text, "0.1.0". */
MIEN_C_API const char* mien_version_text(void);

/* The version of this interface, the 0 of libmien_c.so.0. It is not that of mien. */
#define MIEN_C_ABI 0
MIEN_C_API uint32_t mien_abi_version(void);

/* ---- Errors ----------------------------------------------------------------------------------- */

/* The address: "toon.face.json:12:7: /features/2/points", "gaze.z=1", "mien_pose_set: pose". May be "". */
MIEN_C_API const char* mien_error_where(const mien_error* error);

/* One sentence without a full stop: "expected 2 numbers, got 3". */
MIEN_C_API const char* mien_error_what(const mien_error* error);

MIEN_C_API void mien_error_free(mien_error* error);

/* An error of one's own, for libraries that continue this interface. Never NULL. */
MIEN_C_API mien_error* mien_error_new(const char* where, size_t where_length, const char* what,
                                      size_t what_length);

/* ---- Lists of texts ---------------------------------------------------------------------------- */

MIEN_C_API int32_t mien_texts_count(const mien_texts* texts);

/* The text at an index, which lives as long as the list; "" where there is none. */
MIEN_C_API const char* mien_texts_at(const mien_texts* texts, int32_t index);

MIEN_C_API void mien_texts_free(mien_texts* texts);

/* The sentence about a name that is not among `names`, which has one a line, for doors into other languages: `no WHAT
 * named "WANTED"; did you mean "NAME"?`, as mien's own errors ask, or without the question. A list of one text. */
MIEN_C_API mien_status mien_unknown_name(const char* what, size_t what_length, const char* wanted,
                                         size_t wanted_length, const char* names,
                                         size_t names_length, mien_texts** out, mien_error** error);

/* ---- Faces ------------------------------------------------------------------------------------ */

/* Reads a face file (docs/face-format.md), of format version 1 or 2. */
MIEN_C_API mien_status mien_face_read(const char* path, size_t path_length, mien_face** out,
                                      mien_error** error);

/* The same from memory; `name` stands for the file's name in errors, NULL: "face". */
MIEN_C_API mien_status mien_face_read_text(const char* text, size_t length, const char* name,
                                           size_t name_length, mien_face** out, mien_error** error);

/* The person of a code, "AA7Q2-MKX4T-BY". */
MIEN_C_API mien_status mien_face_from_code(const char* code, size_t length, mien_face** out,
                                           mien_error** error);

/* One more owner of a face: it is freed when it has been freed as often as it was made and retained.
 * Returns the face. */
MIEN_C_API mien_face* mien_face_retain(mien_face* face);
MIEN_C_API void mien_face_free(mien_face* face);

/* The name that the face's file gives it, and whom it credits; may be "". */
MIEN_C_API const char* mien_face_title(const mien_face* face);
MIEN_C_API const char* mien_face_credit(const mien_face* face);

/* What a picture of the face shows. */
typedef struct mien_canvas {
  uint32_t size;    /* sizeof(mien_canvas) */
  int32_t y_up;     /* whether larger y is higher in the picture */
  double box[4];    /* left, lower and right, upper ends of x and y: x0, y0, x1, y1 [face units] */
  double mirror_x;  /* left and right mirror each other about this x [face units] */
  const char* unit; /* the unit's name, for people; lives as long as the face */
} mien_canvas;

/* `out->size` is set by the caller. */
MIEN_C_API mien_status mien_face_canvas(const mien_face* face, mien_canvas* out,
                                        mien_error** error);

/* Something that can be set: a control ("gaze.x", "emotion.joy"), the weight of a pose, or a slice of the
 * face's numbers ("brow.left/spine/1"). */
typedef struct mien_name {
  uint32_t size;      /* sizeof(mien_name) */
  int32_t is_control; /* else a slice */
  int32_t is_pose;    /* a control that is the weight of a pose */
  int32_t count;      /* of its numbers */
  int32_t begin;      /* a slice: where its numbers begin in the face's vector; a control: -1 */
  int32_t reserved;   /* 0 */
  const char* name;   /* lives as long as the face */
  const char* unit;   /* "face units", "ratio", "linear light"; lives as long as the face */
  double lo, hi;      /* the range of each number; may be infinite */
} mien_name;

/* How many names there are: controls first, poses among them, then slices in the vector's order. */
MIEN_C_API int32_t mien_face_name_count(const mien_face* face);

/* The name at an index. `out->size` is set by the caller. */
MIEN_C_API mien_status mien_face_name_at(const mien_face* face, int32_t index, mien_name* out,
                                         mien_error** error);

/* Its numbers at rest. `count` is the name's. */
MIEN_C_API mien_status mien_face_values_at(const mien_face* face, int32_t index, double* values,
                                           int32_t count, mien_error** error);

/* The clips that the face can run, by name. */
MIEN_C_API int32_t mien_face_clip_count(const mien_face* face);
MIEN_C_API const char* mien_face_clip_name(const mien_face* face, int32_t index);

/* How long such a clip is [s]: from then on it repeats, or rests. Infinite where it never does: chance moves it, or its
 * curves are together again after more than an hour, or never. 0 where there is no clip. */
MIEN_C_API double mien_face_clip_length(const mien_face* face, int32_t index);

/* How many numbers the face's vector has. */
MIEN_C_API int32_t mien_face_vector_size(const mien_face* face);

/* ---- Face files with other numbers ------------------------------------------------------------- */

/* Where a face file's text has its values, as JSON pointers (RFC 6901): a text for each name of mien_face_name_at, in its
 * order, "/features/12/spine/1". Two sides that the file writes once have the same one. It is "" where the file does not
 * hold the value: of controls, whose values are poses, and of all names of a recipe. `name` stands for the file's name in
 * errors, NULL: "face". */
MIEN_C_API mien_status mien_face_pointers(const char* text, size_t length, const char* name,
                                          size_t name_length, mien_texts** out, mien_error** error);

/* A face file's text with other values: settings[i], which ends with a NUL, is "NAME=VALUE" as mien_pose_set takes it, and
 * later ones beat earlier ones. All else keeps every byte; a side that differs from its mirror image gets an object of
 * its own. The list's first text is the file's; the others are names that the file cannot hold. `count` is 0 or more. */
MIEN_C_API mien_status mien_face_text_with(const char* text, size_t length, const char* name,
                                           size_t name_length, const char* const* settings,
                                           int32_t count, mien_texts** out, mien_error** error);

/* ---- Morph targets ------------------------------------------------------------------------------ */

/* The face with the morph targets of a file (docs/morph.md) as poses of its own: mien_pose_set holds their
 * weights, "smile=0.6". The face itself does not change. */
MIEN_C_API mien_status mien_face_with_morphs(const mien_face* face, const char* path,
                                             size_t path_length, mien_face** out,
                                             mien_error** error);

/* The same from memory; `name` stands for the file's name in errors, NULL: "morphs". */
MIEN_C_API mien_status mien_face_with_morphs_text(const mien_face* face, const char* text,
                                                  size_t length, const char* name,
                                                  size_t name_length, mien_face** out,
                                                  mien_error** error);

/* The text of such a file, a list of one text: faces[i] is the shape of `rest` that names[i], which ends with a
 * NUL, stands for. All are the same face, slice for slice. `count` is 0 or more. */
MIEN_C_API mien_status mien_morphs_text(const mien_face* rest, const char* const* names,
                                        const mien_face* const* faces, int32_t count,
                                        mien_texts** out, mien_error** error);

/* ---- Bases of animations ------------------------------------------------------------------------ */

/* A basis (docs/pca.md) is the mean and the components of an animation, and the weights of its frames: a frame is
 * mean + weights[0] component 0 + .... A frame is vertices x dimensions numbers, of a face its vector, whose numbers
 * are vertices of one dimension. A basis never changes: threads may share it. */
MIEN_C_API mien_status mien_basis_read(const char* path, size_t path_length, mien_basis** out,
                                       mien_error** error);
MIEN_C_API void mien_basis_free(mien_basis* basis);

/* What sets the number of components. */
enum {
  MIEN_BASIS_COUNT = 0,    /* so many, 1 ... the least of frames and numbers */
  MIEN_BASIS_VARIANCE = 1, /* the fewest that hold this share of the variance, 0 ... 1 */
  MIEN_BASIS_MAX_ERROR = 2 /* the fewest with which no vertex is farther from its place */
};

/* Fits a basis to frames of one's own, one after the other. */
MIEN_C_API mien_status mien_basis_of_frames(const double* frames, size_t frame_count,
                                            size_t vertices, size_t dimensions, int32_t wish,
                                            double wished, mien_basis** out, mien_error** error);

/* Fits a basis to a face at a pose, at first / fps, (first + 1) / fps ... seconds. An error is then in face units,
 * or in levels of 255 for colours. */
MIEN_C_API mien_status mien_basis_of_pose(const mien_pose* pose, int64_t first, size_t frame_count,
                                          double fps, int32_t wish, double wished, mien_basis** out,
                                          mien_error** error);

typedef struct mien_basis_info {
  uint32_t size;         /* sizeof(mien_basis_info) */
  int32_t of_face;       /* whether frames are a face's vectors */
  uint64_t frames;       /* that it was fitted to */
  uint64_t vertices;     /* of a frame */
  uint64_t dimensions;   /* of a vertex */
  uint64_t components;   /* that were kept */
  double total_variance; /* of all components that there could be */
  double fps, begin;     /* of a face's: frames per second, and when the first one is [s] */
} mien_basis_info;

/* `out->size` is set by the caller. */
MIEN_C_API mien_status mien_basis_about(const mien_basis* basis, mien_basis_info* out,
                                        mien_error** error);

/* The basis's numbers, row by row. */
enum {
  MIEN_BASIS_MEAN = 0,       /* vertices x dimensions */
  MIEN_BASIS_COMPONENTS = 1, /* components x vertices x dimensions */
  MIEN_BASIS_VARIANCES = 2,  /* components */
  MIEN_BASIS_WEIGHTS = 3     /* frames x components */
};

/* `count` is how many there are. */
MIEN_C_API mien_status mien_basis_numbers(const mien_basis* basis, int32_t which, double* values,
                                          size_t count, mien_error** error);

/* A frame of weights: vertices x dimensions numbers. Missing weights are 0. */
MIEN_C_API mien_status mien_basis_decode(const mien_basis* basis, const double* weights,
                                         size_t weight_count, double* values, size_t count,
                                         mien_error** error);

/* The weights of frames: `count` is frame_count x components. */
MIEN_C_API mien_status mien_basis_encode(const mien_basis* basis, const double* frames,
                                         size_t frame_count, double* weights, size_t count,
                                         mien_error** error);

/* How many bytes the basis's file has, and the file itself. `count` is so many. */
MIEN_C_API size_t mien_basis_file_size(const mien_basis* basis);
MIEN_C_API mien_status mien_basis_file(const mien_basis* basis, void* bytes, size_t count,
                                       mien_error** error);

/* The face is posed from the basis's vector, which replaces that at rest and the default clip: of these weights,
 * of which missing ones are 0, or with no weights of the pose's time. A NULL basis: no longer. A basis of another
 * face is MIEN_REFUSED. */
MIEN_C_API mien_status mien_pose_basis(mien_pose* pose, const mien_basis* basis,
                                       const double* weights, size_t weight_count,
                                       mien_error** error);

/* ---- People ------------------------------------------------------------------------------------ */

/* The seed that a word stands for: the same word, the same seed, below 2^50. */
MIEN_C_API mien_status mien_seed_from_word(const char* word, size_t length, uint64_t* out,
                                           mien_error** error);

/* The code of a seed, below 2^50: a list of one text. */
MIEN_C_API mien_status mien_code_from_seed(uint64_t seed, mien_texts** out, mien_error** error);

/* The recipe of a seed or a code, a face file of a few lines that mien_face_read_text takes: a list of one
 * text. */
MIEN_C_API mien_status mien_recipe_from_seed(uint64_t seed, mien_texts** out, mien_error** error);
MIEN_C_API mien_status mien_recipe_from_code(const char* code, size_t length, mien_texts** out,
                                             mien_error** error);

/* A recipe's face in full, as `mien new --flat` writes it: a file of format version 1, in which every feature stands and
 * nothing is of parts. `text` is the recipe's, which can have no parts of its own; `name` stands for its file's name in
 * errors, NULL: "face". A list of one text. */
MIEN_C_API mien_status mien_recipe_in_full(const char* text, size_t length, const char* name,
                                           size_t name_length, mien_texts** out,
                                           mien_error** error);

/* The code with one thing held whatever its seed chooses: "hair=bob", "eye.size=1.05". `clamp`: a number out of
 * range becomes the nearer end. A list of one text. */
MIEN_C_API mien_status mien_code_hold(const char* code, size_t length, const char* held,
                                      size_t held_length, int32_t clamp, mien_texts** out,
                                      mien_error** error);

/* The code of the same person without an expression: no smile, no mood, lips closed. A list of one text. */
MIEN_C_API mien_status mien_code_neutral(const char* code, size_t length, mien_texts** out,
                                         mien_error** error);

/* Somebody like the person of a code: `by`, 0 to 1, is how far and how likely things change. Different seeds
 * are different people. */
MIEN_C_API mien_status mien_code_near(const char* code, size_t length, double by, uint64_t seed,
                                      mien_texts** out, mien_error** error);

/* Somebody between two: 0 is the one, 1 the other. */
MIEN_C_API mien_status mien_code_between(const char* one, size_t one_length, const char* other,
                                         size_t other_length, double at, mien_texts** out,
                                         mien_error** error);

/* A child of two. */
MIEN_C_API mien_status mien_code_of_child(const char* one, size_t one_length, const char* other,
                                          size_t other_length, uint64_t seed, mien_texts** out,
                                          mien_error** error);

/* How different two people look: about 1 for other hair. */
MIEN_C_API mien_status mien_code_difference(const char* one, size_t one_length, const char* other,
                                            size_t other_length, double* out, mien_error** error);

/* The codes of `count` people, 0 to 100 000, no two of whom look alike. The first n are the same in every crowd of
 * the word. */
MIEN_C_API mien_status mien_crowd(const char* word, size_t length, int32_t count, mien_texts** out,
                                  mien_error** error);

/* ---- Parts ------------------------------------------------------------------------------------- */

/* What recipes choose from: lists of names. */
MIEN_C_API mien_status mien_part_families(mien_texts** out, mien_error** error);
MIEN_C_API mien_status mien_part_numbers(mien_texts** out, mien_error** error);
MIEN_C_API mien_status mien_part_styles(mien_texts** out, mien_error** error);

/* The parts of a family, "hair". The first is "none" where a face may do without. */
MIEN_C_API mien_status mien_part_names(const char* family, size_t length, mien_texts** out,
                                       mien_error** error);

/* A number's range and what it is at rest: lo, hi, rest. */
MIEN_C_API mien_status mien_part_number(const char* name, size_t length, double out[3],
                                        mien_error** error);

/* ---- Poses ------------------------------------------------------------------------------------- */

/* A pose of the face, at rest. */
MIEN_C_API mien_status mien_pose_new(const mien_face* face, mien_pose** out, mien_error** error);
MIEN_C_API void mien_pose_free(mien_pose* pose);

/* Back to rest. */
MIEN_C_API mien_status mien_pose_clear(mien_pose* pose, mien_error** error);

/* The time at which clips are taken [s]. Until one is said, and after mien_pose_clear, no clip runs. */
MIEN_C_API mien_status mien_pose_time(mien_pose* pose, double seconds, mien_error** error);

/* Holds a control or numbers at a value: "blink=0.5", "brow.left/spine/1=0.1,0.2", "palette/skin=#ffd94a".
 * What is set later beats what was set earlier; settings beat clips and the gaze. */
MIEN_C_API mien_status mien_pose_set(mien_pose* pose, const char* text, size_t length,
                                     mien_error** error);

/* The same by the index of a name, without text: as quick as it gets. `count` is the name's. */
MIEN_C_API mien_status mien_pose_set_at(mien_pose* pose, int32_t index, const double* values,
                                        int32_t count, mien_error** error);

/* Adds an expression of a set, "emotion", "muscle", "arkit", "facs", "vrm", "viseme" or "azure":
 * "joy=0.8", "left.surprise=0.3". `clamp`: a strength out of 0 ... 1 becomes the nearer end instead of an error. */
MIEN_C_API mien_status mien_pose_express(mien_pose* pose, const char* set, size_t set_length,
                                         const char* text, size_t length, int32_t clamp,
                                         mien_error** error);

/* Runs a clip, on top of those before it: "idle", "idle=0.5" (its weight), "idle=1@2" (and when it began
 * [s]). Without any the face's default clip runs. Nothing runs without a time. */
MIEN_C_API mien_status mien_pose_clip(mien_pose* pose, const char* text, size_t length,
                                      mien_error** error);

/* Plays a motion, on top of clips and motions before it: `weight` of the way to its values, its own time 0 at `begin` [s]. As
 * with clips, nothing runs without a time, and the face's default clip runs only where nothing else does. Talking is
 * mien_pose_time and this, for every picture. The motion may be freed afterwards. */
MIEN_C_API mien_status mien_pose_motion(mien_pose* pose, const mien_motion* motion, double weight,
                                        double begin, mien_error** error);

/* Holds what a camera saw in one frame: JSON of ARKit's shapes, or a result of MediaPipe, as for mien_motion_read_text. What
 * is out of range is clamped; what the face does not have is left out. No time is needed. */
MIEN_C_API mien_status mien_pose_follow(mien_pose* pose, const char* frame, size_t length,
                                        mien_error** error);

/* The same for frames that come live, one face's after the other at their moments [s], so that it does not tremble: each
 * number goes through a 1-euro filter (docs/motion.md). `cutoff` [Hz] is above 0, lower is quieter; `beta` is 0 or above,
 * higher is less late where much moves; 1 and 2 are a beginning. After a second without frames it begins again. */
MIEN_C_API mien_status mien_steadier_new(double cutoff, double beta, mien_steadier** out,
                                         mien_error** error);
MIEN_C_API void mien_steadier_free(mien_steadier* steadier);
MIEN_C_API mien_status mien_pose_follow_steadily(mien_pose* pose, mien_steadier* steadier,
                                                 double seconds, const char* frame, size_t length,
                                                 mien_error** error);

/* A word instead of the face's own code, recipe or text, for what the face does by itself: the same word, the same
 * blinks and glances. An empty word is refused. */
MIEN_C_API mien_status mien_pose_seed(mien_pose* pose, const char* word, size_t length,
                                      mien_error** error);

/* How far clips move the face, 0 (not at all) ... 2; 1 as the clips have it. */
MIEN_C_API mien_status mien_pose_liveliness(mien_pose* pose, double liveliness, mien_error** error);

/* How far the head nods and brows rise with the stresses of speech, 0 (the mouth alone speaks) ... 2; 1 unless set. They go
 * with the liveliness, too. */
MIEN_C_API mien_status mien_pose_gestures(mien_pose* pose, double gestures, mien_error** error);

/* The point that the eyes look at [face units], z towards the viewer. */
MIEN_C_API mien_status mien_pose_look_at(mien_pose* pose, double x, double y, double z,
                                         mien_error** error);

/* How far the features have travelled to a flat chart, 0 ... 1. */
enum { MIEN_UNWRAP_LINEAR = 0, MIEN_UNWRAP_DELAYED = 1, MIEN_UNWRAP_SINE = 2 };
MIEN_C_API mien_status mien_pose_unwrap(mien_pose* pose, double share, int32_t mode,
                                        mien_error** error);

/* The posed face's numbers. `count` is mien_face_vector_size. */
MIEN_C_API mien_status mien_pose_vector(mien_pose* pose, double* values, int32_t count,
                                        mien_error** error);

/* ---- Motions ----------------------------------------------------------------------------------- */

/* Reads a take of an actor or a track of speech, whatever program wrote it (docs/motion.md). */
MIEN_C_API mien_status mien_motion_read(const char* path, size_t path_length, mien_motion** out,
                                        mien_error** error);
MIEN_C_API mien_status mien_motion_read_text(const char* text, size_t length, const char* name,
                                             size_t name_length, mien_motion** out,
                                             mien_error** error);
MIEN_C_API void mien_motion_free(mien_motion* motion);

/* [s] Until its last moment. */
MIEN_C_API double mien_motion_length(const mien_motion* motion);

/* The controls that it moves, by name ("arkit.jawOpen", "viseme.aa", "yaw"), and their values at a moment [s]. */
MIEN_C_API int32_t mien_motion_channel_count(const mien_motion* motion);
MIEN_C_API const char* mien_motion_channel_name(const mien_motion* motion, int32_t index);
MIEN_C_API double mien_motion_value(const mien_motion* motion, int32_t index, double seconds);

/* What was odd in its file: values that were clamped, rows without a face, names that mean nothing. */
MIEN_C_API mien_status mien_motion_told(const mien_motion* motion, mien_texts** out,
                                        mien_error** error);

/* The names of what moves in it and not in the face. */
MIEN_C_API mien_status mien_motion_unfollowed(const mien_motion* motion, const mien_face* face,
                                              mien_texts** out, mien_error** error);

/* ---- Scenes ------------------------------------------------------------------------------------ */

/* The posed face as painted layers. The pose may change afterwards: the scene stays. */
MIEN_C_API mien_status mien_scene_new(mien_pose* pose, mien_scene** out, mien_error** error);
MIEN_C_API void mien_scene_free(mien_scene* scene);

/* The scene's shapes and layers as text, one a line: a list of one text. */
MIEN_C_API mien_status mien_scene_text(const mien_scene* scene, mien_texts** out,
                                       mien_error** error);

/* The colour behind everything. */
MIEN_C_API mien_status mien_scene_background(const mien_scene* scene, double color[4],
                                             mien_error** error);

/* Layers, from the bottom to the top. Each has the name of its feature, "iris.left". */
MIEN_C_API int32_t mien_scene_layer_count(const mien_scene* scene);
MIEN_C_API const char* mien_scene_layer_name(const mien_scene* scene, int32_t layer);

/* The signed distance from a point to a layer's outline, negative inside [face units]. */
MIEN_C_API mien_status mien_scene_distance(const mien_scene* scene, int32_t layer, double x,
                                           double y, double* out, mien_error** error);

/* The topmost layer at a point [face units]; -1: none. */
MIEN_C_API mien_status mien_scene_layer_at(const mien_scene* scene, double x, double y,
                                           int32_t* out, mien_error** error);

/* The feature that is seen at a point [face units], "iris.left": a list of one text, or of none. Unlike the topmost
 * layer it is never one that is transparent there, nor a shadow or a glow; outlines count as their features. */
MIEN_C_API mien_status mien_scene_feature_at(const mien_scene* scene, double x, double y,
                                             mien_texts** out, mien_error** error);
/* What moves the face, or how far it is moved, drawn instead of it or over it. Names are not written. */
enum {
  MIEN_DEBUG_MUSCLES =
      0, /* every muscle, blue at rest to red; MIEN_REFUSED where the face has none */
  MIEN_DEBUG_POINTS = 1, /* every point of the vector */
  MIEN_DEBUG_MORPH = 2   /* how far points have moved from rest, blue to red */
};
MIEN_C_API mien_status mien_scene_debug(mien_pose* pose, int32_t which, mien_scene** out,
                                        mien_error** error);

/* ---- Pictures ---------------------------------------------------------------------------------- */

enum { MIEN_FIT_MEET = 0, MIEN_FIT_SLICE = 1 };      /* all of the canvas; all of the picture */
enum { MIEN_BLEND_LINEAR = 0, MIEN_BLEND_SRGB = 1 }; /* where colours are mixed */
enum {
  MIEN_U8 = 0,  /* sRGB-encoded, straight alpha */
  MIEN_U16 = 1, /* the same, native byte order */
  MIEN_F32 = 2  /* linear light, premultiplied by alpha */
};

/* What the picture is. Everything here changes it. */
typedef struct mien_view {
  uint32_t size;          /* sizeof(mien_view) */
  int32_t width, height;  /* [px] of the whole picture, 1 ... 2^20; 512 */
  int32_t fit;            /* MIEN_FIT_...; meet */
  int32_t blend;          /* MIEN_BLEND_...; linear */
  int32_t dither;         /* dithers gradients and lit surfaces at 8 and 16 bits; yes */
  int32_t has_background; /* `background` replaces the face's; no */
  int32_t has_region;     /* only `region` is drawn, with the same bytes as in the whole; no */
  int32_t has_light;      /* `light` replaces the direction to the face's lamp; no */
  int32_t reserved;       /* 0 */
  double background[4];
  double light[3];   /* x right, y up, z > 0 to the viewer */
  int32_t region[4]; /* x, y, width, height [px] */
  double legible;    /* [px] 0 ... 16: lines at least so wide, for small pictures; 0 */
} mien_view;

/* The defaults, and the size. `size` is sizeof(mien_view). False sizes are left alone. */
MIEN_C_API void mien_view_init(mien_view* view, size_t size);

/* Pixels that the caller owns: red, green, blue, alpha; rows from the top. */
typedef struct mien_pixels {
  uint32_t size; /* sizeof(mien_pixels) */
  int32_t depth; /* MIEN_U8, MIEN_U16, MIEN_F32 */
  void* data;    /* aligned for a channel */
  size_t bytes;  /* how many there are from `data` on: nothing is written beyond */
  size_t stride; /* [bytes] from one row to the next */
} mien_pixels;
MIEN_C_API void mien_pixels_init(mien_pixels* pixels, size_t size);

/* Watches long work: called about every 10 ms with the share done, 0 ... 1, from one thread at a time. Returning
 * anything but 0 stops the work within 50 ms, wherever it is; it is then MIEN_CANCELLED. */
typedef int32_t (*mien_progress)(double done, void* data);

/* Runs job(0, job_data) ... job(count - 1, job_data), each once, in any order and on any threads, and
 * returns when all are done. */
typedef void (*mien_executor)(int32_t count, void (*job)(int32_t index, void* job_data),
                              void* job_data, void* data);

/* How it is drawn. Nothing here changes a bit of the picture. */
typedef struct mien_render_options {
  uint32_t size;   /* sizeof(mien_render_options) */
  int32_t threads; /* 0, or more than the machine has: all of them; 1: the caller's alone; 0 */
  mien_progress progress; /* NULL */
  void* progress_data;    /* for `progress` */
  mien_executor executor; /* draws on the caller's threads; `threads` does not count then; NULL */
  void* executor_data;    /* for `executor` */
  /* Steps of work, each one or two nanoseconds; more are MIEN_REFUSED; 0: 8 000 000 000, and 1000 for each pixel */
  int64_t most_steps;
  uint64_t most_memory; /* [bytes] of outlines and their order; more are MIEN_REFUSED; 0: 1 GiB */
} mien_render_options;
MIEN_C_API void mien_render_options_init(mien_render_options* options, size_t size);

/* "#rrggbb" or "#rrggbbaa", sRGB-encoded, as the colours of mien are: for `view.background`. */
MIEN_C_API mien_status mien_color_from_text(const char* text, size_t length, double color[4],
                                            mien_error** error);

MIEN_C_API mien_status mien_renderer_new(mien_renderer** out, mien_error** error);
MIEN_C_API void mien_renderer_free(mien_renderer* renderer);

/* What will be drawn: the part of the region in the picture, or everything: x, y, width, height [px]. */
MIEN_C_API mien_status mien_drawn_rect(const mien_view* view, int32_t rect[4], mien_error** error);

/* Draws into the pixels, which are rows of mien_drawn_rect's size. NULL options are the defaults. After a
 * failure the pixels are unspecified. */
MIEN_C_API mien_status mien_render(mien_renderer* renderer, const mien_scene* scene,
                                   const mien_view* view, const mien_pixels* pixels,
                                   const mien_render_options* options, mien_error** error);

/* How a small display's memory holds a pixel. What a picture leaves open is black. */
enum {
  MIEN_RGB565 = 0,         /* red in the five upper bits of 16, in the machine's byte order */
  MIEN_RGB565_SWAPPED = 1, /* the same with its two bytes exchanged, for displays on a serial bus */
  MIEN_BGRX = 2,           /* blue, green, red and a byte of 255, with the levels of MIEN_U8 */
  MIEN_MONO = 3            /* a bit a pixel, 1 for white, the leftmost in a byte's uppermost */
};

/* Rows of a display that the caller owns; those of MIEN_MONO begin on whole bytes. */
typedef struct mien_device_pixels {
  uint32_t size;  /* sizeof(mien_device_pixels) */
  int32_t format; /* MIEN_RGB565 ... MIEN_MONO */
  void* data;     /* aligned for 16 bits where the format has 16 */
  size_t bytes;   /* how many there are from `data` on: nothing is written beyond */
  size_t stride;  /* [bytes] from one row to the next */
} mien_device_pixels;
MIEN_C_API void mien_device_pixels_init(mien_device_pixels* pixels, size_t size);

/* Draws what mien_render draws, in bands: the whole picture is never held in any other format. With view.dither, levels of
 * MIEN_RGB565 and MIEN_MONO are rounded by an ordered dither of 8 x 8 pixels whose mean is right to 1/128 of a step:
 * between sRGB-encoded levels, and between black and white in linear light. */
MIEN_C_API mien_status mien_render_for_device(const mien_scene* scene, const mien_view* view,
                                              const mien_device_pixels* pixels,
                                              const mien_render_options* options,
                                              mien_error** error);

/* The work that the renderer's last picture took. Regions of other pictures do not count. */
typedef struct mien_render_stats {
  uint32_t size;           /* sizeof(mien_render_stats) */
  int32_t cancelled;       /* whether it was stopped */
  int64_t pixels;          /* drawn */
  int64_t fill_pixels;     /* in runs of one colour */
  int64_t varied_pixels;   /* in runs of a colour that varies */
  int64_t edge_pixels;     /* crossed by visible outlines */
  int64_t resolved_pixels; /* of these, resolved by distances: nothing else was proven */
  int64_t recalled_pixels; /* copied from the frame before */
  int64_t pieces;          /* of outline */
  int64_t crossings;       /* of those pieces with each other */
  int64_t regions;         /* different sets of outlines that places are inside of */
  int64_t doubts;          /* places where the order of outlines could not be proven */
  int64_t roots;           /* solved, where visible pieces meet rows and columns of pixels */
  int64_t distances;       /* solved for light and for gradients along a distance */
  double root_seconds;     /* time of the roots, with summing, over all threads [s] */
  double distance_seconds; /* time of means by distances, light included, over all threads [s] */
  int64_t steps;           /* of work */
  int64_t memory;          /* [bytes] that outlines, their order and regions held at most */
} mien_render_stats;

/* `out->size` is set by the caller. All is 0 before the first picture. */
MIEN_C_API mien_status mien_renderer_stats(const mien_renderer* renderer, mien_render_stats* out,
                                           mien_error** error);

/* How a picture is drawn, as a picture. */
enum {
  MIEN_DEBUG_OUTLINES = 0,  /* every piece of outline, each outline in its colour */
  MIEN_DEBUG_REGIONS = 1,   /* areas between outlines, each in its colour */
  MIEN_DEBUG_FRAGMENTS = 2, /* visible stretches of outline, brighter where colours change more */
  MIEN_DEBUG_LOOKS = 3,     /* regions that look alike share a colour */
  MIEN_DEBUG_DISTANCE =
      4,                 /* to the nearest layer: blue inside, orange outside, lines every 10 px */
  MIEN_DEBUG_NORMALS = 5 /* of reliefs; all else is level */
};

/* Draws one of them into pixels of MIEN_U8. The share that `progress` is told stays 0. NULL options are the defaults. */
MIEN_C_API mien_status mien_debug_picture(const mien_scene* scene, const mien_view* view,
                                          int32_t which, const mien_pixels* pixels,
                                          const mien_render_options* options, mien_error** error);

/* The scene as an SVG file, of lines and parabolas that leave the outlines by `tolerance` [px] at most, 1e-4 ... 1;
 * 0 is 0.006. A list of texts: the file's, and a sentence for each thing that SVG cannot show, with its layer. The view's
 * size, fit, background and legibility count; colours are mixed as SVG viewers do, as encoded. `id_prefix`, which may be
 * empty, begins all ids, so that several pictures can stand in one page; NULL of length 0: one made of the picture, so that
 * only equal pictures share ids. Of the options, which may be NULL, `progress`, `most_steps` and `most_memory` count. */
MIEN_C_API mien_status mien_svg(const mien_scene* scene, const mien_view* view, double tolerance,
                                const char* id_prefix, size_t length,
                                const mien_render_options* options, mien_texts** out,
                                mien_error** error);

/* Where a point of the picture [px] is in the face [face units], and back. */
MIEN_C_API mien_status mien_face_from_pixel(const mien_scene* scene, const mien_view* view,
                                            double x, double y, double out[2], mien_error** error);
MIEN_C_API mien_status mien_pixel_from_face(const mien_scene* scene, const mien_view* view,
                                            double x, double y, double out[2], mien_error** error);

/* A picture to be drawn piece by piece, as tiles of a viewer or strips of a file: its outlines are made once.
 * The view's region does not count. Options may be NULL: `progress`, whose share stays 0, may cancel the making of
 * outlines; the limits hold for it and for each piece. */
MIEN_C_API mien_status mien_pieces_new(const mien_scene* scene, const mien_view* view,
                                       int32_t depth, const mien_render_options* options,
                                       mien_pieces** out, mien_error** error);
MIEN_C_API void mien_pieces_free(mien_pieces* pieces);

/* Draws the piece x, y, width, height [px], with the bytes of the whole picture. Threads may draw pieces of one
 * picture at the same time. `stop` is asked every few rows, and may be NULL; anything but 0 stops. */
MIEN_C_API mien_status mien_pieces_draw(mien_pieces* pieces, const int32_t piece[4],
                                        const mien_pixels* pixels, int32_t (*stop)(void* data),
                                        void* data, mien_error** error);

/* ---- Effects ------------------------------------------------------------------------------------ */

/* Effects on a finished picture, in order (docs/effects.md); none at first. They never change what has been
 * drawn: each function below makes another picture. */
MIEN_C_API mien_status mien_effects_new(mien_effects** out, mien_error** error);

/* Those that the face's file asks for. */
MIEN_C_API mien_status mien_effects_of_face(const mien_face* face, mien_effects** out,
                                            mien_error** error);
MIEN_C_API void mien_effects_free(mien_effects* effects);

/* Adds one: "mosaic:24,0.3", "grid:12,1.5,#ffffff80". */
MIEN_C_API mien_status mien_effects_add(mien_effects* effects, const char* text, size_t length,
                                        mien_error** error);
MIEN_C_API int32_t mien_effects_count(const mien_effects* effects);

/* mien_render, and then the effects, before colours are rounded to the pixels' depth. A region has the bytes of
 * the whole picture with effects, which is drawn down to the region's last row, in strips. MIEN_REFUSED: more
 * tiles or cells than pixels across, lines wider than cells. Without effects that change the picture it is
 * mien_render's. */
MIEN_C_API mien_status mien_render_with_effects(mien_renderer* renderer, const mien_scene* scene,
                                                const mien_view* view, const mien_effects* effects,
                                                const mien_pixels* pixels,
                                                const mien_render_options* options,
                                                mien_error** error);

/* The effects on a picture of one's own. `from` is MIEN_F32 and width x height, 1 ... 2^20 each; `to` holds as many
 * pixels at any depth, and is not `from`. */
MIEN_C_API mien_status mien_apply_effects(const mien_effects* effects, const mien_pixels* from,
                                          const mien_pixels* to, int32_t width, int32_t height,
                                          mien_error** error);

/* ---- Distances --------------------------------------------------------------------------------- */

/* d[i] = the distance from (x[i], y[i]) to a curve or outline, in the units of the coordinates, for `count`
 * points, in SIMD. d may be x or y; no other overlap is allowed. A coordinate that is NaN or infinite gives
 * +infinity. Error bounds: docs/numerics.md.
 *
 *   quad      a quadratic Bezier curve: x0, y0, x1, y1, x2, y2
 *   cubic     a cubic Bezier curve: x0, y0, x1, y1, x2, y2, x3, y3
 *   ellipse   signed, negative inside: centre x, y; radii a, b; the direction of a, x, y, of any length
 *   parabola  signed, negative on the inner side: vertex x, y; axis x, y, of any length, into the inside; bend: the
 *             parabola is vertex + u (axis turned left) + bend u^2 axis, for an axis of length 1
 *   tapered   signed, a stroke along a quadratic Bezier curve: its six numbers, then three half-widths, the
 *             Bernstein coefficients of the half-width along it
 *
 * MIEN_REFUSED: a negative radius or half-width, a direction or axis of no length. */
MIEN_C_API mien_status mien_distances_quad_f32(const double curve[6], const float* x,
                                               const float* y, float* d, size_t count,
                                               mien_error** error);
MIEN_C_API mien_status mien_distances_quad_f64(const double curve[6], const double* x,
                                               const double* y, double* d, size_t count,
                                               mien_error** error);
MIEN_C_API mien_status mien_distances_cubic_f32(const double curve[8], const float* x,
                                                const float* y, float* d, size_t count,
                                                mien_error** error);
MIEN_C_API mien_status mien_distances_cubic_f64(const double curve[8], const double* x,
                                                const double* y, double* d, size_t count,
                                                mien_error** error);
MIEN_C_API mien_status mien_distances_ellipse_f32(const double ellipse[6], const float* x,
                                                  const float* y, float* d, size_t count,
                                                  mien_error** error);
MIEN_C_API mien_status mien_distances_ellipse_f64(const double ellipse[6], const double* x,
                                                  const double* y, double* d, size_t count,
                                                  mien_error** error);
MIEN_C_API mien_status mien_distances_parabola_f32(const double side[5], const float* x,
                                                   const float* y, float* d, size_t count,
                                                   mien_error** error);
MIEN_C_API mien_status mien_distances_parabola_f64(const double side[5], const double* x,
                                                   const double* y, double* d, size_t count,
                                                   mien_error** error);
MIEN_C_API mien_status mien_distances_tapered_f32(const double stroke[9], const float* x,
                                                  const float* y, float* d, size_t count,
                                                  mien_error** error);
MIEN_C_API mien_status mien_distances_tapered_f64(const double stroke[9], const double* x,
                                                  const double* y, double* d, size_t count,
                                                  mien_error** error);

/* To a quadratic Bezier curve, almost as if computed in double precision and rounded once. */
MIEN_C_API mien_status mien_distances_quad_accurate_f32(const double curve[6], const float* x,
                                                        const float* y, float* d, size_t count,
                                                        mien_error** error);

/* To the nearest of `curve_count` quadratic Bezier curves, of six numbers each; +infinity if there are none. */
MIEN_C_API mien_status mien_distances_quads_f32(const double* curves, size_t curve_count,
                                                const float* x, const float* y, float* d,
                                                size_t count, mien_error** error);

/* From the points of a grid, d[j columns + i] from (x + i step, y + j step), each rounded to float: quickest where
 * the grid is fine compared with the curve. d has columns * rows numbers. */
MIEN_C_API mien_status mien_distances_quad_on_grid_f32(const double curve[6], double x, double y,
                                                       double step, size_t columns, size_t rows,
                                                       float* d, mien_error** error);

/* Feet: where on curves the nearest point lies, in which direction, and the runner-up; <mien/feet.h> says what each
 * figure is. Each array has `count` numbers; what is NULL is not written. Set by mien_feet_init, with the struct's size. */
typedef struct mien_feet {
  uint32_t size;    /* sizeof(mien_feet) */
  int32_t reserved; /* 0 */
  int32_t* piece;   /* the curve's index; -1: there is none, and the distance is +infinity */
  double* t;        /* 0 to 1 along it; of an ellipse the angle of the parameter [rad] */
  double* distance; /* as mien_distances_... have it */
  double* normal_x; /* the gradient of the distance, of length 1 */
  double* normal_y;
  double* bend; /* the curvature of the level line there */
} mien_feet;
MIEN_C_API void mien_feet_init(mien_feet* feet, size_t size);

/* From (x[i], y[i]) the nearest foot and the next one, in SIMD, with the same bytes on every machine. Either may be NULL.
 * A curve that begins exactly where the one before ends continues it. Results may not overlap x, y or each other.
 *
 *   quads    curves of six numbers each, as above
 *   lines    x0, y0, x1, y1, half-width
 *   tapered  strokes of nine numbers each, as above
 *   ellipse  as above
 */
MIEN_C_API mien_status mien_feet_quads_f64(const double* curves, size_t curve_count,
                                           const double* x, const double* y, size_t count,
                                           const mien_feet* nearest, const mien_feet* next,
                                           mien_error** error);
MIEN_C_API mien_status mien_feet_lines_f64(const double* lines, size_t line_count, const double* x,
                                           const double* y, size_t count, const mien_feet* nearest,
                                           const mien_feet* next, mien_error** error);
MIEN_C_API mien_status mien_feet_tapered_f64(const double* strokes, size_t stroke_count,
                                             const double* x, const double* y, size_t count,
                                             const mien_feet* nearest, const mien_feet* next,
                                             mien_error** error);
MIEN_C_API mien_status mien_feet_ellipse_f64(const double ellipse[6], const double* x,
                                             const double* y, size_t count,
                                             const mien_feet* nearest, const mien_feet* next,
                                             mien_error** error);

#ifdef __cplusplus
}
#endif
#endif
