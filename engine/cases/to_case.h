#pragma once

// A query and its result as a case: the arguments of the query, then what it returned.
//
//   graze::write_case("odd.json", graze::to_case({bolt}, {nut, pose}, graze::distance({bolt}, {nut,
//   pose})));

#include <graze/engine/cases/case.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/mesh_contacts.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/self.h>
#include <graze/engine/mesh/separating_translation.h>
#include <graze/engine/mesh/volume_query.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shape_separation.h>
#include <graze/narrowphase/triangle_distance.h>
#include <graze/narrowphase/triangle_intersection.h>
#include <graze/narrowphase/triangle_ray.h>

namespace graze {

/// Make a case of intersects(): of two meshes; a mesh and a volume; triangles; two bodies; two
/// volumes.
Case to_case(const PlacedMeshView& a, const PlacedMeshView& b, bool says,
             const QuerySettings& settings = {});
Case to_case(const PlacedMeshView& a, const CaseShape& volume, bool says,
             const VolumeQuerySettings& settings);
Case to_case(const Triangle& a, const Triangle& b, Touch touch, bool says);
Case to_case(const CaseShape& a, const CaseShape& b, bool says);

/// Make a case of find_triangle_pairs() and find_triangles() with these settings. Throw InputError
/// for a list that a limit has cut if the settings name another limit, or another volume than is
/// theirs by default: which pairs are found may then be others when the case is asked again.
Case to_case(const PlacedMeshView& a, const PlacedMeshView& b, const TrianglePairs& pairs,
             const PairSettings& settings = {});
Case to_case(const PlacedMeshView& a, const CaseShape& volume, const TriangleList& triangles,
             const TriangleSettings& settings = {});

/// Make a case of distance(), within(), find_contacts() without a limit, and find_intersection().
Case to_case(const PlacedMeshView& a, const PlacedMeshView& b, const MeshDistance& gap);
Case to_case_within(const PlacedMeshView& a, const PlacedMeshView& b, double clearance, bool says);
Case to_case(const PlacedMeshView& a, const PlacedMeshView& b, const MeshContacts& contacts);
Case to_case(const PlacedMeshView& a, const PlacedMeshView& b,
             const MeshIntersection& intersection);

/// Makes a case of separating_translation(), without a direction or along one.
Case to_case(const PlacedMeshView& a, const PlacedMeshView& b,
             const SeparatingTranslation& separation,
             const std::optional<Eigen::Vector3d>& direction = std::nullopt);

/// Make a case of distance() and intersection() of triangles.
Case to_case(const Triangle& a, const Triangle& b, const TriangleDistance& gap);
Case to_case(const Triangle& a, const Triangle& b, const TriangleIntersection& intersection);

/// Make a case of distance() and find_contacts() of placed shapes.
Case to_case(const CaseBody& a, const CaseBody& b, const ShapeDistance& gap);
Case to_case(const CaseBody& a, const CaseBody& b, const Manifold& manifold);

/// Make a case of cast_ray() of a mesh or a body, or of a triangle, and of cast_ray_all().
Case to_case(const CaseShape& shape, const Ray& ray, const std::optional<RayHit>& first);
Case to_case(const Triangle& triangle, const Ray& ray, const std::optional<TriangleRayHit>& hit);
Case to_case(const PlacedMeshView& mesh, const Ray& ray, const std::vector<RayHit>& all);

/// Make a case of contains() of a mesh or a volume, self_intersects(), and find_self_pairs().
Case to_case_contains(const Mesh& mesh, const Eigen::Vector3d& point, bool is_inside);
Case to_case_contains(const CaseShape& volume, const Eigen::Vector3d& point, bool is_inside);
Case to_case_self(const Mesh& mesh, bool crosses_itself);
Case to_case_self(const Mesh& mesh, const TrianglePairs& self_pairs,
                  const SelfSettings& settings = {});

/// Return results as the answers of cases. Throw InputError for a point that is not finite: a ray's
/// hit may be beyond the largest double.
CaseAnswer answer_of(const TrianglePairs& pairs);
CaseAnswer answer_of(const TriangleList& triangles);
CaseAnswer answer_of(const MeshDistance& gap);
CaseAnswer answer_of(const MeshContacts& contacts);
CaseAnswer answer_of(const MeshIntersection& intersection);
CaseAnswer answer_of(const SeparatingTranslation& separation);
/// Returns the translation of B by the depth along the normal; for two that are apart it is zero.
CaseAnswer answer_of(const ShapeSeparation& separation);
CaseAnswer answer_of(const TriangleDistance& gap);
CaseAnswer answer_of(const TriangleIntersection& intersection);
CaseAnswer answer_of(const ShapeDistance& gap);
CaseAnswer answer_of(const Manifold& manifold);
CaseAnswer answer_of(const std::optional<RayHit>& first);
CaseAnswer answer_of(const std::optional<TriangleRayHit>& hit);
CaseAnswer answer_of(const std::vector<RayHit>& all);

}  // namespace graze
