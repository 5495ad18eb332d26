#include <graze/engine/mesh/motion/feature_contacts.h>
#include <graze/narrowphase/crossing.h>
#include <graze/narrowphase/motion/contact_stages.h>
#include <graze/narrowphase/triangle_pair/crossing_stages.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace graze {
namespace {

PointPath corner_path(const MeshPathAccess::Data& mesh, std::uint32_t vertex) {
  return {mesh.start.vertices()[vertex], mesh.end.vertices()[vertex]};
}

TrianglePath triangle_path(const MeshPathAccess::Data& mesh, const TriangleIndices& t) {
  return {corner_path(mesh, t[0]), corner_path(mesh, t[1]), corner_path(mesh, t[2])};
}

bool has(const TriangleIndices& t, std::uint32_t vertex) {
  return t[0] == vertex || t[1] == vertex || t[2] == vertex;
}

auto order_of(const MeshFirstContact& c) {
  return std::make_tuple(c.time, !c.is_at_start, c.pair, c.features, c.place_a, c.place_b);
}

}  // namespace

void FeatureContacts::ask(const MeshPathAccess::Data& a, const MeshPathAccess::Data& b,
                          TrianglePair pair) {
  ask_pair(a, b, pair, Meshes::Two);
}

void FeatureContacts::ask_of_one_mesh(const MeshPathAccess::Data& mesh, TrianglePair pair) {
  ask_pair(mesh, mesh, pair, Meshes::One);
}

void FeatureContacts::ask_pair(const MeshPathAccess::Data& a, const MeshPathAccess::Data& b,
                               TrianglePair pair, Meshes meshes) {
  const bool is_self = meshes == Meshes::One;
  const TriangleIndices &of_a = a.start.triangles()[pair.a], &of_b = b.start.triangles()[pair.b];
  const std::uint8_t represented_a = a.represented[pair.a], represented_b = b.represented[pair.b];
  const auto are_one = [&](std::uint32_t vertex_a, std::uint32_t vertex_b) {
    return is_self && vertex_a == vertex_b;
  };
  const bool have_common_vertices =
      is_self && (has(of_b, of_a[0]) || has(of_b, of_a[1]) || has(of_b, of_a[2]));
  ask_start(a, b, pair, have_common_vertices);
  const TrianglePath path_a = triangle_path(a, of_a), path_b = triangle_path(b, of_b);
  const PointPath corner_a[3] = {path_a.a, path_a.b, path_a.c};
  const PointPath corner_b[3] = {path_b.a, path_b.b, path_b.c};
  for (std::uint32_t i = 0; i < 3; ++i) {
    if ((represented_a & corner_bit(i)) != 0 && !(is_self && has(of_b, of_a[i])))
      ask_features(corner_a[i], path_b, {0, false, pair, MeetingFeatures::VertexFace, i, 0});
    if ((represented_b & corner_bit(i)) != 0 && !(is_self && has(of_a, of_b[i])))
      ask_features(corner_b[i], path_a, {0, false, pair, MeetingFeatures::FaceVertex, 0, i});
    if ((represented_a & edge_bit(i)) == 0) continue;
    const std::uint32_t from_a = of_a[i], to_a = of_a[(i + 1) % 3];
    const EdgePath edge_a{corner_a[i], corner_a[(i + 1) % 3]};
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t from_b = of_b[k], to_b = of_b[(k + 1) % 3];
      if ((represented_b & edge_bit(k)) == 0 || are_one(from_a, from_b) || are_one(from_a, to_b) ||
          are_one(to_a, from_b) || are_one(to_a, to_b))
        continue;
      const EdgePath edge_b{corner_b[k], corner_b[(k + 1) % 3]};
      ask_features(edge_a, edge_b, {0, false, pair, MeetingFeatures::EdgeEdge, i, k});
    }
  }
}

void FeatureContacts::ask_start(const MeshPathAccess::Data& a, const MeshPathAccess::Data& b,
                                TrianglePair pair, bool have_common_vertices) {
  const Triangle triangle_a = a.start.triangle(pair.a), triangle_b = b.start.triangle(pair.b);
  const bool may_touch = settings_.start == StartContact::IsLeft || have_common_vertices;
  const bool is_hit = may_touch ? crosses(triangle_a, triangle_b)
                                : narrowphase::decide(triangle_a, triangle_b).is_hit;
  if (is_hit) take({0, true, pair, MeetingFeatures::AtStart, 0, 0});
}

template <typename FeatureA, typename FeatureB>
void FeatureContacts::ask_features(const FeatureA& a, const FeatureB& b,
                                   const MeshFirstContact& which) {
  const auto contact = narrowphase::first_contact_of(a, b, settings_, limit());
  if (!contact) return;
  MeshFirstContact found = which;
  found.time = contact->time;
  found.is_at_start = contact->is_at_start;
  take(found);
}

void FeatureContacts::take(const MeshFirstContact& contact) {
  if (kept_ == KeptContacts::All || found_.empty()) {
    found_.push_back(contact);
  } else if (order_of(contact) < order_of(found_.front())) {
    found_.front() = contact;
  }
}

std::vector<MeshFirstContact> FeatureContacts::take_all() {
  const auto place_of = [](const MeshFirstContact& c) {
    return std::make_tuple(c.pair, c.features, c.place_a, c.place_b);
  };
  std::sort(found_.begin(), found_.end(),
            [&](const auto& s, const auto& t) { return place_of(s) < place_of(t); });
  return std::move(found_);
}

}  // namespace graze
