// The structs that are meant for designated initialisers, each with one member named: compiled, and nothing else, under
// a strict project's warnings.

#include <mien/mien.h>
#include <mien/pca.h>
#include <mien/svg.h>
#include <mien/write.h>

mien::View view_of_a_width() {
  return {.width = 640};
}
mien::RenderOptions options_of_a_thread() {
  return {.threads = {.count = 1}};
}
mien::Pose pose_of_a_time() {
  return {.time = 1.25};
}
mien::SvgOptions svg_of_a_width() {
  return {.width = 640};
}
mien::WriteOptions write_of_a_recipe() {
  return {.recipe = "a test"};
}
mien::PictureOptions picture_of_a_depth() {
  return {.depth = mien::Depth::u16};
}
mien::PcaOptions pca_in_single() {
  return {.single = true};
}
