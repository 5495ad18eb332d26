#include <graze/bvh/fit/methods/kdop_faces.h>
#include <graze/bvh/value/local_frame.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace graze::bvh {
namespace {

constexpr int kSlabs = KDop<18>::kSlabs;

/// In local units the coordinate slabs lie within [-2, 2]: no bound of a slab beyond 8 cuts off
/// anything more, or leaves anything more, than 8 does.
constexpr double kFarBound = 8;
constexpr double kFarCorner = 32;

/// The points x with normal . x <= bound.
struct HalfSpace {
  Eigen::Vector3d normal;
  double bound;
};

/// The half spaces of a k-DOP: 2 i bounds slab i above, 2 i + 1 below.
using HalfSpaces = std::array<HalfSpace, 2 * kSlabs>;

/// A face while it is clipped: a polygon that is convex, but for what rounding does to slivers.
class FacePolygon {
 public:
  explicit FacePolygon(const HalfSpace& face) {
    const Eigen::Vector3d normal = face.normal.normalized();
    const Eigen::Vector3d middle = face.normal * (face.bound / face.normal.squaredNorm());
    const Eigen::Vector3d u = normal.unitOrthogonal();
    const Eigen::Vector3d v = normal.cross(u);
    corners_ = {middle + kFarCorner * (u + v), middle + kFarCorner * (v - u),
                middle - kFarCorner * (u + v), middle + kFarCorner * (u - v)};
  }

  bool is_empty() const { return corners_.empty(); }

  /// Clips the polygon as Sutherland and Hodgman do: what lies inside stays, edges that cross the
  /// plane end there.
  void clip(const HalfSpace& half_space) {
    before_.swap(corners_);
    corners_.clear();
    for (std::size_t i = 0; i < before_.size(); ++i) {
      const Eigen::Vector3d& from = before_[i];
      const Eigen::Vector3d& to = before_[i + 1 == before_.size() ? 0 : i + 1];
      const double from_excess = half_space.normal.dot(from) - half_space.bound;
      const double to_excess = half_space.normal.dot(to) - half_space.bound;
      if (from_excess <= 0) corners_.push_back(from);
      if ((from_excess < 0 && to_excess > 0) || (from_excess > 0 && to_excess < 0)) {
        corners_.push_back(from + (from_excess / (from_excess - to_excess)) * (to - from));
      }
    }
  }

  double area() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 2; i < corners_.size(); ++i)
      sum += (corners_[i - 1] - corners_[0]).cross(corners_[i] - corners_[0]);
    return 0.5 * sum.norm();
  }

 private:
  std::vector<Eigen::Vector3d> corners_;
  std::vector<Eigen::Vector3d> before_;
};

/// Returns the bound of slab i relative to the centre c, in local units: b - n . c, with what n . c
/// rounds taken off too, so that k-DOPs far from the origin keep their digits.
double local_bound(double bound, int slab, const LocalFrame& frame, double scale) {
  const std::array<int, 3>& direction = kKDopDirections<18>[slab];
  double sum = 0;
  double error = 0;
  for (int k = 0; k < 3; ++k) {
    const double term = direction[k] * frame.centre[k];
    const double next = sum + term;
    const double part = next - sum;
    error += (sum - (next - part)) + (term - part);
    sum = next;
  }
  return std::clamp(((bound - sum) - error) * scale, -kFarBound, kFarBound);
}

/// Returns the faces of a k-DOP whose bounds are below 2^1000.
KDopFaces faces_in_range(const KDop<18>& kdop) {
  const LocalFrame frame = LocalFrame::around(
      {{kdop.min[0], kdop.min[1], kdop.min[2]}, {kdop.max[0], kdop.max[1], kdop.max[2]}});
  const double scale = std::ldexp(1.0, -frame.exponent);
  HalfSpaces half_spaces;
  for (int i = 0; i < kSlabs; ++i) {
    const std::array<int, 3>& d = kKDopDirections<18>[i];
    const Eigen::Vector3d normal(d[0], d[1], d[2]);
    half_spaces[2 * i] = {normal, local_bound(kdop.max[i], i, frame, scale)};
    half_spaces[2 * i + 1] = {-normal, -local_bound(kdop.min[i], i, frame, scale)};
  }
  KDopFaces result{frame.unit(), {}};
  for (int i = 0; i < 2 * kSlabs; ++i) {
    FacePolygon polygon(half_spaces[i]);
    for (int j = 0; j < 2 * kSlabs && !polygon.is_empty(); ++j) {
      // A face is not clipped by the other bound of its own slab, which it satisfies, however flat
      // the slab.
      if (j / 2 != i / 2) polygon.clip(half_spaces[j]);
    }
    result.faces[i] = {polygon.area(), half_spaces[i].bound / half_spaces[i].normal.norm()};
  }
  return result;
}

}  // namespace

KDopFaces faces_of(const KDop<18>& kdop) {
  double largest = 0;
  for (int i = 0; i < kSlabs; ++i)
    largest = std::max({largest, std::abs(kdop.min[i]), std::abs(kdop.max[i])});
  if (largest < 0x1p1000) return faces_in_range(kdop);
  KDop<18> small = kdop;
  for (int i = 0; i < kSlabs; ++i) {
    small.min[i] *= 0x1p-100;
    small.max[i] *= 0x1p-100;
  }
  KDopFaces faces = faces_in_range(small);
  faces.unit *= 0x1p100;
  return faces;
}

}  // namespace graze::bvh
