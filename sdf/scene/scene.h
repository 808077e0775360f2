#pragma once
// A picture as data: layers of painted areas, bottom to top, in face units. Immutable once built.
//
//   SceneBuilder build({.canvas = …, .background = …});
//   const Area opening = build.shape(Band{…});
//   build.layer("sclera", opening, {.color = white});
//   build.layer("iris", build.intersect(build.shape(iris), opening), {.color = brown});
//   const Scene scene = std::move(build).finish();
//
// Areas are shared: both layers use the one outline of `opening`, so there is no seam between them.

#include <mien/api.h>
#include <mien/box2.h>
#include <mien/color.h>
#include <mien/mix_mode.h>
#include <mien/op.h>
#include <mien/paint.h>
#include <mien/shape.h>

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace mien {

struct Node {
  Op op;
  int a = -1,
      b = -1;  ///< operands (indices of earlier nodes); for Op::shape `a` is the shape's index
  double amount = 0;  ///< [face units]
};

struct Layer {
  std::string name;  ///< the feature's, as in the face file: "iris.left"
  Area area;
  Paint paint;
  int group = -1;  ///< index into Scene::groups(); −1: none
};

/// Layers that are composited with each other first; the result is then mixed with what is below, with an
/// opacity. What is below a group in a group is what that one has so far. The layers of a group and of its
/// subgroups are consecutive.
struct Group {
  std::string name;
  int parent = -1;     ///< the group it is in; −1: none
  double opacity = 1;  ///< 0 … 1
  MixMode mix = MixMode::normal;
};

struct Canvas {
  Box2 box{{-0.5, -0.5}, {0.5, 0.5}};  ///< what the picture shows, finite and not empty
  bool y_up = true;                    ///< whether larger y is higher in the picture
};

class ShapeDistances;
class ShapeOutlines;

class MIEN_API Scene {
 public:
  const Canvas& canvas() const { return data_->canvas; }
  const Color& background() const { return data_->background; }
  std::span<const Shape> shapes() const { return data_->shapes; }
  std::span<const Node> nodes() const { return data_->nodes; }     ///< operands before users
  std::span<const Layer> layers() const { return data_->layers; }  ///< bottom to top
  std::span<const Group> groups() const { return data_->groups; }  ///< parents first
  const Light& light() const { return data_->light; }

  /// The signed distance of an area by its CSG tree, and what that distance promises.
  double distance(Area area, glm::dvec2 p) const;
  /// The same of one of its shapes. Paths of many sides that are asked often answer in about log n.
  double shape_distance(std::size_t shape, glm::dvec2 p) const;
  Exactness exactness(Area area) const;
  /// What distances to a shape are measured to: the shape itself or, if it is a path filled by the nonzero rule whose
  /// loops overlap, its visible outline. Sides with the inside on both hands are none.
  const Shape& outlined_shape(std::size_t shape) const;
  Box2 bounds(Area area) const;

  /// The scene as text: canvas, shapes, areas and layers, one per line, with numbers in the shortest
  /// exact form.
  std::string text() const;

 private:
  friend class SceneBuilder;
  friend Scene legible_scene(const Scene& scene, double least);
  struct Data {
    Canvas canvas;
    Color background;
    std::vector<Shape> shapes;
    std::vector<Node> nodes;
    std::vector<Layer> layers;
    std::vector<Group> groups;
    Light light;
    std::shared_ptr<const ShapeDistances> asked;
    std::shared_ptr<const ShapeOutlines> outlines;
  };
  std::shared_ptr<const Data> data_ = std::make_shared<const Data>();
};

class MIEN_API SceneBuilder {
 public:
  SceneBuilder(Canvas canvas, Color background);

  /// An empty area if a number of the shape is not finite.
  Area shape(Shape shape);
  Area unite(Area a, Area b);
  Area intersect(Area a, Area b);
  Area subtract(Area a, Area b);
  Area complement(Area a);
  Area offset(Area a, double amount);
  Area shell(Area a, double amount);
  Area everywhere();
  /// The same area elsewhere.
  Area moved(Area a, glm::dvec2 by);

  void layer(std::string name, Area area, Paint paint);

  /// Begins a group; the layers up to the matching close_group belong to it. With a `clip` they are drawn
  /// only inside that area.
  void open_group(std::string name, double opacity, Area clip = {}, MixMode mix = MixMode::normal);
  void close_group();

  void light(const Light& light) { data_.light = light; }
  Scene finish() &&;

 private:
  Area add(Node node);
  struct OpenGroup {
    int group;
    Area clip;  ///< the intersection of all clips so far
  };
  Scene::Data data_;
  std::vector<OpenGroup> open_;
};

}  // namespace mien
