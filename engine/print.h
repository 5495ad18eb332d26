#pragma once

// These write values as one line of text, for logs, debuggers and failing tests: numbers in the
// fewest digits that give the same double, whatever the stream has set, lengths in metres. Long
// lists end after sixteen elements with how many more there are. The text is for people and may
// change.

#include <graze/bvh/error.h>
#include <graze/bvh/kdop.h>
#include <graze/bvh/obb.h>
#include <graze/bvh/pose.h>
#include <graze/bvh/ray.h>
#include <graze/bvh/sphere.h>
#include <graze/bvh/volume.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/fit.h>
#include <graze/engine/mesh/interior.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/mesh_cast.h>
#include <graze/engine/mesh/mesh_contacts.h>
#include <graze/engine/mesh/mesh_health.h>
#include <graze/engine/mesh/mesh_intersection.h>
#include <graze/engine/mesh/mesh_path.h>
#include <graze/engine/mesh/mesh_ray.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/mesh/prepare.h>
#include <graze/engine/mesh/query_settings.h>
#include <graze/engine/mesh/rigid_certificate.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/mesh/separating_translation.h>
#include <graze/engine/mesh/triangle_pairs.h>
#include <graze/engine/mesh/volume_cast.h>
#include <graze/engine/mesh/voxel_grid.h>
#include <graze/engine/mesh/voxels.h>
#include <graze/engine/work.h>
#include <graze/engine/world/body.h>
#include <graze/engine/world/broad_phase.h>
#include <graze/engine/world/convex_hull.h>
#include <graze/engine/world/height_field.h>
#include <graze/engine/world/ids.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/placed_shape.h>
#include <graze/engine/world/shape.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_cast.h>
#include <graze/engine/world/shape_motion.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shape_separation.h>
#include <graze/engine/world/sides.h>
#include <graze/engine/world/world.h>
#include <graze/engine/world/world_drawing.h>
#include <graze/engine/world/world_pairs.h>
#include <graze/engine/world/world_update.h>
#include <graze/narrowphase/first_contact.h>
#include <graze/narrowphase/touch.h>
#include <graze/narrowphase/triangle.h>
#include <graze/narrowphase/triangle_distance.h>
#include <graze/narrowphase/triangle_intersection.h>
#include <graze/narrowphase/triangle_ray.h>
#include <graze/narrowphase/volumes/ellipsoid.h>

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
std::ostream& operator<<(std::ostream& out, const RigidCourse& course);
std::ostream& operator<<(std::ostream& out, const RigidVelocities& velocities);
std::ostream& operator<<(std::ostream& out, const Screw& screw);
std::ostream& operator<<(std::ostream& out, const PointPath& path);
std::ostream& operator<<(std::ostream& out, const EdgePath& path);
std::ostream& operator<<(std::ostream& out, const TrianglePath& path);
std::ostream& operator<<(std::ostream& out, const ErrorPlace& place);

/// These write shapes, placed or in motion, with their numbers; of hulls, height fields and meshes
/// how large they are.
std::ostream& operator<<(std::ostream& out, const Ellipsoid& ellipsoid);
std::ostream& operator<<(std::ostream& out, const Box& box);
std::ostream& operator<<(std::ostream& out, const Capsule& capsule);
std::ostream& operator<<(std::ostream& out, const Cylinder& cylinder);
std::ostream& operator<<(std::ostream& out, const Cone& cone);
std::ostream& operator<<(std::ostream& out, const HalfSpace& half_space);
std::ostream& operator<<(std::ostream& out, const Plane& plane);
std::ostream& operator<<(std::ostream& out, const ConvexHull& hull);
std::ostream& operator<<(std::ostream& out, const HeightField& field);
std::ostream& operator<<(std::ostream& out, const FieldRange& range);
std::ostream& operator<<(std::ostream& out, const Mesh& mesh);
std::ostream& operator<<(std::ostream& out, const Shape& shape);
std::ostream& operator<<(std::ostream& out, const PlacedShape& placed);
std::ostream& operator<<(std::ostream& out, const PlacedMesh& placed);
std::ostream& operator<<(std::ostream& out, const ShapeInMotion& moving);
std::ostream& operator<<(std::ostream& out, const MeshInMotion& moving);
std::ostream& operator<<(std::ostream& out, const RigidPair& pair);
std::ostream& operator<<(std::ostream& out, const MeshSides& sides);
std::ostream& operator<<(std::ostream& out, const Filter& filter);
std::ostream& operator<<(std::ostream& out, const BoxGap& gap);

/// These write the names of enumerators, and of what is none its number.
std::ostream& operator<<(std::ostream& out, Touch value);
std::ostream& operator<<(std::ostream& out, StartContact value);
std::ostream& operator<<(std::ostream& out, IntersectionKind value);
std::ostream& operator<<(std::ostream& out, Feature value);
std::ostream& operator<<(std::ostream& out, Hit value);
std::ostream& operator<<(std::ostream& out, Interior value);
std::ostream& operator<<(std::ostream& out, Completeness value);
std::ostream& operator<<(std::ostream& out, SelfPairKind value);
std::ostream& operator<<(std::ostream& out, VoxelFill value);
std::ostream& operator<<(std::ostream& out, PreparedFor value);
std::ostream& operator<<(std::ostream& out, MeetingFeatures value);
std::ostream& operator<<(std::ostream& out, RigidStatus value);
std::ostream& operator<<(std::ostream& out, FreedomStep::Kind value);
std::ostream& operator<<(std::ostream& out, Sides value);
std::ostream& operator<<(std::ostream& out, BodyKind value);
std::ostream& operator<<(std::ostream& out, Detection value);
std::ostream& operator<<(std::ostream& out, Role value);
std::ostream& operator<<(std::ostream& out, PairStatus value);
std::ostream& operator<<(std::ostream& out, PairMethod value);
std::ostream& operator<<(std::ostream& out, Drawn value);
std::ostream& operator<<(std::ostream& out, Volume value);
std::ostream& operator<<(std::ostream& out, PairVolume value);
std::ostream& operator<<(std::ostream& out, ShapeKind value);

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

/// These write parts of what check(), find_intersection() and certify_free() return.
std::ostream& operator<<(std::ostream& out, const FaultyEdge& edge);
std::ostream& operator<<(std::ostream& out, const DuplicateTriangle& triangle);
std::ostream& operator<<(std::ostream& out, const InsideOutPart& part);
std::ostream& operator<<(std::ostream& out, const IntersectionPoint& point);
std::ostream& operator<<(std::ostream& out, const IntersectionSegment& segment);
std::ostream& operator<<(std::ostream& out, const IntersectionCurve& curve);
std::ostream& operator<<(std::ostream& out, const IntersectionPolygon& polygon);
std::ostream& operator<<(std::ostream& out, const IntersectionPatch& patch);
std::ostream& operator<<(std::ostream& out, const TouchingPoint& touching);
std::ostream& operator<<(std::ostream& out, const FreedomStep& step);

/// These write how many parts there are of what is large.
std::ostream& operator<<(std::ostream& out, const Topology& topology);
std::ostream& operator<<(std::ostream& out, const MeshIntersection& common);
std::ostream& operator<<(std::ostream& out, const Voxels& voxels);
std::ostream& operator<<(std::ostream& out, const FreedomCertificate& certificate);
std::ostream& operator<<(std::ostream& out, const WorldUpdate& update);

/// These write only the counters that are not 0.
std::ostream& operator<<(std::ostream& out, const Work& work);
std::ostream& operator<<(std::ostream& out, const WorldWork& work);
std::ostream& operator<<(std::ostream& out, const BroadPhaseWork& work);

}  // namespace graze
