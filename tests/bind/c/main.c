/* Every function of the C interface, used and misused, by a program in C99: mien_c_tests FACE FOLDER */
#include <stdio.h>
#include <string.h>

#include "tests/bind/c/check.h"

int check_failed = 0;
static const char* face_file;

void check(int is_so, const char* what, const char* file, int line) {
  if (is_so) return;
  printf("%s:%d: not so: %s\n", file, line, what);
  ++check_failed;
}

int holds(const char* text, const char* part) {
  return strstr(text, part) != NULL;
}

void check_status(mien_status status, mien_status wanted, mien_error* error, const char* words,
                  const char* file, int line) {
  char said[2000];
  snprintf(said, sizeof said, "%s: %s", mien_error_where(error), mien_error_what(error));
  if (status != wanted || (error != NULL) != (wanted != MIEN_OK)) {
    printf("%s:%d: status %d instead of %d: %s\n", file, line, (int)status, (int)wanted, said);
    ++check_failed;
  } else if (words && !holds(said, words)) {
    printf("%s:%d: \"%s\" does not say %s\n", file, line, said, words);
    ++check_failed;
  }
  mien_error_free(error);
}

const char* face_path(void) {
  return face_file;
}

mien_face* any_face(void) {
  mien_error* error = NULL;
  mien_face* face = NULL;
  OK(mien_face_read(face_file, END, &face, &error));
  return face;
}

mien_scene* any_scene(void) {
  mien_error* error = NULL;
  mien_face* face = any_face();
  mien_pose* pose = NULL;
  mien_scene* scene = NULL;
  OK(mien_pose_new(face, &pose, &error));
  OK(mien_scene_new(pose, &scene, &error));
  mien_pose_free(pose);
  mien_face_free(face);
  return scene;
}

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  face_file = argv[1];
  test_errors();
  test_faces();
  test_face_texts();
  test_people();
  test_poses();
  test_scenes();
  test_pictures();
  test_cancelling();
  test_morphs();
  test_motions();
  test_effects();
  test_bases(argv[2]);
  test_debug();
  test_device();
  test_distances();
  test_feet();
#ifdef MIEN_IMAGE
  test_files(argv[2]);
#endif
  printf("%d not so\n", check_failed);
  return check_failed != 0;
}
