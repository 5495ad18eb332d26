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

/// Where a mesh of a case comes from, if not from the case itself.
struct CaseMeshFile {
  std::string path;    ///< relative to the folder of the case, which it cannot leave
  std::string sha256;  ///< of the file's bytes
};

/// A mesh of a case, in its pose.
struct CaseMesh {
  /// A mesh of vertices in a pose, or what a query was asked about.
  CaseMesh(Mesh the_mesh, const Pose& the_pose) : mesh(std::move(the_mesh)), pose(the_pose) {}
  CaseMesh(const PlacedMeshView& placed) : mesh(placed.mesh), pose(placed.pose) {}

  Mesh mesh;                         ///< a handle
  Pose pose;                         ///< of the mesh
  std::optional<CaseMeshFile> file;  ///< written in place of the vertices
  /// Where it goes from its pose, of Ask::FirstContact and Ask::Free; none: it rests.
  std::optional<RigidCourse> course = {};
};

/// A point, metres.
struct CasePoint {
  Eigen::Vector3d position;  ///< in the common frame
};

/// Any shape that a body of a world can have, in its pose.
struct CaseBody {
  /// A shape in a pose; a height field as the mesh that it is, which says the same. What a ray hits
  /// is then called by the mesh's numbers, which leave out holes.
  CaseBody(Shape the_shape, const Pose& the_pose) : shape(std::move(the_shape)), pose(the_pose) {
    if (const auto* field = shape.as<HeightField>()) shape = Shape(field->mesh());
  }

  Shape shape;  ///< a handle, where it is a hull or a mesh
  Pose pose;    ///< of the shape
  /// Where it goes from its pose, of Ask::FirstContact and Ask::Free; none: it rests.
  std::optional<RigidCourse> course = {};
};

/// One of the two things that a case asks about. Only meshes and bodies have poses: a triangle is
/// placed.
using CaseShape = std::variant<Triangle, Aabb, Obb, Sphere, CasePoint, CaseMesh, CaseBody, Ray>;

/// Which query a case is. The names in brackets are those of the file. README.md has the table of
/// all queries.
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

/// The settings that can change an answer, and no others.
struct CaseSettings {
  /// Of two meshes' Any; of two triangles' Any and meshes' Pairs Touching or Crossing; of a mesh's
  /// and a volume's Any Touching or Solid.
  Hit hit = Hit::Touching;
  double clearance = 0;     ///< metres, of Ask::Within, FirstContact and Free
  double tolerance = 1e-6;  ///< metres, of Ask::FirstContact and Free
  /// Of Ask::Separation, of any length; none: the best that is found.
  std::optional<Eigen::Vector3d> direction = {};
  SelfPairKind self_kind = SelfPairKind::Intersecting;  ///< of Ask::SelfPairs
  /// Of Pairs and SelfPairs: stop after so many. Which ones these are is for the engine to say.
  std::optional<std::uint32_t> limit = {};
};

/// A MeshContact without what refers to lists.
struct CaseContact {
  Eigen::Vector3d point;    ///< midway between the two
  Eigen::Vector3d point_a;  ///< on A
  Eigen::Vector3d point_b;  ///< on B
  Eigen::Vector3d normal;   ///< from A to B
  double depth;             ///< metres
};

/// A ShapeContact, as far as its engine or its file names points on the surfaces.
struct CaseShapeContact {
  Eigen::Vector3d point;                   ///< midway between the two, or where the engine puts it
  std::optional<Eigen::Vector3d> point_a;  ///< on A
  std::optional<Eigen::Vector3d> point_b;  ///< on B
  Eigen::Vector3d normal;                  ///< from A to B
  double depth;                            ///< metres
  ContactFeature feature;                  ///< which parts meet
};

/// What an engine answered: the parts that its question asks for. Distances alone may be infinite,
/// where the true one is beyond the largest double.
struct CaseAnswer {
  std::optional<bool> says;                             ///< Any, Within, Contains, SelfAny, Free
  std::optional<std::vector<TrianglePair>> pairs;       ///< Pairs of two meshes, SelfPairs
  std::optional<std::vector<std::uint32_t>> triangles;  ///< Pairs, of a mesh and a volume
  /// Distance, Separation; metres. Of a distance a negative one claims a touch: some engines return
  /// -1 or how deep it is.
  std::optional<double> distance;
  std::optional<double> lower_bound;                      ///< Distance of bodies, metres
  std::optional<bool> is_converged;                       ///< likewise
  std::optional<Eigen::Vector3d> normal;                  ///< likewise, from A to B
  std::optional<Eigen::Vector3d> point_a;                 ///< Distance, if the engine names points
  std::optional<Eigen::Vector3d> point_b;                 ///< likewise
  std::optional<TrianglePair> pair;                       ///< Distance, if the engine names a pair
  std::optional<Eigen::Vector3d> translation;             ///< Separation, metres
  std::optional<std::vector<CaseContact>> contacts;       ///< Contacts, of meshes
  std::optional<std::vector<CaseShapeContact>> manifold;  ///< Contacts, of bodies
  std::optional<CaseIntersection> intersection;           ///< Intersection, of meshes
  std::optional<std::vector<Eigen::Vector3d>> corners;    ///< Intersection, of triangles
  std::optional<std::vector<RayHit>> hits;                ///< Ray: one at most; RayAll
  std::optional<RigidStatus> status;                      ///< FirstContact
  /// FirstContact: no contact before it. 1 for what is free. An engine that names one time alone
  /// says it in both.
  std::optional<double> low;
  std::optional<double>
      high;  ///< FirstContact: they meet at it or before; 1 if no contact is known
};

/// Whether two answers agree in every bit, but for the sign of zeros in numbers that are equal. On
/// which points of the surfaces two bodies meet is compared where both answers say it.
bool is_same(const CaseAnswer& answer_a, const CaseAnswer& answer_b);

/// Who answered.
struct CaseWitness {
  std::string engine = "graze";  ///< its name
  std::string version;           ///< empty if it does not say
};

/// A query that can be asked again, bit for bit, with the answer that somebody gave.
struct Case {
  std::string note;                  ///< why it is kept; may be empty
  Ask ask = Ask::Any;                ///< which query
  CaseSettings settings;             ///< of that query
  CaseShape a;                       ///< the first thing that it is about
  std::optional<CaseShape> b;        ///< none where A is asked about itself
  std::optional<CaseAnswer> answer;  ///< none: it has not been answered
  CaseWitness answered_by;           ///< who gave that answer
  std::string origin = {};           ///< where it is from, for people: an address; may be empty
};

/// The name of a question, a shape or a status in a file.
const char* name_of(Ask ask);
const char* name_of(const CaseShape& shape);
const char* name_of(RigidStatus status);

}  // namespace graze
