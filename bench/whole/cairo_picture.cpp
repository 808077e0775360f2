#include "bench/whole/cairo_picture.h"

#include <cairo.h>

namespace mien::bench {
namespace {

void add(cairo_t* to, const PathSteps& steps) {
  for (const PathStep& step : steps) {
    const glm::dvec2* p = step.p;
    switch (step.kind) {
      case PathStep::Kind::move:
        cairo_move_to(to, p[0].x, p[0].y);
        break;
      case PathStep::Kind::line:
        cairo_line_to(to, p[0].x, p[0].y);
        break;
      case PathStep::Kind::cubic:
        cairo_curve_to(to, p[0].x, p[0].y, p[1].x, p[1].y, p[2].x, p[2].y);
        break;
      case PathStep::Kind::close:
        cairo_close_path(to);
        break;
    }
  }
}

void add_ellipse(cairo_t* to, const Ellipse& e) {
  cairo_matrix_t before;
  cairo_get_matrix(to, &before);
  const cairo_matrix_t there{e.radii.x * e.axis.x, e.radii.x * e.axis.y, -e.radii.y * e.axis.y,
                             e.radii.y * e.axis.x, e.center.x,           e.center.y};
  cairo_transform(to, &there);
  cairo_arc(to, 0, 0, 1, 0, 6.283185307179586);
  cairo_close_path(to);
  cairo_set_matrix(to, &before);
}

cairo_extend_t cairo_extend(Extend extend) {
  return extend == Extend::pad      ? CAIRO_EXTEND_PAD
         : extend == Extend::repeat ? CAIRO_EXTEND_REPEAT
                                    : CAIRO_EXTEND_REFLECT;
}

/// The ellipse as the unit circle: the pattern's matrix leads from the picture to it.
cairo_pattern_t* radial_pattern(const PeerGradient& g) {
  cairo_pattern_t* const pattern = cairo_pattern_create_radial(0, 0, 0, 0, 0, 1);
  const glm::dvec2 a = g.axis / g.radii.x, b = glm::dvec2{-g.axis.y, g.axis.x} / g.radii.y;
  const cairo_matrix_t circle_from_picture{
      a.x, b.x, a.y, b.y, -(a.x * g.from.x + a.y * g.from.y), -(b.x * g.from.x + b.y * g.from.y)};
  cairo_pattern_set_matrix(pattern, &circle_from_picture);
  return pattern;
}

void set_gradient(cairo_t* to, const PeerGradient& g) {
  cairo_pattern_t* const pattern =
      g.radii.x > 0 ? radial_pattern(g)
                    : cairo_pattern_create_linear(g.from.x, g.from.y, g.to.x, g.to.y);
  for (const Stop& s : g.stops)
    cairo_pattern_add_color_stop_rgba(pattern, s.at, s.color.r, s.color.g, s.color.b, s.color.a);
  cairo_pattern_set_extend(pattern, cairo_extend(g.extend));
  cairo_set_source(to, pattern);
  cairo_pattern_destroy(pattern);
}

void draw_figure(cairo_t* to, const PeerFigure& figure) {
  const Color& color = figure.color;
  if (figure.gradient)
    set_gradient(to, *figure.gradient);
  else
    cairo_set_source_rgba(to, color.r, color.g, color.b, color.a);
  if (!figure.clips.empty()) cairo_save(to);
  for (const PathSteps& clip : figure.clips) {
    add(to, clip);
    cairo_clip(to);
  }
  if (figure.kind == PeerFigure::Kind::ellipse) {
    add_ellipse(to, figure.ellipse);
    cairo_fill(to);
  } else if (figure.kind == PeerFigure::Kind::stroke) {
    add(to, figure.path);
    cairo_set_line_width(to, figure.width);
    cairo_stroke(to);
  } else {
    add(to, figure.path);
    cairo_set_fill_rule(to, figure.even_odd ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
    cairo_fill(to);
  }
  if (!figure.clips.empty()) cairo_restore(to);
}

}  // namespace

struct CairoPicture::Surface {
  cairo_surface_t* handle;
};

CairoPicture::CairoPicture(const PeerDrawing& drawing, std::uint32_t* pixels)
    : drawing_(drawing),
      surface_(new Surface{cairo_image_surface_create_for_data(
          reinterpret_cast<unsigned char*>(pixels), CAIRO_FORMAT_ARGB32, drawing.width,
          drawing.height, 4 * drawing.width)}) {}

CairoPicture::~CairoPicture() {
  cairo_surface_destroy(surface_->handle);
}

void CairoPicture::draw() {
  cairo_t* const to = cairo_create(surface_->handle);
  const Color& back = drawing_.background;
  cairo_set_source_rgba(to, back.r, back.g, back.b, back.a);
  cairo_paint(to);
  cairo_set_line_cap(to, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(to, CAIRO_LINE_JOIN_ROUND);
  for (const PeerFigure& figure : drawing_.figures) draw_figure(to, figure);
  cairo_destroy(to);
  cairo_surface_flush(surface_->handle);
}

}  // namespace mien::bench
