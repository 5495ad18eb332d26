#include <graze/narrowphase/convex/core/segments.h>
#include <graze/narrowphase/convex/depth/expanding_polytope.h>

#include <algorithm>
#include <initializer_list>
#include <limits>

namespace graze::narrowphase {
namespace {

struct Face {
  int corner[3];  ///< counter-clockwise from outside
};

constexpr int kMostFaces = 2 * kMostPolytopeCorners;

/// Holds the planes of faces, each coordinate in a row of its own: all are asked about each new
/// corner.
struct Planes {
  double x[kMostFaces];  ///< a coordinate of the unit normals
  double y[kMostFaces];
  double z[kMostFaces];
  double height[kMostFaces];  ///< metres above the origin along the normal

  Vec3 normal(int i) const { return {x[i], y[i], z[i]}; }
  void set(int i, const Vec3& normal, double its_height) {
    x[i] = normal.x, y[i] = normal.y, z[i] = normal.z, height[i] = its_height;
  }
  void copy(int from, int to) {
    x[to] = x[from], y[to] = y[from], z[to] = z[from], height[to] = height[from];
  }
};

struct Edge {
  int from;
  int to;
};

class Polytope {
 public:
  Polytope(const Core& a, const Core& b, double tolerance)
      : a_(a), b_(b), tolerance_(tolerance), noise_(0x1p-46 * pair_scale(a, b)) {}

  PolytopeDepth run() {
    if (!start()) return result(false);
    for (;;) {
      const int nearest = nearest_face();
      lower_ = bound_of(nearest);
      const Vec3 normal = planes_.normal(nearest);
      const Vec3 corner = look_along(normal);
      const bool is_known = upper_ - lower_ <= tolerance_;
      if (is_known || !(dot(normal, corner) - lower_ > noise_) || !grow(corner)) {
        if (!has_right_planes()) continue;
        prove();
        return result(is_known && upper_ - lower_ <= tolerance_);
      }
    }
  }

 private:
  /// Returns the corner of the difference A - B farthest along a direction, and remembers the least
  /// plane.
  Vec3 look_along(const Vec3& direction) {
    const Vec3 corner = rounded_support(a_, direction) - rounded_support(b_, -direction);
    const double height = dot(corner, direction);
    if (height < upper_) upper_ = height, normal_ = direction;
    return corner;
  }

  int add_corner(const Vec3& corner) {
    corners_[corner_count_] = corner;
    return corner_count_++;
  }

  Vec3 farther_along(const Vec3& direction, const Vec3& from) {
    const Vec3 ahead = look_along(direction);
    const Vec3 behind = look_along(-direction);
    const bool is_ahead = dot(ahead - from, direction) >= -dot(behind - from, direction);
    return is_ahead ? ahead : behind;
  }

  /// Finds four support points with a volume.
  bool start() {
    const Vec3 first = unit_or(b_.at - a_.at, {1, 0, 0});
    const Vec3 p0 = look_along(first);
    const Vec3 p1 = look_along(-first);
    const Vec3 line = unit_or(p1 - p0, first);
    const Vec3 p2 = farther_along(any_normal_to(line), p0);
    const Vec3 out = unit_or(cross(p1 - p0, p2 - p0), {});
    if (!(largest(out) > 0)) return false;
    const Vec3 p3 = farther_along(out, p0);
    const bool is_above = dot(p3 - p0, out) > 0;
    for (const Vec3* p : {&p0, is_above ? &p2 : &p1, is_above ? &p1 : &p2, &p3})
      add_corner(*p);
    add_face(0, 1, 2);
    add_face(0, 3, 1);
    add_face(1, 3, 2);
    add_face(2, 3, 0);
    return true;
  }

  /// Adds a face. One that is narrower than rounding has no normal worth asking: it keeps the
  /// surface closed and is never the nearest nor seen. Its neighbours, which share its long edges,
  /// stand for it.
  void add_face(int i, int j, int k) {
    const Vec3& p = corners_[i];
    const Vec3 u = corners_[j] - p;
    const Vec3 v = corners_[k] - p;
    const Vec3 product = cross(u, v);
    const double longest = largest(u) + largest(v);
    const int face = face_count_++;
    faces_[face] = {{i, j, k}};
    planes_.set(face, {}, std::numeric_limits<double>::infinity());
    if (!(largest(product) > kNarrowest * noise_ * longest)) return;
    const Vec3 normal = unit_or(product, {});
    // The mean of three heights is nearer to the truth than one.
    planes_.set(face, normal, dot(normal, (p + corners_[j] + corners_[k]) * (1.0 / 3)));
  }

  int nearest_face() const {
    int nearest = 0;
    for (int i = 1; i < face_count_; ++i) {
      if (planes_.height[i] < planes_.height[nearest]) nearest = i;
    }
    return nearest;
  }

  /// Returns a bound that no depth is below, by the nearest face. From inside of the polytope that
  /// is the face's height. Where the origin is outside, as of cores whose radii alone overlap, some
  /// edge or corner may be what is nearest, and heights of faces prove nothing; but to any point of
  /// the polytope the two are no further apart than it is from the origin.
  ///
  /// Corners are off by the noise, and so is the plane within the face. A triangle's least altitude
  /// is its product over its longest side, that is sqrt(3) of the sum of coordinates at most:
  /// beyond the face the plane is off by 2 sqrt(3) noises over that for each metre. The nearest
  /// face mostly has the foot of the origin in it.
  double bound_of(int face) const {
    Core triangle;
    triangle.kind = CoreKind::Triangle;
    for (int k = 0; k < 3; ++k)
      triangle.corner[k] = corners_[faces_[face].corner[k]];
    const Vec3 nearest = nearest_on_triangle(triangle, {0, 0, 0});
    const double height = planes_.height[face];
    if (height < 0) return std::min(height, -length(nearest));
    const Vec3 u = triangle.corner[1] - triangle.corner[0];
    const Vec3 v = triangle.corner[2] - triangle.corner[0];
    const double beyond = length(nearest - planes_.normal(face) * height);
    const double leaning = kLeaning * (largest(u) + largest(v)) / length(cross(u, v));
    return height - noise_ * (1 + leaning * beyond);
  }

  /// The plane of a narrow face may be off by its normal's rounding over its length, and another
  /// face may be the nearest. But the least of what a unit direction makes of three corners is a
  /// bound of the triangle's distance from the origin whatever the direction is: no point of the
  /// triangle makes less than that, and none makes more than its own distance. Planes that promise
  /// more than their triangles keep are set right; false if there are any that were below the
  /// bound.
  bool has_right_planes() {
    bool are_right = true;
    for (int i = 0; i < face_count_ && lower_ >= 0; ++i) {
      const Vec3 normal = planes_.normal(i);
      if (!(largest(normal) > 0) || !(least_along(faces_[i], normal) < lower_)) continue;
      const Vec3 better = without_longest_edge(i);
      const double height = least_along(faces_[i], better);
      if (!(planes_.height[i] - height > noise_)) continue;
      planes_.set(i, better, height);
      if (height < lower_) are_right = false;
    }
    return are_right;
  }

  /// Leaves of the bound of the nearest plane what holds for all triangles, those without a plane
  /// among them. A bound above the depth is no bound: rounding has torn the polytope.
  void prove() {
    double least = lower_ + noise_;
    for (int i = 0; i < face_count_ && lower_ >= 0; ++i) {
      const double of_plane = least_along(faces_[i], planes_.normal(i));
      if (of_plane < least) least = std::min(least, std::max(of_plane, along_nearest(i)));
    }
    lower_ = std::min(lower_, least - noise_);
    if (lower_ - upper_ > tolerance_) lower_ = -std::numeric_limits<double>::infinity();
  }

  double least_along(const Face& face, const Vec3& direction) const {
    return std::min(dot(corners_[face.corner[0]], direction),
                    std::min(dot(corners_[face.corner[1]], direction),
                             dot(corners_[face.corner[2]], direction)));
  }

  /// Returns the normal of a face without what rounding leaves of it along the longest edge.
  Vec3 without_longest_edge(int i) const {
    const int* corner = faces_[i].corner;
    Vec3 longest;
    for (int k = 0; k < 3; ++k) {
      const Vec3 edge = corners_[corner[(k + 1) % 3]] - corners_[corner[k]];
      if (dot(edge, edge) > dot(longest, longest)) longest = edge;
    }
    const Vec3 normal = planes_.normal(i);
    return unit_or(normal - longest * (dot(normal, longest) / dot(longest, longest)), normal);
  }

  /// Returns the same bound along the way to the nearest point of a face's triangle.
  double along_nearest(int i) const {
    Core triangle;
    triangle.kind = CoreKind::Triangle;
    for (int k = 0; k < 3; ++k)
      triangle.corner[k] = corners_[faces_[i].corner[k]];
    return least_along(faces_[i], unit_or(nearest_on_triangle(triangle, {0, 0, 0}), {}));
  }

  /// Replaces all faces that see the corner by a fan from their horizon, one closed loop. False if
  /// there is none, and all stays as it was.
  bool grow(const Vec3& corner) {
    if (corner_count_ == kMostPolytopeCorners) return false;
    Edge horizon[kMostFaces];
    int edges = 0;
    double above[kMostFaces];
    for (int i = 0; i < face_count_; ++i)
      above[i] = dot(planes_.normal(i), corner) - planes_.height[i];
    int seen = 0;
    for (int i = 0; i < face_count_; ++i) {
      if (!(above[i] > noise_)) continue;
      ++seen;
      const Face& face = faces_[i];
      for (int k = 0; k < 3; ++k) {
        if (!toggle(horizon, edges, {face.corner[k], face.corner[(k + 1) % 3]})) return false;
      }
    }
    if (edges < 3 || face_count_ - seen + edges > kMostFaces) return false;
    int kept = 0;
    for (int i = 0; i < face_count_; ++i) {
      if (above[i] > noise_) continue;
      if (kept != i) faces_[kept] = faces_[i], planes_.copy(i, kept);
      ++kept;
    }
    face_count_ = kept;
    const int apex = add_corner(corner);
    for (int i = 0; i < edges; ++i)
      add_face(horizon[i].from, horizon[i].to, apex);
    return true;
  }

  /// Adds an edge to the horizon, or takes it away if its other side was seen, too.
  static bool toggle(Edge (&horizon)[kMostFaces], int& edges, const Edge& edge) {
    for (int i = 0; i < edges; ++i) {
      if (horizon[i].from != edge.to || horizon[i].to != edge.from) continue;
      horizon[i] = horizon[--edges];
      return true;
    }
    if (edges == kMostFaces) return false;
    horizon[edges++] = edge;
    return true;
  }

  PolytopeDepth result(bool is_closed) const { return {normal_, upper_, lower_, is_closed}; }

  static constexpr double kNarrowest = 4;
  static constexpr double kLeaning = 3.5;  ///< a bound above 2 sqrt(3)

  const Core& a_;
  const Core& b_;
  double tolerance_;
  double noise_;
  Vec3 corners_[kMostPolytopeCorners];
  Face faces_[kMostFaces];
  Planes planes_;
  int corner_count_ = 0;
  int face_count_ = 0;
  double upper_ = std::numeric_limits<double>::infinity();
  double lower_ = 0;
  Vec3 normal_;
};

}  // namespace

PolytopeDepth polytope_depth(const Core& a, const Core& b, double tolerance) {
  return Polytope(a, b, tolerance).run();
}

}  // namespace graze::narrowphase
