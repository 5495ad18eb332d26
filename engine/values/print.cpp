#include <graze/print.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <iterator>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace graze {
namespace {

constexpr std::size_t kMostElements = 16;

/// Text that grows: nothing of it goes by what the stream has set.
class Text {
 public:
  template <typename... Parts>
  explicit Text(const Parts&... parts) {
    (add(parts), ...);
  }

  void add(std::string_view text) { text_ += text; }
  void add(double number) {
    char digits[32];
    text_.append(digits, std::to_chars(digits, std::end(digits), number).ptr);
  }
  void add(std::uint64_t number) { text_ += std::to_string(number); }
  void add(std::uint32_t number) { add(std::uint64_t{number}); }
  void add(const Eigen::Vector3d& point) {
    const double* p = point.data();
    add("("), add(p[0]), add(", "), add(p[1]), add(", "), add(p[2]), add(")");
  }

  const std::string& str() const { return text_; }

 private:
  std::string text_;
};

std::ostream& operator<<(std::ostream& out, const Text& text) {
  return out << text.str();
}

template <typename List>
std::ostream& write_list(std::ostream& out, const List& list, const char* of) {
  out << Text(std::uint64_t{list.size()}, " ", of, list.empty() ? "" : ":");
  const std::size_t shown = std::min(list.size(), kMostElements);
  auto element = list.begin();
  for (std::size_t i = 0; i < shown; ++i, ++element)
    out << Text(" ") << *element;
  if (shown < list.size()) out << Text(" and ", std::uint64_t{list.size() - shown}, " more");
  return out;
}

/// As write_list(), of one that a limit may have cut.
template <typename List>
std::ostream& write_limited(std::ostream& out, const List& list, const char* of) {
  write_list(out, list, of);
  return list.completeness == Completeness::LimitReached ? out << Text(" (limit reached)") : out;
}

/// A number as an element of a list.
struct Number {
  std::uint32_t value;
};

std::ostream& operator<<(std::ostream& out, const Number& number) {
  return out << Text(number.value);
}

}  // namespace

std::string to_text(const Pose& pose) {
  Text text;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 4; ++k)
      text.add(i + k == 0 ? "" : " "), text.add(pose.matrix()(i, k));
  }
  return text.str();
}

std::ostream& operator<<(std::ostream& out, const BodyId& id) {
  return out << Text("body ", id.index, ".", id.generation);
}
std::ostream& operator<<(std::ostream& out, const BoxId& id) {
  return out << Text("box ", id.index, ".", id.generation);
}
std::ostream& operator<<(std::ostream& out, const BodyPair& pair) {
  return out << pair.a << Text(" and ") << pair.b;
}
std::ostream& operator<<(std::ostream& out, const BoxPair& pair) {
  return out << Text(pair.a, "-", pair.b);
}
std::ostream& operator<<(std::ostream& out, const TrianglePair& pair) {
  return out << Text(pair.a, "-", pair.b);
}
std::ostream& operator<<(std::ostream& out, const ContactFeature& feature) {
  return out << Text(feature.a, "-", feature.b);
}
std::ostream& operator<<(std::ostream& out, const Voxel& voxel) {
  return out << Text("(", std::uint32_t{voxel.i}, ", ", std::uint32_t{voxel.j}, ", ",
                     std::uint32_t{voxel.k}, ")");
}

std::ostream& operator<<(std::ostream& out, const Aabb& box) {
  return out << Text("box from ", box.min, " to ", box.max);
}
std::ostream& operator<<(std::ostream& out, const Obb& box) {
  return out << Text("box of half extents ", box.half_extents, " in pose ", to_text(box.pose));
}
std::ostream& operator<<(std::ostream& out, const Sphere& sphere) {
  return out << Text("ball around ", sphere.centre, " of radius ", sphere.radius);
}
std::ostream& operator<<(std::ostream& out, const KDop<18>& kdop) {
  Text text("18-DOP");
  for (std::size_t i = 0; i < kdop.min.size(); ++i)
    text.add(" ["), text.add(kdop.min[i]), text.add(", "), text.add(kdop.max[i]), text.add("]");
  return out << text;
}
std::ostream& operator<<(std::ostream& out, const Ray& ray) {
  return out << Text("ray from ", ray.origin, " along ", ray.direction, " for ", ray.max_distance);
}
std::ostream& operator<<(std::ostream& out, const Triangle& triangle) {
  return out << Text("triangle ", triangle.a, " ", triangle.b, " ", triangle.c);
}

std::ostream& operator<<(std::ostream& out, const TrianglePairs& pairs) {
  return write_limited(out, pairs, "pairs");
}
std::ostream& operator<<(std::ostream& out, const TriangleList& list) {
  std::vector<Number> numbers;
  for (const std::uint32_t triangle : list)
    numbers.push_back({triangle});
  write_list(out, numbers, "triangles");
  return list.completeness == Completeness::LimitReached ? out << Text(" (limit reached)") : out;
}
std::ostream& operator<<(std::ostream& out, const TriangleDistance& gap) {
  return out << Text("distance ", gap.distance, " from ", gap.point_a, " to ", gap.point_b);
}
std::ostream& operator<<(std::ostream& out, const TriangleRayHit& hit) {
  return out << Text("hit at ", hit.distance, ", point ", hit.point, ", normal ", hit.normal);
}
std::ostream& operator<<(std::ostream& out, const FirstContact& contact) {
  return out << Text("contact at time ", contact.time)
             << (contact.is_at_start ? ", from the start" : "");
}
std::ostream& operator<<(std::ostream& out, const MeshFirstContact& contact) {
  return out << FirstContact{contact.time, contact.is_at_start} << Text(", triangles ")
             << contact.pair;
}
std::ostream& operator<<(std::ostream& out, const MeshCast& cast) {
  return out << FirstContact{cast.time, cast.is_at_start} << Text(", triangles ") << cast.pair
             << Text(", point ", cast.point, ", normal ", cast.normal);
}
std::ostream& operator<<(std::ostream& out, const VolumeCast& cast) {
  return out << FirstContact{cast.time, cast.is_at_start}
             << Text(", triangle ", cast.triangle, ", point ", cast.point, ", normal ",
                     cast.normal);
}
std::ostream& operator<<(std::ostream& out, const ShapeCast& cast) {
  return out << FirstContact{cast.time, cast.is_at_start}
             << Text(", point ", cast.point, ", normal ", cast.normal);
}
std::ostream& operator<<(std::ostream& out, const RigidContact& contact) {
  if (contact.status == RigidStatus::Free) return out << "free";
  if (contact.status == RigidStatus::Hit)
    return out << Text("free up to ", contact.low, ", hit at ", contact.high);
  return out << Text("free up to ", contact.low)
             << (contact.is_out_of_budget ? ", out of budget" : ", then close");
}
std::ostream& operator<<(std::ostream& out, const MeshDistance& gap) {
  return out << Text("distance ", gap.distance, " from ", gap.point_a, " to ", gap.point_b,
                     ", triangles ")
             << gap.pair;
}
std::ostream& operator<<(std::ostream& out, const NearestPoint& nearest) {
  return out << Text("distance ", nearest.distance, " to ", nearest.point, " in triangle ",
                     nearest.triangle);
}
std::ostream& operator<<(std::ostream& out, const MeshHealth& health) {
  return out << Text(health.open_edges.size(), " open, ", health.non_manifold_edges.size(),
                     " non-manifold and ", health.turned_edges.size(), " turned edges, ",
                     health.degenerate_triangles.size(), " degenerate and ",
                     health.duplicate_triangles.size(), " duplicate triangles, ",
                     health.inside_out_parts.size(), " parts inside out, ",
                     health.self_intersections.size(), " self-intersections");
}
std::ostream& operator<<(std::ostream& out, const MeshContact& contact) {
  return out << Text("[depth ", contact.depth, ", normal ", contact.normal, ", from ",
                     contact.point_a, " to ", contact.point_b, "]");
}
std::ostream& operator<<(std::ostream& out, const MeshContacts& contacts) {
  return write_limited(out, contacts, "contacts");
}
std::ostream& operator<<(std::ostream& out, const Separation& separation) {
  return out << Text("apart after ", separation.distance, " along ", separation.direction);
}
std::ostream& operator<<(std::ostream& out, const RayHit& hit) {
  out << Text("hit at ", hit.distance, ", point ", hit.point, ", normal ", hit.normal);
  return hit.triangle == kNoTriangle ? out : out << Text(", triangle ", hit.triangle);
}
std::ostream& operator<<(std::ostream& out, const ShapeDistance& gap) {
  return out << Text("distance ", gap.distance, " from ", gap.point_a, " to ", gap.point_b,
                     ", normal ", gap.normal, ", at least ", gap.lower_bound,
                     gap.status == PairStatus::Converged ? "" : ", not converged");
}
std::ostream& operator<<(std::ostream& out, const ShapeContact& contact) {
  return out << Text("[depth ", contact.depth, ", normal ", contact.normal, ", from ",
                     contact.point_a, " to ", contact.point_b, ", features ")
             << contact.feature << Text("]");
}
std::ostream& operator<<(std::ostream& out, const Manifold& manifold) {
  return write_list(out, manifold, "contacts");
}
std::ostream& operator<<(std::ostream& out, const BodyContact& contact) {
  out << contact.pair << Text(": ");
  const Manifold& manifold = contact.manifold;
  if (manifold.part_a() != 0 || manifold.part_b() != 0)
    out << Text("parts ", manifold.part_a(), " and ", manifold.part_b(), ", ");
  return out << manifold;
}
/// A body, and its part if that has a number other than 0.
static std::ostream& write_found(std::ostream& out, const BodyId& id, std::uint32_t part) {
  out << id;
  if (part != 0) out << Text(", part ", part);
  return out << Text(": ");
}
std::ostream& operator<<(std::ostream& out, const BodyDistance& found) {
  return write_found(out, found.id, found.part) << found.distance;
}
std::ostream& operator<<(std::ostream& out, const BodyRayHit& found) {
  return write_found(out, found.id, found.part) << found.hit;
}
std::ostream& operator<<(std::ostream& out, const BodyCast& found) {
  return write_found(out, found.id, found.part) << found.contact;
}

std::ostream& operator<<(std::ostream& out, const Work& work) {
  const std::pair<const char*, std::uint64_t> counters[] = {
      {"volume tests", work.volume_tests},
      {"volume rejections", work.volume_rejections},
      {"filter tests", work.filter_tests},
      {"triangle tests", work.triangle_tests},
      {"exact tests", work.exact_tests},
      {"points tested", work.points_tested},
      {"skipped by memory", work.skipped_by_memory},
      {"trees built", work.trees_built},
      {"treelets built", work.treelets_built},
      {"trees refitted", work.trees_refitted},
      {"treelets refitted", work.treelets_refitted},
      {"triangles rebuilt", work.triangles_rebuilt},
      {"skins built", work.skins_built},
      {"convex tests", work.convex_tests},
      {"convex failures", work.convex_failures},
      {"penetration tests", work.penetration_tests},
      {"penetration failures", work.penetration_failures},
  };
  static_assert(sizeof(counters) / sizeof(counters[0]) == sizeof(Work) / sizeof(std::uint64_t));
  Text text;
  for (const auto& [name, count] : counters) {
    if (count == 0) continue;
    text.add(text.str().empty() ? "" : ", "), text.add(count), text.add(" "), text.add(name);
  }
  return out << (text.str().empty() ? Text("no work") : text);
}

}  // namespace graze
