// Morph targets: files of them, and faces that have them as poses.

#include <mien/morph_file.h>
#include "bind/c/door_private.h"
#include "bind/c/handles_private.h"

#include <fmt/format.h>

using namespace mien::c;

extern "C" {

mien_status mien_face_with_morphs(const mien_face* face, const char* path, size_t path_length,
                                  mien_face** out, mien_error** error) {
  return pass("mien_face_with_morphs", error, [&] {
    mien_face*& made = place(out);
    const mien::Face& rest = need(face, "face").face;
    made =
        new mien_face(must(mien::read_morphs(rest, path_of(path, path_length)), MIEN_UNREADABLE));
  });
}

mien_status mien_face_with_morphs_text(const mien_face* face, const char* text, size_t length,
                                       const char* name, size_t name_length, mien_face** out,
                                       mien_error** error) {
  return pass("mien_face_with_morphs_text", error, [&] {
    mien_face*& made = place(out);
    const mien::Face& rest = need(face, "face").face;
    const auto whole = text_of(text, length, "text");
    const auto called = name_of(name, name_length, "morphs");
    made = new mien_face(must(mien::read_morphs_text(rest, whole, called), MIEN_UNREADABLE));
  });
}

mien_status mien_morphs_text(const mien_face* rest, const char* const* names,
                             const mien_face* const* faces, int32_t count, mien_texts** out,
                             mien_error** error) {
  return pass("mien_morphs_text", error, [&] {
    mien_texts*& made = place(out);
    need(rest, "rest");
    if (count < 0) misuse("count", "is " + std::to_string(count));
    if (count > 0) need(names, "names"), need(faces, "faces");
    std::vector<mien::MorphTarget> targets;
    for (int32_t i = 0; i < count; ++i) {
      const mien_face& face = need(faces[i], fmt::format("faces[{}]", i));
      targets.push_back({&need(names[i], fmt::format("names[{}]", i)), face.face});
    }
    made = new_texts({must(mien::morph_text(rest->face, targets), MIEN_REFUSED)});
  });
}
}
