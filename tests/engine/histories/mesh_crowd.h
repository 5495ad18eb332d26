#pragma once

// A crowd of the bundled meshes on paths of their own, in a world and beside it.

#include <graze/engine/world/world.h>

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "tests/shapes/random_source.h"

namespace graze::tests {

struct CrowdSettings {
  int bodies = 100;
  std::uint64_t seed = 1;
  WorldSettings world = {};
};

/// Bodies that creep, run, turn, lie still, sleep, are put elsewhere, take other shapes, filters,
/// motions and roles, come and go. What should touch is known by asking intersects() of two meshes
/// for every pair whose vertices' boxes overlap: no broad phase, no world, no tree of boxes decides
/// which those are.
class MeshCrowd {
 public:
  explicit MeshCrowd(const CrowdSettings& settings);

  /// One step of all bodies, and an update. Says what is wrong with what the world lists, by
  /// failing expectations.
  void step();

  std::size_t touching() const { return touching_.size(); }
  std::size_t begun() const { return begun_; }
  std::size_t skipped() const { return skipped_; }

 private:
  struct Actor {
    BodyId id;
    std::size_t mesh;
    Pose pose = Pose::Identity();
    BodyKind kind = BodyKind::Dynamic;
    Role role = Role::Solid;
    Filter filter = {};
    bool is_asleep = false;
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
    Eigen::Vector3d spin = Eigen::Vector3d::Zero();
    std::uint64_t version = 0;  // of mesh and pose
    Aabb box = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  };
  using Pair = std::pair<std::size_t, std::size_t>;  // actors, the smaller first

  std::size_t one_of(std::size_t count);
  Pose random_place();
  void add_actor(std::size_t index);
  void place(Actor& actor, const Pose& pose);
  void set_out(Actor& actor);
  void act(std::size_t index);
  void put_elsewhere(std::size_t index);
  void change_rules(Actor& actor);
  void exclude_some();
  bool meet(std::size_t i, std::size_t j) const;
  std::set<Pair> find_touching();
  void settle();
  void check(const WorldUpdate& update, const std::set<Pair>& now);
  BodyPair pair_of(const Pair& pair) const;

  RandomSource random_;
  std::vector<Mesh> meshes_;
  std::vector<std::shared_ptr<const BodyShape>> shapes_;
  double width_;
  World world_;
  std::vector<Actor> actors_;
  std::vector<BodyId> moved_ids_;
  std::vector<Pose> moved_poses_;
  std::set<Pair> excluded_, touching_;
  std::set<BodyPair> listed_;
  struct Answer {
    std::uint64_t version_i, version_j;
    bool do_touch;
  };
  std::map<Pair, Answer> answers_;
  std::uint64_t versions_ = 0;
  std::size_t begun_ = 0, skipped_ = 0;
};

}  // namespace graze::tests
