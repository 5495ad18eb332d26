#include <graze/bvh/error.h>
#include <graze/engine/compare/run/poses/block_cache.h>
#include <graze/engine/compare/run/poses/pose_source.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_pairs.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <utility>

namespace graze::compare {
namespace {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}

  double from_minus_one_to_one() { return static_cast<double>(random_() >> 11) * 0x1p-52 - 1; }

  Eigen::Vector3d in_cube() {
    const double x = from_minus_one_to_one();
    const double y = from_minus_one_to_one();
    const double z = from_minus_one_to_one();
    return {x, y, z};
  }

  /// Returns a direction of length one.
  Eigen::Vector3d direction() {
    for (;;) {
      const Eigen::Vector3d v = in_cube();
      const double square = (v.x() * v.x() + v.y() * v.y()) + v.z() * v.z();
      if (square > 0.01 && square <= 1) return v / std::sqrt(square);
    }
  }

  /// Makes two directions orthogonal, and adds their cross product: each rotation is as likely as
  /// another.
  Pose rotation() {
    for (;;) {
      const Eigen::Vector3d x = direction();
      const Eigen::Vector3d aside = direction();
      Eigen::Vector3d y = aside - ((x.x() * aside.x() + x.y() * aside.y()) + x.z() * aside.z()) * x;
      const double length = std::sqrt((y.x() * y.x() + y.y() * y.y()) + y.z() * y.z());
      if (length < 0.1) continue;
      y /= length;
      Pose pose = Pose::Identity();
      pose.linear().col(0) = x;
      pose.linear().col(1) = y;
      pose.linear().col(2) << x.y() * y.z() - x.z() * y.y(), x.z() * y.x() - x.x() * y.z(),
          x.x() * y.y() - x.y() * y.x();
      return pose;
    }
  }

 private:
  std::mt19937_64 random_;
};

/// Holds a box by its middle and its half diagonal.
struct Extent {
  Eigen::Vector3d middle;
  Eigen::Vector3d half;
  double radius;
};

Extent extent_of(const Aabb& box) {
  const Eigen::Vector3d half = box.max / 2 - box.min / 2;
  return {box.max / 2 + box.min / 2, half,
          std::sqrt((half.x() * half.x() + half.y() * half.y()) + half.z() * half.z())};
}

/// Returns the pose that turns B and brings the middle of its bounds to a point in A's frame.
Pose with_middle_at(const Pose& rotation, const Extent& b, const Eigen::Vector3d& point,
                    const Pose& pose_a) {
  Pose pose = rotation;
  pose.translation() = place(pose_a, point) - place(rotation, b.middle);
  return pose;
}

/// Says what poses are drawn for.
struct Room {
  Extent a;
  Pose pose_a;
  Extent b;
  std::function<bool(const Pose&)> is_hit;  ///< true if they hit with B in this pose
};

Room room_of(const Mesh& a, const Pose& pose_a, const Mesh& b) {
  return {extent_of(a.bounds()), pose_a, extent_of(b.bounds()), [a, pose_a, b](const Pose& pose) {
            return intersects(PlacedMeshView{a, pose_a}, {b, pose});
          }};
}

/// Returns nothing for a half-space or a plane, which have no end.
std::optional<Extent> extent_of(const Shape& shape) {
  if (shape.as<HalfSpace>() != nullptr || shape.as<Plane>() != nullptr) return std::nullopt;
  return extent_of(bounding_aabb({shape, Pose::Identity()}));
}

/// Returns, for a shape without an end, the part around the point nearest to the origin of its
/// frame that is as large as the other shape.
Extent extent_beside(const Shape& shape, const std::optional<Extent>& other) {
  const auto* space = shape.as<HalfSpace>();
  const auto* plane = shape.as<Plane>();
  const Eigen::Vector3d normal = space != nullptr ? space->normal : plane->normal;
  const double radius = other ? other->radius : 1;
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(radius);
  return {normal * (space != nullptr ? space->offset : plane->offset), half, radius};
}

Room room_of(const CaseBody& a, const Shape& b) {
  const std::optional<Extent> extent_a = extent_of(a.shape), extent_b = extent_of(b);
  return {extent_a ? *extent_a : extent_beside(a.shape, extent_b), a.pose,
          extent_b ? *extent_b : extent_beside(b, extent_a), [a, b](const Pose& pose) {
            return intersects(PlacedShapeView{a.shape, a.pose}, {b, pose});
          }};
}

std::vector<Pose> random_in(const Room& room, std::size_t count, std::uint64_t seed) {
  Dice dice(seed);
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < count; ++i) {
    const Pose rotation = dice.rotation();
    const Eigen::Vector3d where = dice.in_cube();
    const Eigen::Vector3d extent = room.a.half + Eigen::Vector3d::Constant(room.b.radius / 2);
    poses.push_back(
        with_middle_at(rotation, room.b, room.a.middle + where.cwiseProduct(extent), room.pose_a));
  }
  return poses;
}

std::vector<Pose> grazing_in(const Room& room, std::size_t count, std::uint64_t seed) {
  constexpr int kSteps = 64;        // steps from far away to where the middles meet
  constexpr int kMaxMisses = 1000;  // the number of lines through A that meet nothing
  Dice dice(seed);
  std::vector<Pose> poses;
  for (int misses = 0; poses.size() < count;) {
    const Pose rotation = dice.rotation();
    const Eigen::Vector3d target = room.a.middle + dice.in_cube().cwiseProduct(room.a.half) / 2;
    const Eigen::Vector3d out = dice.direction() * (2 * (room.a.radius + room.b.radius));
    const auto pose_at = [&](double share) {
      return with_middle_at(rotation, room.b, target + out * share, room.pose_a);
    };
    const auto is_hit_at = [&](double share) { return room.is_hit(pose_at(share)); };
    double hit = -1;
    double apart = 1;
    const bool begins_apart = !is_hit_at(apart);  // false within a half-space
    for (int step = kSteps - 1; begins_apart && step >= 0 && hit < 0; --step) {
      const double share = static_cast<double>(step) / kSteps;
      (is_hit_at(share) ? hit : apart) = share;
    }
    if (hit < 0) {
      if (++misses == kMaxMisses) throw InputError("--grazing: the two never touch");
      continue;
    }
    for (double middle = hit / 2 + apart / 2; middle != hit && middle != apart;
         middle = hit / 2 + apart / 2) {
      (is_hit_at(middle) ? hit : apart) = middle;
    }
    poses.push_back(pose_at(poses.size() % 2 == 0 ? hit : apart));
  }
  return poses;
}

}  // namespace

std::vector<Pose> random_poses(const PlacedMeshView& mesh_a, const Mesh& mesh_b, std::size_t count,
                               std::uint64_t seed) {
  return random_in(room_of(mesh_a.mesh, mesh_a.pose, mesh_b), count, seed);
}

std::vector<Pose> grazing_poses(const PlacedMeshView& mesh_a, const Mesh& mesh_b, std::size_t count,
                                std::uint64_t seed) {
  return grazing_in(room_of(mesh_a.mesh, mesh_a.pose, mesh_b), count, seed);
}

namespace {

/// This is the finisher of Sebastiano Vigna's splitmix64: one bit of the input changes half of the
/// others.
std::uint64_t mixed(std::uint64_t bits) {
  bits += 0x9e3779b97f4a7c15;
  bits = (bits ^ bits >> 30) * 0xbf58476d1ce4e5b9;
  bits = (bits ^ bits >> 27) * 0x94d049bb133111eb;
  return bits ^ bits >> 31;
}

std::uint64_t seed_of(std::uint64_t seed, std::size_t block) {
  return block == 0 ? seed : mixed(mixed(seed) ^ block);
}

using Generate = std::vector<Pose> (*)(const Room&, std::size_t, std::uint64_t);

class GeneratedPoses : public PoseSource {
 public:
  GeneratedPoses(const char* kind, Generate generate, const Room& room, std::size_t count,
                 std::uint64_t seed)
      : size_(count),
        key_(std::string(kind) + " " + std::to_string(count) + ", seed " + std::to_string(seed)),
        blocks_(
            [=](std::size_t block) {
              const std::size_t rest = count - block * kPosesOfSeed;
              return generate(room, std::min(rest, kPosesOfSeed), seed_of(seed, block));
            },
            (count + kPosesOfSeed - 1) / kPosesOfSeed) {}

  std::size_t size() const override { return size_; }
  Pose at(std::size_t place) const override {
    return (*blocks_.at(place / kPosesOfSeed))[place % kPosesOfSeed];
  }
  const std::string& key() const override { return key_; }

 private:
  std::size_t size_;
  std::string key_;
  BlockCache<Pose> blocks_;
};

}  // namespace

std::shared_ptr<const PoseSource> random_pose_source(const CaseMesh& a, const Mesh& b,
                                                     std::size_t count, std::uint64_t seed) {
  return std::make_shared<GeneratedPoses>("random", random_in, room_of(a.mesh, a.pose, b), count,
                                          seed);
}

std::shared_ptr<const PoseSource> grazing_pose_source(const CaseMesh& a, const Mesh& b,
                                                      std::size_t count, std::uint64_t seed) {
  return std::make_shared<GeneratedPoses>("grazing", grazing_in, room_of(a.mesh, a.pose, b), count,
                                          seed);
}

std::shared_ptr<const PoseSource> random_pose_source(const CaseBody& a, const Shape& b,
                                                     std::size_t count, std::uint64_t seed) {
  return std::make_shared<GeneratedPoses>("random", random_in, room_of(a, b), count, seed);
}

std::shared_ptr<const PoseSource> grazing_pose_source(const CaseBody& a, const Shape& b,
                                                      std::size_t count, std::uint64_t seed) {
  return std::make_shared<GeneratedPoses>("grazing", grazing_in, room_of(a, b), count, seed);
}

}  // namespace graze::compare
