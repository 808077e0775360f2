#include "lib/parts/compose/style_rig.h"

namespace mien {
namespace {

/// Two objects as one, or two lists.
void write_both(const Reading& in, const JsonNode& first, const Reading& own,
                const JsonNode& second, const RigPlace& place, TreeWriter& to) {
  own.expect(second, first.kind);
  first.kind == JsonKind::array ? to.array() : to.object();
  to.copy_children(in.tree, first,
                   [&](const JsonNode& at) { return write_placed(in, at, place, to); });
  to.copy_children(own.tree, second,
                   [&](const JsonNode& at) { return write_placed(own, at, place, to); });
  to.close();
}

void write_control(const Reading& in, const JsonNode& control, const Reading& own,
                   const JsonNode& more, const RigPlace& place, TreeWriter& to) {
  to.object();
  in.for_each(control, [&](const JsonNode& member, int) {
    const std::string_view key = in.tree.key(member);
    to.key(key);
    if (const JsonNode* added = own.find(more, key))
      write_both(in, member, own, *added, place, to);
    else
      write_rig(in, member, place, to);
  });
  own.for_each(more, [&](const JsonNode& member, int) {
    if (in.find(control, own.tree.key(member))) return;
    to.key(own.tree.key(member)), write_rig(own, member, place, to);
  });
  to.close();
}

/// The slice that a pen multiplies of a feature; empty: none. What is known ahead of its figure has no lines.
std::string_view pen_slice(const Reading& in, const JsonNode& lines, const FlatFeatures::One& one,
                           const RigPlace& place) {
  std::string_view slice;
  if (is_ahead(one)) return slice;
  in.for_each(lines, [&](const JsonNode& line, int) {
    const std::string_view key = in.tree.key(line), role = key.substr(key.find('/') + 1);
    const bool of_slot = role.size() == key.size() ||
                         slot_named(place.library.topology().in(), key.substr(0, key.find('/')),
                                    line, place.library) == one.slot;
    if (of_slot && (one.role == role || one.name == key)) slice = in.string(line);
  });
  return slice;
}

void write_pen(const Reading& in, const JsonNode& pen, const RigPlace& place, TreeWriter& to) {
  to.object();
  to.key("name"), to.string("pen");
  to.key("range"), to.pair({1, in.number(in.need(pen, "most"))});
  to.key("rest"), to.number(1);
  to.key("scale"), to.array();
  for (const FlatFeatures::One& one : place.features.all()) {
    const std::string_view slice = pen_slice(in, in.need(pen, "lines"), one, place);
    if (!slice.empty())
      for (const std::string& name : names_of(one)) to.string(to.kept({name, "/", slice}));
  }
  to.close(), to.close();
}

}  // namespace

void write_controls(const Reading& in, const JsonNode& controls, const PartStyle& style,
                    const RigPlace& place, TreeWriter& to) {
  const JsonNode *all = style.find("controls"), *pen = style.find("pen");
  to.array();
  in.for_each(controls, [&](const JsonNode& control, int) {
    const JsonNode* more =
        all ? style.in().find(*all, in.string(in.need(control, "name"))) : nullptr;
    if (more)
      write_control(in, control, style.in(), *more, place, to);
    else
      write_rig(in, control, place, to);
  });
  if (pen) write_pen(style.in(), *pen, place, to);
  to.close();
}

}  // namespace mien
