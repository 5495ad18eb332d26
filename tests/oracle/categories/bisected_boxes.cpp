#include <graze/engine/compare/referee.h>
#include <tests/oracle/bisection.h>
#include <tests/oracle/category.h>

// Triangles and boxes moved to within rounding of the place where the answer changes.

namespace graze::oracle {
namespace {

using Eigen::Vector3d;

template <typename Make>
TriangleAndBox at_flip(Sampler& s, Make make) {
  const double t = near_flip(s, make, [](const TriangleAndBox& pair) {
    return compare::referee_intersects(pair.triangle, pair.box);
  });
  return make(t);
}

Vector3d rounded(const Sampler& s, const Vector3d& p) {
  return {on_grid(p.x(), s.grid()), on_grid(p.y(), s.grid()), on_grid(p.z(), s.grid())};
}

Aabb rounded_box(Sampler& s) {
  const Vector3d p = rounded(s, s.point());
  return box_between(p, rounded(s, s.point()));
}

// The triangle slides out of the box.
TriangleAndBox sliding(Sampler& s) {
  const Aabb box = rounded_box(s);
  const Triangle shape = s.triangle();
  const Vector3d inside = (box.min + box.max) / 2 - shape.a;
  const Vector3d away = 4 * s.point();
  return at_flip(s, [&](double t) {
    const auto vertex = [&](const Vector3d& p) { return rounded(s, p + inside + t * away); };
    return TriangleAndBox{for_each_vertex(shape, vertex), box};
  });
}

// One vertex moves: mostly the triangle's inside or an edge comes to touch.
TriangleAndBox stretching(Sampler& s) {
  const Aabb box = rounded_box(s);
  const auto vertex = [&](const Vector3d& p) { return rounded(s, 2 * p); };
  const Triangle t = for_each_vertex(s.triangle(), vertex);
  const Vector3d target = (box.min + box.max) - t.a;
  return at_flip(s, [&](double parameter) {
    return TriangleAndBox{{t.a, t.b, rounded(s, t.c + parameter * (target - t.c))}, box};
  });
}

// The box grows at one corner until it touches.
TriangleAndBox growing(Sampler& s) {
  const Triangle t =
      for_each_vertex(s.triangle(), [&](const Vector3d& p) { return rounded(s, p); });
  const Vector3d p = rounded(s, s.point());
  const Vector3d size = 4 * s.point();
  return at_flip(s, [&](double parameter) {
    return TriangleAndBox{t, box_between(p, rounded(s, p + parameter * size))};
  });
}

}  // namespace

void add_bisected_boxes(std::vector<BoxCategory>& categories) {
  categories.push_back({"bisected_sliding", sliding});
  categories.push_back({"bisected_stretching", stretching});
  categories.push_back({"bisected_growing", growing});
}

}  // namespace graze::oracle
