// Points and a mesh: beside every triangle looked at, beside rational arithmetic, and many beside
// one by one.

#include <graze/bvh/error.h>
#include <graze/engine/mesh/containment.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/derived/point_distance.h>
#include <graze/print.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "tests/engine/rational_containment.h"
#include "tests/shapes/closed_meshes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

NearestPoint brute_force(const PlacedMesh& mesh, const Eigen::Vector3d& point) {
  NearestPoint best{std::numeric_limits<double>::infinity(), {0, 0, 0}, 0xffffffffu};
  for (std::uint32_t i = 0; i < mesh.mesh.triangles().size(); ++i) {
    const auto found = narrowphase::decide_distance(point, place(mesh.pose, mesh.mesh.triangle(i)));
    if (found.distance < best.distance || i == 0) best = {found.distance, found.nearest, i};
  }
  return best;
}

/// Points on lattices and between, near and far, on the surface and at vertices.
std::vector<Eigen::Vector3d> points_around(const PlacedMesh& mesh, double reach, int count,
                                           RandomSource& source) {
  std::vector<Eigen::Vector3d> points;
  const Eigen::Vector3d middle = mesh.pose.translation();
  for (int n = 0; n < count; ++n) {
    points.push_back(source.vector(-reach, reach) + middle);
    points.push_back(source.lattice_point(-3, 3) * (reach / 3) + middle);
    points.push_back(source.vector(-100 * reach, 100 * reach));
    const auto index = static_cast<std::size_t>(
        source.integer(0, static_cast<int>(mesh.mesh.triangles().size()) - 1));
    const Triangle triangle = place(mesh.pose, mesh.mesh.triangle(index));
    points.push_back(triangle.a);
    points.push_back((triangle.a + triangle.b) / 2);
    points.push_back((triangle.a + triangle.b + triangle.c) / 3);
  }
  return points;
}

/// Meshes in poses, at rest, turned, far away, and distorted as far as law 10 lets them.
std::vector<PlacedMesh> placed_meshes(RandomSource& source) {
  std::vector<PlacedMesh> meshes;
  for (int n = 0; n < 4; ++n) {
    const Mesh mesh = n == 0   ? tests::make_torus(2, 0.5, 24, 12)
                      : n == 1 ? tests::lattice_tetrahedra(12, 3, source)
                      : n == 2 ? tests::random_tetrahedra(12, 2, source)
                               : tests::mapped(tests::make_sphere(1, 12, 12), 1e-3, {1, 2, 3});
    meshes.push_back({mesh, Pose::Identity()});
    meshes.push_back({mesh, tests::random_pose(1, source)});
    meshes.push_back({mesh, tests::random_pose(1e6, source)});
    meshes.push_back({mesh, tests::distorted(tests::random_pose(10, source), 1e-7, source)});
  }
  return meshes;
}

TEST(Law9Points, NearestIsBruteForce) {
  RandomSource source(31);
  Work work;
  std::size_t count = 0, all = 0;
  for (const PlacedMesh& mesh : placed_meshes(source)) {
    for (const Eigen::Vector3d& point : points_around(mesh, 3, 20, source)) {
      EXPECT_EQ(nearest_point(mesh, point, &work), brute_force(mesh, point));
      ++count, all += mesh.mesh.triangles().size();
    }
  }
  EXPECT_GT(count, 1500u);
  EXPECT_LT(work.triangle_tests, all / 2) << "most triangles are not looked at";
}

// Law 5 where it is hardest: many triangles that are equally near, up to rounding, and far off.
TEST(Law9Points, TheLowestOfManyThatAreAsNear) {
  RandomSource source(32);
  const Mesh sphere = tests::make_sphere(1, 16, 24);
  for (int n = 0; n < 40; ++n) {
    const PlacedMesh mesh{sphere, tests::random_pose(n % 2 == 0 ? 1 : 1e9, source)};
    const Eigen::Vector3d middle = mesh.pose.translation();
    EXPECT_EQ(nearest_point(mesh, middle), brute_force(mesh, middle));
    EXPECT_EQ(nearest_point(sphere, {0, 0, 0}), brute_force({sphere}, {0, 0, 0}));
  }
  const Mesh box = tests::make_box({1, 1, 1});
  EXPECT_EQ(nearest_point(box, {0, 0, 0}).triangle, 0u);
  EXPECT_EQ(nearest_point(box, {0, 0, 0}).distance, 1);
}

TEST(Law9Points, OfAnySize) {
  RandomSource source(33);
  const Mesh torus = tests::make_torus(2, 0.5, 12, 8);
  for (const double scale : {1e-320, 1e-300, 1e-100, 1e100, 1e300}) {
    const PlacedMesh mesh{tests::mapped(torus, scale, {0, 0, 0})};
    for (int n = 0; n < 20; ++n) {
      const Eigen::Vector3d point = source.vector(-3, 3) * scale;
      EXPECT_EQ(nearest_point(mesh, point), brute_force(mesh, point)) << scale;
    }
    for (const double far : {1e-300, 1.0, 1e300, 1.7e308}) {
      const Eigen::Vector3d point(far, -far, far / 2);
      EXPECT_EQ(nearest_point(mesh, point), brute_force(mesh, point)) << scale << ' ' << far;
    }
  }
}

TEST(Points, SignsAreThoseOfRationalArithmetic) {
  RandomSource source(34);
  int inside = 0, on = 0;
  for (int n = 0; n < 8; ++n) {
    const Mesh mesh = n % 2 == 0 ? tests::lattice_tetrahedra(8, 3, source)
                                 : tests::random_tetrahedra(8, 2, source);
    for (const Eigen::Vector3d& point : points_around({mesh}, 2, 10, source)) {
      const double distance = signed_distance(mesh, point);
      EXPECT_EQ(std::abs(distance), nearest_point(mesh, point).distance);
      EXPECT_EQ(distance <= 0, oracle::contains_by_slanted_ray(mesh, point));
      EXPECT_FALSE(std::signbit(distance) && distance == 0);
      inside += distance < 0, on += distance == 0;
    }
  }
  EXPECT_GT(inside, 40);
  EXPECT_GT(on, 100);
}

Eigen::MatrixXd matrix_of(const std::vector<Eigen::Vector3d>& points) {
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    matrix.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  return matrix;
}

// Law 8: whatever the number of threads, whatever holds the points, each as if alone.
TEST(Law8PointsThreads, ManyAreAsOneByOne) {
  RandomSource source(35);
  for (const PlacedMesh& mesh : placed_meshes(source)) {
    const std::vector<Eigen::Vector3d> points = points_around(mesh, 3, 50, source);
    std::vector<NearestPoint> nearest;
    std::vector<double> distances;
    std::vector<bool> inside;
    for (const Eigen::Vector3d& point : points) {
      nearest.push_back(nearest_point(mesh, point));
      distances.push_back(signed_distance(mesh, point));
      inside.push_back(contains(mesh, point));
    }
    const Eigen::MatrixXd columns = matrix_of(points);
    const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> rows = columns;
    Eigen::MatrixXd wide(2 * columns.rows(), 7);
    wide.setConstant(std::nan(""));
    Eigen::Map<Eigen::MatrixXd, 0, Eigen::Stride<-1, -1>> every_other(
        wide.data(), columns.rows(), 3, Eigen::Stride<-1, -1>(2 * wide.rows(), 2));
    every_other = columns;
    for (const int threads : {0, 1, 2, 3}) {
      const BatchSettings batch{.threads = threads};
      EXPECT_EQ(nearest_points(mesh, points, batch), nearest);
      EXPECT_EQ(signed_distances(mesh, points, batch), distances);
      EXPECT_EQ(contains_points(mesh, points, batch), inside);
      EXPECT_EQ(nearest_points(mesh, columns, batch), nearest);
      EXPECT_EQ(signed_distances(mesh, rows, batch), distances);
      EXPECT_EQ(contains_points(mesh, rows, batch), inside);
      EXPECT_EQ(nearest_points(mesh, every_other, batch), nearest);
      EXPECT_EQ(signed_distances(mesh, every_other, batch), distances);
      EXPECT_EQ(contains_points(mesh, columns, batch), inside);
    }
  }
}

TEST(Points, NoneAndMany) {
  const Mesh torus = tests::make_torus(2, 0.5, 24, 12);
  const std::vector<Eigen::Vector3d> none;
  EXPECT_TRUE(nearest_points(torus, none).empty());
  EXPECT_TRUE(signed_distances(torus, none).empty());
  EXPECT_TRUE(contains_points(torus, Eigen::MatrixXd(0, 3)).empty());
  RandomSource source(36);
  std::vector<Eigen::Vector3d> many;
  for (int n = 0; n < 20000; ++n)
    many.push_back(source.vector(-3, 3));
  Work alone, shared;
  EXPECT_EQ(nearest_points(torus, many, {.threads = 1}, &alone),
            nearest_points(torus, many, {.threads = 0}, &shared));
  EXPECT_GT(shared.triangle_tests, many.size());
  Work inside;
  contains_points(torus, many, {}, &inside);
  EXPECT_GT(inside.points_tested, 1000u);
}

/// A million, of which every thousandth is asked alone.
TEST(PointsSlow, AMillionAreAsOneByOne) {
  const Mesh torus = tests::make_torus(2, 0.5, 96, 48);
  RandomSource source(37);
  std::vector<Eigen::Vector3d> many(1'000'000);
  for (Eigen::Vector3d& point : many)
    point = source.vector(-3, 3);
  std::size_t last_done = 0, last_total = 0;
  const BatchSettings batch{.threads = 0, .on_progress = [&](std::size_t done, std::size_t total) {
                              EXPECT_GE(done, last_done);
                              last_done = done, last_total = total;
                            }};
  const std::vector<double> distances = signed_distances(torus, many, batch);
  EXPECT_GT(last_total, 0u);
  EXPECT_EQ(last_done, last_total);
  const std::vector<bool> inside = contains_points(torus, many);
  const std::vector<NearestPoint> nearest = nearest_points(torus, many);
  ASSERT_EQ(distances.size(), many.size());
  ASSERT_EQ(inside.size(), many.size());
  ASSERT_EQ(nearest.size(), many.size());
  std::size_t within = 0;
  for (std::size_t i = 0; i < many.size(); ++i) {
    EXPECT_EQ(distances[i] < 0, inside[i] && nearest[i].distance > 0);
    EXPECT_EQ(std::abs(distances[i]), nearest[i].distance);
    within += inside[i];
    if (i % 1009 != 0) continue;
    EXPECT_EQ(distances[i], signed_distance(torus, many[i]));
    EXPECT_EQ(nearest[i], nearest_point(torus, many[i]));
    EXPECT_EQ(inside[i], contains(torus, many[i]));
  }
  // The share of a torus in a cube: 2 pi^2 R r^2 of 6^3.
  EXPECT_NEAR(static_cast<double>(within) / 1e6, 9.8696 / 216, 0.002);
}

TEST(Points, AreNearestInPrint) {
  std::ostringstream text;
  text << std::hex << nearest_point(tests::make_box({1, 1, 1}), {0.5, 0.25, 3});
  EXPECT_EQ(text.str().find("distance 2 to (0.5, 0.25, 1) in triangle "), 0u) << text.str();
}

template <typename Error, typename Ask>
std::string message_of(Ask&& ask) {
  try {
    ask();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(Law10Points, WhatIsWrongIsNamed) {
  const Mesh box = tests::make_box({1, 1, 1});
  const Eigen::Vector3d origin(0, 0, 0);
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    const Eigen::Vector3d broken(0, bad, 0);
    EXPECT_EQ(message_of<InputError>([&] { nearest_point(box, broken); }),
              "point: coordinate y is not finite");
    EXPECT_EQ(message_of<InputError>([&] { signed_distance(box, broken); }),
              "point: coordinate y is not finite");
    const std::vector<Eigen::Vector3d> points{origin, origin, broken};
    const Eigen::MatrixXd rows = matrix_of(points);
    const std::string third = "point 2: coordinate y is not finite";
    EXPECT_EQ(message_of<InputError>([&] { nearest_points(box, points); }), third);
    EXPECT_EQ(message_of<InputError>([&] { signed_distances(box, rows); }), third);
    EXPECT_EQ(message_of<InputError>([&] { contains_points(box, points); }), third);
    try {
      contains_points(box, rows);
      FAIL();
    } catch (const InputError& error) {
      EXPECT_EQ(error.place(), (ErrorPlace{.element = "point", .index = 2}));
    }
  }
  EXPECT_EQ(message_of<InputError>([&] { nearest_points(box, Eigen::MatrixXd::Zero(2, 4)); }),
            "points: a matrix of 4 columns, not 3");
  const std::vector<Eigen::Vector3d> one{origin};
  EXPECT_THROW(nearest_points(box, one, {.threads = -1}), InputError);
  EXPECT_THROW(contains_points(box, one, {.threads = -1}), InputError);
  Pose skewed = Pose::Identity();
  skewed.matrix()(0, 1) = 0.1;
  EXPECT_THROW(nearest_point({box, skewed}, origin), PoseError);
  EXPECT_THROW(nearest_points({box, skewed}, one), PoseError);
  EXPECT_THROW(signed_distances({box, skewed}, one), PoseError);
  EXPECT_THROW(contains_points({box, skewed}, one), PoseError);
  const Mesh open = tests::make_row(1);
  const std::string message =
      "the mesh is not closed: it has 3 boundary edges, the first from vertex 0 to vertex 1 of "
      "triangle 0";
  EXPECT_EQ(nearest_point(open, origin).distance, 0);
  EXPECT_EQ(message_of<MeshError>([&] { signed_distance(open, origin); }), message);
  EXPECT_EQ(message_of<MeshError>([&] { signed_distances(open, one); }), message);
  EXPECT_EQ(message_of<MeshError>([&] { contains_points(open, one); }), message);
}

}  // namespace
}  // namespace graze
