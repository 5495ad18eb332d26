// FCL's distances: of triangles, by the test at the leaves of its trees (PQP's) and by GJK of its
// two solvers, whose tolerance is set to the roundoff; of meshes, by its trees of RSS and OBBRSS.
// GJK answers -1 for what touches: read as 0.

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/triangle_p.h>
#include <fcl/narrowphase/detail/gjk_solver_indep.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>
#include <fcl/narrowphase/detail/primitive_shape_algorithm/triangle_distance.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

#include "tests/benchmark/common/fcl_models.h"
#include "tests/benchmark/error/peers/peers.h"
#include "tests/benchmark/error/peers/support_limit.h"

namespace graze::benchmark {
namespace {

constexpr double kTolerance = 1e-15;  // of GJK: what rounding leaves

Label peer(const char* name) {
  return {name, Origin::Peer, "double", std::nullopt};
}

double leaf_distance(const TrianglePair& pair) {
  Eigen::Vector3d p, q;
  return fcl::detail::TriangleDistance<double>::triDistance(pair.a.a, pair.a.b, pair.a.c, pair.b.a,
                                                            pair.b.b, pair.b.c, p, q);
}

struct DestroyTriangle {
  void operator()(void* triangle) const { fcl::detail::triDeleteGJKObject(triangle); }
};
using CcdTriangle = std::unique_ptr<void, DestroyTriangle>;

CcdTriangle to_ccd(const Triangle& t) {
  return CcdTriangle(fcl::detail::triCreateGJKObject(t.a, t.b, t.c));
}

void counted_support(const void* triangle, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  static const fcl::detail::GJKSupportFunction support = fcl::detail::triGetSupportFunction();
  SupportLimit::count();
  support(triangle, direction, point);
}

/// Where squares overflow an assertion of the library ends the program: such a pair counts as
/// failed.
bool is_in_range(const TrianglePair& pair) {
  for (const Eigen::Vector3d& p : {pair.a.a, pair.a.b, pair.a.c, pair.b.a, pair.b.b, pair.b.c}) {
    if (p.cwiseAbs().maxCoeff() > 1e70) return false;
  }
  return true;
}

/// The solver's own function knows no pair of triangles; this is what it does for other shapes.
double by_libccd(const std::pair<CcdTriangle, CcdTriangle>& pair) {
  if (!pair.first) throw std::out_of_range("squares overflow");
  static const fcl::detail::GJKSolver_libccdd solver;
  double distance = -1;
  SupportLimit::begin();
  fcl::detail::GJKDistance<double>(pair.first.get(), counted_support, pair.second.get(),
                                   counted_support,
                                   static_cast<unsigned int>(solver.max_distance_iterations),
                                   kTolerance, &distance, nullptr, nullptr);
  return std::max(distance, 0.0);
}

struct Shapes {
  fcl::TrianglePd a;
  fcl::TrianglePd b;
};

double by_indep(const Shapes& pair) {
  static const fcl::Transform3d identity = fcl::Transform3d::Identity();
  fcl::detail::GJKSolver_indepd solver;
  solver.gjk_tolerance = kTolerance;
  double distance = -1;
  solver.shapeDistance(pair.a, identity, pair.b, identity, &distance);
  return std::max(distance, 0.0);
}

template <typename Volume>
class FclMeshDistances final : public MeshDistanceContestant {
 public:
  explicit FclMeshDistances(const char* name) : MeshDistanceContestant(peer(name)) {}

  void prepare(const Mesh& mesh_a, const Mesh& mesh_b) override {
    mesh_a_ = to_fcl<Volume>(mesh_a);
    mesh_b_ = to_fcl<Volume>(mesh_b);
  }
  double distance(const Pose& pose_b) override {
    fcl::DistanceResultd result;
    const double found = fcl::distance(mesh_a_.get(), fcl::Transform3d::Identity(), mesh_b_.get(),
                                       to_fcl_pose(pose_b), fcl::DistanceRequestd(), result);
    return std::max(found, 0.0);
  }

 private:
  std::shared_ptr<fcl::BVHModel<Volume>> mesh_a_;
  std::shared_ptr<fcl::BVHModel<Volume>> mesh_b_;
};

}  // namespace

void add_fcl_distances(Field& field) {
  add(
      field.distances, peer("FCL"), [](const TrianglePair& pair) { return pair; }, leaf_distance);
  add(
      field.distances, peer("FCL libccd"),
      [](const TrianglePair& pair) {
        if (!is_in_range(pair)) return std::pair<CcdTriangle, CcdTriangle>();
        return std::pair(to_ccd(pair.a), to_ccd(pair.b));
      },
      by_libccd);
  add(
      field.distances, peer("FCL indep"),
      [](const TrianglePair& pair) {
        return Shapes{{pair.a.a, pair.a.b, pair.a.c}, {pair.b.a, pair.b.b, pair.b.c}};
      },
      by_indep);
  field.mesh_distances.push_back(std::make_unique<FclMeshDistances<fcl::RSSd>>("FCL RSS"));
  field.mesh_distances.push_back(std::make_unique<FclMeshDistances<fcl::OBBRSSd>>("FCL OBBRSS"));
}

}  // namespace graze::benchmark
