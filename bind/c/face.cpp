// Faces, their names and numbers.

#include <mien/composed_face.h>
#include <mien/face_file.h>
#include <mien/face_model.h>
#include <mien/motion_length.h>
#include <mien/version.h>
#include "bind/c/door_private.h"
#include "bind/c/handles_private.h"

#include <algorithm>

namespace mien::c {

mien_texts* new_texts(std::vector<std::string> texts) {
  return new mien_texts{std::move(texts)};
}

}  // namespace mien::c

using namespace mien::c;

extern "C" {

uint32_t mien_version(void) {
  return MIEN_VERSION_MAJOR << 16 | MIEN_VERSION_MINOR << 8 | MIEN_VERSION_PATCH;
}
const char* mien_version_text(void) {
  return MIEN_VERSION_STRING;
}
uint32_t mien_abi_version(void) {
  return MIEN_C_ABI;
}

int32_t mien_texts_count(const mien_texts* texts) {
  return texts ? int32_t(texts->all.size()) : 0;
}
const char* mien_texts_at(const mien_texts* texts, int32_t index) {
  const bool there = texts && index >= 0 && std::size_t(index) < texts->all.size();
  return there ? texts->all[std::size_t(index)].c_str() : "";
}
void mien_texts_free(mien_texts* texts) {
  delete texts;
}

mien_status mien_face_read(const char* path, size_t path_length, mien_face** out,
                           mien_error** error) {
  return pass("mien_face_read", error, [&] {
    mien_face*& made = place(out);
    made = new mien_face(must(mien::read_face(path_of(path, path_length)), MIEN_UNREADABLE));
  });
}

mien_status mien_face_read_text(const char* text, size_t length, const char* name,
                                size_t name_length, mien_face** out, mien_error** error) {
  return pass("mien_face_read_text", error, [&] {
    mien_face*& made = place(out);
    const auto whole = text_of(text, length, "text");
    const auto called = name_of(name, name_length, "face");
    made = new mien_face(must(mien::read_face_text(whole, called), MIEN_UNREADABLE));
  });
}

mien_status mien_face_from_code(const char* code, size_t length, mien_face** out,
                                mien_error** error) {
  return pass("mien_face_from_code", error, [&] {
    mien_face*& made = place(out);
    made =
        new mien_face(must(mien::face_from_code(text_of(code, length, "code")), MIEN_UNREADABLE));
  });
}

mien_face* mien_face_retain(mien_face* face) {
  if (face) ++face->owners;
  return face;
}
void mien_face_free(mien_face* face) {
  if (face && --face->owners == 0) delete face;
}

const char* mien_face_title(const mien_face* face) {
  return face ? face->face.model->name.c_str() : "";
}
const char* mien_face_credit(const mien_face* face) {
  return face ? face->face.model->credit.c_str() : "";
}

mien_status mien_face_canvas(const mien_face* face, mien_canvas* out, mien_error** error) {
  return pass("mien_face_canvas", error, [&] {
    const mien::FaceCanvas& canvas = need(face, "face").face.model->canvas;
    const auto& box = canvas.box;
    give_struct(out, mien_canvas{0,
                                 canvas.y_up,
                                 {box.lo.x, box.lo.y, box.hi.x, box.hi.y},
                                 canvas.mirror_x,
                                 canvas.unit.c_str()});
  });
}

int32_t mien_face_name_count(const mien_face* face) {
  if (!face) return 0;
  const mien::FaceModel& model = *face->face.model;
  return int32_t(model.controls.size() + model.layout.slices().size());
}

mien_status mien_face_name_at(const mien_face* face, int32_t index, mien_name* out,
                              mien_error** error) {
  return pass("mien_face_name_at", error, [&] {
    const auto& names = need(face, "face").names();
    const auto at = std::size_t(index_of(index, names.size(), "index"));
    const mien::SettableName& name = names[at];
    const mien::FaceModel& model = *face->face.model;
    const int begin = name.control ? -1 : model.layout[int(at - model.controls.size())].begin;
    give_struct(out, mien_name{0, name.control, name.pose, int32_t(name.value.size()), begin, 0,
                               name.name.c_str(), name.unit.c_str(), name.lo, name.hi});
  });
}

mien_status mien_face_values_at(const mien_face* face, int32_t index, double* values, int32_t count,
                                mien_error** error) {
  return pass("mien_face_values_at", error, [&] {
    const auto& names = need(face, "face").names();
    const auto& rest = names[std::size_t(index_of(index, names.size(), "index"))].value;
    need_count(count, rest.size(), "count");
    if (count > 0) std::copy(rest.begin(), rest.end(), &need(values, "values"));
  });
}

int32_t mien_face_clip_count(const mien_face* face) {
  return face ? int32_t(face->face.model->clips.size()) : 0;
}
const char* mien_face_clip_name(const mien_face* face, int32_t index) {
  if (index < 0 || index >= mien_face_clip_count(face)) return "";
  return face->face.model->clips[std::size_t(index)].name.c_str();
}

double mien_face_clip_length(const mien_face* face, int32_t index) {
  if (index < 0 || index >= mien_face_clip_count(face)) return 0;
  return mien::motion_length(face->face.model->clips[std::size_t(index)]);
}

int32_t mien_face_vector_size(const mien_face* face) {
  return face ? int32_t(face->face.vector.size()) : 0;
}
}
