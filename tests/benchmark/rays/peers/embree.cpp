// Embree: a scene of one mesh, robust, which closes the gaps between neighbours that its rounding
// would leave. Rays are floats; what its callers would convert is converted before.

#include <embree3/rtcore.h>

#include <algorithm>
#include <limits>

#include "tests/benchmark/rays/contestant.h"

namespace graze::benchmark {
namespace {

constexpr std::size_t kAtOnce = 8;

class Embree : public RayContestant {
 public:
  Embree() : RayContestant("Embree"), device_(rtcNewDevice("threads=1")) {}
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;
  ~Embree() override {
    if (scene_ != nullptr) rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  void build(const Mesh& mesh) override {
    if (scene_ != nullptr) rtcReleaseScene(scene_);
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), mesh.vertices().size()));
    for (const Eigen::Vector3d& v : mesh.vertices()) {
      for (int k = 0; k < 3; ++k)
        *vertices++ = static_cast<float>(v[k]);
    }
    auto* indices = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned), mesh.triangles().size()));
    for (const TriangleIndices& t : mesh.triangles())
      indices = std::copy(t.begin(), t.end(), indices);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }

  void take(std::span<const Ray> rays) override {
    single_.clear();
    packets_.assign((rays.size() + kAtOnce - 1) / kAtOnce, RTCRayHit8{});
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Ray& ray = rays[i];
      RTCRayHit one{};
      one.ray.org_x = static_cast<float>(ray.origin.x());
      one.ray.org_y = static_cast<float>(ray.origin.y());
      one.ray.org_z = static_cast<float>(ray.origin.z());
      one.ray.dir_x = static_cast<float>(ray.direction.x());
      one.ray.dir_y = static_cast<float>(ray.direction.y());
      one.ray.dir_z = static_cast<float>(ray.direction.z());
      one.ray.mask = ~0u;
      single_.push_back(one);
      RTCRay8& r = packets_[i / kAtOnce].ray;
      const std::size_t lane = i % kAtOnce;
      r.org_x[lane] = one.ray.org_x;
      r.org_y[lane] = one.ray.org_y;
      r.org_z[lane] = one.ray.org_z;
      r.dir_x[lane] = one.ray.dir_x;
      r.dir_y[lane] = one.ray.dir_y;
      r.dir_z[lane] = one.ray.dir_z;
      r.mask[lane] = ~0u;
    }
  }

  std::size_t ask(Question question) override {
    switch (question) {
      case Question::First:
        return first();
      case Question::Any:
        return any();
      default:
        return batch();
    }
  }

 private:
  std::size_t first() {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    std::size_t hits = 0;
    for (RTCRayHit& one : single_) {
      one.ray.tfar = std::numeric_limits<float>::infinity();
      one.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(scene_, &context, &one);
      hits += one.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
    return hits;
  }

  std::size_t any() {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    std::size_t hits = 0;
    for (RTCRayHit& one : single_) {
      one.ray.tfar = std::numeric_limits<float>::infinity();
      rtcOccluded1(scene_, &context, &one.ray);
      hits += one.ray.tfar < 0;
    }
    return hits;
  }

  std::size_t batch() {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    alignas(32) int valid[kAtOnce];
    std::size_t hits = 0, left = single_.size();
    for (RTCRayHit8& packet : packets_) {
      for (std::size_t lane = 0; lane < kAtOnce; ++lane) {
        valid[lane] = lane < left ? -1 : 0;
        packet.ray.tfar[lane] = std::numeric_limits<float>::infinity();
        packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
      }
      rtcIntersect8(valid, scene_, &context, &packet);
      for (const unsigned hit : packet.hit.geomID)
        hits += hit != RTC_INVALID_GEOMETRY_ID;
      left -= std::min(left, kAtOnce);
    }
    return hits;
  }

  RTCDevice device_;
  RTCScene scene_ = nullptr;
  std::vector<RTCRayHit> single_;
  std::vector<RTCRayHit8> packets_;
};

}  // namespace

std::unique_ptr<RayContestant> make_embree() {
  return std::make_unique<Embree>();
}

}  // namespace graze::benchmark
