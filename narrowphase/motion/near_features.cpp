#include <graze/narrowphase/motion/near_features.h>
#include <graze/narrowphase/predicates/exact_vector.h>

#include <utility>

namespace graze::narrowphase {
namespace {

/// A vector that changes with time.
struct LongVector {
  LongPolynomial x, y, z;
};

LongVector operator-(const LongVector& a, const LongVector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

LongPolynomial dot(const LongVector& a, const LongVector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

LongVector cross(const LongVector& a, const LongVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Lists all of the pairs, one after the other.
class NearFeatures {
 public:
  NearFeatures(const FourPaths& paths, double clearance) {
    CommonUnit unit({clearance});
    for (int i = 0; i < 4; ++i) {
      unit.include(paths.start[i], 3);
      unit.include(paths.end[i], 3);
    }
    for (int i = 0; i < 4; ++i) {
      const auto coordinate = [&](int k) {
        const auto start = GrowingInteger::from_double(paths.start[i][k], unit.exponent());
        const auto end = GrowingInteger::from_double(paths.end[i][k], unit.exponent());
        return LongPolynomial({start, end - start});
      };
      point_[i] = {coordinate(0), coordinate(1), coordinate(2)};
    }
    const auto s = GrowingInteger::from_double(clearance, unit.exponent());
    clearance2_ = LongPolynomial({s * s});
  }

  void add_corners(int p, int q) {
    const LongVector w = point_[p] - point_[q];
    features.push_back({dot(w, w) - clearance2_, LongPolynomial({GrowingInteger(1)}), {}});
  }

  void add_corner_and_edge(int p, int from, int to) {
    const LongVector edge = point_[to] - point_[from];
    const LongVector w = point_[p] - point_[from], across = cross(w, edge);
    const LongPolynomial size = dot(edge, edge);
    features.push_back({dot(across, across) - clearance2_ * size,
                        size,
                        {dot(w, edge), dot(point_[to] - point_[p], edge)}});
  }

  /// Adds point 0 and the triangle of the others.
  void add_corner_and_face() {
    const LongVector normal = cross(point_[2] - point_[1], point_[3] - point_[1]);
    const LongPolynomial size = dot(normal, normal);
    const LongPolynomial height = dot(point_[0] - point_[1], normal);
    NearFeature feature{height * height - clearance2_ * size, size, {}};
    for (int i = 1; i <= 3; ++i) {
      const LongVector v = point_[i] - point_[0], next = point_[i % 3 + 1] - point_[0];
      feature.inside.push_back(dot(cross(v, next), normal));
    }
    features.push_back(std::move(feature));
  }

  /// Adds the edges from 0 to 1 and from 2 to 3. With w from 0 to 2, e and f along them and m = e x
  /// f, the feet are at (w x f) . m and (w x e) . m, over m^2.
  void add_edges() {
    const LongVector e = point_[1] - point_[0], f = point_[3] - point_[2];
    const LongVector w = point_[2] - point_[0], across = cross(e, f);
    const LongPolynomial size = dot(across, across), height = dot(w, across);
    const LongPolynomial on_e = dot(cross(w, f), across), on_f = dot(cross(w, e), across);
    features.push_back(
        {height * height - clearance2_ * size, size, {on_e, size - on_e, on_f, size - on_f}});
  }

  std::vector<NearFeature> features;

 private:
  LongVector point_[4];
  LongPolynomial clearance2_;
};

}  // namespace

std::vector<NearFeature> near_features_of(const FourPaths& paths, double clearance) {
  NearFeatures all(paths, clearance);
  if (paths.kind == PathPair::PointTriangle) {
    for (int i = 1; i <= 3; ++i) {
      all.add_corners(0, i);
      all.add_corner_and_edge(0, i, i % 3 + 1);
    }
    all.add_corner_and_face();
  } else {
    for (int i = 0; i < 2; ++i) {
      all.add_corner_and_edge(i, 2, 3);
      all.add_corner_and_edge(2 + i, 0, 1);
      all.add_corners(i, 2);
      all.add_corners(i, 3);
    }
    all.add_edges();
  }
  return std::move(all.features);
}

}  // namespace graze::narrowphase
