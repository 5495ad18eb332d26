#include "tests/engine/histories/mesh_crowd.h"

#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placement.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::tests {
namespace {

/// Of ten bodies; a boulder covers hundreds of the others, and is rare.
constexpr std::size_t kUsual[] = {0, 0, 1, 1, 1, 2, 3, 4, 4, 1};
constexpr std::size_t kBoulder = 5;

std::vector<Mesh> bundled() {
  std::vector<Mesh> meshes;
  for (const char* name : {"bolt.obj", "nut.stl", "gear.ply", "pinion.off", "link.ply", "rock.ply"})
    meshes.push_back(load_mesh(std::string(GRAZE_DATA_DIR "/meshes/") + name));
  return meshes;
}

/// Of the placed vertices, by law 1.
Aabb box_of(const Mesh& mesh, const Pose& pose) {
  const double infinity = std::numeric_limits<double>::infinity();
  Aabb box{Eigen::Vector3d::Constant(infinity), Eigen::Vector3d::Constant(-infinity)};
  for (const Eigen::Vector3d& vertex : mesh.vertices()) {
    const Eigen::Vector3d placed = graze::place(pose, vertex);
    box.min = box.min.cwiseMin(placed), box.max = box.max.cwiseMax(placed);
  }
  return box;
}

bool do_overlap(const Aabb& s, const Aabb& t) {
  return (s.min.array() <= t.max.array()).all() && (t.min.array() <= s.max.array()).all();
}

}  // namespace

MeshCrowd::MeshCrowd(const CrowdSettings& settings)
    : random_(settings.seed),
      meshes_(bundled()),
      width_(0.036 * std::cbrt(settings.bodies)),
      world_(settings.world) {
  for (const Mesh& mesh : meshes_)
    shapes_.push_back(share(mesh));
  actors_.resize(static_cast<std::size_t>(settings.bodies));
  for (std::size_t i = 0; i < actors_.size(); ++i)
    add_actor(i);
  // Of two that are put to sleep where they came to be a world need not say whether they touch.
  settle();
}

std::size_t MeshCrowd::one_of(std::size_t count) {
  return static_cast<std::size_t>(random_.integer(0, static_cast<int>(count) - 1));
}

Pose MeshCrowd::random_place() {
  Eigen::Quaterniond turn;
  do {
    for (int k = 0; k < 4; ++k)
      turn.coeffs()[k] = random_.uniform(-1, 1);
  } while (turn.norm() > 1 || turn.norm() < 0.1);
  Pose pose = Pose::Identity();
  pose.linear() = turn.normalized().toRotationMatrix();
  pose.translation() = random_.vector(0, width_);
  return pose;
}

void MeshCrowd::add_actor(std::size_t index) {
  Actor& actor = actors_[index];
  actor = {};
  actor.mesh = one_of(50) == 0 ? kBoulder : kUsual[one_of(10)];
  constexpr BodyKind kMotions[] = {BodyKind::Static, BodyKind::Kinematic, BodyKind::Dynamic,
                                   BodyKind::Dynamic, BodyKind::Dynamic};
  actor.kind = kMotions[one_of(5)];
  actor.role = one_of(20) == 0 ? Role::Sensor : Role::Solid;
  actor.pose = random_place();
  actor.id = world_.add({shapes_[actor.mesh], actor.pose},
                        {.kind = actor.kind, .filter = actor.filter, .role = actor.role});
  actor.version = ++versions_;
  actor.box = box_of(meshes_[actor.mesh], actor.pose);
  set_out(actor);
}

/// By a hundredth of a millimetre a step, or up to half a body's length; mostly towards another.
void MeshCrowd::set_out(Actor& actor) {
  const double speed = std::pow(10, random_.uniform(-5, -2));
  const Actor& other = actors_[one_of(actors_.size())];
  const Eigen::Vector3d offset = other.pose.translation() - actor.pose.translation();
  actor.velocity = speed * random_.vector(-1, 1);
  if (one_of(3) != 0 && offset.norm() > 0) actor.velocity = speed * offset.normalized();
  actor.spin = one_of(3) == 0 ? Eigen::Vector3d(0, 0, 0)
                              : Eigen::Vector3d(30 * speed * random_.vector(-1, 1));
}

void MeshCrowd::place(Actor& actor, const Pose& pose) {
  actor.pose = pose;
  actor.is_asleep = false;
  actor.version = ++versions_;
  actor.box = box_of(meshes_[actor.mesh], pose);
  if (one_of(2) == 0) {
    world_.move(actor.id, pose);
  } else {
    moved_ids_.push_back(actor.id), moved_poses_.push_back(pose);
  }
}

/// Anywhere, into another body of its kind, or to where the two boxes have a face in common.
void MeshCrowd::put_elsewhere(std::size_t index) {
  Actor& actor = actors_[index];
  const Actor& other = actors_[one_of(actors_.size())];
  Pose pose = random_place();
  const std::size_t how = one_of(3);
  if (how > 0) pose = other.pose;
  if (how == 2) {
    const auto k = static_cast<Eigen::Index>(one_of(3));
    const Aabb& own = meshes_[actor.mesh].bounds();
    const Aabb& its = meshes_[other.mesh].bounds();
    pose.translation() += pose.linear().col(k) * (its.max[k] - own.min[k]);
  }
  place(actor, pose);
}

void MeshCrowd::change_rules(Actor& actor) {
  switch (one_of(4)) {
    case 0:
      actor.filter = {.category = 1u << one_of(3),
                      .mask = static_cast<std::uint32_t>(1 + one_of(7)),
                      .group = static_cast<std::int32_t>(one_of(3)) - 1};
      world_.set_filter(actor.id, actor.filter);
      break;
    case 1:
      actor.kind = static_cast<BodyKind>(one_of(3));
      world_.set_kind(actor.id, actor.kind);
      break;
    case 2:
      actor.role = static_cast<Role>(one_of(2));
      world_.set_role(actor.id, actor.role);
      break;
    default:
      actor.mesh = kUsual[one_of(10)];
      actor.version = ++versions_;
      actor.box = box_of(meshes_[actor.mesh], actor.pose);
      world_.set_shape(actor.id, shapes_[actor.mesh]);
  }
  // Between two that sleep a world need not look.
  world_.wake(actor.id);
  actor.is_asleep = false;
}

void MeshCrowd::act(std::size_t index) {
  Actor& actor = actors_[index];
  const auto dice = one_of(1000);
  if (dice < 5) return put_elsewhere(index);
  if (dice < 15) return change_rules(actor);
  if (dice < 18) {
    world_.remove(actor.id);
    std::erase_if(excluded_, [&](const Pair& p) { return p.first == index || p.second == index; });
    return add_actor(index);
  }
  if (dice < 30) set_out(actor);
  if (actor.is_asleep) {
    if (dice < 900) return;
    world_.wake(actor.id);
    actor.is_asleep = false;
  } else if (dice >= 950) {
    world_.sleep(actor.id);
    actor.is_asleep = true;
    return;
  }
  if (actor.kind == BodyKind::Static || dice >= 800) return;
  Pose pose = actor.pose;
  pose.translation() += actor.velocity;
  const double angle = actor.spin.norm();
  if (angle > 0) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(angle, actor.spin / angle).toRotationMatrix() * pose.linear();
    pose.linear() = Eigen::Quaterniond(turn).normalized().toRotationMatrix();
  }
  for (int k = 0; k < 3; ++k) {
    if (pose.translation()[k] < 0 || pose.translation()[k] > width_) actor.velocity[k] *= -1;
  }
  place(actor, pose);
}

void MeshCrowd::exclude_some() {
  for (const Pair& pair : touching_) {
    if (one_of(100) != 0) continue;
    world_.exclude(actors_[pair.first].id, actors_[pair.second].id);
    excluded_.insert(pair);
  }
  for (auto next = excluded_.begin(); next != excluded_.end();) {
    const auto at = next++;
    if (one_of(20) != 0) continue;
    world_.include(actors_[at->second].id, actors_[at->first].id);
    // What is static is never awake by itself.
    for (const std::size_t index : {at->first, at->second}) {
      world_.wake(actors_[index].id);
      actors_[index].is_asleep = false;
    }
    excluded_.erase(at);
  }
}

bool MeshCrowd::meet(std::size_t i, std::size_t j) const {
  const Actor &s = actors_[i], &t = actors_[j];
  const bool is_s = s.role == Role::Sensor, is_t = t.role == Role::Sensor;
  if (is_s && is_t) return false;
  if (is_s && t.kind == BodyKind::Static) return false;
  if (is_t && s.kind == BodyKind::Static) return false;
  if (!is_s && !is_t && s.kind != BodyKind::Dynamic && t.kind != BodyKind::Dynamic) return false;
  if (excluded_.contains({i, j})) return false;
  if (s.filter.group != 0 && s.filter.group == t.filter.group) return s.filter.group > 0;
  return (s.filter.category & t.filter.mask) != 0 && (t.filter.category & s.filter.mask) != 0;
}

/// A sweep along x; what was said of a pair stands until either is placed anew.
std::set<MeshCrowd::Pair> MeshCrowd::find_touching() {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < actors_.size(); ++i)
    order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::size_t s, std::size_t t) {
    return actors_[s].box.min.x() < actors_[t].box.min.x();
  });
  std::set<Pair> touching;
  for (std::size_t n = 0; n < order.size(); ++n) {
    for (std::size_t m = n + 1; m < order.size(); ++m) {
      const Actor &s = actors_[order[n]], &t = actors_[order[m]];
      if (t.box.min.x() > s.box.max.x()) break;
      const Pair pair = std::minmax(order[n], order[m]);
      if (!do_overlap(s.box, t.box) || !meet(pair.first, pair.second)) continue;
      const Actor &first = actors_[pair.first], &second = actors_[pair.second];
      const auto [at, is_new] = answers_.try_emplace(pair);
      Answer& answer = at->second;
      if (is_new || answer.version_i != first.version || answer.version_j != second.version) {
        answer = {
            first.version, second.version,
            intersects({meshes_[first.mesh], first.pose}, {meshes_[second.mesh], second.pose})};
      }
      if (answer.do_touch) touching.insert(pair);
    }
  }
  return touching;
}

BodyPair MeshCrowd::pair_of(const Pair& pair) const {
  const BodyId a = actors_[pair.first].id, b = actors_[pair.second].id;
  return a.index < b.index ? BodyPair{a, b} : BodyPair{b, a};
}

void MeshCrowd::check(const WorldUpdate& update, const std::set<Pair>& now) {
  std::set<BodyPair> expected;
  for (const Pair& pair : now)
    expected.insert(pair_of(pair));
  const std::vector<BodyPair> pairs = world_.pairs();
  EXPECT_TRUE(std::equal(pairs.begin(), pairs.end(), expected.begin(), expected.end()))
      << pairs.size() << " pairs, not " << expected.size();
  std::vector<BodyPair> begun, ended;
  std::set_difference(expected.begin(), expected.end(), listed_.begin(), listed_.end(),
                      std::back_inserter(begun));
  std::set_difference(listed_.begin(), listed_.end(), expected.begin(), expected.end(),
                      std::back_inserter(ended));
  EXPECT_TRUE(std::equal(update.begun.begin(), update.begun.end(), begun.begin(), begun.end()));
  EXPECT_TRUE(std::equal(update.ended.begin(), update.ended.end(), ended.begin(), ended.end()));
  begun_ += begun.size();
  skipped_ += update.work.pairs_apart;
  listed_ = std::move(expected);
}

void MeshCrowd::settle() {
  touching_ = find_touching();
  check(world_.update(), touching_);
}

void MeshCrowd::step() {
  moved_ids_.clear(), moved_poses_.clear();
  for (std::size_t i = 0; i < actors_.size(); ++i)
    act(i);
  exclude_some();
  world_.move(moved_ids_, moved_poses_);
  settle();
  if (one_of(10) == 0) world_.restore(world_.snapshot());
}

}  // namespace graze::tests
