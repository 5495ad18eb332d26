#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/traverse/traverse_pair.h>
#include <graze/bvh/traverse/traverse_self.h>
#include <graze/engine/mesh/motion/feature_contacts.h>
#include <graze/engine/mesh/motion/near_nodes.h>
#include <graze/engine/mesh/placing/relative_frame.h>
#include <graze/engine/mesh/query/node_volumes.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/narrowphase/motion/path_checks.h>

#include <algorithm>

namespace graze {

namespace {

/// Tells `contacts` of all pairs of triangles whose boxes meet, or are near.
template <typename Separation>
void ask_meshes(const MeshPathAccess::Data& a, const MeshPathAccess::Data& b,
                const Separation& separation, FeatureContacts& contacts, Work& work) {
  bvh::traverse_pair(a.tree, b.tree, CountedSeparation(separation, work),
                     [&](const bvh::Node& leaf_a, const bvh::Node& leaf_b) {
                       for (std::uint32_t i = leaf_a.first; i < leaf_a.first + leaf_a.count; ++i) {
                         for (std::uint32_t k = leaf_b.first; k < leaf_b.first + leaf_b.count;
                              ++k) {
                           ++work.triangle_tests;
                           contacts.ask(a, b, {a.tree.primitives[i], b.tree.primitives[k]});
                         }
                       }
                       return bvh::Walk::Continue;
                     });
}

template <typename Separation>
void ask_mesh(const MeshPathAccess::Data& mesh, const Separation& separation,
              FeatureContacts& contacts, Work& work) {
  bvh::traverse_self(mesh.tree, CountedSeparation(separation, work),
                     [&](const bvh::Node& leaf_a, const bvh::Node& leaf_b) {
                       const bool is_same = &leaf_a == &leaf_b;
                       for (std::uint32_t i = leaf_a.first; i < leaf_a.first + leaf_a.count; ++i) {
                         for (std::uint32_t k = is_same ? i + 1 : leaf_b.first;
                              k < leaf_b.first + leaf_b.count; ++k) {
                           ++work.triangle_tests;
                           const auto [low, high] =
                               std::minmax(mesh.tree.primitives[i], mesh.tree.primitives[k]);
                           contacts.ask_of_one_mesh(mesh, {low, high});
                         }
                       }
                       return bvh::Walk::Continue;
                     });
}

FeatureContacts contacts_of_meshes(const MeshPath& path_a, const MeshPath& path_b,
                                   const FirstContactSettings& settings, KeptContacts kept,
                                   Work* work) {
  narrowphase::check_settings(settings);
  CountedWork counted(work);
  FeatureContacts contacts(settings, kept);
  const MeshPathAccess::Data& a = MeshPathAccess::data(path_a);
  const MeshPathAccess::Data& b = MeshPathAccess::data(path_b);
  if (settings.clearance > 0) {
    ask_meshes(a, b, NearNodes(a.tree, b.tree, settings.clearance), contacts, counted.work());
    return contacts;
  }
  const Pose identity = Pose::Identity();
  const bvh::RelativeFrame frame = relative_frame(PlacedFrame(identity, 0, a.tree.frame, a.bounds),
                                                  PlacedFrame(identity, 0, b.tree.frame, b.bounds));
  ask_meshes(a, b, bvh::NodeSeparation(frame, a.tree.nodes, b.tree.nodes), contacts,
             counted.work());
  return contacts;
}

FeatureContacts contacts_of_mesh(const MeshPath& path, const FirstContactSettings& settings,
                                 KeptContacts kept, Work* work) {
  narrowphase::check_settings(settings);
  CountedWork counted(work);
  FeatureContacts contacts(settings, kept);
  const MeshPathAccess::Data& mesh = MeshPathAccess::data(path);
  if (settings.clearance > 0) {
    ask_mesh(mesh, NearNodes(mesh.tree, mesh.tree, settings.clearance), contacts, counted.work());
  } else {
    ask_mesh(mesh, bvh::NodeOverlap(mesh.tree.nodes, mesh.tree.nodes), contacts, counted.work());
  }
  return contacts;
}

}  // namespace

std::optional<MeshFirstContact> first_contact(const MeshPath& path_a, const MeshPath& path_b,
                                              const FirstContactSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::optional<MeshFirstContact> {
    return contacts_of_meshes(path_a, path_b, settings, KeptContacts::Earliest, work).first();
  });
}

std::optional<MeshFirstContact> first_self_contact(const MeshPath& path,
                                                   const FirstContactSettings& settings,
                                                   Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::optional<MeshFirstContact> {
    return contacts_of_mesh(path, settings, KeptContacts::Earliest, work).first();
  });
}

std::vector<MeshFirstContact> find_contacts_in_step(const MeshPath& path_a, const MeshPath& path_b,
                                                    const FirstContactSettings& settings,
                                                    Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<MeshFirstContact> {
    return contacts_of_meshes(path_a, path_b, settings, KeptContacts::All, work).take_all();
  });
}

std::vector<MeshFirstContact> find_self_contacts_in_step(const MeshPath& path,
                                                         const FirstContactSettings& settings,
                                                         Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<MeshFirstContact> {
    return contacts_of_mesh(path, settings, KeptContacts::All, work).take_all();
  });
}

}  // namespace graze
