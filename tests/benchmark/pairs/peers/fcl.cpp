// FCL: collide() and distance() on trees of OBBRSS and OBB, by its public functions. Contact
// geometry is not asked for: each pair is then reported once. It has no question with a clearance,
// so that the distance is compared.

#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <limits>
#include <type_traits>

#include "tests/benchmark/common/fcl_models.h"
#include "tests/benchmark/pairs/peers/peers.h"

namespace graze::benchmark {
namespace {

template <typename Volume>
class FclPairs final : public PairContestant {
 public:
  using PairContestant::PairContestant;

  std::string refusal(Question question) const override {
    const bool has_distance = std::is_same_v<Volume, fcl::OBBRSSd>;
    if (has_distance || question == Question::Any || question == Question::Pairs) return "";
    return "its OBB trees have no distance";
  }

  void build(const Mesh& mesh_a, const Mesh& mesh_b) override {
    mesh_a_ = to_fcl<Volume>(mesh_a);
    mesh_b_ = to_fcl<Volume>(mesh_b);
  }
  void release() override {
    mesh_a_.reset();
    mesh_b_.reset();
    result_ = {};
  }

  bool any(const Pose& pose_b) override {
    collide(pose_b, 1);
    return result_.isCollision();
  }
  void find(const Pose& pose_b, std::vector<TrianglePair>& pairs) override {
    collide(pose_b, std::numeric_limits<std::size_t>::max());
    pairs.clear();
    for (std::size_t i = 0; i < result_.numContacts(); ++i) {
      const fcl::Contactd& contact = result_.getContact(i);
      pairs.push_back(
          {static_cast<std::uint32_t>(contact.b1), static_cast<std::uint32_t>(contact.b2)});
    }
  }
  double distance(const Pose& pose_b) override {
    const fcl::DistanceRequestd request;
    fcl::DistanceResultd result;
    fcl::distance(mesh_a_.get(), fcl::Transform3d::Identity(), mesh_b_.get(), to_fcl(pose_b),
                  request, result);
    return std::max(result.min_distance, 0.0);  // negative where they intersect
  }
  bool within(const Pose& pose_b, double clearance) override {
    return distance(pose_b) <= clearance;
  }

 private:
  static fcl::Transform3d to_fcl(const Pose& pose) {
    fcl::Transform3d placed = fcl::Transform3d::Identity();
    placed.linear() = pose.linear();
    placed.translation() = pose.translation();
    return placed;
  }

  template <typename V>
  static std::shared_ptr<fcl::BVHModel<V>> to_fcl(const Mesh& mesh) {
    return benchmark::to_fcl<V>(mesh);
  }

  void collide(const Pose& pose_b, std::size_t most) {
    const fcl::CollisionRequestd request(most, /*enable_contact=*/false);
    result_.clear();
    fcl::collide(mesh_a_.get(), fcl::Transform3d::Identity(), mesh_b_.get(), to_fcl(pose_b),
                 request, result_);
  }

  std::shared_ptr<fcl::BVHModel<Volume>> mesh_a_;
  std::shared_ptr<fcl::BVHModel<Volume>> mesh_b_;
  fcl::CollisionResultd result_;
};

}  // namespace

void add_fcl(PairContestants& contestants) {
  contestants.push_back(std::make_unique<FclPairs<fcl::OBBRSSd>>("FCL OBBRSS"));
  contestants.push_back(std::make_unique<FclPairs<fcl::OBBd>>("FCL OBB"));
}

}  // namespace graze::benchmark
