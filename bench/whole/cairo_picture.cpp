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

void draw_figure(cairo_t* to, const PeerFigure& figure) {
  cairo_set_source_rgba(to, figure.color.r, figure.color.g, figure.color.b, figure.color.a);
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
