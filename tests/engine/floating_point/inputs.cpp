#include "tests/engine/floating_point/inputs.h"

#include <cmath>
#include <cstdio>

#include "tests/shapes/random_meshes.h"

namespace graze::tests {
namespace {

/// Coordinates of one scale.
class Source {
 public:
  Source(Scale scale, std::uint64_t seed) : scale_(scale), random_(seed) {}

  double coordinate() { return scaled(random_.integer(-6, 6)); }
  double length() { return scaled(random_.integer(1, 6)); }

  /// A whole number of steps of the scale.
  double scaled(double steps) const {
    switch (scale_) {
      case Scale::Denormal:
        return std::ldexp(steps, -1074);
      case Scale::Smallest:
        return std::ldexp(std::ldexp(1.0, 52) + steps + 8, -1074);
      case Scale::Tiny:
        return std::ldexp(steps, -535);
      default:
        return steps / 8;
    }
  }

  Eigen::Vector3d point() {
    const double x = coordinate(), y = coordinate();
    return {x, y, coordinate()};
  }

  Pose pose() {
    Pose pose = random_pose(0, random_);
    pose.translation() = point();
    return pose;
  }

  Triangle triangle() {
    const Eigen::Vector3d a = point(), b = point();
    return {a, b, point()};
  }

  Aabb box() {
    const Eigen::Vector3d a = point(), b = point();
    return {a.cwiseMin(b), a.cwiseMax(b)};
  }

  RandomSource& random() { return random_; }

 private:
  Scale scale_;
  RandomSource random_;
};

void add_tetrahedra(std::vector<Eigen::Vector3d>& vertices, std::vector<TriangleIndices>& triangles,
                    std::size_t count, Source& source) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (int k = 0; k < 4; ++k)
      vertices.push_back(source.point());
    for (const TriangleIndices& t : {TriangleIndices{0, 1, 2}, TriangleIndices{0, 3, 1},
                                     TriangleIndices{1, 3, 2}, TriangleIndices{0, 2, 3}})
      triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
}

void add_volumes(Inputs& in, Source& source) {
  in.triangle_a = source.triangle();
  in.triangle_b = source.triangle();
  for (int i = 0; i < 20; ++i)
    in.triangles.push_back(source.triangle());
  in.box_a = source.box();
  in.box_b = source.box();
  for (int i = 0; i < 40; ++i) {
    in.boxes.push_back(source.box());
    in.boxes_later.push_back(source.box());
  }
  for (Obb* box : {&in.obb_a, &in.obb_b})
    *box = {source.pose(), {source.length(), source.length(), source.length()}};
  in.ball_a = {source.point(), source.length()};
  in.ball_b = {source.point(), source.length()};
  in.ellipsoid = {source.point(), {source.length(), source.length(), source.length()}};
  in.ray = {source.point(), source.random().vector(-1, 1)};
  in.point = source.point();
  in.direction = source.random().vector(-1, 1);
  in.clearance = source.length();
}

void add_bodies(Inputs& in, Source& source) {
  for (int i = 0; i < 12; ++i)
    in.hull_points.push_back(source.random().vector(-1, 1));
  for (int i = 0; i < 12; ++i) {
    Pose pose = random_pose(1.5, source.random());
    // Half of them as far from each other along an axis as the scale has it.
    if (i % 2 == 0) pose.translation().x() = source.coordinate();
    in.body_poses.push_back(pose);
  }
}

std::string text_of(const Pose& pose) {
  std::string text;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      char number[40];
      std::snprintf(number, sizeof number, "%.17g ", pose(row, column));
      text += number;
    }
  }
  return text;
}

void add_poses(Inputs& in, Source& source) {
  in.pose_a = source.pose();
  in.pose_b = source.pose();
  for (int i = 0; i < 6; ++i)
    in.poses.push_back(source.pose());
  // Some that turn nothing, so that lattices meet.
  in.poses[0].linear().setIdentity();
  if (source.random().integer(0, 1) == 0) {
    in.pose_a.linear().setIdentity();
    in.pose_b.linear().setIdentity();
  }
  in.pose_text = text_of(in.pose_b);
}

}  // namespace

Inputs inputs_of(Scale scale, std::uint64_t seed, std::size_t tetrahedra) {
  Source source(scale, seed);
  Inputs in;
  add_tetrahedra(in.vertices_a, in.triangles_a, tetrahedra, source);
  add_tetrahedra(in.vertices_b, in.triangles_b, tetrahedra, source);
  for (std::size_t i = 0; i < in.vertices_b.size(); ++i)
    in.bent.push_back(source.point());
  add_poses(in, source);
  add_volumes(in, source);
  add_bodies(in, source);
  return in;
}

Inputs large_inputs(Scale scale, int n) {
  Inputs in = inputs_of(scale, 1, 1);
  const Source source(scale, 1);
  for (auto* mesh : {&in.vertices_a, &in.vertices_b}) {
    auto& triangles = mesh == &in.vertices_a ? in.triangles_a : in.triangles_b;
    mesh->clear(), triangles.clear();
    for (int axis = 0; axis < 3; ++axis) {
      for (int side : {-1, 1}) {
        const auto first = static_cast<std::uint32_t>(mesh->size());
        for (int v = 0; v <= n; ++v) {
          for (int u = 0; u <= n; ++u) {
            Eigen::Vector3d p;
            p[axis] = source.scaled(side * n / 2);
            p[(axis + 1) % 3] = source.scaled(side * (u - n / 2));
            p[(axis + 2) % 3] = source.scaled(v - n / 2);
            mesh->push_back(p);
          }
        }
        const auto row = static_cast<std::uint32_t>(n + 1);
        for (std::uint32_t v = 0; v + 1 < row; ++v) {
          for (std::uint32_t u = 0; u + 1 < row; ++u) {
            const std::uint32_t a = first + v * row + u;
            triangles.push_back({a, a + 1, a + row});
            triangles.push_back({a + 1, a + row + 1, a + row});
          }
        }
      }
    }
  }
  in.pose_a = in.pose_b = Pose::Identity();
  in.pose_b.translation() = Eigen::Vector3d(source.scaled(1), 0, 0);
  RandomSource random(7);
  for (int i = 0; i < 70; ++i) {
    Pose pose = random_pose(0, random);
    pose.translation() = Eigen::Vector3d{source.scaled(i % 7), 0, source.scaled(n)};
    in.poses.push_back(pose);
  }
  for (int i = 0; i < 9000; ++i) {
    const Eigen::Vector3d p{source.scaled(i % 97), source.scaled(i % 89), source.scaled(i % 83)};
    in.boxes.push_back({p, p});
    const Eigen::Vector3d q{source.scaled(i % 61), source.scaled(i % 67), source.scaled(i % 71)};
    in.boxes_later.push_back({q, q});
  }
  in.bent = in.vertices_b;
  for (std::size_t i = 0; i < in.bent.size(); i += 3)
    in.bent[i] = in.vertices_b[(i * 7) % in.bent.size()];
  return in;
}

}  // namespace graze::tests
