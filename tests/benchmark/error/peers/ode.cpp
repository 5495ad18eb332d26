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
}

}  // namespace graze::benchmark
