// CGAL: do_intersect() of three kernels. Simple_cartesian<double> rounds; EPICK decides by exact
// predicates on doubles; EPECK also constructs exactly. Assertions are off, as in any release
// build. Triangles without area are outside of its preconditions. A sphere has a squared radius
// there, rounded by the first two kernels. A distance is the rounded root of what
// squared_distance() says.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>
#include <CGAL/squared_distance_3.h>

#include <cmath>

#include "tests/benchmark/error/peers/peers.h"

namespace graze::benchmark {
namespace {

template <typename Kernel>
typename Kernel::Point_3 to_cgal(const Eigen::Vector3d& p) {
  return typename Kernel::Point_3(p.x(), p.y(), p.z());
}

template <typename Kernel>
typename Kernel::Triangle_3 to_cgal(const Triangle& t) {
  return
      typename Kernel::Triangle_3(to_cgal<Kernel>(t.a), to_cgal<Kernel>(t.b), to_cgal<Kernel>(t.c));
}

template <typename Kernel>
typename Kernel::Iso_cuboid_3 to_cgal(const Aabb& box) {
  return typename Kernel::Iso_cuboid_3(to_cgal<Kernel>(box.min), to_cgal<Kernel>(box.max));
}

template <typename Kernel>
typename Kernel::Sphere_3 to_cgal(const Sphere& sphere) {
  const typename Kernel::FT radius(sphere.radius);
  return typename Kernel::Sphere_3(to_cgal<Kernel>(sphere.centre), radius * radius);
}

template <typename A, typename B, typename Element, typename Convert>
void add_pairs(Contestants<Element>& contestants, const Label& label, Convert convert) {
  add(contestants, label, convert,
      [](const std::pair<A, B>& pair) { return CGAL::do_intersect(pair.first, pair.second); });
}

template <typename Kernel>
void add_kernel(Field& field, const char* name, const char* precision) {
  using CgalTriangle = typename Kernel::Triangle_3;
  using CgalBox = typename Kernel::Iso_cuboid_3;
  using CgalSphere = typename Kernel::Sphere_3;
  const Label label{name, Origin::Peer, precision, std::nullopt};
  add_pairs<CgalTriangle, CgalTriangle>(field.triangle_pairs, label, [](const TrianglePair& pair) {
    return std::pair(to_cgal<Kernel>(pair.a), to_cgal<Kernel>(pair.b));
  });
  add(
      field.distances, label,
      [](const TrianglePair& pair) {
        return std::pair(to_cgal<Kernel>(pair.a), to_cgal<Kernel>(pair.b));
      },
      [](const std::pair<CgalTriangle, CgalTriangle>& pair) {
        return std::sqrt(CGAL::to_double(CGAL::squared_distance(pair.first, pair.second)));
      });
  add_pairs<CgalTriangle, CgalBox>(field.triangle_boxes, label, [](const TriangleAndBox& pair) {
    return std::pair(to_cgal<Kernel>(pair.triangle), to_cgal<Kernel>(pair.box));
  });
  add_pairs<CgalSphere, CgalBox>(field.sphere_boxes, label, [](const SphereAndBox& pair) {
    return std::pair(to_cgal<Kernel>(pair.sphere), to_cgal<Kernel>(pair.box));
  });
}

}  // namespace

void add_cgal(Field& field) {
  add_kernel<CGAL::Simple_cartesian<double>>(field, "CGAL double", "double");
  add_kernel<CGAL::Exact_predicates_inexact_constructions_kernel>(field, "CGAL EPICK", "exact");
  add_kernel<CGAL::Exact_predicates_exact_constructions_kernel>(field, "CGAL EPECK", "exact");
}

}  // namespace graze::benchmark
