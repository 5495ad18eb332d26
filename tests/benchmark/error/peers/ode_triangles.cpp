// ODE's triangles: meshes that dCollide() asks for one contact. A mesh of one triangle crashes it,
// so each has its triangle twice.

#include <ode/ode.h>

#include <array>
#include <memory>

#include "tests/benchmark/error/peers/peers.h"

namespace graze::benchmark {
namespace {

/// A mesh, its data and the arrays that the data refer to: it stays where it is.
class TriangleGeom {
 public:
  explicit TriangleGeom(const Triangle& t) : data_(dGeomTriMeshDataCreate()) {
    for (std::size_t i = 0; i < 3; ++i) {
      vertices_[i] = t.a.data()[i];
      vertices_[i + 3] = t.b.data()[i];
      vertices_[i + 6] = t.c.data()[i];
    }
    dGeomTriMeshDataBuildDouble(data_, vertices_.data(), 3 * sizeof(double), 3, indices_.data(), 6,
                                3 * sizeof(dTriIndex));
    geom_ = dCreateTriMesh(nullptr, data_, nullptr, nullptr, nullptr);
  }
  TriangleGeom(const TriangleGeom&) = delete;
  TriangleGeom& operator=(const TriangleGeom&) = delete;
  ~TriangleGeom() {
    dGeomDestroy(geom_);
    dGeomTriMeshDataDestroy(data_);
  }

  dGeomID geom() const { return geom_; }

 private:
  std::array<double, 9> vertices_;
  std::array<dTriIndex, 6> indices_{0, 1, 2, 0, 1, 2};
  dTriMeshDataID data_;
  dGeomID geom_;
};

struct Geoms {
  std::unique_ptr<TriangleGeom> a;
  std::unique_ptr<TriangleGeom> b;
};

bool meet(const Geoms& geoms) {
  dContactGeom contact;
  return dCollide(geoms.a->geom(), geoms.b->geom(), 1, &contact, sizeof contact) > 0;
}

}  // namespace

void add_ode_triangles(Field& field) {
  add(
      field.triangle_pairs, {"ODE", Origin::Peer, "double", std::nullopt},
      [](const TrianglePair& pair) {
        return Geoms{std::make_unique<TriangleGeom>(pair.a),
                     std::make_unique<TriangleGeom>(pair.b)};
      },
      meet);
}

}  // namespace graze::benchmark
