/* What the tests of the C interface are written with. */
#ifndef CHECK_H
#define CHECK_H

#include <mien_c.h>

extern int check_failed;

/* Counts and names what is not so. */
void check(int is_so, const char* what, const char* file, int line);
#define CHECK(expression) check((expression) ? 1 : 0, #expression, __FILE__, __LINE__)

/* The status is `wanted`, the error is there only if it is not MIEN_OK and holds `words`; frees the error. */
void check_status(mien_status status, mien_status wanted, mien_error* error, const char* words,
                  const char* file, int line);
#define FAILS(wanted, words, call)                                   \
  do {                                                               \
    const mien_status got = (call);                                  \
    check_status(got, (wanted), error, (words), __FILE__, __LINE__); \
  } while (0)
#define OK(call) FAILS(MIEN_OK, NULL, call)

/* Whether a text holds another. */
int holds(const char* text, const char* part);

/* A face of the repository's, and a scene of it at rest. */
const char* face_path(void);
mien_face* any_face(void);
mien_scene* any_scene(void);

#define END MIEN_NUL_ENDED

void test_errors(void);
void test_faces(void);
void test_face_texts(void);
void test_people(void);
void test_poses(void);
void test_scenes(void);
void test_pictures(void);
void test_cancelling(void);
void test_morphs(void);
void test_motions(void);
void test_effects(void);
void test_bases(const char* folder);
void test_debug(void);
void test_device(void);
void test_distances(void);
void test_feet(void);
#ifdef MIEN_IMAGE
void test_files(const char* folder);
#endif

#endif
