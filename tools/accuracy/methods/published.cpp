#include "tools/accuracy/methods/published.h"

#include "tools/accuracy/methods/bisection.h"
#include "tools/accuracy/methods/closed_form.h"
#include "tools/accuracy/methods/complex_cardano.h"
#include "tools/accuracy/methods/newton.h"
#include "tools/accuracy/methods/subdivision.h"

namespace mien::accuracy {
namespace {

template <class T>
using Distance = T (*)(const QuadBezier& curve, T x, T y);

template <Distance<float> distance>
Solver in_float(const std::string& name) {
  return {name + " f32",
          "",
          Judge::fast,
          0,
          0,
          [](const Case& k) {
            return double(distance(std::get<QuadBezier>(k.figure), float(k.p.x), float(k.p.y)));
          },
          [] {},
          [](const QuadBezier& curve, Points& p) {
            for (std::size_t i = 0; i < p.xf.size(); ++i)
              p.df[i] = distance(curve, p.xf[i], p.yf[i]);
          }};
}

template <Distance<double> distance>
Solver in_double(const std::string& name) {
  return {name + " f64",
          "",
          Judge::exact,
          0,
          0,
          [](const Case& k) { return distance(std::get<QuadBezier>(k.figure), k.p.x, k.p.y); },
          [] {},
          [](const QuadBezier& curve, Points& p) {
            for (std::size_t i = 0; i < p.xd.size(); ++i)
              p.dd[i] = distance(curve, p.xd[i], p.yd[i]);
          }};
}

}  // namespace

std::vector<Solver> published_methods() {
  return {in_float<closed_form<float>>("closed form"),
          in_double<closed_form<double>>("closed form"),
          in_float<complex_cardano<float>>("complex Cardano"),
          in_double<complex_cardano<double>>("complex Cardano"),
          in_float<newton_from_samples<float>>("Newton from samples"),
          in_double<newton_from_samples<double>>("Newton from samples"),
          in_float<bisection<float>>("bisection"),
          in_double<bisection<double>>("bisection"),
          in_float<subdivision<float>>("subdivision"),
          in_double<subdivision<double>>("subdivision")};
}

}  // namespace mien::accuracy
