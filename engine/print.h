#pragma once

// These write values as one line of text, for logs, debuggers and failing tests: numbers in the
// fewest digits that give the same double, whatever the stream has set, lengths in metres. Long
// lists end after sixteen elements with how many more there are. The text is for people and may
// change.

#include <graze/bvh/kdop.h>
#include <graze/bvh/obb.h>
#include <graze/bvh/pose.h>
#include <graze/bvh/ray.h>
#include <graze/bvh/sphere.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/fit.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/mesh_cast.h>
#include <graze/engine/mesh/mesh_contacts.h>
#include <graze/engine/mesh/mesh_health.h>
#include <graze/engine/mesh/mesh_intersection.h>
#include <graze/engine/mesh/mesh_path.h>
#include <graze/engine/mesh/mesh_ray.h>
#include <graze/engine/mesh/rigid_certificate.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/mesh/separating_translation.h>
#include <graze/engine/mesh/triangle_pairs.h>
#include <graze/engine/mesh/volume_cast.h>
#include <graze/engine/mesh/voxel_grid.h>
#include <graze/engine/mesh/voxels.h>
#include <graze/engine/work.h>
#include <graze/engine/world/ids.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_cast.h>
#include <graze/engine/world/shape_separation.h>
#include <graze/engine/world/world.h>
#include <graze/engine/world/world_pairs.h>
#include <graze/engine/world/world_update.h>
#include <graze/narrowphase/first_contact.h>
#include <graze/narrowphase/triangle.h>
#include <graze/narrowphase/triangle_distance.h>
#include <graze/narrowphase/triangle_intersection.h>
#include <graze/narrowphase/triangle_ray.h>

#include <iosfwd>
#include <string>

namespace graze {

/// Returns the twelve numbers of a pose as parse_pose() reads them: the same pose to the last bit.
std::string to_text(const Pose& pose);

/// These write ids, pairs and voxels in a short form: `body 3.0`, `3-4`, `(1, 2, 3)`.
std::ostream& operator<<(std::ostream& out, const BodyId& id);
std::ostream& operator<<(std::ostream& out, const BoxId& id);
std::ostream& operator<<(std::ostream& out, const BodyPair& pair);
std::ostream& operator<<(std::ostream& out, const WorldBodyPair& pair);
std::ostream& operator<<(std::ostream& out, const BoxPair& pair);
std::ostream& operator<<(std::ostream& out, const TrianglePair& pair);
std::ostream& operator<<(std::ostream& out, const ContactFeature& feature);
std::ostream& operator<<(std::ostream& out, const Voxel& voxel);

/// These write volumes, triangles and motions with their numbers.
std::ostream& operator<<(std::ostream& out, const Aabb& box);
std::ostream& operator<<(std::ostream& out, const Obb& box);
std::ostream& operator<<(std::ostream& out, const Sphere& sphere);
std::ostream& operator<<(std::ostream& out, const KDop<18>& kdop);
std::ostream& operator<<(std::ostream& out, const Ray& ray);
std::ostream& operator<<(std::ostream& out, const Triangle& triangle);
std::ostream& operator<<(std::ostream& out, const VoxelGrid& grid);
std::ostream& operator<<(std::ostream& out, const RigidMotion& motion);

/// These write results with their members.
std::ostream& operator<<(std::ostream& out, const TrianglePairs& pairs);
std::ostream& operator<<(std::ostream& out, const TriangleList& triangles);
std::ostream& operator<<(std::ostream& out, const TriangleDistance& distance);
std::ostream& operator<<(std::ostream& out, const TriangleIntersection& common);
std::ostream& operator<<(std::ostream& out, const TriangleRayHit& hit);
std::ostream& operator<<(std::ostream& out, const FirstContact& contact);
std::ostream& operator<<(std::ostream& out, const MeshFirstContact& contact);
std::ostream& operator<<(std::ostream& out, const MeshCast& cast);
std::ostream& operator<<(std::ostream& out, const VolumeCast& cast);
std::ostream& operator<<(std::ostream& out, const RigidContact& contact);
std::ostream& operator<<(std::ostream& out, const MeshDistance& distance);
std::ostream& operator<<(std::ostream& out, const NearestPoint& nearest);
std::ostream& operator<<(std::ostream& out, const MeshHealth& health);
std::ostream& operator<<(std::ostream& out, const MeshContact& contact);
std::ostream& operator<<(std::ostream& out, const MeshContacts& contacts);
std::ostream& operator<<(std::ostream& out, const SeparatingTranslation& separation);
std::ostream& operator<<(std::ostream& out, const VolumeFit& fit);
std::ostream& operator<<(std::ostream& out, const MeshFit& fit);
std::ostream& operator<<(std::ostream& out, const RayHit& hit);
std::ostream& operator<<(std::ostream& out, const ShapeDistance& distance);
std::ostream& operator<<(std::ostream& out, const ShapeSeparation& separation);
std::ostream& operator<<(std::ostream& out, const ShapeCast& cast);
std::ostream& operator<<(std::ostream& out, const ShapeContact& contact);
std::ostream& operator<<(std::ostream& out, const Manifold& manifold);
std::ostream& operator<<(std::ostream& out, const BodyContact& contact);
std::ostream& operator<<(std::ostream& out, const BodyDistance& distance);
std::ostream& operator<<(std::ostream& out, const BodyRayHit& hit);
std::ostream& operator<<(std::ostream& out, const BodyCast& cast);
std::ostream& operator<<(std::ostream& out, const BodyPairDistance& distance);
std::ostream& operator<<(std::ostream& out, const BodyFirstContact& contact);

/// These write how many parts there are of what is large.
std::ostream& operator<<(std::ostream& out, const Topology& topology);
std::ostream& operator<<(std::ostream& out, const MeshIntersection& common);
std::ostream& operator<<(std::ostream& out, const Voxels& voxels);
std::ostream& operator<<(std::ostream& out, const FreedomCertificate& certificate);
std::ostream& operator<<(std::ostream& out, const WorldUpdate& update);

/// These write only the counters that are not 0.
std::ostream& operator<<(std::ostream& out, const Work& work);
std::ostream& operator<<(std::ostream& out, const WorldWork& work);

}  // namespace graze
