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

}  // namespace

void write_controls(const Reading& in, const JsonNode& controls, const PartStyle& style,
                    const RigPlace& place, TreeWriter& to) {
  const JsonNode* all = style.find("controls");
  if (!all) return write_rig(in, controls, place, to);
  to.array();
  in.for_each(controls, [&](const JsonNode& control, int) {
    const JsonNode* more = style.in().find(*all, in.string(in.need(control, "name")));
    if (more)
      write_control(in, control, style.in(), *more, place, to);
    else
      write_rig(in, control, place, to);
  });
  to.close();
}

}  // namespace mien
