/* A face file in, a still out, in C:   example_still_c faces/toon.face.json toon.png */
#include <mien_image_c.h>
#include <stdio.h>

int main(int argc, char** argv) {
  mien_error* error = NULL;
  mien_face* face = NULL;
  mien_pose* pose = NULL;
  mien_scene* scene = NULL;
  mien_view view;
  if (argc != 3) return 2;

  mien_view_init(&view, sizeof view);
  view.width = 1920, view.height = 1080;
  if (mien_face_read(argv[1], MIEN_NUL_ENDED, &face, &error) ||
      mien_pose_new(face, &pose, &error) || mien_pose_time(pose, 1.25, &error) ||
      mien_scene_new(pose, &scene, &error) ||
      mien_write_picture(scene, &view, argv[2], MIEN_NUL_ENDED, NULL, &error)) {
    fprintf(stderr, "%s: %s\n", mien_error_where(error), mien_error_what(error));
    mien_error_free(error);
    return 1;
  }
  printf("%s: %d layers\n", mien_face_title(face), (int)mien_scene_layer_count(scene));
  mien_scene_free(scene), mien_pose_free(pose), mien_face_free(face);
  return 0;
}
