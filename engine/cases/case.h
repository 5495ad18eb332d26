#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <graze/bvh/aabb.h>
#include <graze/bvh/obb.h>
#include <graze/bvh/ray.h>
#include <graze/bvh/sphere.h>
#include <graze/engine/cases/case_intersection.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/mesh_ray.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/mesh/query_settings.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/mesh/self.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape.h>
#include <graze/narrowphase/triangle.h>

namespace graze {

/// Says which file a mesh of a case comes from, if not from the case itself.
struct CaseMeshFile {
  std::string path;    ///< relative to the folder of the case, which it cannot leave
  std::string sha256;  ///< the SHA-256 of the file's bytes
};

/// Holds a mesh of a case, in its pose.
struct CaseMesh {
  /// Takes a mesh of vertices in a pose, or the mesh that a query was asked about.
  CaseMesh(Mesh the_mesh, const Pose& the_pose) : mesh(std::move(the_mesh)), pose(the_pose) {}
  CaseMesh(const PlacedMeshView& placed) : mesh(placed.mesh), pose(placed.pose) {}

  Mesh mesh;                         ///< a handle
  Pose pose;                         ///< the mesh's pose
  std::optional<CaseMeshFile> file;  ///< the file, written in place of the vertices
  /// The course on which the mesh goes from its pose, for Ask::FirstContact and Ask::Free; without
  /// one it rests.
  std::optional<RigidCourse> course = {};
};

/// Holds a point, metres.
struct CasePoint {
  Eigen::Vector3d position;  ///< the point in the common frame
};

/// Holds any shape that a body of a world can have, in its pose.
struct CaseBody {
  /// Takes a shape in a pose. A height field is kept as the mesh that it is, which says the same;
  /// what a ray hits is then called by the mesh's numbers, which leave out holes.
  CaseBody(Shape the_shape, const Pose& the_pose) : shape(std::move(the_shape)), pose(the_pose) {
    if (const auto* field = shape.as<HeightField>()) shape = Shape(field->mesh());
  }

  Shape shape;  ///< a handle, where it is a hull or a mesh
  Pose pose;    ///< the shape's pose
  /// The course on which the shape goes from its pose, for Ask::FirstContact and Ask::Free; without
  /// one it rests.
  std::optional<RigidCourse> course = {};
};

/// One of the two things that a case asks about. Only meshes and bodies have poses: a triangle is
/// placed.
using CaseShape = std::variant<Triangle, Aabb, Obb, Sphere, CasePoint, CaseMesh, CaseBody, Ray>;

/// Names the query that a case is. The names in brackets are those of the file. README.md has the
/// table of all queries.
enum class Ask {
  Any,           ///< "any": intersects(A, B), or intersects(A, B) of two volumes
  Pairs,         ///< "pairs": find_triangle_pairs(A, B), find_triangles(A, B) for a volume B
  Distance,      ///< "distance": distance(A, B) of meshes, triangles or bodies
  Within,        ///< "within": within(A, B, clearance)
  Contacts,      ///< "contacts": find_contacts(A, B) of meshes or bodies
  Intersection,  ///< "intersection": find_intersection(A, B), intersection(A, B) of triangles
  Separation,    ///< "separation": separating_translation(A, B), along a direction or the best
  Ray,           ///< "ray": cast_ray(A, B) of a mesh, a triangle or a body, and a ray
  RayAll,        ///< "ray_all": cast_ray_all(A, B), a mesh and a ray
  Contains,      ///< "contains": contains(A, B), a mesh or a volume, and a point
  SelfAny,       ///< "self_any": self_intersects(A)
  SelfPairs,     ///< "self_pairs": find_self_pairs(A)
  FirstContact,  ///< "first_contact": first_contact(A, B) of two meshes or bodies in motion
  Free,          ///< "free": is_free(A, B) of two meshes or bodies in motion
};

/// Holds the settings that can change an answer, and no others.
struct CaseSettings {
  /// The touches that count as a hit. Any of two meshes takes every kind. Any of two triangles, and
  /// Pairs of two meshes, take Touching or Crossing. Any of a mesh and a volume takes Touching or
  /// Solid.
  Hit hit = Hit::Touching;
  double clearance = 0;     ///< metres, for Ask::Within, FirstContact and Free
  double tolerance = 1e-6;  ///< metres, for Ask::FirstContact and Free
  /// The direction for Ask::Separation, of any length; without one the best that is found is meant.
  std::optional<Eigen::Vector3d> direction = {};
  SelfPairKind self_kind = SelfPairKind::Intersecting;  ///< for Ask::SelfPairs
  /// The number of pairs after which Pairs and SelfPairs stop. Which pairs these are is for the
  /// engine to say.
  std::optional<std::uint32_t> limit = {};
};

/// Holds a MeshContact without what refers to lists.
struct CaseContact {
  Eigen::Vector3d point;    ///< midway between the two
  Eigen::Vector3d point_a;  ///< the point on A
  Eigen::Vector3d point_b;  ///< the point on B
  Eigen::Vector3d normal;   ///< from A to B; unit unless the engine errs
  double depth;             ///< metres
};

/// Holds a ShapeContact, with points on the surfaces if its engine or its file names them.
struct CaseShapeContact {
  Eigen::Vector3d point;                   ///< midway between the two, or where the engine puts it
  std::optional<Eigen::Vector3d> point_a;  ///< the point on A
  std::optional<Eigen::Vector3d> point_b;  ///< the point on B
  Eigen::Vector3d normal;                  ///< from A to B; unit unless the engine errs
  double depth;                            ///< metres
  ContactFeature feature;                  ///< the parts that meet
};

/// Holds what an engine answered: the parts that its question asks for. Distances alone may be
/// infinite, where the true one is beyond the largest double.
struct CaseAnswer {
  std::optional<bool> says;                             ///< Any, Within, Contains, SelfAny, Free
  std::optional<std::vector<TrianglePair>> pairs;       ///< Pairs of two meshes, SelfPairs
  std::optional<std::vector<std::uint32_t>> triangles;  ///< Pairs, of a mesh and a volume
  /// Distance, Separation; metres. A negative answer to Distance claims a touch: some engines
  /// return -1, or minus the depth.
  std::optional<double> distance;
  std::optional<double> lower_bound;                      ///< Distance of bodies, metres
  std::optional<bool> is_converged;                       ///< Distance of bodies
  std::optional<Eigen::Vector3d> normal;                  ///< Distance of bodies, from A to B
  std::optional<Eigen::Vector3d> point_a;                 ///< Distance, if the engine names points
  std::optional<Eigen::Vector3d> point_b;                 ///< Distance, if the engine names points
  std::optional<TrianglePair> pair;                       ///< Distance, if the engine names a pair
  std::optional<Eigen::Vector3d> translation;             ///< Separation, metres
  std::optional<std::vector<CaseContact>> contacts;       ///< Contacts, of meshes
  std::optional<std::vector<CaseShapeContact>> manifold;  ///< Contacts, of bodies
  std::optional<CaseIntersection> intersection;           ///< Intersection, of meshes
  std::optional<std::vector<Eigen::Vector3d>> corners;    ///< Intersection, of triangles
  std::optional<std::vector<RayHit>> hits;                ///< Ray, at most one; RayAll
  std::optional<RigidStatus> status;                      ///< FirstContact
  /// FirstContact: there is no contact before this time; 1 for what is free. An engine that names
  /// one time alone says it in both.
  std::optional<double> low;
  std::optional<double>
      high;  ///< FirstContact: the two meet at this time or before; 1 if no contact is known
};

/// True if two answers agree in every bit, but for the sign of zeros in numbers that are equal. On
/// which points of the surfaces two bodies meet is compared where both answers say it.
bool is_same(const CaseAnswer& answer_a, const CaseAnswer& answer_b);

/// Says who answered.
struct CaseWitness {
  std::string engine = "graze";  ///< the engine's name
  std::string version;           ///< empty if it does not say
};

/// Holds a query that can be asked again, bit for bit, with the answer that somebody gave.
struct Case {
  std::string note;                  ///< why it is kept; may be empty
  Ask ask = Ask::Any;                ///< the query
  CaseSettings settings;             ///< the settings of that query
  CaseShape a;                       ///< the first thing that it is about
  std::optional<CaseShape> b;        ///< the second thing; none where A is asked about itself
  std::optional<CaseAnswer> answer;  ///< none if it has not been answered
  CaseWitness answered_by;           ///< the engine that gave that answer
  std::string origin = {};           ///< the address that it is from, for people; may be empty
};

/// Return the name of a question, a shape or a status in a file.
const char* name_of(Ask ask);
const char* name_of(const CaseShape& shape);
const char* name_of(RigidStatus status);

}  // namespace graze
