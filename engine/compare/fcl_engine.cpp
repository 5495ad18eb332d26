#include <graze/engine/compare/fcl_engine.h>

#include <fcl/config.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>
#include <algorithm>
#include <limits>
#include <string>

// The library that is linked was compiled for the baseline. Under wider SIMD flags Eigen would lay
// out the types that cross into it differently, and nearly everything would seem to overlap.
static_assert(EIGEN_MAX_ALIGN_BYTES == 16, "compile this file without -march or -mavx flags");

namespace graze::compare {

using FclModel = fcl::BVHModel<fcl::OBBRSSd>;

struct FclMesh::Model {
  FclModel bvh;
};

namespace {

void check(int code, const char* step) {
  if (code != fcl::BVH_OK) {
    throw MeshError(std::string("FCL refuses the mesh: ") + step + " returned " +
                    std::to_string(code));
  }
}

fcl::Transform3d to_fcl(const Pose& pose) {
  fcl::Transform3d transform = fcl::Transform3d::Identity();
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row)
      transform(row, column) = pose(row, column);
  }
  return transform;
}

/// Contact geometry is never asked for: FCL then records each intersecting pair exactly once, where
/// with it a pair is recorded once for each contact point, and not at all if there is none.
fcl::CollisionResultd collide(const FclModel& mesh_a, const Pose& pose_a, const FclModel& mesh_b,
                              const Pose& pose_b, std::size_t max_pairs) {
  const fcl::CollisionRequestd request(max_pairs, /*enable_contact=*/false);
  fcl::CollisionResultd result;
  fcl::collide(&mesh_a, to_fcl(pose_a), &mesh_b, to_fcl(pose_b), request, result);
  return result;
}

}  // namespace

FclMesh::FclMesh(const Mesh& mesh) {
  auto model = std::make_unique<Model>();
  const std::span<const Eigen::Vector3d> vertices = mesh.vertices();
  const std::span<const TriangleIndices> triangles = mesh.triangles();
  std::vector<fcl::Triangle> fcl_triangles;
  fcl_triangles.reserve(triangles.size());
  for (const TriangleIndices& t : triangles)
    fcl_triangles.emplace_back(t[0], t[1], t[2]);

  FclModel& bvh = model->bvh;
  check(bvh.beginModel(static_cast<int>(triangles.size()), static_cast<int>(vertices.size())),
        "beginModel");
  check(
      bvh.addSubModel(std::vector<fcl::Vector3d>(vertices.begin(), vertices.end()), fcl_triangles),
      "addSubModel");
  check(bvh.endModel(), "endModel");
  model_ = std::move(model);
}

FclMesh::~FclMesh() = default;
FclMesh::FclMesh(FclMesh&&) noexcept = default;
FclMesh& FclMesh::operator=(FclMesh&&) noexcept = default;

bool intersects(const FclMesh& mesh_a, const Pose& pose_a, const FclMesh& mesh_b,
                const Pose& pose_b) {
  return collide(mesh_a.model_->bvh, pose_a, mesh_b.model_->bvh, pose_b, 1).isCollision();
}

std::vector<TrianglePair> find_triangle_pairs(const FclMesh& mesh_a, const Pose& pose_a,
                                              const FclMesh& mesh_b, const Pose& pose_b) {
  const fcl::CollisionResultd result = collide(mesh_a.model_->bvh, pose_a, mesh_b.model_->bvh,
                                               pose_b, std::numeric_limits<std::size_t>::max());
  std::vector<TrianglePair> pairs;
  pairs.reserve(result.numContacts());
  for (std::size_t i = 0; i < result.numContacts(); ++i) {
    // FCL keeps the order of the triangles: b1 and b2 are the mesh's own indices.
    const fcl::Contactd& contact = result.getContact(i);
    pairs.push_back(
        {static_cast<std::uint32_t>(contact.b1), static_cast<std::uint32_t>(contact.b2)});
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

FclDistance distance(const FclMesh& mesh_a, const Pose& pose_a, const FclMesh& mesh_b,
                     const Pose& pose_b) {
  const fcl::DistanceRequestd request(/*enable_nearest_points=*/true);
  fcl::DistanceResultd result;
  fcl::distance(&mesh_a.model_->bvh, to_fcl(pose_a), &mesh_b.model_->bvh, to_fcl(pose_b), request,
                result);
  return {std::max(result.min_distance, 0.0),  // FCL says -1 for triangles that meet
          {static_cast<std::uint32_t>(result.b1), static_cast<std::uint32_t>(result.b2)}};
}

std::vector<FclContact> find_contacts(const FclMesh& mesh_a, const Pose& pose_a,
                                      const FclMesh& mesh_b, const Pose& pose_b) {
  const fcl::CollisionRequestd request(std::numeric_limits<std::size_t>::max(),
                                       /*enable_contact=*/true);
  fcl::CollisionResultd result;
  fcl::collide(&mesh_a.model_->bvh, to_fcl(pose_a), &mesh_b.model_->bvh, to_fcl(pose_b), request,
               result);
  std::vector<FclContact> contacts;
  contacts.reserve(result.numContacts());
  for (std::size_t i = 0; i < result.numContacts(); ++i) {
    const fcl::Contactd& contact = result.getContact(i);
    contacts.push_back({contact.pos, contact.normal, contact.penetration_depth});
  }
  return contacts;
}

const char* fcl_version() {
  return FCL_VERSION;
}

}  // namespace graze::compare
