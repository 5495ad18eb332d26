// Embree: rtcCollide() of two scenes of user geometry, the only kind that it takes. It has no
// poses: for each query B's triangles are placed, B's tree is refitted, and the candidates that the
// boxes let through go to the library's exact test of triangles, so that only its trees are
// compared. It cannot be stopped at the first pair.

#include <embree3/rtcore.h>

#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/triangle_triangle.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "tests/benchmark/pairs/peers/peers.h"

namespace graze::benchmark {
namespace {

float below(double x) {
  return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::infinity());
}
float above(double x) {
  return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
}

void bounds_of(const RTCBoundsFunctionArguments* arguments) {
  const auto& triangles = *static_cast<const std::vector<Triangle>*>(arguments->geometryUserPtr);
  const Triangle& t = triangles[arguments->primID];
  const Eigen::Vector3d low = t.a.cwiseMin(t.b).cwiseMin(t.c);
  const Eigen::Vector3d high = t.a.cwiseMax(t.b).cwiseMax(t.c);
  *arguments->bounds_o = {below(low.x()),  below(low.y()),  below(low.z()),  0,
                          above(high.x()), above(high.y()), above(high.z()), 0};
}

/// A scene of one geometry over placed triangles.
class Scene {
 public:
  Scene(RTCDevice device, const Mesh& mesh) : mesh_(mesh) {
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i)
      triangles_.push_back(mesh.triangle(i));
    scene_ = rtcNewScene(device);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_DYNAMIC);
    geometry_ = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry_, static_cast<unsigned>(triangles_.size()));
    rtcSetGeometryUserData(geometry_, &triangles_);
    rtcSetGeometryBoundsFunction(geometry_, bounds_of, nullptr);
    rtcCommitGeometry(geometry_);
    rtcAttachGeometry(scene_, geometry_);
    rtcCommitScene(scene_);
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  ~Scene() {
    rtcReleaseGeometry(geometry_);
    rtcReleaseScene(scene_);
  }

  void move(const Pose& pose) {
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      triangles_[i] = place(pose, mesh_.triangle(i));
    rtcSetGeometryBuildQuality(geometry_, RTC_BUILD_QUALITY_REFIT);
    rtcCommitGeometry(geometry_);
    rtcCommitScene(scene_);
  }

  /// Its own copies of the mesh.
  std::size_t bytes() const {
    return triangles_.size() * (sizeof(Triangle) + sizeof(TriangleIndices)) +
           mesh_.vertices().size() * sizeof(Eigen::Vector3d);
  }

  RTCScene scene() const { return scene_; }
  const Triangle& triangle(unsigned index) const { return triangles_[index]; }

 private:
  Mesh mesh_;
  std::vector<Triangle> triangles_;
  RTCScene scene_;
  RTCGeometry geometry_;
};

class EmbreePairs final : public PairContestant {
 public:
  EmbreePairs() : PairContestant("Embree"), device_(rtcNewDevice("threads=1,set_affinity=0")) {
    if (device_ == nullptr) throw Error("Embree has no device");
    rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, &bytes_);
  }
  EmbreePairs(const EmbreePairs&) = delete;
  EmbreePairs& operator=(const EmbreePairs&) = delete;
  ~EmbreePairs() override {
    EmbreePairs::release();
    rtcReleaseDevice(device_);
  }

  std::string refusal(Question question) const override {
    return question == Question::Any || question == Question::Pairs
               ? ""
               : "its nearest points are those of a point";
  }
  void build(const Mesh& mesh_a, const Mesh& mesh_b) override {
    a_ = std::make_unique<Scene>(device_, mesh_a);
    b_ = std::make_unique<Scene>(device_, mesh_b);
  }
  void release() override {
    a_.reset();
    b_.reset();
  }
  bool any(const Pose& pose_b) override {
    find(pose_b, pairs_);
    return !pairs_.empty();
  }
  void find(const Pose& pose_b, std::vector<TrianglePair>& pairs) override {
    pairs.clear();
    found_ = &pairs;
    b_->move(pose_b);
    rtcCollide(a_->scene(), b_->scene(), test, this);
  }
  std::optional<std::size_t> bytes() const override {
    return static_cast<std::size_t>(bytes_.load()) + a_->bytes() + b_->bytes();
  }

 private:
  static bool count_bytes(void* bytes, ssize_t more, bool /*post*/) {
    *static_cast<std::atomic<ssize_t>*>(bytes) += more;
    return true;
  }

  static void test(void* self, RTCCollision* collisions, unsigned count) {
    const auto& pairs = *static_cast<EmbreePairs*>(self);
    for (unsigned i = 0; i < count; ++i) {
      const RTCCollision& c = collisions[i];
      if (intersects(pairs.a_->triangle(c.primID0), pairs.b_->triangle(c.primID1)))
        pairs.found_->push_back({c.primID0, c.primID1});
    }
  }

  std::atomic<ssize_t> bytes_ = 0;  // of trees, as it says
  RTCDevice device_;
  std::unique_ptr<Scene> a_;
  std::unique_ptr<Scene> b_;
  std::vector<TrianglePair> pairs_;
  std::vector<TrianglePair>* found_ = nullptr;
};

}  // namespace

void add_embree(PairContestants& contestants) {
  contestants.push_back(std::make_unique<EmbreePairs>());
}

}  // namespace graze::benchmark
