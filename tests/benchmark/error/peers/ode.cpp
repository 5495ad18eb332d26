// ODE, compiled for double: dCollide() of geoms that are there before the clock starts, asked for
// one contact. A box is a centre and lengths here: that much rounding its types force.

#include <ode/ode.h>

#include <memory>

#include "tests/benchmark/error/peers/peers.h"

namespace graze::benchmark {
namespace {

struct Destroy {
  void operator()(dGeomID geom) const { dGeomDestroy(geom); }
};
using Geom = std::unique_ptr<dxGeom, Destroy>;

Geom to_ode(const Sphere& sphere) {
  Geom geom(dCreateSphere(nullptr, sphere.radius));
  dGeomSetPosition(geom.get(), sphere.centre.x(), sphere.centre.y(), sphere.centre.z());
  return geom;
}

Geom to_ode(const Aabb& box) {
  const Eigen::Vector3d centre = 0.5 * box.min + 0.5 * box.max;
  const Eigen::Vector3d size = box.max - box.min;
  Geom geom(dCreateBox(nullptr, size.x(), size.y(), size.z()));
  dGeomSetPosition(geom.get(), centre.x(), centre.y(), centre.z());
  return geom;
}

Geom to_ode(const Obb& box) {
  const Eigen::Vector3d size = 2 * box.half_extents;
  Geom geom(dCreateBox(nullptr, size.x(), size.y(), size.z()));
  const double* m = box.pose.data();  // column-major 4x4, ODE's rows of 4
  const dMatrix3 rotation = {m[0], m[4], m[8], 0, m[1], m[5], m[9], 0, m[2], m[6], m[10], 0};
  dGeomSetRotation(geom.get(), rotation);
  dGeomSetPosition(geom.get(), m[12], m[13], m[14]);
  return geom;
}

struct Geoms {
  Geom a;
  Geom b;
};

bool meet(const Geoms& geoms) {
  dContactGeom contact;
  return dCollide(geoms.a.get(), geoms.b.get(), 1, &contact, sizeof contact) > 0;
}

}  // namespace

void add_ode(Field& field) {
  dInitODE2(0);
  dAllocateODEDataForThread(dAllocateMaskAll);
  const Label label{"ODE", Origin::Peer, "double", std::nullopt};
  add(
      field.sphere_boxes, label,
      [](const SphereAndBox& pair) {
        return Geoms{to_ode(pair.sphere), to_ode(pair.box)};
      },
      meet);
  add(
      field.sphere_pairs, label,
      [](const SpherePair& pair) {
        return Geoms{to_ode(pair.a), to_ode(pair.b)};
      },
      meet);
  add(
      field.obb_pairs, label,
      [](const ObbPair& pair) {
        return Geoms{to_ode(pair.a), to_ode(pair.b)};
      },
      meet);
  add_ode_triangles(field);
}

}  // namespace graze::benchmark
