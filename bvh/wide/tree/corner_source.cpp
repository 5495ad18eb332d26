#include <graze/bvh/value/to_local.h>
#include <graze/bvh/wide/tree/corner_source.h>

#include <cmath>

namespace graze::bvh {

References CornerSource::references(const LocalFrame& frame,
                                    std::span<const std::uint32_t> primitives) const {
  const ToLocal to_local(frame);
  const auto box_of = [&](std::size_t index) {
    const Corners& t = primitives_[index];
    return to_local.box(points_[t[0]].data(), points_[t[1]].data(), points_[t[2]].data());
  };
  if (primitives.empty()) return references_made(primitives_.size(), box_of);
  References references(primitives.size());
  for (std::size_t i = 0; i < primitives.size(); ++i)
    references.data[i] = reference_to(box_of(primitives[i]), primitives[i]);
  return references;
}

Bounds CornerSource::bounds(const LocalFrame& frame,
                            std::span<const std::uint32_t> primitives) const {
  PointPairs low = load_point(points_[primitives_[primitives[0]][0]].data());
  PointPairs high = low;
  for (const std::uint32_t primitive : primitives) {
    for (const std::uint32_t vertex : primitives_[primitive]) {
      const PointPairs p = load_point(points_[vertex].data());
      low = smaller(low, p);
      high = larger(high, p);
    }
  }
  const double min[3] = {low.xy[0], low.xy[1], low.yz[1]};
  const double max[3] = {high.xy[0], high.xy[1], high.yz[1]};
  return ToLocal(frame).box(min, max);
}

void CornerSource::fill(std::span<const std::uint32_t> primitives, const LocalFrame& frame,
                        const double (&origin)[3], CornerRows& rows) const {
  const double scale = std::ldexp(1.0, -frame.exponent);
  for (std::size_t c = 0; c < 3; ++c) {
    float* x = rows.row(c, 0);
    float* y = rows.row(c, 1);
    float* z = rows.row(c, 2);
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const double* p = points_[primitives_[primitives[i]][c]].data();
      x[i] = static_cast<float>((p[0] - frame.centre[0]) * scale - origin[0]);
      y[i] = static_cast<float>((p[1] - frame.centre[1]) * scale - origin[1]);
      z[i] = static_cast<float>((p[2] - frame.centre[2]) * scale - origin[2]);
    }
  }
}

}  // namespace graze::bvh
