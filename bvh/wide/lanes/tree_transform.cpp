#include <graze/bvh/value/local_frame.h>
#include <graze/bvh/wide/lanes/tree_transform.h>
#include <graze/bvh/wide/tree/wide_bounds.h>

#include <limits>

namespace graze::bvh {

TreeTransform::TreeTransform(const RelativeFrame& frame) {
  const double per_unit = 1 / frame.units_a;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      rotation[i][j] = frame.rotation[i][j];
      columns[j][i] = static_cast<float>(frame.rotation[i][j]);
    }
    columns[i][3] = 0;
    translation[i] = frame.translation[i] * per_unit;
  }
  scale = frame.units_b * per_unit;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      scaled[j][i] = static_cast<float>(rotation[i][j] * scale);
  }
  slack = rounded_up(3 * frame.slack * per_unit + kWideUnderflow);
  if (!(scale <= kLargestScale)) slack = std::numeric_limits<float>::infinity();
}

}  // namespace graze::bvh
