#include "tests/support/pictures/svg_raster.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace mien::test {
namespace {

using Rgba = std::array<double, 4>;  // premultiplied
using Row = std::vector<Rgba>;

struct Point {
  double x, y;
};

/// Lines from top to bottom.
struct Edge {
  double top, bottom, x, slope;
  int turn;
};
struct Edges {
  std::vector<Edge> all;
  std::vector<Edge> near;  ///< those that pass the row of pixels at hand
  bool even_odd = false;

  void line(Point a, Point b) {
    if (a.y == b.y) return;
    const int turn = a.y < b.y ? 1 : -1;
    if (turn < 0) std::swap(a, b);
    all.push_back({a.y, b.y, a.x, (b.x - a.x) / (b.y - a.y), turn});
  }
  void quad(Point a, Point c, Point b) {
    const double bend = std::hypot(a.x - 2 * c.x + b.x, a.y - 2 * c.y + b.y);
    const int n = 1 + int(std::sqrt(bend / 8 / 1e-4));  // a chord is off by bend / (4 n²) at most
    Point from = a;
    for (int i = 1; i <= n; ++i) {
      const double t = double(i) / n, s = 1 - t;
      const Point to = i == n ? b
                              : Point{s * s * a.x + 2 * s * t * c.x + t * t * b.x,
                                      s * s * a.y + 2 * s * t * c.y + t * t * b.y};
      line(from, to);
      from = to;
    }
  }
  void go_to_row(int y) {
    near.clear();
    for (const Edge& e : all)
      if (e.top < y + 1 && e.bottom > y) near.push_back(e);
  }
};

/// Numbers and letters of path data.
class PathReader {
 public:
  explicit PathReader(const std::string& data) : data_(data) {}

  void read(Edges& to) {
    Point start{0, 0}, at{0, 0};
    char command = 0;
    while (more()) {
      if (std::isalpha(static_cast<unsigned char>(data_[at_]))) command = data_[at_++];
      if (command == 'z') {
        to.line(at, start);
        at = start, command = 0;
      } else if (command == 'M') {
        start = at = {number(), number()};
        command = 0;
      } else if (command == 'l') {
        const Point end = beyond(at);
        to.line(at, end);
        at = end;
      } else if (command == 'q') {
        const Point control = beyond(at), end = beyond(at);
        to.quad(at, control, end);
        at = end;
      } else {
        throw std::runtime_error("path data: " + data_.substr(at_, 20));
      }
    }
  }

 private:
  bool more() {
    while (at_ < data_.size() && data_[at_] == ' ') ++at_;
    return at_ < data_.size();
  }
  double number() {
    more();
    std::size_t used = 0;
    const double value = std::stod(data_.substr(at_, 40), &used);
    at_ += used;
    return value;
  }
  Point beyond(Point p) {
    const double x = number();
    return {p.x + x, p.y + number()};
  }

  const std::string& data_;
  std::size_t at_ = 0;
};

double channel(const std::string& hex, std::size_t at) {
  return double(std::stoi(hex.substr(at, 2), nullptr, 16)) / 255;
}
Rgba straight_color(const std::string& hex, double opacity) {
  if (hex.size() != 7 || hex[0] != '#') throw std::runtime_error("a colour: " + hex);
  return {channel(hex, 1), channel(hex, 3), channel(hex, 5), opacity};
}
Rgba premultiplied(const Rgba& c) {
  return {c[0] * c[3], c[1] * c[3], c[2] * c[3], c[3]};
}

struct Server {
  bool radial = false;
  double x1 = 0, y1 = 0, x2 = 0, y2 = 0, cx = 0, cy = 0, r = 0;
  std::array<double, 6> matrix{1, 0, 0, 1, 0, 0};
  std::string spread;
  std::vector<std::pair<double, Rgba>> stops;

  Rgba at(Point p) const {
    const auto& [a, b, c, d, e, f] = matrix;
    const double det = a * d - b * c, u = p.x - e, v = p.y - f;
    const Point q{(d * u - c * v) / det, (a * v - b * u) / det};
    const double wx = x2 - x1, wy = y2 - y1;
    double t = radial ? std::hypot(q.x - cx, q.y - cy) / r
                      : ((q.x - x1) * wx + (q.y - y1) * wy) / (wx * wx + wy * wy);
    if (spread == "repeat") t -= std::floor(t);
    if (spread == "reflect") t = 1 - std::abs(std::fmod(std::abs(t), 2.0) - 1);
    std::size_t i = 0;
    while (i < stops.size() && stops[i].first <= t) ++i;
    if (i == 0) return premultiplied(stops.front().second);
    if (i == stops.size()) return premultiplied(stops.back().second);
    const auto& [from, low] = stops[i - 1];
    const auto& [to, high] = stops[i];
    Rgba mixed{};
    for (std::size_t k = 0; k < 4; ++k)
      mixed[k] = low[k] + (t - from) / (to - from) * (high[k] - low[k]);
    return premultiplied(mixed);
  }
};

struct Shown {
  enum class Kind { fill, group } kind = Kind::fill;
  std::shared_ptr<Edges> edges;
  Rgba color{};
  const Server* server = nullptr;
  const Edges* clip = nullptr;
  double opacity = 1;
  std::string mode = "normal";
  bool apart = false;  ///< a group that is composited first
  std::vector<Shown> children;
};

class Raster {
 public:
  explicit Raster(const SvgElement& root) {
    known(root, "svg", {"xmlns", "width", "height", "viewBox", "fill-rule", "clip-rule", "style"});
    made_.width = int(root.number("width")), made_.height = int(root.number("height"));
    if (root.get("viewBox") != "0 0 " + root.get("width") + " " + root.get("height"))
      throw std::runtime_error("viewBox " + root.get("viewBox"));
    even_odd_ = root.get("fill-rule") == "evenodd";
    if (even_odd_ != (root.get("clip-rule") == "evenodd")) throw std::runtime_error("two rules");
    for (const SvgElement& child : root.children)
      if (child.tag == "defs")
        for (const SvgElement& one : child.children) define(one);
    for (const SvgElement& child : root.children)
      if (child.tag != "defs" && child.tag != "title" && child.tag != "metadata")
        shown_.push_back(shown(child));
  }

  SvgRaster draw() {
    const auto w = std::size_t(made_.width);
    made_.pixels.assign(w * std::size_t(made_.height), SvgPixel{});
    Row row(w);
    for (int y = 0; y < made_.height; ++y) {
      for (Edges* edges : every_) edges->go_to_row(y);
      for (auto& [id, edges] : clips_) edges.go_to_row(y);
      for (int k = 0; k < kSvgSamples; ++k) {
        y_ = y + (k + 0.5) / kSvgSamples;
        shift_ = std::fmod(double(k) * kSvgStride + 0.5, kSvgSamples) / kSvgSamples;
        std::fill(row.begin(), row.end(), Rgba{});
        for (const Shown& one : shown_) lay(one, row);
        for (std::size_t x = 0; x < w; ++x)
          for (std::size_t c = 0; c < 4; ++c)
            made_.pixels[std::size_t(y) * w + x][c] += row[x][c] / kSvgSamples;
      }
    }
    for (SvgPixel& p : made_.pixels)
      for (std::size_t c = 0; c < 3; ++c) p[c] = p[3] > 0 ? p[c] / p[3] : 0;
    return std::move(made_);
  }

 private:
  static void known(const SvgElement& e, const std::string& tag,
                    const std::vector<std::string>& names) {
    if (e.tag != tag) throw std::runtime_error("expected " + tag + ", got " + e.tag);
    for (const auto& [name, value] : e.attributes)
      if (std::find(names.begin(), names.end(), name) == names.end())
        throw std::runtime_error(tag + " has " + name);
  }

  void define(const SvgElement& e) {
    const std::string id = e.get("id");
    if (e.tag == "clipPath") {
      known(e, "clipPath", {"id"});
      Edges& edges = clips_[id];
      edges.even_odd = even_odd_;
      for (const SvgElement& path : e.children) {
        known(path, "path", {"d"});
        PathReader(path.get("d")).read(edges);
      }
      return;
    }
    Server& made = servers_[id];
    made.radial = e.tag == "radialGradient";
    known(e, made.radial ? "radialGradient" : "linearGradient",
          made.radial ? std::vector<std::string>{"id", "gradientUnits", "cx", "cy", "r",
                                                 "spreadMethod", "gradientTransform"}
                      : std::vector<std::string>{"id", "gradientUnits", "x1", "y1", "x2", "y2",
                                                 "spreadMethod"});
    if (e.get("gradientUnits") != "userSpaceOnUse") throw std::runtime_error("gradientUnits");
    made.x1 = e.number("x1"), made.y1 = e.number("y1"), made.x2 = e.number("x2");
    made.y2 = e.number("y2"), made.cx = e.number("cx"), made.cy = e.number("cy");
    made.r = e.number("r"), made.spread = e.get("spreadMethod", "pad");
    if (const std::string text = e.get("gradientTransform"); !text.empty()) {
      std::istringstream in(text.substr(std::string("matrix(").size()));
      for (double& v : made.matrix) in >> v;
    }
    for (const SvgElement& stop : e.children) {
      known(stop, "stop", {"offset", "stop-color", "stop-opacity"});
      made.stops.emplace_back(
          stop.number("offset"),
          straight_color(stop.get("stop-color"), stop.number("stop-opacity", 1)));
    }
    if (made.stops.empty()) throw std::runtime_error("a gradient without stops");
  }

  static std::string reference(const std::string& text) {
    if (!text.starts_with("url(#") || text.back() != ')') throw std::runtime_error("url: " + text);
    return text.substr(5, text.size() - 6);
  }

  Shown shown(const SvgElement& e) {
    Shown made;
    if (const std::string clip = e.get("clip-path"); !clip.empty())
      made.clip = &clips_.at(reference(clip));
    if (e.tag == "g") {
      known(e, "g", {"id", "data-name", "opacity", "style", "clip-path"});
      made.kind = Shown::Kind::group;
      made.opacity = e.number("opacity", 1);
      const std::string style = e.get("style");
      if (style.starts_with("mix-blend-mode:"))
        made.mode = style.substr(15);
      else if (!style.empty() && style != "isolation:isolate")
        throw std::runtime_error("style " + style);
      made.apart = made.opacity < 1 || !style.empty() || made.clip;
      for (const SvgElement& child : e.children) made.children.push_back(shown(child));
      return made;
    }
    made.edges = std::make_shared<Edges>();
    made.edges->even_odd = even_odd_;
    if (e.tag == "rect") {
      known(e, "rect", {"x", "y", "width", "height", "fill", "fill-opacity"});
      const double x = e.number("x"), y = e.number("y"), r = x + e.number("width"),
                   b = y + e.number("height");
      made.edges->line({x, y}, {x, b});
      made.edges->line({r, b}, {r, y});
    } else {
      known(e, "path", {"id", "data-name", "d", "fill", "fill-opacity", "clip-path"});
      PathReader(e.get("d")).read(*made.edges);
    }
    every_.push_back(made.edges.get());
    const std::string fill = e.get("fill");
    if (fill.starts_with("url"))
      made.server = &servers_.at(reference(fill));
    else
      made.color = premultiplied(straight_color(fill, e.number("fill-opacity", 1)));
    return made;
  }

  /// The samples of the row at hand that are inside, as ranges.
  std::vector<std::pair<int, int>> spans(const Edges& edges) const {
    if (edges.near.empty()) return {};
    std::vector<std::pair<double, int>>& met = met_;
    met.clear();
    for (const Edge& e : edges.near)
      if (e.top <= y_ && y_ < e.bottom) met.emplace_back(e.x + (y_ - e.top) * e.slope, e.turn);
    std::sort(met.begin(), met.end());
    std::vector<std::pair<int, int>> found;
    int winding = 0;
    for (std::size_t i = 0; i + 1 < met.size(); ++i) {
      winding += met[i].second;
      if (edges.even_odd ? !(winding & 1) : !winding) continue;
      const auto first = [&](double x) {
        return int(std::clamp(std::ceil(x - shift_), 0.0, double(made_.width)));
      };
      const int from = first(met[i].first), to = first(met[i + 1].first);
      if (from < to) found.emplace_back(from, to);
    }
    return found;
  }

  static Rgba over(const Rgba& top, const Rgba& below, const std::string& mode) {
    Rgba made{};
    for (std::size_t c = 0; c < 4; ++c) {
      const double s = top[c], b = below[c], as = top[3], ab = below[3];
      if (c == 3 || mode == "normal")
        made[c] = s + b * (1 - as);
      else if (mode == "multiply")
        made[c] = s * (1 - ab) + b * (1 - as) + s * b;
      else if (mode == "screen")
        made[c] = s + b - s * b;
      else
        throw std::runtime_error("mode " + mode);
    }
    return made;
  }

  void lay(const Shown& one, Row& row) {
    if (one.kind == Shown::Kind::group && !one.apart) {
      for (const Shown& child : one.children) lay(child, row);
      return;
    }
    if (one.kind == Shown::Kind::group) {
      Row own(row.size(), Rgba{});
      for (const Shown& child : one.children) lay(child, own);
      each_unclipped(one, 0, int(row.size()), [&](std::size_t x) {
        for (double& c : own[x]) c *= one.opacity;
        row[x] = over(own[x], row[x], one.mode);
      });
      return;
    }
    for (const auto& [from, to] : spans(*one.edges))
      each_unclipped(one, from, to, [&](std::size_t x) {
        const Rgba color = one.server ? one.server->at({double(x) + shift_, y_}) : one.color;
        row[x] = over(color, row[x], "normal");
      });
  }

  template <class Work>
  void each_unclipped(const Shown& one, int from, int to, const Work& work) const {
    const std::vector<std::pair<int, int>> all{{0, made_.width}};
    for (const auto& [a, b] : one.clip ? spans(*one.clip) : all)
      for (int x = std::max(a, from); x < std::min(b, to); ++x) work(std::size_t(x));
  }

  SvgRaster made_;
  bool even_odd_ = false;
  std::map<std::string, Edges> clips_;
  std::map<std::string, Server> servers_;
  std::vector<Shown> shown_;
  std::vector<Edges*> every_;
  mutable std::vector<std::pair<double, int>> met_;  ///< scratch
  double y_ = 0, shift_ = 0;
};

}  // namespace

SvgRaster svg_raster(const SvgElement& root) {
  return Raster(root).draw();
}

}  // namespace mien::test
