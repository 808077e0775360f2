// Any bytes at all are edited as a face file: refused with one sentence, or a face whose values are those that were asked for.

#include <mien/face_edit.h>
#include <mien/face_file.h>
#include <mien/face_model.h>
#include <mien/face_pointers.h>
#include <mien/pose.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/faces/box_letters.h"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

/// Every `step`th name of the face, a little off.
std::vector<std::string> settings_of(const mien::Face& face, std::size_t step) {
  std::vector<std::string> settings;
  const auto names = mien::settable_names(face);
  for (std::size_t i = step / 2; i < names.size(); i += step) {
    std::string text = names[i].name;
    char before = '=';
    for (const double value : names[i].value) {
      text.append(1, before).append(std::to_string(value + 0.01 * double(1 + i % 5)));
      before = ',';
    }
    if (mien::read_setting(face, text)) settings.push_back(text);
  }
  return settings;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const mien::FaceLimits limits{.bytes = 1u << 20, .numbers = 10'000, .features = 1'000};
  const mien::Letters letters = mien::test::box_letters();
  const auto untouched = mien::edit_face_text(text, {}, "fuzz", limits, letters);
  const auto face = mien::read_face_text(text, "fuzz", limits, nullptr, letters);
  require(bool(untouched) == bool(face));
  if (!face) {
    require(sentence(untouched.error()) == sentence(face.error()));
    return 0;
  }
  require(untouched->text == text);
  const auto pointers = mien::face_pointers(text, "fuzz", limits, letters);
  require(pointers && pointers->size() == mien::settable_names(*face).size());

  const std::vector<std::string> settings = settings_of(*face, 1 + size % 7);
  const auto edited = mien::edit_face_text(text, settings, "fuzz", limits, letters);
  if (!edited) {  // what would become of it is no face
    require(!edited.error().what.empty());
    return 0;
  }
  const auto again = mien::read_face_text(edited->text, "fuzz", limits, nullptr, letters);
  require(again && again->vector.size() == face->vector.size());
  mien::FaceVector wanted = face->vector;
  for (const std::string& setting : settings) {
    const std::string name = setting.substr(0, setting.find('='));
    if (std::find(edited->left.begin(), edited->left.end(), name) != edited->left.end()) continue;
    const auto read = mien::read_setting(*face, setting);
    std::copy(read->values.begin(), read->values.end(), wanted.begin() + read->index);
  }
  mien::apply_rules(face->model->layout, face->vector, wanted);
  for (const mien::Slice& slice : face->model->layout.slices()) {
    if (slice.name.find("/dome/") != std::string::npos) continue;  // follow the eye
    for (std::size_t i = std::size_t(slice.begin); i < std::size_t(slice.begin + slice.size); ++i)
      require(std::abs(again->vector[i] - wanted[i]) <= 1e-12);
  }
  return 0;
}
