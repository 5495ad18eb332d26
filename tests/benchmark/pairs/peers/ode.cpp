// ODE, compiled for double: dCollide() of two trimeshes (OPCODE, whose trees are of floats), asked
// for one contact of no importance. What it lists are contacts, merged and at most 65,535: not the
// pairs.

#include <ode/ode.h>

#include <memory>
#include <type_traits>

#include "tests/benchmark/pairs/peers/peers.h"

namespace graze::benchmark {
namespace {

struct DestroyGeom {
  void operator()(dGeomID geom) const { dGeomDestroy(geom); }
};
struct DestroyData {
  void operator()(dTriMeshDataID data) const { dGeomTriMeshDataDestroy(data); }
};

/// A trimesh and the arrays that it refers to.
class Trimesh {
 public:
  explicit Trimesh(const Mesh& mesh) : data_(dGeomTriMeshDataCreate()) {
    for (const Eigen::Vector3d& p : mesh.vertices())
      vertices_.insert(vertices_.end(), {p.x(), p.y(), p.z()});
    for (const TriangleIndices& t : mesh.triangles())
      indices_.insert(indices_.end(), t.begin(), t.end());
    dGeomTriMeshDataBuildDouble(data_.get(), vertices_.data(), 3 * sizeof(double),
                                static_cast<int>(mesh.vertices().size()), indices_.data(),
                                static_cast<int>(indices_.size()), 3 * sizeof(dTriIndex));
    geom_.reset(dCreateTriMesh(nullptr, data_.get(), nullptr, nullptr, nullptr));
  }

  void move(const Pose& pose) {
    dMatrix3 rotation = {};
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k)
        rotation[4 * i + k] = pose.linear()(i, k);
    }
    const auto& t = pose.translation();
    dGeomSetPosition(geom_.get(), t.x(), t.y(), t.z());
    dGeomSetRotation(geom_.get(), rotation);
  }

  dGeomID geom() const { return geom_.get(); }

 private:
  std::vector<double> vertices_;
  std::vector<dTriIndex> indices_;
  std::unique_ptr<std::remove_pointer_t<dTriMeshDataID>, DestroyData> data_;
  std::unique_ptr<dxGeom, DestroyGeom> geom_;
};

class OdePairs final : public PairContestant {
 public:
  OdePairs() : PairContestant("ODE") {}

  std::string refusal(Question question) const override {
    if (question == Question::Any) return "";
    return question == Question::Pairs ? "it lists contacts, not pairs" : "it has no distance";
  }
  void build(const Mesh& mesh_a, const Mesh& mesh_b) override {
    a_ = std::make_unique<Trimesh>(mesh_a);
    b_ = std::make_unique<Trimesh>(mesh_b);
  }
  void release() override {
    a_.reset();
    b_.reset();
  }
  bool any(const Pose& pose_b) override {
    b_->move(pose_b);
    dContactGeom contact;
    constexpr int kOne = static_cast<int>(CONTACTS_UNIMPORTANT | 1U);
    return dCollide(a_->geom(), b_->geom(), kOne, &contact, sizeof contact) > 0;
  }

 private:
  std::unique_ptr<Trimesh> a_;
  std::unique_ptr<Trimesh> b_;
};

}  // namespace

void add_ode(PairContestants& contestants) {
  dInitODE2(0);
  dAllocateODEDataForThread(dAllocateMaskAll);
  contestants.push_back(std::make_unique<OdePairs>());
}

}  // namespace graze::benchmark
