#include <mien/obj_map.h>
#include "lib/base/memory_ran_out.h"

#include <mien/face_model.h>
#include <mien/morph_file.h>
#include <mien/obj.h>
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/file/json/read_bytes.h"
#include "lib/file/json/reading.h"

#include <fmt/format.h>

#include <cmath>

namespace mien {
namespace {

std::vector<int> read_vertices(const Reading& in, const JsonNode& node) {
  std::vector<int> vertices;
  for (const double number : in.numbers(node, 1, 1 << 20)) {
    if (!(number >= 0 && number < 2e9) || number != std::floor(number))
      in.refuse(node, fmt::format("expected vertices, whole numbers from 0, got {}", number));
    vertices.push_back(int(number));
  }
  return vertices;
}

int point_named(const Reading& in, const JsonNode& node, const Face& face, std::string_view name) {
  const Layout& layout = face.model->layout;
  const int found = layout.find(name);
  if (found >= 0 && layout[found].kind == SliceKind::point) return found;
  std::vector<std::string_view> known;
  for (const Slice& slice : layout.slices())
    if (slice.kind == SliceKind::point) known.push_back(slice.name);
  in.refuse(node, unknown_name("point", name, known));
}

ObjMap read_root(Reading& in, const Face& face) {
  const JsonNode& root = in.tree.root();
  in.expect_object(root, {"format", "format_version", "scale", "points"});
  const JsonNode& format = in.need(root, "format");
  if (in.string(format) != "mien-map")
    in.refuse(format, fmt::format("expected \"mien-map\", got {}", in_quotes(in.string(format))));
  if (const JsonNode& version = in.need(root, "format_version"); in.number(version) != 1)
    in.refuse(version, fmt::format("expected the integer 1, got {}", in.number(version)));
  ObjMap map;
  if (const JsonNode* scale = in.find(root, "scale")) {
    map.scale = in.number(*scale);
    if (!(map.scale > 0)) in.refuse(*scale, "a scale is a positive number");
  }
  const JsonNode& points = in.need(root, "points");
  in.expect(points, JsonKind::object);
  in.for_each(points, [&](const JsonNode& child, int) {
    const std::string_view name = in.tree.key(child);
    if (name != "comment")
      map.bindings.push_back({point_named(in, child, face, name), read_vertices(in, child)});
  });
  if (map.bindings.empty()) in.refuse(points, "expected at least one point");
  return map;
}

glm::dvec2 place(const ObjMap::Binding& binding, const Mesh& mesh, bool y_up) {
  glm::dvec2 sum{0};
  for (const int v : binding.vertices) {
    const glm::dvec3& p = mesh.points[std::size_t(v)];
    sum += glm::dvec2{p.x, y_up ? p.y : -p.y};
  }
  return sum / double(binding.vertices.size());
}

/// The root of the summed squared distances from the mean.
double spread(const std::vector<glm::dvec2>& points) {
  glm::dvec2 middle{0};
  for (const glm::dvec2 p : points) middle += p / double(points.size());
  double sum = 0;
  for (const glm::dvec2 p : points)
    sum += (p.x - middle.x) * (p.x - middle.x) + (p.y - middle.y) * (p.y - middle.y);
  return std::sqrt(sum);
}

Expected<double> scale_of(const Face& face, const ObjMap& map, const Mesh& neutral) {
  if (map.scale > 0) return map.scale;
  std::vector<glm::dvec2> of_face, of_mesh;
  for (const ObjMap::Binding& binding : map.bindings) {
    const auto at = std::size_t(face.model->layout[binding.slice].begin);
    of_face.emplace_back(face.vector[at], face.vector[at + 1]);
    of_mesh.push_back(place(binding, neutral, face.model->canvas.y_up));
  }
  const double mesh_spread = spread(of_mesh), face_spread = spread(of_face);
  if (!(mesh_spread > 0) || !(face_spread > 0))
    return Error{"", "the bound points lie in one place: say a \"scale\" in the map"};
  return face_spread / mesh_spread;
}

}  // namespace

Expected<ObjMap> read_obj_map_text(const Face& face, std::string_view text,
                                   std::string_view name) try {
  const FaceLimits limits;
  try {
    if (text.size() > limits.bytes) return Error{one_line(name), "is too long for a map"};
    const Expected<JsonTree> tree = JsonTree::read(text, name, limits);
    if (!tree) return tree.error();
    Reading in(*tree, limits, nullptr);
    return read_root(in, face);
  } catch (const Refusal& refusal) {
    return refusal.error;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    return Error{one_line(name), fmt::format("cannot be read: {}", one_line(e.what()))};
  }
} catch (const std::bad_alloc&) {
  return memory_ran_out(name);
}

Expected<ObjMap> read_obj_map(const Face& face, const std::filesystem::path& path) try {
  const auto text = read_bytes(path, FaceLimits{}.bytes);
  if (!text) return text.error();
  return read_obj_map_text(face, *text, path.string());
} catch (const std::bad_alloc&) {
  return memory_ran_out(path.native());
}

Expected<std::string> morph_text_from_meshes(
    const Face& face, const ObjMap& map, const Mesh& neutral,
    const std::vector<std::pair<std::string, Mesh>>& targets) try {
  const Layout& layout = face.model->layout;
  for (const ObjMap::Binding& binding : map.bindings)
    for (const int v : binding.vertices)
      if (std::size_t(v) >= neutral.points.size())
        return Error{"",
                     fmt::format("{} is bound to vertex {}, and the mesh has {}",
                                 in_quotes(layout[binding.slice].name), v, neutral.points.size())};
  for (const auto& [name, mesh] : targets)
    if (const auto fits = check_fits(neutral, mesh, name); !fits) return fits.error();
  const auto scale = scale_of(face, map, neutral);
  if (!scale) return scale.error();
  std::vector<MorphTarget> shapes;
  for (const auto& [name, mesh] : targets) {
    Face shape = face;
    for (const ObjMap::Binding& binding : map.bindings) {
      const bool up = face.model->canvas.y_up;
      const glm::dvec2 by = *scale * (place(binding, mesh, up) - place(binding, neutral, up));
      const auto at = std::size_t(layout[binding.slice].begin);
      shape.vector[at] += by.x;
      shape.vector[at + 1] += by.y;
    }
    shapes.push_back({name, std::move(shape)});
  }
  return morph_text(face, shapes);
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

}  // namespace mien
