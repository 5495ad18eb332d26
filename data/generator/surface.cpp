#include "data/generator/surface.h"

namespace graze::generator {

std::uint32_t Surface::vertex(const Eigen::Vector3d& position) {
  // Adding zero turns -0 into 0: the two are equal as numbers but differ in a file.
  const Eigen::Vector3d p = position.array() + 0.0;
  const auto next = static_cast<std::uint32_t>(vertices_.size());
  const auto [entry, is_new] = index_of_.try_emplace({p.x(), p.y(), p.z()}, next);
  if (is_new) vertices_.push_back(p);
  return entry->second;
}

void Surface::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (a != b && b != c && c != a) triangles_.push_back({a, b, c});
}

void Surface::quadrangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  triangle(a, b, c);
  triangle(a, c, d);
}

Surface Surface::scaled(double factor) const {
  Surface result;
  result.triangles_ = triangles_;
  for (const Eigen::Vector3d& p : vertices_) {
    const Eigen::Vector3d q = p * factor;
    result.index_of_.try_emplace({q.x(), q.y(), q.z()},
                                 static_cast<std::uint32_t>(result.vertices_.size()));
    result.vertices_.push_back(q);
  }
  return result;
}

}  // namespace graze::generator
