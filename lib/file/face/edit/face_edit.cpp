#include <mien/face_edit.h>
#include <mien/face_model.h>
#include <mien/pose.h>
#include "lib/base/memory_ran_out.h"

#include "lib/base/one_line.h"
#include "lib/file/face/placed_face_private.h"
#include "lib/file/json/json_text.h"
#include "lib/file/json/read_bytes.h"
#include "written_slice_private.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <map>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>

namespace mien {
namespace {

/// Where changes go: into the numbers that a slice stands in, if it stands there alone, or if both sides that stand there
/// change alike; else into an object of its side, which gets a copy of the member ("spine") that the slice is in.
class Editing {
 public:
  Editing(std::string_view text, const PlacedFace& of)
      : text_(text), edits_(text), of_(of), wanted_(of.face.vector) {
    std::unordered_map<std::int32_t, int> seen;  // slices by their nodes
    partners_.assign(of.places.size(), -1);
    for (int slice = 0; slice < int(of.places.size()); ++slice) {
      if (place(slice).node < 0) continue;
      const auto [other, first] = seen.emplace(place(slice).node, slice);
      if (first) continue;
      partners_[std::size_t(slice)] = other->second;
      partners_[std::size_t(other->second)] = slice;
    }
  }

  /// Takes a setting in.
  Expected<Done> set(const std::string& text) {
    const auto setting = read_setting(of_.face, text);
    if (!setting) return setting.error();
    const int slice = setting->control ? -1 : slice_with(setting->index);
    if (slice < 0 || place(slice).node < 0) {
      const std::string name = text.substr(0, text.find('='));
      if (std::find(left_.begin(), left_.end(), name) == left_.end()) left_.push_back(name);
    } else {
      std::copy(setting->values.begin(), setting->values.end(), wanted_.begin() + setting->index);
    }
    return Done{};
  }

  EditedFace edited() {
    apply_rules(layout(), of_.face.vector, wanted_);
    in_file_ = wanted_;
    const FaceVector& mood = of_.face.model->mood_shift;
    for (std::size_t i = 0; i < mood.size(); ++i) in_file_[i] -= mood[i];
    std::map<std::int32_t, std::vector<int>> shared;  // by the member that both sides read
    for (int slice = 0; slice < int(of_.places.size()); ++slice) {
      if (!is_changed(slice)) continue;
      if (partner(slice) < 0)
        write(slice);
      else
        shared[of_.tree.index(member_with(slice))].push_back(slice);
    }
    for (const auto& [member, slices] : shared) write_shared(slices);
    for (const auto& [owner, members] : own_)
      insert_own(*of_.tree.at(owner.first), owner.second, members);
    return {edits_.text(), left_};
  }

 private:
  const Layout& layout() const { return of_.face.model->layout; }
  const SlicePlace& place(int slice) const { return of_.places[std::size_t(slice)]; }
  int partner(int slice) const { return partners_[std::size_t(slice)]; }
  const JsonNode& node(int slice) const { return *of_.tree.at(place(slice).node); }

  /// The slice that a number of the vector is in.
  int slice_with(int number) const {
    const auto& slices = layout().slices();
    const auto after = std::upper_bound(slices.begin(), slices.end(), number,
                                        [](int n, const Slice& slice) { return n < slice.begin; });
    return int(after - slices.begin()) - 1;
  }

  std::span<const double> values(const FaceVector& vector, int slice) const {
    const Slice& of = layout()[slice];
    return std::span(vector).subspan(std::size_t(of.begin), std::size_t(of.size));
  }
  bool is_changed(int slice) const {
    const auto now = values(wanted_, slice), before = values(of_.face.vector, slice);
    return place(slice).node >= 0 && !std::equal(now.begin(), now.end(), before.begin());
  }

  /// The numbers of the file, where it writes the slice; none: they would not read back exactly.
  std::optional<std::vector<double>> written(int slice) const {
    const auto now = values(in_file_, slice);
    if (!place(slice).mirrored) return std::vector(now.begin(), now.end());
    return written_mirrored(layout()[slice].kind, now, of_.face.model->canvas.twice_axis());
  }

  /// "left" or "right", of "brow.left/spine/1".
  std::string_view side(int slice) const {
    const std::string_view name = layout()[slice].name, owner = name.substr(0, name.find('/'));
    return owner.ends_with(".left") ? "left" : owner.ends_with(".right") ? "right" : "";
  }
  /// "spine" of the feature: what an object of one side can say instead.
  const JsonNode& member_with(int slice) const {
    constexpr std::size_t kDepth = 3;  // the file, its features, one of them, its member
    std::vector<const JsonNode*> way;
    for (const JsonNode* at = &node(slice); at; at = of_.tree.at(at->parent)) way.push_back(at);
    return *way[way.size() - 1 - kDepth];
  }

  /// In place, if it can be said there.
  void write(int slice) {
    if (const auto numbers = written(slice))
      write_slice(of_.tree, node(slice), layout()[slice], *numbers, edits_);
    else
      give_own(slice);
  }

  /// Slices of one member, which their partners read, too. The first of two is the one that the file's numbers are for.
  void write_shared(const std::vector<int>& slices) {
    const auto is_first = [&](int slice) { return slice < partner(slice); };
    const auto first = std::find_if(slices.begin(), slices.end(), is_first);
    const auto second = std::find_if_not(slices.begin(), slices.end(), is_first);
    if (std::all_of(slices.begin(), slices.end(), [&](int s) { return is_image(s); }))
      return write_all(slices, is_first);
    give_own(second == slices.end() ? *first : *second);
    if (second != slices.end()) write_all(slices, is_first);
  }
  template <class Wanted>
  void write_all(const std::vector<int>& slices, const Wanted& is_wanted) {
    for (const int slice : slices)
      if (is_wanted(slice)) write(slice);
  }
  /// Whether both sides say the same of the file's numbers.
  bool is_image(int slice) const {
    const auto one = written(slice), other = written(partner(slice));
    return one && other && *one == *other;
  }

  /// Writes the slice's member once more, for its side alone.
  void give_own(int slice) {
    const JsonNode& member = member_with(slice);
    const std::size_t begin = member.offset, end = json_end(text_, begin);
    TextEdits copy(text_);
    for (int other = 0; other < int(of_.places.size()); ++other)
      if (place(other).node >= 0 && side(other) == side(slice) && node(other).offset >= begin &&
          node(other).offset < end)
        write_slice(of_.tree, node(other), layout()[other], values(in_file_, other), copy);
    std::string& members = own_[{member.parent, side(slice)}][of_.tree.index(member)];
    members = fmt::format("{}: {}", json_string(of_.tree.key(member)), copy.text(begin, end));
  }

  using Members = std::map<std::int32_t, std::string>;  ///< by those that they are instead of
  void insert_own(const JsonNode& owner, std::string_view side, const Members& members) {
    std::string list;
    for (const auto& [instead, text] : members) list += (list.empty() ? "" : ", ") + text;
    if (const JsonNode* own = of_.tree.member(owner, side))
      insert(*own, list);
    else
      insert(owner, fmt::format("\"{}\": {{{}}}", side, list));
  }
  /// After the object's last member, set off from it as it is from what is before it.
  void insert(const JsonNode& object, const std::string& members) {
    const JsonNode* last = of_.tree.first(object);
    if (!last) return edits_.insert(object.offset + 1, members);
    while (const JsonNode* next = of_.tree.next(*last)) last = next;
    const std::size_t key = last->key_offset,
                      before = text_.find_last_not_of(" \t\n\r", key - 1) + 1;
    const std::string_view gap = before == key ? " " : text_.substr(before, key - before);
    edits_.insert(json_end(text_, last->offset), fmt::format(",{}{}", gap, members));
  }

  std::string_view text_;
  TextEdits edits_;
  const PlacedFace& of_;
  FaceVector wanted_, in_file_;  ///< at rest; without the face's mood, as the file has them
  std::vector<int> partners_;    ///< per slice: the other side's that stands there, too; −1: none
  std::vector<std::string> left_;
  std::map<std::pair<std::int32_t, std::string_view>, Members> own_;  ///< by feature, and side
};

Expected<EditedFace> edit(std::string_view text, const std::vector<std::string>& settings,
                          std::string_view name, const std::filesystem::path* folder,
                          const FaceLimits& limits, const Letters& letters) {
  const auto read = read_placed_face(text, name, folder, limits, letters);
  if (!read) return read.error();
  Editing editing(text, *read);
  for (const std::string& setting : settings)
    if (const auto done = editing.set(setting); !done) return done.error();
  EditedFace edited = editing.edited();
  if (edited.text == text) return edited;
  if (const auto again = read_placed_face(edited.text, name, folder, limits, letters); !again)
    return again.error();
  return edited;
}

}  // namespace

Expected<EditedFace> edit_face_text(std::string_view text, const std::vector<std::string>& settings,
                                    std::string_view name, const FaceLimits& limits,
                                    const Letters& letters) try {
  return edit(text, settings, name, nullptr, limits, letters);
} catch (const std::bad_alloc&) {
  return memory_ran_out(name);
}

Expected<EditedFace> edit_face(const std::filesystem::path& path,
                               const std::vector<std::string>& settings, const FaceLimits& limits,
                               const Letters& letters) try {
  try {
    const auto text = read_bytes(path, limits.bytes);
    if (!text) return text.error();
    const std::filesystem::path folder = path.parent_path();
    return edit(*text, settings, path.string(), &folder, limits, letters);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    return Error{{}, fmt::format("cannot read the face: {}", one_line(e.what()))};
  }
} catch (const std::bad_alloc&) {
  return memory_ran_out(path.native());
}

}  // namespace mien
