#include "tests/benchmark/error/baselines/akenine_moeller.h"

#include <algorithm>

namespace graze::benchmark {
namespace {

template <typename Real, typename Snapping>
class Axes {
 public:
  Axes(const PlainVector<Real>& half, Snapping snap) : half_(half), snap_(snap) {}

  bool separates(Real a, Real b, Real c, Real radius) const {
    return snap_(std::min(std::min(a, b), c) - radius) > 0 ||
           snap_(-std::max(std::max(a, b), c) - radius) > 0;
  }

  /// The cross products of one edge with the box's; `u` is an end of the edge, `w` the vertex
  /// opposite to it.
  bool separates(const PlainVector<Real>& edge, const PlainVector<Real>& u,
                 const PlainVector<Real>& w) const {
    const PlainVector<Real> size{std::abs(edge.x), std::abs(edge.y), std::abs(edge.z)};
    return separates(edge.z * u.y - edge.y * u.z, edge.z * w.y - edge.y * w.z,
                     half_.y * size.z + half_.z * size.y) ||
           separates(edge.x * u.z - edge.z * u.x, edge.x * w.z - edge.z * w.x,
                     half_.z * size.x + half_.x * size.z) ||
           separates(edge.y * u.x - edge.x * u.y, edge.y * w.x - edge.x * w.y,
                     half_.x * size.y + half_.y * size.x);
  }

  bool plane_separates(const PlainVector<Real>& n, const PlainVector<Real>& a) const {
    const Real radius = half_.x * std::abs(n.x) + half_.y * std::abs(n.y) + half_.z * std::abs(n.z);
    return snap_(std::abs(dot(n, a)) - radius) > 0;
  }

 private:
  bool separates(Real a, Real b, Real radius) const {
    return snap_(std::min(a, b) - radius) > 0 || snap_(-std::max(a, b) - radius) > 0;
  }

  PlainVector<Real> half_;
  Snapping snap_;
};

}  // namespace

template <typename Real, typename Snapping>
bool akenine_moeller(const Corners<Real>& triangle, const Real* low, const Real* high,
                     Snapping snap) {
  const Real two = 2;
  const Real centre[3] = {(low[0] + high[0]) / two, (low[1] + high[1]) / two,
                          (low[2] + high[2]) / two};
  const PlainVector<Real> half{(high[0] - low[0]) / two, (high[1] - low[1]) / two,
                               (high[2] - low[2]) / two};
  const Axes<Real, Snapping> axes(half, snap);
  const PlainVector<Real> a = difference(triangle.p, centre);
  const PlainVector<Real> b = difference(triangle.q, centre);
  const PlainVector<Real> c = difference(triangle.r, centre);
  if (axes.separates(a.x, b.x, c.x, half.x) || axes.separates(a.y, b.y, c.y, half.y) ||
      axes.separates(a.z, b.z, c.z, half.z)) {
    return false;
  }
  const PlainVector<Real> e = difference(triangle.q, triangle.p);
  const PlainVector<Real> f = difference(triangle.r, triangle.q);
  const PlainVector<Real> g = difference(triangle.p, triangle.r);
  if (axes.separates(e, a, c) || axes.separates(f, b, a) || axes.separates(g, c, b)) return false;
  return !axes.plane_separates(cross(e, f), a);
}

using FloatCorners = Corners<float>;
using DoubleCorners = Corners<double>;
template bool akenine_moeller(const FloatCorners&, const float*, const float*, NoSnap);
template bool akenine_moeller(const FloatCorners&, const float*, const float*, Snap<float>);
template bool akenine_moeller(const DoubleCorners&, const double*, const double*, NoSnap);
template bool akenine_moeller(const DoubleCorners&, const double*, const double*, Snap<double>);

}  // namespace graze::benchmark
