// Embree's collision of a scene with itself, the tree refitted or built anew in each frame. Its
// boxes are floats, which these are; each candidate is tested all the same.

#include <embree3/rtcore.h>

#include "tests/benchmark/broad_phase/peers/peers.h"

namespace graze::benchmark {
namespace {

class Embree : public Contestant {
 public:
  explicit Embree(RTCBuildQuality quality)
      : device_(rtcNewDevice("threads=1")), quality_(quality) {}
  ~Embree() override {
    if (scene_ != nullptr) rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  void start(std::span<const Aabb> boxes) override {
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_DYNAMIC);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_LOW);
    geometry_ = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryBuildQuality(geometry_, quality_);
    rtcSetGeometryUserPrimitiveCount(geometry_, static_cast<unsigned>(boxes.size()));
    rtcSetGeometryUserData(geometry_, this);
    rtcSetGeometryBoundsFunction(geometry_, bounds, this);
    boxes_ = boxes;
    rtcCommitGeometry(geometry_);
    rtcAttachGeometry(scene_, geometry_);
    rtcReleaseGeometry(geometry_);
    rtcCommitScene(scene_);
  }

  std::span<const BoxPair> step(std::span<const Aabb> boxes,
                                std::span<const std::uint32_t>) override {
    boxes_ = boxes;
    pairs_.clear();
    rtcCommitGeometry(geometry_);
    rtcCommitScene(scene_);
    rtcCollide(scene_, scene_, meet, this);
    return pairs_;
  }

 private:
  static void bounds(const RTCBoundsFunctionArguments* args) {
    const Aabb& box = static_cast<const Embree*>(args->geometryUserPtr)->boxes_[args->primID];
    RTCBounds& out = *args->bounds_o;
    out.lower_x = static_cast<float>(box.min[0]), out.upper_x = static_cast<float>(box.max[0]);
    out.lower_y = static_cast<float>(box.min[1]), out.upper_y = static_cast<float>(box.max[1]);
    out.lower_z = static_cast<float>(box.min[2]), out.upper_z = static_cast<float>(box.max[2]);
  }
  static void meet(void* self, RTCCollision* found, unsigned count) {
    Embree& embree = *static_cast<Embree*>(self);
    for (unsigned k = 0; k < count; ++k) {
      const std::uint32_t s = found[k].primID0, t = found[k].primID1;
      if (s < t && share_point(embree.boxes_[s], embree.boxes_[t])) embree.pairs_.push_back({s, t});
    }
  }

  RTCDevice device_;
  RTCBuildQuality quality_;
  RTCScene scene_ = nullptr;
  RTCGeometry geometry_ = nullptr;
  std::span<const Aabb> boxes_;
  std::vector<BoxPair> pairs_;
};

}  // namespace

void add_embree(std::vector<Entry>& entries) {
  entries.push_back(
      {"Embree, refit", [] { return std::make_unique<Embree>(RTC_BUILD_QUALITY_REFIT); }});
  entries.push_back(
      {"Embree, rebuilt", [] { return std::make_unique<Embree>(RTC_BUILD_QUALITY_LOW); }});
}

}  // namespace graze::benchmark
