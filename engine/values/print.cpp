#include <graze/print.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <iterator>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace graze {
namespace {

constexpr std::size_t kMostElements = 16;

/// Text that grows. What the stream has set changes nothing in it.
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

/// Writes a list as write_list() does, and says if a limit may have cut it.
template <typename List>
std::ostream& write_limited(std::ostream& out, const List& list, const char* of) {
  write_list(out, list, of);
  return list.completeness == Completeness::LimitReached ? out << Text(" (limit reached)") : out;
}

struct Counter {
  const char* name;
  std::uint64_t count;
};

/// Writes the counters that are not 0.
template <std::size_t N>
Text text_of(const Counter (&counters)[N]) {
  Text text;
  for (const auto& [name, count] : counters) {
    if (count == 0) continue;
    text.add(text.str().empty() ? "" : ", "), text.add(count), text.add(" "), text.add(name);
  }
  return text;
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
std::ostream& operator<<(std::ostream& out, const WorldBodyPair& pair) {
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
std::ostream& operator<<(std::ostream& out, const VoxelGrid& grid) {
  return out << Text("grid of ", grid.counts[0], " x ", grid.counts[1], " x ", grid.counts[2],
                     " voxels of ", grid.edge, " from ", grid.origin);
}
std::ostream& operator<<(std::ostream& out, const RigidMotion& motion) {
  return out << Text("from pose ", to_text(motion.start()), " by ", motion.shift(), " and ",
                     motion.angle(), " rad about ", motion.axis(), " through ", motion.centre());
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
std::ostream& operator<<(std::ostream& out, const TriangleIntersection& common) {
  static constexpr const char* kNames[] = {"nothing", "point", "segment", "polygon"};
  Text text(kNames[static_cast<int>(common.kind)]);
  for (const Eigen::Vector3d& corner : common)
    text.add(" "), text.add(corner);
  return out << text;
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
std::ostream& operator<<(std::ostream& out, const SeparatingTranslation& separation) {
  return out << Text("apart after ", separation.distance, " along ", separation.direction);
}
std::ostream& operator<<(std::ostream& out, const VolumeFit& fit) {
  Text text(name_of(fit.type), " of ", fit.volume, " m^3 and ", fit.surface, " m^2");
  if (fit.empty_share) text.add(", empty share "), text.add(*fit.empty_share);
  if (fit.relative_volume) text.add(", relative volume "), text.add(*fit.relative_volume);
  return out << text;
}
std::ostream& operator<<(std::ostream& out, const MeshFit& fit) {
  out << (fit.enclosed_volume ? Text("encloses ", *fit.enclosed_volume, " m^3") : Text("open"));
  for (const VolumeFit& volume : fit.volumes)
    out << Text("; ") << volume;
  return out;
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
std::ostream& operator<<(std::ostream& out, const ShapeSeparation& apart) {
  return out << Text("separation ", apart.distance, " from ", apart.point_a, " to ", apart.point_b,
                     ", normal ", apart.normal,
                     apart.status == PairStatus::Converged ? "" : ", not converged");
}
std::ostream& operator<<(std::ostream& out, const ShapeContact& contact) {
  return out << Text("[depth ", contact.depth, ", normal ", contact.normal, ", from ",
                     contact.point_a, " to ", contact.point_b, ", features ")
             << contact.feature << Text("]");
}
std::ostream& operator<<(std::ostream& out, const Manifold& manifold) {
  return write_list(out, manifold, "contacts");
}
/// Writes two bodies, and their parts if one has a number other than 0.
template <typename Pair>
static std::ostream& write_pair(std::ostream& out, const Pair& pair, std::uint32_t part_a,
                                std::uint32_t part_b) {
  out << pair << Text(": ");
  if (part_a != 0 || part_b != 0) out << Text("parts ", part_a, " and ", part_b, ", ");
  return out;
}
std::ostream& operator<<(std::ostream& out, const BodyContact& contact) {
  const Manifold& manifold = contact.manifold;
  return write_pair(out, contact.pair, manifold.part_a(), manifold.part_b()) << manifold;
}
std::ostream& operator<<(std::ostream& out, const BodyPairDistance& found) {
  return write_pair(out, WorldBodyPair{found.a, found.b}, found.part_a, found.part_b)
         << found.distance;
}
std::ostream& operator<<(std::ostream& out, const BodyFirstContact& found) {
  return write_pair(out, found.pair, found.part_a, found.part_b)
         << found.contact
         << Text(found.is_at_start ? ", touching at the start" : "", ", point ", found.point,
                 ", normal ", found.normal);
}
/// Writes a body, and its part if that has a number other than 0.
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

std::ostream& operator<<(std::ostream& out, const Topology& topology) {
  return out << Text(topology.is_closed ? "closed" : "open", ", ", topology.welded_vertices,
                     " vertices, ", topology.components, " components, ", topology.boundary_edges,
                     " boundary edges, ", topology.degenerate_triangles, " degenerate and ",
                     topology.duplicate_triangles, " duplicate triangles");
}
std::ostream& operator<<(std::ostream& out, const MeshIntersection& common) {
  return out << Text(common.curves.size(), " curves, ", common.patches.size(), " patches, ",
                     common.touching_points.size(), " touching points: ", common.points.size(),
                     " points, ", common.segments.size(), " segments and ", common.polygons.size(),
                     " polygons of ", common.pairs.size(), " pairs");
}
std::ostream& operator<<(std::ostream& out, const Voxels& voxels) {
  return out << Text(std::uint64_t{voxels.size()}, " voxels of a ") << voxels.grid;
}
std::ostream& operator<<(std::ostream& out, const FreedomCertificate& certificate) {
  return out << Text("proof of ", certificate.steps.size(), " steps that ",
                     certificate.order_a.size(), " and ", certificate.order_b.size(),
                     " triangles stay further apart than ", certificate.clearance);
}
std::ostream& operator<<(std::ostream& out, const WorldUpdate& update) {
  return out << Text(update.begun.size(), " begun, ", update.ended.size(), " ended, ",
                     update.moved.size(), " moved, ", update.contacts.size(), " contacts, ",
                     update.begun_near.size(), " begun near, ", update.ended_near.size(),
                     " ended near, ", update.first_contacts.size(), " first contacts");
}

std::ostream& operator<<(std::ostream& out, const Work& work) {
  const Counter counters[] = {
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
  const Text text = text_of(counters);
  return out << (text.str().empty() ? Text("no work") : text);
}
std::ostream& operator<<(std::ostream& out, const WorldWork& work) {
  const Counter counters[] = {
      {"pairs filtered", work.pairs_filtered},
      {"pairs at rest", work.pairs_at_rest},
      {"pairs asleep", work.pairs_asleep},
      {"pairs apart", work.pairs_apart},
      {"shape tests", work.shape_tests},
      {"gaps measured", work.gaps_measured},
      {"pairs near", work.pairs_near},
      {"contacts found", work.contacts_found},
      {"contacts skipped", work.contacts_skipped},
      {"islands merged", work.islands_merged},
      {"islands split", work.islands_split},
      {"island steps", work.island_steps},
      {"pairs swept", work.pairs_swept},
      {"trees unbuilt", work.trees_unbuilt},
  };
  static_assert(sizeof(counters) / sizeof(counters[0]) ==
                (sizeof(WorldWork) - sizeof(Work)) / sizeof(std::uint64_t));
  const Text text = text_of(counters);
  if (text.str().empty()) return out << work.shapes;
  return work.shapes == Work{} ? out << text : out << text << Text(", ") << work.shapes;
}

}  // namespace graze
