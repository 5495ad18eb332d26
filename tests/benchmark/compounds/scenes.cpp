#include <cmath>

#include "tests/benchmark/compounds/contestant.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/random_source.h"

namespace graze::benchmark {

namespace {

Shape random_part(RandomSource& source, std::size_t kind) {
  const double size = source.uniform(0.05, 0.15);
  if (kind % 3 == 0) return Box{{size, 0.7 * size, 0.4 * size}};
  if (kind % 3 == 1) return Sphere{{0, 0, 0}, size};
  return Capsule{0.4 * size, size};
}

Parts parts_in(std::size_t count, double side, RandomSource& source) {
  Parts parts;
  for (std::size_t i = 0; i < count; ++i) {
    Pose pose = tests::random_pose(0, source);
    pose.translation() = source.vector(-side / 2, side / 2);
    parts.push_back({random_part(source, i), pose});
  }
  return parts;
}

}  // namespace

Parts random_parts(std::size_t count, double side) {
  RandomSource source(11);
  return parts_in(count, side, source);
}

Asked random_asked(std::size_t parts, std::size_t poses, double side) {
  RandomSource source(12);
  Asked asked;
  if (parts == 1) {
    asked.parts.push_back({Box{{0.1, 0.07, 0.05}}, Pose::Identity()});
  } else {
    asked.parts = parts_in(parts, 0.6, source);
  }
  // What has many parts meets one wherever there are any: half of its poses are beside them.
  const double reach = parts == 1 ? side / 2 : 0.8 * side;
  for (std::size_t i = 0; i < poses; ++i) {
    Pose pose = tests::random_pose(0, source);
    pose.translation() = source.vector(-reach, reach);
    asked.poses.push_back(pose);
  }
  return asked;
}

Voxels ball_of_voxels(std::uint32_t side, bool is_solid) {
  Voxels voxels;
  const double edge = 0.0625, half = edge * side / 2;
  voxels.grid = {{-half, -half, -half}, edge, {side, side, side}};
  const double radius = 0.45 * side;
  for (std::uint32_t k = 0; k < side; ++k) {
    for (std::uint32_t j = 0; j < side; ++j) {
      for (std::uint32_t i = 0; i < side; ++i) {
        const auto at = [&](std::uint32_t index) { return index + 0.5 - side / 2.0; };
        const double far = std::sqrt(at(i) * at(i) + at(j) * at(j) + at(k) * at(k));
        if (far > radius || (!is_solid && far < radius - 1)) continue;
        voxels.voxels.push_back({static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j),
                                 static_cast<std::uint16_t>(k)});
      }
    }
  }
  return voxels;
}

}  // namespace graze::benchmark
