// Law 12 for meshes with a clearance: what a walk finds beside each pair of triangles, or of
// features.

#include <graze/bvh/error.h>
#include <graze/engine/mesh/mesh_path.h>
#include <graze/narrowphase/crossing.h>
#include <graze/narrowphase/triangle_distance.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

constexpr StartContact kStarts[] = {StartContact::Counts, StartContact::IsLeft};

/// Every vertex goes its own way, and all by `shift` besides.
MeshPath moving(const Mesh& mesh, double reach, const Eigen::Vector3d& shift,
                RandomSource& source) {
  std::vector<Eigen::Vector3d> vertices(mesh.vertices().begin(), mesh.vertices().end());
  for (Eigen::Vector3d& v : vertices)
    v = v + shift + reach * source.vector(-1, 1);
  return MeshPath(mesh, mesh.deformed(vertices));
}

/// A strip of n squares along x, with shared vertices.
Mesh strip(std::uint32_t n, double z, RandomSource& source) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t k = 0; k < 2; ++k)
      vertices.emplace_back(i, k, z + 0.05 * source.uniform(-1, 1));
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    triangles.push_back({2 * i, 2 * i + 2, 2 * i + 1});
    triangles.push_back({2 * i + 1, 2 * i + 2, 2 * i + 3});
  }
  return Mesh(vertices, triangles);
}

PointPath path_of(const MeshPath& path, std::uint32_t vertex) {
  return {path.start().vertices()[vertex], path.end().vertices()[vertex]};
}

TrianglePath path_of(const MeshPath& path, const TriangleIndices& t) {
  return {path_of(path, t[0]), path_of(path, t[1]), path_of(path, t[2])};
}

void take(std::optional<FirstContact>& first, const std::optional<FirstContact>& contact) {
  if (!contact) return;
  if (!first || contact->time < first->time ||
      (contact->time == first->time && contact->is_at_start))
    first = contact;
}

std::optional<FirstContact> each_with_each(const MeshPath& a, const MeshPath& b,
                                           const FirstContactSettings& settings) {
  std::optional<FirstContact> first;
  for (const TriangleIndices& t : a.start().triangles()) {
    for (const TriangleIndices& u : b.start().triangles())
      take(first, first_contact(path_of(a, t), path_of(b, u), settings));
  }
  return first;
}

bool shares(std::initializer_list<std::uint32_t> a, const TriangleIndices& t) {
  return std::any_of(a.begin(), a.end(),
                     [&](std::uint32_t v) { return v == t[0] || v == t[1] || v == t[2]; });
}

std::optional<FirstContact> of_itself(const MeshPath& path, const FirstContactSettings& settings) {
  std::optional<FirstContact> first;
  const auto triangles = path.start().triangles();
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      if (i == k) continue;
      const TriangleIndices &t = triangles[i], &u = triangles[k];
      if (crosses(path.start().triangle(i), path.start().triangle(k)))
        take(first, FirstContact{0, true});
      for (std::size_t c = 0; c < 3; ++c) {
        if (!shares({t[c]}, u))
          take(first, first_contact(path_of(path, t[c]), path_of(path, u), settings));
        for (std::size_t d = 0; d < 3; ++d) {
          const std::uint32_t from_t = t[c], to_t = t[(c + 1) % 3];
          const std::uint32_t from_u = u[d], to_u = u[(d + 1) % 3];
          if (from_t == from_u || from_t == to_u || to_t == from_u || to_t == to_u) continue;
          take(first,
               first_contact(EdgePath{path_of(path, from_t), path_of(path, to_t)},
                             EdgePath{path_of(path, from_u), path_of(path, to_u)}, settings));
        }
      }
    }
  }
  return first;
}

void expect_same(const std::optional<MeshFirstContact>& found,
                 const std::optional<FirstContact>& right) {
  ASSERT_EQ(found.has_value(), right.has_value());
  if (!found) return;
  EXPECT_EQ(found->time, right->time);
  EXPECT_EQ(found->is_at_start, right->is_at_start);
}

TEST(Law12NearMeshes, AreEachTriangleWithEach) {
  RandomSource source(141);
  int later = 0;
  for (int n = 0; n < 16; ++n) {
    const MeshPath a =
        moving(tests::random_soup({.count = 8, .size = 0.2}, source), 0.3, {0, 0, 0}, source);
    const MeshPath b =
        moving(tests::random_soup({.count = 8, .size = 0.2}, source), 0.3, {0.2, 0, 0}, source);
    for (const StartContact start : kStarts) {
      const FirstContactSettings settings{.start = start, .clearance = 0.02 * (1 + n % 3)};
      const auto found = first_contact(a, b, settings);
      expect_same(found, each_with_each(a, b, settings));
      later += found && !found->is_at_start;
      const auto mirrored = first_contact(b, a, settings);
      ASSERT_EQ(mirrored.has_value(), found.has_value());
      if (found) {
        EXPECT_EQ(mirrored->time, found->time);
      }
    }
  }
  EXPECT_GT(later, 5);
}

/// The largest step that keeps a distance: it is kept there, and not a thousandth later.
TEST(Law12NearMeshes, AStepToTheTimeKeepsTheDistance) {
  RandomSource source(142);
  const auto distance_at = [](const MeshPath& a, const MeshPath& b, double t) {
    double least = std::numeric_limits<double>::infinity();
    const auto at = [&](const MeshPath& path, const TriangleIndices& i) {
      const auto corner = [&](std::uint32_t v) {
        const Eigen::Vector3d &from = path.start().vertices()[v], &to = path.end().vertices()[v];
        return Eigen::Vector3d(from + t * (to - from));
      };
      return Triangle{corner(i[0]), corner(i[1]), corner(i[2])};
    };
    for (const TriangleIndices& i : a.start().triangles()) {
      for (const TriangleIndices& k : b.start().triangles())
        least = std::min(least, distance(at(a, i), at(b, k)).distance);
    }
    return least;
  };
  for (int n = 0; n < 8; ++n) {
    const MeshPath low = moving(strip(3, 0, source), 0.05, {0, 0, 0.3}, source);
    const MeshPath high = moving(strip(4, 0.7, source), 0.05, {0, 0, -0.5}, source);
    Work work;
    const auto found = first_contact(low, high, {.clearance = 0.1}, &work);
    ASSERT_TRUE(found);
    EXPECT_NEAR(distance_at(low, high, found->time), 0.1, 1e-12);
    EXPECT_GT(distance_at(low, high, 0.99 * found->time), 0.1);
    EXPECT_LT(found->time, first_contact(low, high)->time);
    expect_same(found, each_with_each(low, high, {.clearance = 0.1}));
    EXPECT_FALSE(first_contact(low, moving(strip(2, 9, source), 0.1, {0, 0, -0.5}, source),
                               {.clearance = 0.1}));
  }
}

TEST(Law12NearMeshes, OneWithItself) {
  RandomSource source(143);
  int later = 0;
  for (int n = 0; n < 6; ++n) {
    // A strip that rolls up, and comes near to itself.
    const Mesh flat = strip(5, 0, source);
    std::vector<Eigen::Vector3d> rolled;
    for (const Eigen::Vector3d& v : flat.vertices()) {
      const double angle = (1.1 + 0.1 * n) * v.x();
      rolled.emplace_back(0.9 * std::sin(angle), v.y(), 0.9 - 0.9 * std::cos(angle));
    }
    const MeshPath path(flat, flat.deformed(rolled));
    for (const StartContact start : kStarts) {
      const FirstContactSettings settings{.start = start, .clearance = 0.1};
      const auto found = first_self_contact(path, settings);
      expect_same(found, of_itself(path, settings));
      later += found && !found->is_at_start;
    }
  }
  EXPECT_GT(later, 2);
}

TEST(Law12NearMeshes, AllContactsInAStepHaveTheFirst) {
  RandomSource source(144);
  const MeshPath low = moving(strip(2, 0, source), 0.05, {0, 0, 0.3}, source);
  const MeshPath high = moving(strip(2, 0.4, source), 0.05, {0, 0, -0.2}, source);
  const FirstContactSettings settings{.clearance = 0.05};
  const auto all = find_contacts_in_step(low, high, settings);
  const auto first = first_contact(low, high, settings);
  ASSERT_TRUE(first);
  EXPECT_GE(all.size(), find_contacts_in_step(low, high).size());
  EXPECT_NE(std::find(all.begin(), all.end(), *first), all.end());
  for (const MeshFirstContact& each : all)
    EXPECT_GE(each.time, first->time);
  EXPECT_FALSE(find_self_contacts_in_step(low, settings).size() > 0 &&
               !first_self_contact(low, settings));
}

TEST(Law12NearMeshes, HugeAndTiny) {
  for (const double scale : {0x1p1000, 0x1p-1000}) {
    const Mesh floor(std::vector<Eigen::Vector3d>{{0, 0, 0}, {4 * scale, 0, 0}, {0, 4 * scale, 0}},
                     std::vector<TriangleIndices>{{0, 1, 2}});
    const auto lifted = [&](double height) {
      std::vector<Eigen::Vector3d> vertices(floor.vertices().begin(), floor.vertices().end());
      for (Eigen::Vector3d& v : vertices)
        v.z() += height * scale;
      return floor.deformed(vertices);
    };
    const MeshPath rest(floor, floor), falls(lifted(4), lifted(0));
    const auto met = first_contact(rest, falls, {.clearance = scale});
    ASSERT_TRUE(met);
    EXPECT_EQ(met->time, 0.75);
    const MeshPath stays(lifted(4), lifted(3));
    EXPECT_FALSE(first_contact(rest, stays, {.clearance = 2 * scale}));
  }
}

TEST(Law12NearMeshes, RefusesWhatIsNoDistance) {
  RandomSource source(145);
  const MeshPath path = moving(strip(1, 0, source), 0.05, {0, 0, 0.3}, source);
  for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(first_contact(path, path, {.clearance = bad}), InputError);
    EXPECT_THROW(first_self_contact(path, {.clearance = bad}), InputError);
    EXPECT_THROW(find_contacts_in_step(path, path, {.clearance = bad}), InputError);
    EXPECT_THROW(find_self_contacts_in_step(path, {.clearance = bad}), InputError);
  }
}

}  // namespace
}  // namespace graze
