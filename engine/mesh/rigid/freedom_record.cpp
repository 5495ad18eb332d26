#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/rigid/contact_walk.h>
#include <graze/engine/mesh/rigid/freedom_record.h>
#include <graze/engine/mesh/rigid/motion_query.h>

namespace graze {

std::vector<std::uint32_t> FreedomRecord::sizes_of(const bvh::Tree& tree) {
  // Children stand behind their parents.
  std::vector<std::uint32_t> sizes(tree.nodes.size());
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const bvh::Node& node = tree.nodes[i];
    sizes[i] = node.is_leaf() ? node.count : sizes[node.first] + sizes[node.first + 1];
  }
  return sizes;
}

std::vector<std::uint32_t> FreedomRecord::order_of(const bvh::Tree& tree) {
  std::vector<std::uint32_t> order, open{0};
  order.reserve(tree.primitives.size());
  while (!open.empty()) {
    const bvh::Node& node = tree.nodes[open.back()];
    open.pop_back();
    if (!node.is_leaf()) {
      open.push_back(node.first + 1);
      open.push_back(node.first);
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
      order.push_back(tree.primitives[i]);
  }
  return order;
}

std::optional<FreedomCertificate> certify_free(const MeshInMotion& mesh_a,
                                               const MeshInMotion& mesh_b,
                                               const RigidContactSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::optional<FreedomCertificate> {
    CountedWork counted(work);
    MotionQuery query(mesh_a, mesh_b, settings, counted.work());
    FreedomRecord record(query.a.tree, query.b.tree);
    ContactWalk walk = query.walk(ContactWalk::End::AtAny);
    walk.record_in(record);
    if (walk.run() != query.pair.grid().end()) return std::nullopt;
    return record.take(settings.clearance);
  });
}

}  // namespace graze
