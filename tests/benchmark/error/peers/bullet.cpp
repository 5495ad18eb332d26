// Bullet, compiled for double. Triangles meet by GImpact's pair of tests (planes and margins, then
// clipping) with a margin of 0, and by GJK with EPA behind it on shapes with a margin of 0; a
// triangle meets a box by the exact test of GImpact's boxes, whose plane counts.

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletCollision/Gimpact/btBoxCollision.h>
#include <BulletCollision/Gimpact/btTriangleShapeEx.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "tests/benchmark/error/peers/peers.h"

static_assert(sizeof(btScalar) == sizeof(double), "compile this file with BT_USE_DOUBLE_PRECISION");

namespace graze::benchmark {
namespace {

Label label(const char* name) {
  return {name, Origin::Peer, "double", std::nullopt};
}

btVector3 to_bullet(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

struct Vertices {
  explicit Vertices(const Triangle& t) : v{to_bullet(t.a), to_bullet(t.b), to_bullet(t.c)} {}
  btVector3 v[3];
};

struct VertexPair {
  Vertices a;
  Vertices b;
};

btPrimitiveTriangle primitive(const Vertices& vertices) {
  btPrimitiveTriangle triangle;
  for (int i = 0; i < 3; ++i)
    triangle.m_vertices[i] = vertices.v[i];
  triangle.m_margin = 0;
  triangle.buildTriPlane();
  return triangle;
}

bool by_gimpact(const VertexPair& pair) {
  btPrimitiveTriangle a = primitive(pair.a);
  btPrimitiveTriangle b = primitive(pair.b);
  GIM_TRIANGLE_CONTACT contacts;
  return a.overlap_test_conservative(b) && a.find_triangle_collision_clip_method(b, contacts);
}

/// The solvers that the detector needs, which keep nothing from pair to pair.
class Gjk {
 public:
  bool operator()(const VertexPair& pair) {
    const btPointCollector result = collect(pair);
    return result.m_hasResult && result.m_distance <= 0;
  }

  /// Metres; throws for a pair without a result.
  double distance(const VertexPair& pair) {
    const btPointCollector result = collect(pair);
    if (!result.m_hasResult) throw std::runtime_error("no result");
    return std::max(result.m_distance, 0.0);
  }

 private:
  btPointCollector collect(const VertexPair& pair) {
    btTriangleShape a(pair.a.v[0], pair.a.v[1], pair.a.v[2]);
    btTriangleShape b(pair.b.v[0], pair.b.v[1], pair.b.v[2]);
    a.setMargin(0);
    b.setMargin(0);
    simplex_.reset();
    btGjkPairDetector detector(&a, &b, &simplex_, &depth_);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA.setIdentity();
    input.m_transformB.setIdentity();
    btPointCollector result;
    detector.getClosestPoints(input, result, nullptr);
    return result;
  }

  btVoronoiSimplexSolver simplex_;
  btGjkEpaPenetrationDepthSolver depth_;
};

struct TriangleBox {
  Vertices triangle;
  btAABB box;
};

bool by_exact_box_test(const TriangleBox& pair) {
  const btVector3* v = pair.triangle.v;
  btVector3 normal = (v[1] - v[0]).cross(v[2] - v[0]);
  normal.normalize();
  const btVector4 plane(normal[0], normal[1], normal[2], v[0].dot(normal));
  return pair.box.collide_triangle_exact(v[0], v[1], v[2], plane);
}

}  // namespace

void add_bullet(Field& field) {
  const auto to_vertices = [](const TrianglePair& pair) {
    return VertexPair{Vertices(pair.a), Vertices(pair.b)};
  };
  add(field.triangle_pairs, label("Bullet GImpact"), to_vertices, by_gimpact);
  add(field.triangle_pairs, label("Bullet GJK"), to_vertices,
      [gjk = std::make_shared<Gjk>()](const VertexPair& pair) { return (*gjk)(pair); });
  add(field.distances, label("Bullet GJK"), to_vertices,
      [gjk = std::make_shared<Gjk>()](const VertexPair& pair) { return gjk->distance(pair); });
  add(
      field.triangle_boxes, label("Bullet GImpact"),
      [](const TriangleAndBox& pair) {
        TriangleBox result{Vertices(pair.triangle), btAABB()};
        result.box.m_min = to_bullet(pair.box.min);
        result.box.m_max = to_bullet(pair.box.max);
        return result;
      },
      by_exact_box_test);
  add_bullet_volumes(field);
}

}  // namespace graze::benchmark
