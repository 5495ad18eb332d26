#include <graze/bvh/clusters/cluster_pairs.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/traverse/traverse_self.h>
#include <graze/bvh/value/to_local.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/pairs/corner_labels.h>
#include <graze/engine/mesh/pairs/self_pairs.h>
#include <graze/engine/mesh/query/node_volumes.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/self.h>
#include <graze/narrowphase/triangle_pair/adjacent_triangles.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <hwy/cache_control.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>

namespace graze {
namespace {

/// A triangle of a mesh, and the welded vertices that its corners are.
struct WeldedTriangle {
  std::uint32_t index;
  std::uint32_t welded[3];
};

/// The order of the corners of two triangles in which those whose welded vertices they share come
/// first, in the same order.
struct Adjacency {
  std::uint8_t corners_a[3] = {0, 1, 2};
  std::uint8_t corners_b[3] = {0, 1, 2};
  std::uint8_t shared = 0;
};

/// Returns the adjacency for `are_same`, which has bit 3 i + j if corner i of the one is corner j
/// of the other. A vertex that a triangle repeats is shared once.
constexpr Adjacency adjacency_of(unsigned are_same) {
  Adjacency result;
  const auto are_equal = [&](int i, int j) {
    return (are_same >> (3 * result.corners_a[i] + result.corners_b[j]) & 1) != 0;
  };
  for (int i = 0; i < 3; ++i) {
    bool is_repeated = false;
    for (int k = 0; k < result.shared; ++k)
      is_repeated |= are_equal(i, k);
    for (int j = result.shared; j < 3 && !is_repeated; ++j) {
      if (!are_equal(i, j)) continue;
      std::swap(result.corners_a[result.shared], result.corners_a[i]);
      std::swap(result.corners_b[result.shared], result.corners_b[j]);
      ++result.shared;
      break;
    }
  }
  return result;
}

/// The adjacency for each value of `are_same`: to compare and look up takes a third of the time
/// that comparing and branching does.
constexpr auto kAdjacencies = [] {
  std::array<Adjacency, 512> all;
  for (unsigned are_same = 0; are_same < all.size(); ++are_same)
    all[are_same] = adjacency_of(are_same);
  return all;
}();

const Adjacency& adjacency_of(const WeldedTriangle& a, const WeldedTriangle& b) {
  unsigned are_same = 0;
  for (unsigned i = 0; i < 3; ++i) {
    for (unsigned j = 0; j < 3; ++j)
      are_same |= static_cast<unsigned>(a.welded[i] == b.welded[j]) << (3 * i + j);
  }
  return kAdjacencies[are_same];
}

class SelfQuery {
 public:
  SelfQuery(const Mesh& mesh, Work& work)
      : vertices_(mesh.vertices()),
        triangles_(mesh.triangles()),
        welded_(mesh.welded()),
        work_(work) {}

  WeldedTriangle welded(std::uint32_t index) const {
    const TriangleIndices& t = triangles_[index];
    return {index, {welded_[t[0]], welded_[t[1]], welded_[t[2]]}};
  }

  /// Returns how the triangles meet; nothing if they are apart.
  std::optional<SelfPairKind> meet(const WeldedTriangle& a, const WeldedTriangle& b) {
    ++work_.triangle_tests;
    const Adjacency& adjacency = adjacency_of(a, b);
    const Triangle triangle_a = triangle(a.index, adjacency.corners_a);
    const Triangle triangle_b = triangle(b.index, adjacency.corners_b);
    if (adjacency.shared == 0) {
      if (!do_strangers_meet(triangle_a, triangle_b)) return std::nullopt;
      return SelfPairKind::Intersecting;
    }
    ++work_.exact_tests;
    const bool is_intersecting =
        adjacency.shared == 3 ||
        (adjacency.shared == 2 ? narrowphase::intersect_beyond_edge(triangle_a, triangle_b)
                               : narrowphase::intersect_beyond_vertex(triangle_a, triangle_b));
    return is_intersecting ? SelfPairKind::Intersecting : SelfPairKind::Neighbour;
  }

 private:
  Triangle triangle(std::uint32_t index, const std::uint8_t (&corners)[3]) const {
    const TriangleIndices& t = triangles_[index];
    return {vertices_[t[corners[0]]], vertices_[t[corners[1]]], vertices_[t[corners[2]]]};
  }

  bool do_strangers_meet(const Triangle& triangle_a, const Triangle& triangle_b) {
    const narrowphase::Decision decision = narrowphase::decide(triangle_a, triangle_b);
    work_.exact_tests += decision.stage == narrowphase::Stage::Exact;
    return decision.is_hit;
  }

  std::span<const Eigen::Vector3d> vertices_;
  std::span<const TriangleIndices> triangles_;
  std::span<const std::uint32_t> welded_;
  Work& work_;
};

/// Returns the tree's frame in itself. No pose moves the mesh, so that the slack need only cover
/// the rounding of the separations, as in relative_frame().
bvh::RelativeFrame own_frame() {
  return {.rotation = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          .translation = {0, 0, 0},
          .units_a = 1,
          .units_b = 1,
          .slack = 128 * 0x1p-53 * 16};
}

/// Calls `use(separation)` for a tree with itself. Boxes in one frame are compared as they are.
template <typename Use>
void with_own_separation(Volume volume, const NodeVolumes& volumes, Use&& use) {
  if (volume == Volume::Aabb) return use(bvh::NodeOverlap(volumes.nodes, volumes.nodes));
  with_separation(volume, own_frame(), volumes, volumes, use);
}

/// Returns the triangles in clusters, labelled by the vertices around which they surely only meet
/// as neighbours do.
bvh::Clusters clusters_of(const Mesh& mesh, const bvh::Tree& tree) {
  const std::vector<std::array<std::uint32_t, 3>> labels = corner_labels(mesh);
  const bvh::ToLocal to_local(tree.frame);
  const std::span<const Eigen::Vector3d> vertices = mesh.vertices();
  constexpr std::uint32_t kFetched = 16;  // places that are fetched ahead, which takes as long as
                                          // memory does
  return bvh::clusters_of(
      tree,
      [&](std::uint32_t place) {
        const TriangleIndices& t = mesh.triangles()[tree.primitives[place]];
        return float_box(
            to_local.box(vertices[t[0]].data(), vertices[t[1]].data(), vertices[t[2]].data()));
      },
      [&](std::uint32_t place, std::uint32_t(&own)[3]) {
        if (place + kFetched < tree.primitives.size())
          hwy::Prefetch(&labels[tree.primitives[place + kFetched]]);
        std::copy_n(labels[tree.primitives[place]].data(), 3, own);
      });
}

/// Calls `on_pair(pair)`, a < b, for each pair of that kind, until it answers Stop, and
/// `on_cluster(triangle_count)` for each cluster once.
template <typename OnPair, typename OnCluster>
void for_each_self_pair(const Mesh& mesh, const SelfSettings& settings, Work& work,
                        OnPair&& on_pair, OnCluster&& on_cluster) {
  const NodeVolumes volumes = volumes_of(mesh, settings.volume, work);
  const bvh::Tree& tree = tree_of(mesh);
  const bvh::Clusters clusters = clusters_of(mesh, tree);
  SelfQuery query(mesh, work);
  const auto is_of_kind = [&](std::uint32_t a, std::uint32_t b, bool is_sharing) {
    const SelfPairKind sure = SelfPairKind::Neighbour;
    return (is_sharing ? sure : query.meet(query.welded(a), query.welded(b))) == settings.kind;
  };
  const auto test_clusters = [&](std::uint32_t node_a, std::uint32_t node_b) {
    const bvh::Cluster& a = clusters.all[clusters.of_node[node_a]];
    const bvh::Cluster& b = clusters.all[clusters.of_node[node_b]];
    const bool is_same = node_a == node_b;
    if (is_same) on_cluster(a.count);
    work.filter_tests += is_same ? a.count * (a.count - 1) / 2 : a.count * b.count;
    const bvh::ClusterPairs pairs = is_same ? bvh::pairs_within(a) : bvh::pairs_of(a, b);
    std::uint64_t open = pairs.overlapping;
    if (settings.kind == SelfPairKind::Intersecting) open &= ~pairs.sharing;
    for (; open != 0; open &= open - 1) {
      const int bit = std::countr_zero(open);
      const std::uint32_t one = a.primitive[bit / 8], other = b.primitive[bit % 8];
      if (!is_of_kind(one, other, (pairs.sharing >> bit & 1) != 0)) continue;
      const auto [low, high] = std::minmax(one, other);
      if (on_pair(TrianglePair{low, high}) == bvh::Walk::Stop) return bvh::Walk::Stop;
    }
    return bvh::Walk::Continue;
  };
  with_own_separation(settings.volume, volumes, [&](const auto& separation) {
    bvh::traverse_self(
        tree, CountedSeparation(separation, work),
        [&](std::uint32_t node) { return clusters.is_cluster(node); }, test_clusters);
  });
}

template <typename OnPair>
void for_each_self_pair(const Mesh& mesh, const SelfSettings& settings, Work& work,
                        OnPair&& on_pair) {
  for_each_self_pair(mesh, settings, work, on_pair, [](std::uint32_t) {});
}

/// Returns how many pairs of triangles are tested, leaf by leaf, before clusters are made: where
/// many intersect a pair that does is found sooner than that, and where none does this costs a
/// twentieth of the rest.
std::uint64_t tests_alone(const Mesh& mesh) {
  return 512 + mesh.triangles().size() / 8;
}

/// Returns whether any pair intersects, if the first few tests say so. For a small mesh these are
/// all.
std::optional<bool> intersects_at_first(const Mesh& mesh, Volume volume, Work& work) {
  const NodeVolumes volumes = volumes_of(mesh, volume, work);
  const bvh::Tree& tree = tree_of(mesh);
  SelfQuery query(mesh, work);
  const std::uint64_t most_tests = work.triangle_tests + tests_alone(mesh);
  bool is_intersecting = false;
  const auto test_leaves = [&](const bvh::Node& leaf_a, const bvh::Node& leaf_b) {
    const bool is_same = &leaf_a == &leaf_b;
    for (std::uint32_t i = leaf_a.first; i < leaf_a.first + leaf_a.count; ++i) {
      const WeldedTriangle one = query.welded(tree.primitives[i]);
      const std::uint32_t first = is_same ? i + 1 : leaf_b.first;
      for (std::uint32_t j = first; j < leaf_b.first + leaf_b.count; ++j) {
        is_intersecting =
            query.meet(one, query.welded(tree.primitives[j])) == SelfPairKind::Intersecting;
        if (is_intersecting || work.triangle_tests >= most_tests) return bvh::Walk::Stop;
      }
    }
    return bvh::Walk::Continue;
  };
  auto walk = bvh::Walk::Continue;
  with_own_separation(volume, volumes, [&](const auto& separation) {
    walk = bvh::traverse_self(tree, CountedSeparation(separation, work), test_leaves);
  });
  if (walk == bvh::Walk::Stop && !is_intersecting) return std::nullopt;
  return is_intersecting;
}

}  // namespace

void for_each_self_intersection(const Mesh& mesh, Work& work,
                                const std::function<void(TrianglePair)>& on_pair,
                                const std::function<void(std::size_t)>& on_done) {
  std::size_t done = 0;
  for_each_self_pair(
      mesh, {}, work,
      [&](TrianglePair pair) {
        on_pair(pair);
        return bvh::Walk::Continue;
      },
      [&](std::uint32_t count) { on_done(done += count); });
}

bool self_intersects(const Mesh& mesh, Work* work) {
  return self_intersects(mesh, SelfQuerySettings{}, work);
}

bool self_intersects(const Mesh& mesh, const SelfQuerySettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    CountedWork counted(work);
    if (const auto answer = intersects_at_first(mesh, settings.volume, counted.work()))
      return *answer;
    return has_any([&](auto&& on_pair) {
      for_each_self_pair(mesh, {.volume = settings.volume}, counted.work(), on_pair);
    });
  });
}

TrianglePairs find_self_pairs(const Mesh& mesh, const SelfSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> TrianglePairs {
    CountedWork counted(work);
    TrianglePairs found;
    found.completeness = collect(found.pairs, settings.limit, [&](auto&& on_pair) {
      for_each_self_pair(mesh, settings, counted.work(), on_pair);
    });
    return found;
  });
}

}  // namespace graze
