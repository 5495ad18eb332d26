#include "tests/engine/first_touch/motion_questions.h"

#include <graze/engine/mesh/mesh_cast.h>
#include <graze/engine/mesh/mesh_path.h>
#include <graze/engine/mesh/rigid_certificate.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/volume_cast.h>
#include <graze/engine/world/shape_cast.h>
#include <graze/engine/world/shape_motion.h>

#include <vector>

#include "tests/shapes/pose_at.h"

namespace graze::tests {
namespace {

/// They touch there, and are apart there.
Pose beside() {
  return at(0.3, 0.1, 0.2);
}
Pose far_away() {
  return at(2.5, 0.1, 0.2);
}

/// B, as it falls on A and turns.
RigidMotion falling() {
  return RigidMotion(at(0, 0, 2.5), {.shift = {0.1, 0.2, -3}, .axis = {1, 2, 3}, .angle = 2});
}

Digest told(const RigidContact& found) {
  return Digest() << found.status << found.low << found.high;
}

}  // namespace

/// Both rise by a metre in a step, and B back again.
Digest on_the_way(const Mesh& a, const Mesh& b) {
  const auto raised = [](const Mesh& mesh) {
    std::vector<Eigen::Vector3d> vertices(mesh.vertices().begin(), mesh.vertices().end());
    for (Eigen::Vector3d& vertex : vertices)
      vertex.z() += 1;
    return mesh.deformed(vertices);
  };
  const MeshPath rising(a, raised(a)), sinking(raised(b), b);
  Digest digest;
  for (const auto& met : {first_contact(rising, sinking), first_self_contact(rising),
                          first_contact(rising, sinking, {.clearance = 0.01})}) {
    digest << met.has_value();
    if (met) digest << met->time << met->pair.a << met->pair.b;
  }
  const auto cast_down = cast({a}, {b, beside()}, Eigen::Vector3d(0.1, 0.2, -3));
  digest << cast_down.has_value();
  if (cast_down) digest << cast_down->time << cast_down->pair.a << cast_down->pair.b;
  return digest;
}

Digest in_motion(const Mesh& a, const Mesh& b) {
  const RigidMotion rest(beside());
  Digest digest = told(first_contact({a, rest}, {b, falling()}));
  digest << is_free({a, rest}, {b, falling()}, {.clearance = 0.1});
  if (const auto last = last_free({a, rest}, {b, falling()})) digest << *last;
  const RigidContact of_shapes = first_contact({Shape(a), rest}, {Capsule{0.25, 0.5}, falling()});
  return digest << of_shapes.low << of_shapes.high;
}

Digest certified(const Mesh& a, const Mesh& b) {
  const RigidMotion rest(beside()), slides(at(4), {.shift = {0, 0.5, 0.25}, .angle = 0.5});
  const auto proof = certify_free({a, rest}, {b, slides});
  Digest digest;
  digest << proof.has_value();
  if (proof) digest << proof->steps.size() << proves_freedom(*proof, {a, rest}, {b, slides});
  return digest;
}

Digest many_motions(const Mesh& a, const Mesh& b) {
  const RigidMotion rest(beside()), away(far_away());
  Digest digest;
  for (const RigidContact& found :
       first_contact({a, rest}, {b, std::vector<RigidMotion>{falling(), away}}))
    digest << found.low << found.high;
  const std::vector<RigidPair> pairs{
      {a, rest, b, falling()}, {b, away, a, rest}, {a, away, a, rest}};
  for (const RigidContact& found : first_contact(pairs))
    digest << found.low << found.high;
  for (const bool free : is_free(pairs))
    digest << free;
  return digest;
}

Digest straight(const Mesh& a, const Mesh& b) {
  Digest digest;
  const Eigen::Vector3d down(0.1, 0.2, -3);
  if (const auto met = cast({a}, Sphere{{0, 0, 2.5}, 0.25}, down))
    digest << met->time << met->point;
  for (const Shape& shape : {Shape(b), Shape(Capsule{0.25, 0.5})}) {
    const auto met = cast({Shape(a), beside()}, {shape, at(0, 0, 2.5)}, down);
    if (met) digest << met->time << met->point << met->normal;
  }
  return digest;
}

}  // namespace graze::tests
