#include <graze/bvh/error.h>
#include <graze/bvh/traverse_pair.h>
#include <graze/engine/mesh/contacts/last_contact.h>
#include <graze/engine/mesh/contacts/swept_nodes.h>
#include <graze/engine/mesh/contacts/swept_triangles.h>
#include <graze/engine/mesh/placement.h>

#include <algorithm>
#include <cmath>

namespace graze::contacts {
namespace {

/// Prunes what cannot meet later than the latest contact found so far.
class LaterContact {
 public:
  LaterContact(const SweptNodes& nodes, const bvh::Tree& tree_a, const bvh::Tree& tree_b,
               const double& latest, Work& work)
      : nodes_(nodes), tree_a_(tree_a), tree_b_(tree_b), latest_(latest), work_(work) {}

  bool are_apart(std::uint32_t a, std::uint32_t b) const {
    ++work_.volume_tests;
    const bool is_pruned =
        nodes_.last_contact(tree_a_.nodes[a].box, tree_b_.nodes[b].box) <= latest_;
    work_.volume_rejections += is_pruned;
    return is_pruned;
  }
  bool is_first_larger(std::uint32_t a, std::uint32_t b) const {
    return nodes_.is_first_larger(tree_a_.nodes[a].box, tree_b_.nodes[b].box);
  }

 private:
  const SweptNodes& nodes_;
  const bvh::Tree& tree_a_;
  const bvh::Tree& tree_b_;
  const double& latest_;
  Work& work_;
};

}  // namespace

Eigen::Vector3d unit_direction(const Eigen::Vector3d& direction) {
  const double* d = direction.data();
  const double largest = std::max(std::abs(d[0]), std::max(std::abs(d[1]), std::abs(d[2])));
  if (!std::isfinite(d[0]) || !std::isfinite(d[1]) || !std::isfinite(d[2])) {
    throw InputError("direction: a component is not finite");
  }
  if (largest == 0) throw InputError("direction: it is zero");
  const int exponent = -std::ilogb(largest);
  const double x = std::scalbn(d[0], exponent);
  const double y = std::scalbn(d[1], exponent);
  const double z = std::scalbn(d[2], exponent);
  const double length = std::sqrt((x * x + y * y) + z * z);
  return {x / length, y / length, z / length};
}

double last_contact(const PlacedMesh& a, const PlacedMesh& b, const Eigen::Vector3d& direction,
                    double limit, Work& work) {
  const bvh::Tree& tree_a = a.mesh.tree(&work);
  const bvh::Tree& tree_b = b.mesh.tree(&work);
  const SweepUnits units(a, b);
  const double d[3] = {direction.data()[0], direction.data()[1], direction.data()[2]};
  const SweptNodes nodes(a, b, units, d);
  double latest = 0;
  const double wanted = limit * units.per_metre;
  const auto sweep_leaves = [&](const bvh::Node& leaf_a, const bvh::Node& leaf_b) {
    for (std::uint32_t i = leaf_a.first; i < leaf_a.first + leaf_a.count; ++i) {
      const SweptTriangle swept_a(place(a.pose, a.mesh.triangle(tree_a.primitives[i])),
                                  units.per_metre);
      for (std::uint32_t j = leaf_b.first; j < leaf_b.first + leaf_b.count; ++j) {
        const SweptTriangle swept_b(place(b.pose, b.mesh.triangle(tree_b.primitives[j])),
                                    units.per_metre);
        ++work.triangle_tests;
        latest = std::max(latest, last_contact(swept_a, swept_b, d, latest));
      }
    }
    return latest < wanted ? bvh::Walk::Continue : bvh::Walk::Stop;
  };
  bvh::traverse_pair(tree_a, tree_b, LaterContact(nodes, tree_a, tree_b, latest, work),
                     sweep_leaves);
  return latest * units.metres;
}

}  // namespace graze::contacts
