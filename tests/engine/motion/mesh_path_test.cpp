// Law 12 for meshes: what a walk finds beside each pair of triangles, or of features.

#include <graze/bvh/error.h>
#include <graze/engine/mesh/mesh_path.h>
#include <graze/narrowphase/crossing.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

constexpr StartContact kStarts[] = {StartContact::Counts, StartContact::IsLeft};

/// Every vertex goes its own way, and all by `shift` besides.
Mesh moved(const Mesh& mesh, double reach, const Eigen::Vector3d& shift, RandomSource& source) {
  std::vector<Eigen::Vector3d> vertices(mesh.vertices().begin(), mesh.vertices().end());
  for (Eigen::Vector3d& v : vertices)
    v = v + shift + reach * source.vector(-1, 1);
  return mesh.deformed(vertices);
}

/// A sheet of n by n squares over [0, 1]^2, at height z, with shared vertices.
Mesh sheet(std::uint32_t n, double z, double roughness, RandomSource& source) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t k = 0; k <= n; ++k)
      vertices.emplace_back(double(i) / n, double(k) / n, z + roughness * source.uniform(-1, 1));
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t a = i * (n + 1) + k, b = a + n + 1;
      triangles.push_back({a, b, a + 1});
      triangles.push_back({a + 1, b, b + 1});
    }
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

std::optional<FirstContact> brute_force(const MeshPath& a, const MeshPath& b, StartContact start) {
  std::optional<FirstContact> first;
  for (const TriangleIndices& t : a.start().triangles()) {
    for (const TriangleIndices& u : b.start().triangles())
      take(first, first_contact(path_of(a, t), path_of(b, u), {.start = start}));
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

/// What the features that it names do alone.
std::optional<FirstContact> of_features(const MeshPath& a, const MeshPath& b,
                                        const MeshFirstContact& found, StartContact start) {
  const TrianglePath t = path_of(a, a.start().triangles()[found.pair.a]);
  const TrianglePath u = path_of(b, b.start().triangles()[found.pair.b]);
  const PointPath corner_t[3] = {t.a, t.b, t.c}, corner_u[3] = {u.a, u.b, u.c};
  const std::uint32_t i = found.place_a, k = found.place_b;
  switch (found.features) {
    case MeetingFeatures::VertexFace:
      return first_contact(corner_t[i], u, {.start = start});
    case MeetingFeatures::FaceVertex:
      return first_contact(corner_u[k], t, {.start = start});
    case MeetingFeatures::EdgeEdge:
      return first_contact(EdgePath{corner_t[i], corner_t[(i + 1) % 3]},
                           EdgePath{corner_u[k], corner_u[(k + 1) % 3]}, {.start = start});
    case MeetingFeatures::AtStart:
      break;
  }
  return intersects(Triangle{t.a.start, t.b.start, t.c.start},
                    Triangle{u.a.start, u.b.start, u.c.start})
             ? std::optional<FirstContact>({0, true})
             : std::nullopt;
}

TEST(Law12Meshes, AreEachTriangleWithEach) {
  RandomSource source(41);
  int later = 0;
  for (int n = 0; n < 60; ++n) {
    const Mesh start_a = tests::random_soup({.count = 12, .size = 0.2}, source);
    const Mesh start_b = tests::random_soup({.count = 12, .size = 0.2}, source);
    const MeshPath a(start_a, moved(start_a, 0.3, {0, 0, 0}, source));
    const MeshPath b(start_b, moved(start_b, 0.3, {0.2, 0, 0}, source));
    for (StartContact start : kStarts) {
      const auto found = first_contact(a, b, {.start = start});
      expect_same(found, brute_force(a, b, start));
      if (found) expect_same(found, of_features(a, b, *found, start));
      later += found && !found->is_at_start;
      const auto mirrored = first_contact(b, a, {.start = start});
      ASSERT_EQ(mirrored.has_value(), found.has_value());
      if (found) {
        EXPECT_EQ(mirrored->time, found->time);
      }
    }
  }
  EXPECT_GT(later, 20);
}

TEST(Law12Meshes, OfLatticesTouchInManyWays) {
  RandomSource source(42);
  for (int n = 0; n < 40; ++n) {
    const Mesh start_a = tests::lattice_soup(6, 2, source),
               end_a = tests::lattice_soup(6, 2, source);
    const Mesh start_b = tests::lattice_soup(6, 2, source),
               end_b = tests::lattice_soup(6, 2, source);
    if (start_a.vertices().size() != end_a.vertices().size() ||
        start_b.vertices().size() != end_b.vertices().size())
      continue;
    const MeshPath a(start_a, start_a.deformed(end_a.vertices()));
    const MeshPath b(start_b, start_b.deformed(end_b.vertices()));
    for (StartContact start : kStarts)
      expect_same(first_contact(a, b, {.start = start}), brute_force(a, b, start));
  }
}

// Two sheets that come together, each in its own way: most pairs of boxes are never opened.
TEST(Law12Meshes, SheetsMeetOnce) {
  RandomSource source(43);
  for (int n = 0; n < 10; ++n) {
    const Mesh low = sheet(6, 0, 0.02, source), high = sheet(5, 0.3, 0.02, source);
    const MeshPath a(low, moved(low, 0.01, {0, 0, 0.2}, source));
    const MeshPath b(high, moved(high, 0.01, {0.01, 0, -0.2}, source));
    Work work;
    const auto found = first_contact(a, b, {}, &work);
    ASSERT_TRUE(found);
    EXPECT_GT(found->time, 0.5);
    expect_same(found, brute_force(a, b, StartContact::Counts));
    EXPECT_GT(work.volume_rejections, 0u);
    EXPECT_GT(a.bytes(), 72 * sizeof(std::uint32_t));
  }
}

std::optional<FirstContact> brute_force_of_one(const MeshPath& path, StartContact start) {
  std::optional<FirstContact> first;
  const auto triangles = path.start().triangles();
  const auto shares = [](const auto& a, const auto& b) {
    return std::any_of(a.begin(), a.end(), [&](std::uint32_t v) {
      return std::find(b.begin(), b.end(), v) != b.end();
    });
  };
  using Vertices = std::vector<std::uint32_t>;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      if (i == k) continue;
      const TriangleIndices &t = triangles[i], &u = triangles[k];
      const Vertices of_t{t[0], t[1], t[2]}, of_u{u[0], u[1], u[2]};
      const Triangle start_t = path.start().triangle(i), start_u = path.start().triangle(k);
      if (start == StartContact::IsLeft || shares(of_t, of_u) ? crosses(start_t, start_u)
                                                              : intersects(start_t, start_u))
        take(first, FirstContact{0, true});
      for (int c = 0; c < 3; ++c) {
        if (!shares(Vertices{t[c]}, of_u))
          take(first, first_contact(path_of(path, t[c]), path_of(path, u), {.start = start}));
        for (int d = 0; d < 3; ++d) {
          const Vertices edge_t{t[c], t[(c + 1) % 3]}, edge_u{u[d], u[(d + 1) % 3]};
          if (shares(edge_t, edge_u)) continue;
          take(first, first_contact(EdgePath{path_of(path, edge_t[0]), path_of(path, edge_t[1])},
                                    EdgePath{path_of(path, edge_u[0]), path_of(path, edge_u[1])},
                                    {.start = start}));
        }
      }
    }
  }
  return first;
}

TEST(Law12Meshes, OneWithItself) {
  RandomSource source(44);
  int later = 0;
  for (int n = 0; n < 12; ++n) {
    const Mesh flat = sheet(3, 0, n % 3 == 0 ? 0 : 0.05, source);
    const MeshPath path(flat, moved(flat, n % 2 == 0 ? 0.1 : 0.6, {0, 0, 1}, source));
    for (StartContact start : kStarts) {
      const auto found = first_self_contact(path, {.start = start});
      expect_same(found, brute_force_of_one(path, start));
      if (found) {
        EXPECT_LT(found->pair.a, found->pair.b);
      }
      later += found && !found->is_at_start;
    }
  }
  EXPECT_GT(later, 3);
  // At rest a sheet with itself, as neighbours that only touch, meets nothing.
  const Mesh rest = sheet(4, 0, 0.1, source);
  EXPECT_EQ(first_self_contact(MeshPath(rest, rest)), std::nullopt);
}

/// What two features do, in words that can be sorted.
struct ToldContact {
  MeetingFeatures features;
  double time;
  bool is_at_start;
  auto operator<=>(const ToldContact&) const = default;
};

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::set<Edge> edges_of(const Mesh& mesh) {
  std::set<Edge> edges;
  for (const TriangleIndices& t : mesh.triangles()) {
    for (int k = 0; k < 3; ++k)
      edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  }
  return edges;
}

/// Every vertex with every face, and every edge with every edge, once; and what crosses at t = 0.
/// Of one mesh what has vertices in common is left out.
std::vector<ToldContact> all_contacts(const MeshPath& a, const MeshPath& b, StartContact start,
                                      bool is_one) {
  std::vector<ToldContact> all;
  const auto add = [&](MeetingFeatures features, const std::optional<FirstContact>& contact) {
    if (contact) all.push_back({features, contact->time, contact->is_at_start});
  };
  const auto has = [&](const TriangleIndices& t, std::uint32_t v) {
    return is_one && (t[0] == v || t[1] == v || t[2] == v);
  };
  const auto in_a = a.start().triangles(), in_b = b.start().triangles();
  for (std::uint32_t v = 0; v < a.start().vertices().size(); ++v) {
    for (const TriangleIndices& u : in_b) {
      if (!has(u, v))
        add(MeetingFeatures::VertexFace, first_contact(path_of(a, v), path_of(b, u), {start}));
    }
  }
  for (std::uint32_t v = 0; !is_one && v < b.start().vertices().size(); ++v) {
    for (const TriangleIndices& t : in_a)
      add(MeetingFeatures::VertexFace, first_contact(path_of(b, v), path_of(a, t), {start}));
  }
  for (const Edge& e : edges_of(a.start())) {
    for (const Edge& f : edges_of(b.start())) {
      const bool share =
          e.first == f.first || e.first == f.second || e.second == f.first || e.second == f.second;
      if (is_one && (share || !(e < f))) continue;
      add(MeetingFeatures::EdgeEdge,
          first_contact(EdgePath{path_of(a, e.first), path_of(a, e.second)},
                        EdgePath{path_of(b, f.first), path_of(b, f.second)}, {start}));
    }
  }
  for (std::size_t i = 0; i < in_a.size(); ++i) {
    for (std::size_t k = is_one ? i + 1 : 0; k < in_b.size(); ++k) {
      const Triangle t = a.start().triangle(i), u = b.start().triangle(k);
      const bool may_touch = start == StartContact::IsLeft || has(in_a[i], in_b[k][0]) ||
                             has(in_a[i], in_b[k][1]) || has(in_a[i], in_b[k][2]);
      if (may_touch ? crosses(t, u) : intersects(t, u))
        all.push_back({MeetingFeatures::AtStart, 0, true});
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

void expect_all(const std::vector<MeshFirstContact>& found, std::vector<ToldContact> right,
                const std::optional<MeshFirstContact>& first) {
  const auto place_of = [](const MeshFirstContact& c) {
    return std::make_tuple(c.pair, c.features, c.place_a, c.place_b);
  };
  std::vector<ToldContact> told;
  for (const MeshFirstContact& c : found) {
    const bool is_face = c.features == MeetingFeatures::FaceVertex;
    told.push_back({is_face ? MeetingFeatures::VertexFace : c.features, c.time, c.is_at_start});
  }
  std::sort(told.begin(), told.end());
  EXPECT_EQ(told.size(), right.size());
  EXPECT_TRUE(told == right);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end(), [&](const auto& s, const auto& t) {
    return place_of(s) < place_of(t);
  }));
  EXPECT_EQ(first.has_value(), !found.empty());
  if (first) {
    EXPECT_NE(std::find(found.begin(), found.end(), *first), found.end());
  }
}

TEST(Law12Meshes, AllContactsAreThoseOfEachPairOfFeatures) {
  RandomSource source(47);
  std::size_t contacts = 0;
  for (int n = 0; n < 12; ++n) {
    const Mesh low = sheet(3, 0, 0.05, source), high = sheet(2, 0.2, 0.05, source);
    const MeshPath a(low, moved(low, 0.1, {0, 0, 0.2}, source));
    const MeshPath b(high, moved(high, 0.1, {0.05, 0, n % 3 == 0 ? -0.3 : -0.1}, source));
    const MeshPath crumpled(low, moved(low, 0.6, {0, 0, 0}, source));
    for (StartContact start : kStarts) {
      const auto found = find_contacts_in_step(a, b, {.start = start});
      expect_all(found, all_contacts(a, b, start, false), first_contact(a, b, {.start = start}));
      const auto own = find_self_contacts_in_step(crumpled, {.start = start});
      expect_all(own, all_contacts(crumpled, crumpled, start, true),
                 first_self_contact(crumpled, {.start = start}));
      contacts += found.size() + own.size();
    }
  }
  EXPECT_GT(contacts, 200u);
}

// A mesh beside a copy of its own path is two meshes in one place.
TEST(Law12Meshes, TwoHandlesToOnePathAreTwoMeshes) {
  RandomSource source(45);
  const Mesh rest = sheet(2, 0, 0.1, source);
  const MeshPath path(rest, rest), copy = path;
  const auto found = first_contact(path, copy);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_at_start);
  EXPECT_EQ(found->pair, (TrianglePair{0, 0}));
}

TEST(Law12Meshes, PathsBetweenOtherTrianglesAreRefused) {
  RandomSource source(46);
  const Mesh small = sheet(2, 0, 0, source), large = sheet(3, 0, 0, source);
  EXPECT_THROW(MeshPath(small, large), MeshError);
  std::vector<TriangleIndices> turned(small.triangles().begin(), small.triangles().end());
  EXPECT_NO_THROW(MeshPath(small, Mesh(small.vertices(), turned)));
  std::swap(turned[3][0], turned[3][1]);
  try {
    const MeshPath path(small, Mesh(small.vertices(), turned));
    FAIL();
  } catch (const MeshError& error) {
    EXPECT_STREQ(error.what(), "path: triangle 3 is another one at the end");
    EXPECT_EQ(error.place().index, 3u);
  }
  turned.pop_back();
  EXPECT_THROW(MeshPath(small, Mesh(small.vertices(), turned)), MeshError);
  const MeshPath path(small, small);
  EXPECT_THROW(first_contact(path, path, {.start = static_cast<StartContact>(9)}), InputError);
  EXPECT_THROW(first_self_contact(path, {.start = static_cast<StartContact>(9)}), InputError);
  EXPECT_THROW(find_contacts_in_step(path, path, {.start = static_cast<StartContact>(9)}),
               InputError);
  EXPECT_THROW(find_self_contacts_in_step(path, {.start = static_cast<StartContact>(9)}),
               InputError);
}

}  // namespace
}  // namespace graze
