// Embree: rtcCollide() finds pairs of float boxes of two trees; the test of two triangles is the
// caller's, here Guigue and Devillers' in float, since the library exports none. Its trees do not
// move, so that a query places the second mesh, and refits its tree to it: that is in the time.

#include <embree3/rtcore.h>

#include <graze/bvh/error.h>
#include <graze/engine/mesh/placement.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <type_traits>
#include <vector>

#include "tests/benchmark/error/baselines/guigue_devillers.h"
#include "tests/benchmark/error/peers/peers.h"

namespace graze::benchmark {
namespace {

template <auto release>
struct Release {
  template <typename Object>
  void operator()(Object* object) const {
    release(object);
  }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release<rtcReleaseDevice>>;
using Scene = std::unique_ptr<std::remove_pointer_t<RTCScene>, Release<rtcReleaseScene>>;
using Geometry = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, Release<rtcReleaseGeometry>>;

using FloatTriangle = PlainTriangle<float>;

/// The box of a triangle in floats, which its corners are already.
void find_bounds(const RTCBoundsFunctionArguments* arguments) {
  const FloatTriangle& t = (*static_cast<const std::vector<FloatTriangle>*>(
      arguments->geometryUserPtr))[arguments->primID];
  RTCBounds& box = *arguments->bounds_o;
  float* lower[3] = {&box.lower_x, &box.lower_y, &box.lower_z};
  float* upper[3] = {&box.upper_x, &box.upper_y, &box.upper_z};
  for (int k = 0; k < 3; ++k) {
    *lower[k] = std::min({t.a[k], t.b[k], t.c[k]});
    *upper[k] = std::max({t.a[k], t.b[k], t.c[k]});
  }
}

/// A mesh in floats, placed, and its tree of boxes.
class FloatScene {
 public:
  FloatScene(RTCDevice device, const Mesh& mesh)
      : mesh_(mesh),
        triangles_(mesh.triangles().size()),
        scene_(rtcNewScene(device)),
        geometry_(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER)) {
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_DYNAMIC);
    rtcSetGeometryBuildQuality(geometry_.get(), RTC_BUILD_QUALITY_REFIT);
    rtcSetGeometryUserPrimitiveCount(geometry_.get(), static_cast<unsigned>(triangles_.size()));
    rtcSetGeometryUserData(geometry_.get(), &triangles_);
    rtcSetGeometryBoundsFunction(
        geometry_.get(), [](const RTCBoundsFunctionArguments* a) { find_bounds(a); }, nullptr);
    rtcAttachGeometry(scene_.get(), geometry_.get());
    move_to(Pose::Identity());
  }

  void move_to(const Pose& pose) {
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      triangles_[i] = to_plain<float>(place(pose, mesh_.triangle(static_cast<std::uint32_t>(i))));
    rtcCommitGeometry(geometry_.get());
    rtcCommitScene(scene_.get());
  }

  RTCScene scene() const { return scene_.get(); }
  const FloatTriangle& operator[](unsigned i) const { return triangles_[i]; }

 private:
  Mesh mesh_;
  std::vector<FloatTriangle> triangles_;
  Scene scene_;
  Geometry geometry_;
};

class EmbreeMeshes final : public MeshContestant {
 public:
  EmbreeMeshes()
      : MeshContestant({"Embree boxes, Guigue-Devillers", Origin::Peer, "float", std::nullopt}),
        device_(rtcNewDevice("threads=1,set_affinity=0")) {
    if (!device_) throw Error("Embree has no device");
  }

  void prepare(const Mesh& mesh_a, const Mesh& mesh_b) override {
    a_ = std::make_unique<FloatScene>(device_.get(), mesh_a);
    b_ = std::make_unique<FloatScene>(device_.get(), mesh_b);
  }
  bool any(const Pose& pose_b) override {
    collide(pose_b, {*a_, *b_, nullptr});
    return is_hit_;
  }
  void find(const Pose& pose_b, std::vector<IndexPair>& pairs) override {
    pairs.clear();
    collide(pose_b, {*a_, *b_, &pairs});
  }

 private:
  struct Query {
    const FloatScene& a;
    const FloatScene& b;
    std::vector<IndexPair>* pairs;  ///< none if one is enough
    bool is_hit = false;
  };

  void collide(const Pose& pose_b, Query query) {
    b_->move_to(pose_b);
    rtcCollide(a_->scene(), b_->scene(), on_boxes, &query);
    is_hit_ = query.is_hit;
  }

  /// Nothing stops a query; after the first hit it only ignores what it finds.
  static void on_boxes(void* user, RTCCollision* found, unsigned count) {
    Query& query = *static_cast<Query*>(user);
    for (unsigned i = 0; i < count; ++i) {
      if (query.is_hit && query.pairs == nullptr) return;
      const unsigned a = found[i].primID0, b = found[i].primID1;
      if (!guigue_devillers(corners_of(query.a[a]), corners_of(query.b[b]), NoSnap{})) continue;
      query.is_hit = true;
      if (query.pairs != nullptr) query.pairs->push_back({a, b});
    }
  }

  Device device_;
  std::unique_ptr<FloatScene> a_;
  std::unique_ptr<FloatScene> b_;
  bool is_hit_ = false;
};

}  // namespace

void add_embree(Field& field) {
  field.meshes.push_back(std::make_unique<EmbreeMeshes>());
}

}  // namespace graze::benchmark
