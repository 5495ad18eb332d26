#include <graze/engine/world/contacts/contact_regions.h>
#include <graze/engine/world/contacts/sides/corner_ways.h>

#include <algorithm>
#include <limits>

namespace graze {

using narrowphase::Core;
using narrowphase::Exit;
using narrowphase::Vec3;

namespace {

// So many points bound the depths at all corners, and at one; what would need more is not found.
constexpr std::size_t kMostKept = 24;
constexpr std::size_t kMostAtCorner = 32;

// So many points on all sides of a corner are taken first.
constexpr std::size_t kFirst = 8;

}  // namespace

CornerWays::Scratch& CornerWays::scratch() {
  static thread_local Scratch kept;  // no pair is looked at within another
  return kept;
}

CornerWays::CornerWays(const Core& core, const PlacedMeshView& mesh, const Vec3& origin,
                       const FacingFeatures& features, double allowance)
    : core_(core),
      placing_(placing_of(mesh, origin)),
      features_(features),
      allowance_(allowance),
      s_(scratch()) {
  s_.seen.clear(), s_.points.clear(), s_.found.clear();
}

void CornerWays::see(std::uint32_t triangle, const Vec3& deepest) {
  s_.seen.push_back({triangle, deepest});
  if (s_.points.size() == kMostKept) return;
  const bool is_known = std::any_of(s_.points.begin(), s_.points.end(), [&](const Vec3& point) {
    return largest(point - deepest) == 0;
  });
  if (!is_known) s_.points.push_back(deepest);
}

void CornerWays::begin() {
  if (s_.asked.size() < placing_.vertices.size()) s_.asked.resize(placing_.vertices.size(), 0);
  if (++s_.call != 0) return;
  std::fill(s_.asked.begin(), s_.asked.end(), 0);
  s_.call = 1;
}

std::optional<LocalParting> CornerWays::shortest(double limit) {
  begin();
  for (const SeenTriangle& seen : s_.seen) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = features_.vertex(seen.triangle, k);
      if (s_.asked[vertex] == s_.call) continue;
      s_.asked[vertex] = s_.call;
      const Corner corner{seen.triangle, k, vertex, placed_vertex(placing_, vertex)};
      if (is_too_far(corner, seen.deepest, limit) || !go_round(corner)) continue;
      limit = search(corner, limit);
    }
  }
  if (s_.found.empty()) return std::nullopt;
  // Of ways that are equally long the order of the triangles must not decide.
  return parting_of(
      *std::min_element(s_.found.begin(), s_.found.end(), [](const Way& s, const Way& t) {
        return s.exit.depth != t.exit.depth ? s.exit.depth < t.exit.depth : s.vertex < t.vertex;
      }));
}

LocalParting CornerWays::parting_of(const Way& way) const {
  const std::span<const std::uint32_t> fan = features_.fan(way.vertex);
  const auto is_solid = [&](std::uint32_t index) {
    return !FacingFeatures::is_sliver(features_.placed_triangle(index));
  };
  const std::uint32_t index = *std::find_if(fan.begin(), fan.end(), is_solid);
  int k = 0;
  while (features_.vertex(index, k) != way.vertex)
    ++k;
  return {index, way.exit, LeftFeature::Corner, k};
}

/// True if bounds that cost little show that no way past the corner is below the limit, or if the
/// corner does not face the sum of its triangles' normals. A direction that it faces is a sum of
/// these normals, in shares of 1 or more together: a point of the body moves along it no less than
/// to the nearest of their planes.
bool CornerWays::is_too_far(const Corner& corner, const Vec3& deepest, double limit) const {
  if (length(corner.at - core_.at) - core_.bounding_radius >= limit) return true;
  s_.normals.clear();
  Vec3 sum;
  for (const std::uint32_t index : features_.fan(corner.vertex)) {
    const Core triangle = core_of(placed_corners(placing_, index));
    if (FacingFeatures::is_sliver(triangle)) continue;
    s_.normals.push_back(LocalPartings::normal_of(triangle));
    sum = sum + s_.normals.back();
  }
  // The normal that showed that a point is too near is asked first about the next one.
  std::size_t first = 0;
  const auto is_below_all = [&](const Vec3& point) {
    const Vec3 offset = corner.at - point;
    for (std::size_t i = 0; i < s_.normals.size(); ++i) {
      const std::size_t at =
          first + i < s_.normals.size() ? first + i : first + i - s_.normals.size();
      if (dot(s_.normals[at], offset) < limit) {
        first = at;
        return false;
      }
    }
    return true;
  };
  if (is_below_all(deepest) || std::any_of(s_.points.begin(), s_.points.end(), is_below_all))
    return true;
  return !features_.corner_faces(corner.triangle, corner.k, unit_or(sum, {0, 0, 1}));
}

/// Takes the normals around the corner in their order, those that are equal once. False if it has
/// fewer than three, or if its triangles do not go round it once.
bool CornerWays::go_round(const Corner& corner) const {
  const std::size_t count = features_.fan(corner.vertex).size();
  s_.normals.clear();
  std::uint32_t index = corner.triangle;
  for (std::size_t step = 1; step <= count; ++step) {
    const Core triangle = features_.placed_triangle(index);
    if (!FacingFeatures::is_sliver(triangle)) {
      const Vec3 normal = LocalPartings::normal_of(triangle);
      if (s_.normals.empty() || !is_one_direction(normal, s_.normals.back()))
        s_.normals.push_back(normal);
    }
    int k = 0;
    while (features_.vertex(index, k) != corner.vertex)
      ++k;
    const std::optional<std::uint32_t> next = features_.across(index, (k + 2) % 3);
    if (!next) return false;
    index = *next;
    if (index == corner.triangle) return step == count && s_.normals.size() > 2;
  }
  return false;
}

/// Finds the exits past the corner below the limit, and returns what they lower it to. Once the
/// bound is exact where it is least along the border of the directions that the corner faces, it
/// has a least within them if the depth itself has one that is less than all along the border. A
/// least that a few points on all sides show spares most of the border.
double CornerWays::search(const Corner& corner, double limit) {
  s_.offsets.clear();
  const std::size_t count = s_.normals.size(), few = std::min(count, kFirst);
  for (std::size_t i = 0; i < few; ++i) {
    const Vec3& normal = s_.normals[i * count / few];
    if (bound(normal) < limit) settled_depth(corner, normal);
  }
  limit = search_within(corner, 0, limit);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t first = s_.offsets.size();
    settle_arc(corner, i, limit);
    limit = search_within(corner, first, limit);
  }
  return limit;
}

/// Looks at the triples of points that the bound is made of, of those from `first` on and all
/// before, and of those that are found on the way.
double CornerWays::search_within(const Corner& corner, std::size_t first, double limit) {
  for (std::size_t k = std::max<std::size_t>(first, 2); k < s_.offsets.size(); ++k) {
    for (std::size_t j = 1; j < k; ++j) {
      for (std::size_t i = 0; i < j; ++i) {
        if (is_full()) return limit;
        const std::optional<Exit> exit = exit_at(corner, {i, j, k}, limit);
        if (!exit) continue;
        s_.found.push_back({corner.vertex, *exit});
        limit = std::min(limit, exit->depth + allowance_);
      }
    }
  }
  return limit;
}

/// Makes the bound exact where it is least along the arc between two successive normals, unless it
/// is not below the limit.
void CornerWays::settle_arc(const Corner& corner, std::size_t first, double limit) {
  const Vec3 from = s_.normals[first], to = s_.normals[(first + 1) % s_.normals.size()];
  while (!is_full()) {
    Vec3 least = from;
    double depth = bound(from);
    const auto offer = [&](const Vec3& direction) {
      const double other = bound(direction);
      if (other < depth) depth = other, least = direction;
    };
    offer(to);
    // Between the ends it is least where two of the points are equally deep.
    for (std::size_t j = 1; j < s_.offsets.size(); ++j) {
      for (std::size_t i = 0; i < j; ++i) {
        const Vec3 apart = s_.offsets[j] - s_.offsets[i];
        const double at_from = dot(from, apart), at_to = dot(to, apart);
        if (at_from * at_to < 0)
          offer(unit_or(from * std::abs(at_to) + to * std::abs(at_from), from));
      }
    }
    if (!(depth < limit) || settled_depth(corner, least)) return;
  }
}

/// Returns the exit along the normal of the plane through three points, if it leads past the
/// corner, which the body then touches between them. Takes another point if that is deeper.
std::optional<Exit> CornerWays::exit_at(const Corner& corner, const std::size_t (&of)[3],
                                        double limit) {
  const Vec3 at[3] = {s_.offsets[of[0]], s_.offsets[of[1]], s_.offsets[of[2]]};
  const Vec3 across = unit_or(cross(at[1] - at[0], at[2] - at[0]), {0, 0, 0});
  const double height = dot(across, at[0]);
  if (!(std::abs(height) < limit)) return std::nullopt;
  const Vec3 direction = height < 0 ? -across : across;
  for (int i = 0; i < 3; ++i) {
    const Vec3 along = at[(i + 1) % 3] - at[i];
    const Vec3 inward = cross(across, along);
    if (dot(inward, across * height - at[i]) < -allowance_ * length(along)) return std::nullopt;
  }
  if (bound(direction) > std::abs(height) + allowance_) return std::nullopt;
  if (!features_.corner_faces(corner.triangle, corner.k, direction)) return std::nullopt;
  const std::optional<double> depth = settled_depth(corner, direction);
  if (!depth || !(*depth > 0)) return std::nullopt;
  return Exit{direction, *depth};
}

/// Returns the depth that the points at the corner show.
double CornerWays::bound(const Vec3& direction) const {
  double depth = -std::numeric_limits<double>::infinity();
  for (const Vec3& offset : s_.offsets)
    depth = std::max(depth, dot(direction, offset));
  return depth;
}

/// Returns the depth along a direction if the bound is exact there; else takes a point that raises
/// the bound: one that is known, if there is one.
std::optional<double> CornerWays::settled_depth(const Corner& corner, const Vec3& direction) {
  double most = bound(direction) + allowance_;
  const Vec3* deeper = nullptr;
  for (const Vec3& point : s_.points) {
    const double depth = dot(direction, corner.at - point);
    if (depth > most) most = depth, deeper = &point;
  }
  if (deeper != nullptr) {
    s_.offsets.push_back(corner.at - *deeper);
    return std::nullopt;
  }
  const Vec3 last = support(core_, -direction);
  const double depth = dot(direction, corner.at - last);
  if (!(depth > most)) return depth;
  if (s_.points.size() < kMostKept) s_.points.push_back(last);
  s_.offsets.push_back(corner.at - last);
  return std::nullopt;
}

bool CornerWays::is_full() const {
  return s_.offsets.size() >= kMostAtCorner;
}

}  // namespace graze
