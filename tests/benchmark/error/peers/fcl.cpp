// FCL, in double: at the level of its solvers, below the dispatch and the results of its public
// functions. Triangles meet by the test that its trees use at their leaves; the others by its two
// solvers, "libccd" (the default) and "indep", which come with tests of their own for some shapes.
// A box is a centre and lengths here: that much rounding its types force.

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/detail/gjk_solver_indep.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>
#include <fcl/narrowphase/detail/traversal/collision/intersect.h>

#include <memory>

#include "tests/benchmark/error/peers/peers.h"
#include "tests/benchmark/error/peers/support_limit.h"

// The library that is linked was compiled for the baseline; wider SIMD would change Eigen's layout.
static_assert(EIGEN_MAX_ALIGN_BYTES == 16, "compile this file without -march or -mavx flags");

namespace graze::benchmark {
namespace {

Label label(const char* name) {
  return {name, Origin::Peer, "double", std::nullopt};
}

struct PlacedBox {
  explicit PlacedBox(const Aabb& bounds)
      : box(bounds.max - bounds.min), pose(fcl::Transform3d::Identity()) {
    pose.translation() = 0.5 * bounds.min + 0.5 * bounds.max;
  }
  fcl::Boxd box;
  fcl::Transform3d pose;
};

struct PlacedSphere {
  explicit PlacedSphere(const Sphere& ball)
      : sphere(ball.radius), pose(fcl::Transform3d::Identity()) {
    pose.translation() = ball.centre;
  }
  fcl::Sphered sphere;
  fcl::Transform3d pose;
};

struct TriangleBox {
  Triangle triangle;
  PlacedBox box;
};

bool meet(const fcl::detail::GJKSolver_indepd& solver, const TriangleBox& pair) {
  return solver.shapeTriangleIntersect(pair.box.box, pair.box.pose, pair.triangle.a,
                                       pair.triangle.b, pair.triangle.c);
}

/// Forwards to FCL's own support functions, and counts.
template <fcl::detail::GJKSupportFunction (*function)()>
void counted_support(const void* shape, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  static const fcl::detail::GJKSupportFunction support = function();
  SupportLimit::count();
  support(shape, direction, point);
}

/// What the solver's shapeTriangleIntersect() does, with an end: see support_limit.h.
bool meet(const fcl::detail::GJKSolver_libccdd& solver, const TriangleBox& pair) {
  using Initializer = fcl::detail::GJKInitializer<double, fcl::Boxd>;
  const std::unique_ptr<void, void (*)(void*)> box(
      Initializer::createGJKObject(pair.box.box, pair.box.pose), Initializer::deleteGJKObject);
  const std::unique_ptr<void, void (*)(void*)> triangle(
      fcl::detail::triCreateGJKObject(pair.triangle.a, pair.triangle.b, pair.triangle.c),
      fcl::detail::triDeleteGJKObject);
  SupportLimit::begin();
  return fcl::detail::GJKCollide<double>(
      box.get(), counted_support<Initializer::getSupportFunction>, Initializer::getCenterFunction(),
      triangle.get(), counted_support<fcl::detail::triGetSupportFunction>,
      fcl::detail::triGetCenterFunction(),
      static_cast<unsigned int>(solver.max_collision_iterations), solver.collision_tolerance,
      nullptr, nullptr, nullptr);
}

template <typename Solver>
void add_solver(Field& field, const char* name) {
  add(
      field.triangle_boxes, label(name),
      [](const TriangleAndBox& pair) {
        return TriangleBox{pair.triangle, PlacedBox(pair.box)};
      },
      [solver = Solver()](const TriangleBox& pair) { return meet(solver, pair); });
  struct SphereBox {
    PlacedSphere sphere;
    PlacedBox box;
  };
  add(
      field.sphere_boxes, label(name),
      [](const SphereAndBox& pair) {
        return SphereBox{PlacedSphere(pair.sphere), PlacedBox(pair.box)};
      },
      [solver = Solver()](const SphereBox& pair) {
        return solver.shapeIntersect(pair.sphere.sphere, pair.sphere.pose, pair.box.box,
                                     pair.box.pose, nullptr);
      });
  struct Spheres {
    PlacedSphere a;
    PlacedSphere b;
  };
  add(
      field.sphere_pairs, label(name),
      [](const SpherePair& pair) {
        return Spheres{PlacedSphere(pair.a), PlacedSphere(pair.b)};
      },
      [solver = Solver()](const Spheres& pair) {
        return solver.shapeIntersect(pair.a.sphere, pair.a.pose, pair.b.sphere, pair.b.pose,
                                     nullptr);
      });
}

}  // namespace

void add_fcl(Field& field) {
  add(
      field.triangle_pairs, label("FCL"), [](const TrianglePair& pair) { return pair; },
      [](const TrianglePair& pair) {
        return fcl::detail::Intersect<double>::intersect_Triangle(pair.a.a, pair.a.b, pair.a.c,
                                                                  pair.b.a, pair.b.b, pair.b.c);
      });
  add_solver<fcl::detail::GJKSolver_libccdd>(field, "FCL libccd");
  add_solver<fcl::detail::GJKSolver_indepd>(field, "FCL indep");
  add_fcl_meshes(field.meshes);
  add_fcl_volumes(field);
  add_fcl_distances(field);
}

}  // namespace graze::benchmark
