#pragma once
// The muscle law a second time, in another formulation, for tests: the face file is read with a JSON
// library's own tree, points are complex numbers, each side stands alone as in facemotion.js (points
// on the axis are held there), and time goes in tiny steps of the classical Runge-Kutta method.

#include <complex>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace mien::test {

class MuscleReference {
 public:
  using Complex = std::complex<double>;
  using Pulls = std::map<std::string, double>;  ///< of one side
  using PullsAt = std::function<Pulls(double time)>;

  /// The written side (left) of a face whose muscles all have sides.
  explicit MuscleReference(const std::string& path) {
    face_ = nlohmann::json::parse(std::ifstream(path));
    stiffness_ = face_["muscles"]["stiffness"].get<double>();
    damping_ = face_["muscles"]["damping"].get<double>();
    for (const auto& group : face_["muscles"]["groups"])
      for (const auto& [name, weight] : group["attach"].items())
        if (name.find("/points/") != std::string::npos) add(group, name, weight.get<double>());
  }

  /// The mixing law, as facemotion.js goes through it.
  Pulls mix(const std::map<std::string, double>& emotions) const {
    Pulls pulls;
    for (const auto& group : face_["muscles"]["groups"])
      pulls[group["name"].get<std::string>()] = 0;
    for (const auto& [emotion, strength] : emotions)
      for (const auto& [muscle, amount] : face_["emotions"][emotion].items())
        pulls[muscle] = 1 - (1 - amount.get<double>() * strength) * (1 - pulls[muscle]);
    return pulls;
  }

  /// Where the points are after `seconds`, from rest.
  std::map<std::string, Complex> run(const PullsAt& pulls, double seconds, double step) const {
    std::vector<Complex> p, v(points_.size());
    for (const Point& point : points_) p.push_back(point.rest);
    const auto steps = (long long)(std::llround(seconds / step));
    for (long long n = 0; n < steps; ++n) {
      const double t = double(n) * step;
      const Pulls at[3] = {pulls(t), pulls(t + 0.5 * step), pulls(t + step)};
      for (std::size_t i = 0; i < p.size(); ++i) advance(points_[i], at, step, p[i], v[i]);
    }
    std::map<std::string, Complex> result;
    for (std::size_t i = 0; i < p.size(); ++i) result[points_[i].name] = p[i];
    return result;
  }

 private:
  struct Hold {
    std::string muscle;
    Complex origin;
    double strength, stroke, length;
  };
  struct Point {
    std::string name;  ///< "mouth/points/2"
    Complex rest;
    std::vector<Hold> holds;
  };

  void add(const nlohmann::json& group, const std::string& name, double weight) {
    const std::size_t slash = name.find('/');
    Complex rest;
    for (const auto& feature : face_["features"])
      if (feature["name"] == name.substr(0, slash)) {
        const auto& xy = feature["points"][std::stoul(name.substr(name.rfind('/') + 1))];
        rest = {xy[0].get<double>(), xy[1].get<double>()};
      }
    std::size_t i = 0;
    while (i < points_.size() && points_[i].name != name) ++i;
    if (i == points_.size()) points_.push_back({name, rest, {}});
    const Complex origin{group["origin"][0].get<double>(), group["origin"][1].get<double>()};
    points_[i].holds.push_back({group["name"].get<std::string>(), origin,
                                weight * group["strength"].get<double>(),
                                group["stroke"].get<double>(), std::abs(rest - origin)});
  }

  Complex force(const Point& point, const Pulls& pulls, Complex p, Complex v) const {
    Complex sum = stiffness_ * (point.rest - p) - damping_ * v;
    for (const Hold& hold : point.holds) {
      const double e = pulls.at(hold.muscle);
      const Complex way = hold.origin - p;
      if (std::abs(way) > 0)
        sum += std::polar(hold.strength * e * (std::abs(way) - (hold.length - hold.stroke * e)),
                          std::arg(way));
    }
    return point.rest.real() == 0 ? Complex{0, sum.imag()} : sum;
  }

  void advance(const Point& point, const Pulls (&pulls)[3], double h, Complex& p,
               Complex& v) const {
    const Complex v1 = v, a1 = force(point, pulls[0], p, v1);
    const Complex v2 = v + 0.5 * h * a1, a2 = force(point, pulls[1], p + 0.5 * h * v1, v2);
    const Complex v3 = v + 0.5 * h * a2, a3 = force(point, pulls[1], p + 0.5 * h * v2, v3);
    const Complex v4 = v + h * a3, a4 = force(point, pulls[2], p + h * v3, v4);
    p += h / 6 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
    v += h / 6 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
  }

  nlohmann::json face_;
  double stiffness_, damping_;
  std::vector<Point> points_;
};

}  // namespace mien::test
