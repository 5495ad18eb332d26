#include <graze/engine/mesh/data/mesh_patch.h>
#include <graze/engine/world/fields/field_data.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shapes/field_heights.h>
#include <graze/engine/world/shapes/half_space_pair.h>
#include <graze/engine/world/shapes/mesh_heights.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace graze {

using narrowphase::Core;
using narrowphase::Vec3;

namespace {

/// True if the middle of the shape's extent along the normal is above the plane, or on it: then its
/// way upwards is the shorter one, and if it is apart it is above.
bool is_mostly_above(const Core& core, const PlacedHalfSpace& plane) {
  const double low = dot(plane.normal, rounded_support(core, -plane.normal)) - plane.offset;
  const double high = dot(plane.normal, rounded_support(core, plane.normal)) - plane.offset;
  return low + high >= 0;
}

bool has_holes(const HeightFieldData& field) {
  return std::any_of(field.tiles.begin(), field.tiles.end(),
                     [](const auto& tile) { return !tile->holes.empty(); });
}

/// Returns the triangles on one side of the plane, of a mesh without triangles that cross it.
Shape piece_of(const Mesh& mesh, const std::vector<bool>& is_above, bool above) {
  MeshPatch patch;
  patch.bounds = mesh.bounds();
  const MeshNumbers numbers = numbers_of(mesh);
  const auto count = static_cast<std::uint32_t>(mesh.vertices().size());
  std::vector<std::uint32_t> index_of(count, count);
  std::vector<bool> is_used(count, false);
  for (const TriangleIndices& triangle : mesh.triangles()) {
    if (is_above[triangle[0]] != above) continue;
    for (const std::uint32_t corner : triangle)
      is_used[corner] = true;
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!is_used[i]) continue;
    index_of[i] = static_cast<std::uint32_t>(patch.vertices.size());
    patch.vertices.push_back(mesh.vertices()[i]);
    patch.vertex_numbers.push_back(numbers.vertex(i));
  }
  for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
    const TriangleIndices& triangle = mesh.triangles()[i];
    if (is_above[triangle[0]] != above) continue;
    patch.triangles.push_back(
        {index_of[triangle[0]], index_of[triangle[1]], index_of[triangle[2]]});
    patch.triangle_numbers.push_back(numbers.triangle(i));
  }
  return mesh_of(std::move(patch));
}

}  // namespace

HalfSpace front_of(const graze::Plane& plane) {
  return {plane.normal, plane.offset};
}

HalfSpace back_of(const graze::Plane& plane) {
  return {-plane.normal, -plane.offset};
}

HalfSpacePair::HalfSpacePair(const PlacedShapeView& a, const PlacedShapeView& b, Work& work)
    : a_{a}, b_{b} {
  if (is_plane(a)) choose(a_, b_, work);
  if (is_plane(b)) choose(b_, a_, work);
}

// Two flat shapes may be apart only if their normals are opposite, and then only for one of all
// ways to choose half-spaces.
void HalfSpacePair::choose(Side& plane, Side& other, Work& work) {
  const graze::Plane& as_plane = *plane.own.shape.as<graze::Plane>();
  const Shape front = front_of(as_plane), back = back_of(as_plane);
  const Pose& pose = plane.own.pose;
  const PlacedShapeView by = other.view(0);
  const auto is_apart = [&](const Shape& side) { return !intersects({side, pose}, by, &work); };
  switch (by.shape.kind()) {
    case ShapeKind::HalfSpace:
    case ShapeKind::Plane:
      plane.by[0] = !is_apart(front) && is_apart(back) ? back : front;
      return;
    case ShapeKind::Mesh:
      return choose_beside_mesh(plane, other, *by.shape.as<Mesh>(), front, back, work);
    case ShapeKind::HeightField:
      return choose_beside_field(plane, other, front, back, work);
    default: {
      const Eigen::Vector3d origin = middle_of(by.shape, by.pose);
      const Core core = core_of(by.shape, by.pose, origin);
      const bool is_above =
          is_mostly_above(core, placed_half_space(*front.as<HalfSpace>(), pose, origin));
      plane.by[0] = is_above ? front : back;
    }
  }
}

void HalfSpacePair::choose_beside_field(Side& plane, Side& other, const Shape& front,
                                        const Shape& back, Work& work) {
  const Pose& pose = plane.own.pose;
  const PlacedShapeView& by = other.own;
  const bool is_above = !intersects({front, pose}, by, &work);
  const bool is_below = !is_above && !intersects({back, pose}, by, &work);
  plane.by[0] = is_below ? back : front;
  if (is_above || is_below) return;
  const HeightFieldData& field = HeightFieldAccess::data(*by.shape.as<HeightField>());
  if (has_holes(field)) {
    choose_beside_mesh(plane, other, by.shape.as<HeightField>()->mesh(), front, back, work);
    return;
  }
  const Eigen::Vector3d origin = middle_of(by.shape, by.pose);
  const auto lowest = [&](const Shape& side) {
    return lowest_of(field, by.pose, placed_half_space(*side.as<HalfSpace>(), pose, origin)).height;
  };
  if (lowest(front) < lowest(back)) plane.by[0] = back;
}

void HalfSpacePair::choose_beside_mesh(Side& plane, Side& other, const Mesh& mesh,
                                       const Shape& front, const Shape& back, Work& work) {
  const PlacedMeshView placed{mesh, other.own.pose};
  const double* m = placed.pose.data();
  const Eigen::Vector3d origin(m[12], m[13], m[14]);  // the origin, as for a mesh and a half-space
  const auto flat = [&](const Shape& side) {
    return placed_half_space(*side.as<HalfSpace>(), plane.own.pose, origin);
  };
  const PlacedHalfSpace below = flat(front), above = flat(back);
  const double never = -std::numeric_limits<double>::infinity();
  const MeshHeights heights(placed, below, origin, work);
  const Height low = heights.lowest(never);
  const Height high = MeshHeights(placed, above, origin, work).lowest(never);
  plane.by[0] = low.height >= high.height ? front : back;
  const bool reaches_both = !(low.height - low.slack > 0) && !(high.height - high.slack > 0);
  if (!reaches_both || heights.find_crossed()) return;
  is_divided_ = true;
  std::vector<bool> is_above(mesh.vertices().size());
  for (std::uint32_t i = 0; i < is_above.size(); ++i)
    is_above[i] = heights.of_vertex(i) > 0;
  plane.by = {front, back};
  other.by = {piece_of(mesh, is_above, true), piece_of(mesh, is_above, false)};
}

namespace {

/// Returns the point at which the segment from one point to the other crosses the plane, or is
/// nearest to it.
Vec3 crossing(const Vec3& low, const Vec3& high, const PlacedHalfSpace& plane) {
  const double below = dot(plane.normal, low) - plane.offset;
  const double above = dot(plane.normal, high) - plane.offset;
  if (!(above > below)) return low;
  return low + (high - low) * std::clamp(-below / (above - below), 0.0, 1.0);
}

Vec3 crossing_of_mesh(const PlacedMeshView& mesh, const PlacedHalfSpace& plane,
                      const Eigen::Vector3d& origin, Work& work) {
  const MeshHeights heights(mesh, plane, origin, work);
  const std::uint32_t triangle = heights.find_crossed().value_or(0);
  TriangleIndices corners = mesh.mesh.triangles()[triangle];
  std::sort(corners.begin(), corners.end(), [&](std::uint32_t s, std::uint32_t t) {
    return heights.of_vertex(s) < heights.of_vertex(t);
  });
  const auto placed = [&](std::uint32_t index) {
    return to_vec3(narrowphase::place(mesh.pose, mesh.mesh.vertices()[index])) - to_vec3(origin);
  };
  return crossing(placed(corners[0]), placed(corners[2]), plane);
}

/// Returns a point of a field without holes on the plane: it is found along edges from the lowest
/// vertex to the highest.
Vec3 crossing_of_field(const HeightFieldData& field, const Pose& pose, const PlacedHalfSpace& plane,
                       const Eigen::Vector3d& origin) {
  const FieldVertex low = lowest_of(field, pose, plane);
  const FieldVertex high = lowest_of(field, pose, {-plane.normal, -plane.offset, plane.slack});
  const auto next = [](std::uint32_t at, std::uint32_t end) { return at < end ? at + 1 : at - 1; };
  const auto placed = [&](std::uint32_t column, std::uint32_t row) {
    return to_vec3(narrowphase::place(pose, field.vertex(column, row))) - to_vec3(origin);
  };
  std::uint32_t column = low.column, row = low.row;
  Vec3 last = placed(column, row);
  while (column != high.column || row != high.row) {
    (column != high.column ? column : row) =
        column != high.column ? next(column, high.column) : next(row, high.row);
    const Vec3 here = placed(column, row);
    if (height_of(field, pose, plane, column, row) >= 0) return crossing(last, here, plane);
    last = here;
  }
  return last;
}

/// Returns a point of two flat shapes on the plane: the known point is on both planes, unless they
/// are parallel.
Vec3 crossing_of_flat(const Vec3& known, const PlacedHalfSpace& plane) {
  return known - plane.normal * (dot(plane.normal, known) - plane.offset);
}

}  // namespace

Eigen::Vector3d point_in_plane(const PlacedShapeView& a, const PlacedShapeView& b,
                               const Eigen::Vector3d& known, Work& work) {
  const PlacedShapeView& own = is_plane(a) ? a : b;
  const PlacedShapeView& other = is_plane(a) ? b : a;
  const Eigen::Vector3d origin = middle_of(other.shape, other.pose);
  const PlacedHalfSpace plane =
      placed_half_space(front_of(*own.shape.as<graze::Plane>()), own.pose, origin);
  const auto in_world = [&](const Vec3& point) { return to_eigen(point + to_vec3(origin)); };
  if (const auto* mesh = other.shape.as<Mesh>())
    return in_world(crossing_of_mesh({*mesh, other.pose}, plane, origin, work));
  if (const auto* field = other.shape.as<HeightField>()) {
    const HeightFieldData& data = HeightFieldAccess::data(*field);
    if (has_holes(data))
      return in_world(crossing_of_mesh({field->mesh(), other.pose}, plane, origin, work));
    return in_world(crossing_of_field(data, other.pose, plane, origin));
  }
  if (!is_convex_core(other.shape.kind()))
    return in_world(crossing_of_flat(to_vec3(known) - to_vec3(origin), plane));
  const Core core = core_of(other.shape, other.pose, origin);
  return in_world(
      crossing(rounded_support(core, -plane.normal), rounded_support(core, plane.normal), plane));
}

}  // namespace graze
