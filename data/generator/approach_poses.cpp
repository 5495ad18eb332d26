#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/pair.h>

#include <cmath>

#include "data/generator/approach.h"
#include "data/generator/parts/link.h"

namespace graze::generator {
namespace {

using Eigen::Vector3d;

constexpr double kMillimetre = 1e-3;

Vector3d middle_of(const Mesh& mesh) {
  return (mesh.bounds().min + mesh.bounds().max) / 2;
}

Vector3d half_sides(const Mesh& mesh) {
  return (mesh.bounds().max - mesh.bounds().min) / 2;
}

// From any direction, turned anyhow, at a point in the middle half of A's bounds.
ApproachPair from_anywhere(const Mesh& mesh_a, const Mesh& mesh_b) {
  const double reach =
      std::sqrt(squared_length(half_sides(mesh_a))) + std::sqrt(squared_length(half_sides(mesh_b)));
  const auto draw = [=](Dice& dice) -> Approach {
    const Eigen::Matrix3d rotation = dice.rotation();
    const Vector3d direction = dice.direction();
    const Vector3d goal = middle_of(mesh_a) + dice.vector(half_sides(mesh_a) / 2);
    return {rotation, goal - 1.5 * reach * direction, direction, 1.5 * reach};
  };
  return {mesh_a, mesh_b, 2 * half_sides(mesh_b).maxCoeff(), draw};
}

// Straight down, turned anyhow, to where the ground reaches out beyond B on all sides.
ApproachPair from_above(const Mesh& ground, const Mesh& mesh_b) {
  const double radius = std::sqrt(squared_length(half_sides(mesh_b)));
  const Vector3d reach = half_sides(ground).array() - 2 * radius;
  const double top = ground.bounds().max.z() + 2 * radius;
  const double height = top - ground.bounds().min.z();
  const auto draw = [=](Dice& dice) -> Approach {
    const Eigen::Matrix3d rotation = dice.rotation();
    const Vector3d spot = middle_of(ground) + dice.vector({reach.x(), reach.y(), 0});
    return {rotation, {spot.x(), spot.y(), top}, -Vector3d::UnitZ(), height};
  };
  return {ground, mesh_b, 2 * half_sides(mesh_b).maxCoeff(), draw};
}

// Through A's opening and across it, tilted by up to some 20 degrees, its bend somewhere in the
// middle third of the opening.
Approach hanging(const ChainLink& link, Dice& dice) {
  const Vector3d tilt = dice.vector({0.12, 0.12, 0.12});
  // The quaternion of a quarter turn around x has equal parts w and x.
  const Eigen::Matrix3d rotation = quaternion_rotation(1, Vector3d::UnitX() + tilt);
  const Vector3d slack = dice.vector({link.pitch / 6, 0.8, 0.8});
  const Vector3d middle = Vector3d((link.pitch + link.wire) / 2, 0, 0) + slack;
  return {rotation, middle * kMillimetre, Vector3d::UnitX(), link.pitch * kMillimetre};
}

// Pulled tight along A, or up to some 20 degrees off.
ApproachPair pulled(const Mesh& mesh, const ChainLink& link) {
  const auto draw = [=](Dice& dice) {
    Approach approach = hanging(link, dice);
    const Vector3d towards = Vector3d::UnitX() + dice.vector({0, 0.3, 0.3});
    approach.direction = towards / std::sqrt(squared_length(towards));
    return approach;
  };
  return {mesh, mesh, link.wire * kMillimetre, draw};
}

PoseList clear_links(const Mesh& mesh, Dice& dice) {
  const ApproachPair pair = pulled(mesh, kLink);
  PoseList list{"link-link.clear.txt", {}};
  while (list.poses.size() < 36) {
    const Eigen::Isometry3d pose = at_distance(pair, hanging(kLink, dice), 0);
    if (!intersects({mesh}, {mesh, pose})) list.poses.push_back(pose);
  }
  return list;
}

std::vector<PoseList> link_poses(const Mesh& mesh) {
  const ApproachPair tight = pulled(mesh, kLink);
  Dice dice(1);
  return {clear_links(mesh, dice), approach(tight, near_regime("link-link.near.txt"), dice),
          approach(tight, touch_regime("link-link.touch.txt"), dice),
          approach(tight, deep_regime("link-link.deep.txt"), dice),
          approach(from_anywhere(mesh, mesh), far_regime("link-link.apart.txt"), dice)};
}

// far, near and touch of a pair under the name of its files.
std::vector<PoseList> outer_poses(const ApproachPair& pair, const std::string& name, Dice& dice) {
  return {approach(pair, far_regime(name + ".far.txt"), dice),
          approach(pair, near_regime(name + ".near.txt"), dice),
          approach(pair, touch_regime(name + ".touch.txt"), dice)};
}

std::vector<PoseList> all_poses(const ApproachPair& pair, const std::string& name, Dice& dice) {
  std::vector<PoseList> lists = outer_poses(pair, name, dice);
  lists.push_back(approach(pair, deep_regime(name + ".deep.txt"), dice));
  return lists;
}

}  // namespace

std::vector<PoseList> approach_poses(const std::filesystem::path& meshes) {
  const Mesh rock = load_mesh(meshes / "rock.ply");
  const Mesh terrain = load_mesh(meshes / "terrain.ply");
  const Mesh bolt = load_mesh(meshes / "bolt.obj");
  const Mesh nut = load_mesh(meshes / "nut.stl");
  const Mesh gear = load_mesh(meshes / "gear.ply");
  const Mesh pinion = load_mesh(meshes / "pinion.off");
  std::vector<PoseList> lists = link_poses(load_mesh(meshes / "link.ply"));
  const auto add = [&](const std::vector<PoseList>& more) {
    lists.insert(lists.end(), more.begin(), more.end());
  };
  // Each pair throws dice of its own, so that a change to one leaves the others alone.
  Dice dice_2(2), dice_3(3), dice_4(4), dice_5(5);
  add(all_poses(from_anywhere(rock, rock), "rock-rock", dice_2));
  add(all_poses(from_above(terrain, rock), "terrain-rock", dice_3));
  add(outer_poses(from_anywhere(bolt, nut), "bolt-nut", dice_4));
  add(outer_poses(from_anywhere(gear, pinion), "gear-pinion", dice_5));
  return lists;
}

}  // namespace graze::generator
