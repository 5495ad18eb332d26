#include <graze/narrowphase/triangle_pair/adjacent_triangles.h>
#include <graze/narrowphase/triangle_pair/vertex_fan.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/shapes/random_source.h"

namespace graze::narrowphase {
namespace {

using FanKind = VertexFan::Kind;

constexpr double kTurn = 2 * std::numbers::pi;

/// A vertex, and where its rays lead to.
struct Fan {
  Eigen::Vector3d vertex = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> ends;
  FanKind kind = FanKind::Closed;

  bool is_sure() const {
    std::vector<const Eigen::Vector3d*> rays;
    rays.reserve(ends.size());
    for (const Eigen::Vector3d& end : ends)
      rays.push_back(&end);
    return is_surely_simple({&vertex, rays, kind});
  }

  /// Exactly, pair by pair: no two triangles have more in common than they share.
  bool is_simple() const {
    const std::size_t rays = ends.size();
    const std::size_t sectors = kind == FanKind::Closed ? rays : rays - 1;
    const auto end = [&](std::size_t i) { return ends[i % rays]; };
    for (std::size_t i = 0; i < sectors; ++i) {
      for (std::size_t j = i + 1; j < sectors; ++j) {
        const bool is_next = j == i + 1;
        const bool is_before = kind == FanKind::Closed && i == 0 && j == rays - 1;
        const bool do_meet =
            is_next ? intersect_beyond_edge({vertex, end(j), end(i)}, {vertex, end(j), end(j + 1)})
            : is_before ? intersect_beyond_edge({vertex, end(0), end(1)}, {vertex, end(0), end(j)})
                        : intersect_beyond_vertex({vertex, end(i), end(i + 1)},
                                                  {vertex, end(j), end(j + 1)});
        if (do_meet) return false;
      }
    }
    return true;
  }
};

/// Rays at equal angles, the last one `turns` turns on from the first, or before it if closed.
Fan regular(std::size_t rays, double turns, FanKind kind, double slope = 0) {
  Fan fan{.ends = {}, .kind = kind};
  const double step =
      turns * kTurn / static_cast<double>(kind == FanKind::Closed ? rays : rays - 1);
  for (std::size_t i = 0; i < rays; ++i) {
    const double angle = step * static_cast<double>(i);
    fan.ends.emplace_back(std::cos(angle), std::sin(angle), slope);
  }
  return fan;
}

TEST(VertexFan, IsSureOfWhatSurfacesHave) {
  EXPECT_TRUE(regular(6, 1, FanKind::Closed).is_sure()) << "opposite edges lie on one line";
  EXPECT_TRUE(regular(3, 1, FanKind::Closed, -1).is_sure());
  EXPECT_TRUE(regular(4, 1, FanKind::Closed, -5).is_sure());
  EXPECT_TRUE(regular(128, 1, FanKind::Closed, 3).is_sure());
  EXPECT_TRUE(regular(2, 0.2, FanKind::Open).is_sure());
  EXPECT_TRUE(regular(5, 0.5, FanKind::Open).is_sure()) << "ends on the line that it begins with";
  EXPECT_TRUE(regular(7, 0.9, FanKind::Open).is_sure());
  // A cube's corner, one of whose faces is two triangles.
  EXPECT_TRUE((Fan{.ends = {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}}}).is_sure());
  // A crease of 20 degrees, most of whose triangles lie on one side: their mean normal sees the
  // rest from behind.
  Fan crease;
  for (int i = 0; i <= 8; ++i)
    crease.ends.emplace_back(std::cos(kTurn * i / 16), std::sin(kTurn * i / 16), 0);
  crease.ends.emplace_back(0.1, std::cos(kTurn / 18), -std::sin(kTurn / 18));
  EXPECT_TRUE(crease.is_simple());
  EXPECT_TRUE(crease.is_sure());
}

TEST(VertexFan, IsNeverSureOfWhatOverlaps) {
  EXPECT_FALSE(regular(14, 2, FanKind::Closed).is_sure()) << "around twice";
  EXPECT_FALSE(regular(21, 3, FanKind::Closed, 1).is_sure());
  EXPECT_FALSE(regular(9, 1.1, FanKind::Open).is_sure());
  EXPECT_FALSE(regular(9, 1.6, FanKind::Open).is_sure());
  EXPECT_FALSE(regular(9, 2.1, FanKind::Open).is_sure());
  Fan back{.ends = {{1, 0, 0}, {0, 1, 0}, {1, 0.1, 0}}, .kind = FanKind::Open};
  EXPECT_FALSE(back.is_sure()) << "turns back";
  // Its last ray is its first, further on.
  Fan whole = regular(5, 1, FanKind::Open);
  whole.ends.back() = {2, 0, 0};
  EXPECT_FALSE(whole.is_simple());
  EXPECT_FALSE(whole.is_sure());
  Fan flat{.ends = {{1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}}};
  EXPECT_FALSE(flat.is_sure()) << "a triangle without area";
  Fan at_vertex{.ends = {{1, 0, 0}, {0, 0, 0}, {-1, -1, 0}}};
  EXPECT_FALSE(at_vertex.is_sure());
}

// What it is sure of holds exactly, and it is sure of most of what is seen to be simple.
TEST(VertexFan, IsRightWhereItIsSure) {
  RandomSource source(11);
  int sure = 0, wrong = 0, simple = 0, crossing = 0;
  for (int n = 0; n < 30000; ++n) {
    const auto rays = static_cast<std::size_t>(source.integer(3, 9));
    const FanKind kind = n % 2 == 0 ? FanKind::Closed : FanKind::Open;
    const double turns = kind == FanKind::Closed ? source.integer(1, 2) : source.uniform(0.1, 1.5);
    Fan fan = regular(rays, turns, kind, source.uniform(-2, 2));
    // From smooth to crumpled; a third on a lattice, where edges and triangles line up.
    const double noise = std::pow(10, source.uniform(-17, 0));
    fan.vertex = noise * source.vector(-1, 1);
    for (Eigen::Vector3d& end : fan.ends) {
      end = source.uniform(0.5, 2) * (end + noise * source.vector(-1, 1));
      if (n % 3 == 0) end = (2 * end).array().round();
    }
    if (n % 3 == 0) fan.vertex.setZero();
    const double scale = std::pow(10, source.uniform(-170, 140));
    if (n % 5 == 0) {
      fan.vertex *= scale;
      for (Eigen::Vector3d& end : fan.ends)
        end *= scale;
    }
    const bool is_sure = fan.is_sure();
    sure += is_sure;
    if (fan.is_simple()) {
      ++simple;
    } else {
      ++crossing;
      wrong += is_sure;
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(crossing, 5000);
  EXPECT_GT(simple, 5000);
  EXPECT_GT(sure, simple / 2);
}

TEST(VertexFan, IsUnsureOutsideItsRange) {
  for (const double scale : {1e-300, 1e-160, 1e160, 1e305}) {
    Fan fan = regular(6, 1, FanKind::Closed);
    for (Eigen::Vector3d& end : fan.ends)
      end *= scale;
    EXPECT_FALSE(fan.is_sure()) << scale;
  }
}

}  // namespace
}  // namespace graze::narrowphase
