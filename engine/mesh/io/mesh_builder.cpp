#include <graze/engine/mesh/io/mesh_builder.h>
#include <algorithm>
#include <string>
#include <utility>

namespace graze::mesh_io {
namespace {

constexpr std::uint64_t kMaxVertices = 0x7fffffff;

}  // namespace

void MeshBuilder::add_corner(std::int64_t index, Place place) {
  const std::uint64_t total = std::min(rules_.total.value_or(kMaxVertices), kMaxVertices);
  if (index < rules_.first || std::cmp_greater_equal(index - rules_.first, total)) {
    fail_out_of_range(index, place, rules_.total.value_or(vertex_count()));
  }
  corners_.push_back(static_cast<std::uint32_t>(index - rules_.first));
}

void MeshBuilder::end_polygon(Place place) {
  if (corners_.size() < 3) {
    fail(source_, place,
         "a polygon needs at least 3 corners, this has " + std::to_string(corners_.size()));
  }
  const std::size_t first = arrays_.triangles.size();
  const std::size_t count = corners_.size() - 2;
  arrays_.triangles.resize(first + count);
  if (settings_.has_places) arrays_.places.resize(first + count, place);
  if (*std::max_element(corners_.begin(), corners_.end()) >= vertex_count()) {
    waiting_.push_back({waiting_corners_.size(), corners_.size(), first, place});
    waiting_corners_.insert(waiting_corners_.end(), corners_.begin(), corners_.end());
    return;
  }
  triangulator_.triangulate(arrays_.vertices, corners_,
                            std::span(arrays_.triangles).subspan(first, count));
}

MeshArrays MeshBuilder::finish() {
  for (const Waiting& polygon : waiting_) {
    check_waiting(polygon);
    triangulator_.triangulate(
        arrays_.vertices,
        std::span(waiting_corners_).subspan(polygon.first_corner, polygon.corner_count),
        std::span(arrays_.triangles).subspan(polygon.first_triangle, polygon.corner_count - 2));
  }
  return std::move(arrays_);
}

void MeshBuilder::check_waiting(const Waiting& polygon) const {
  for (std::size_t i = 0; i < polygon.corner_count; ++i) {
    const std::uint32_t corner = waiting_corners_[polygon.first_corner + i];
    if (corner >= vertex_count()) {
      fail_out_of_range(corner + rules_.first, polygon.place, vertex_count());
    }
  }
}

void MeshBuilder::fail_out_of_range(std::int64_t index, Place place, std::uint64_t total) const {
  fail(source_, place,
       "index " + std::to_string(index) + " is out of range, there are " + std::to_string(total) +
           " vertices counted from " + std::to_string(rules_.first));
}

}  // namespace graze::mesh_io
