#include <graze/bvh/skins/obb_separation.h>
#include <graze/bvh/value/separating_axes.h>

#include <cmath>

namespace graze::bvh {
namespace {

// This is what the axes' rounding to float costs. Write Q_a, Q_b for the rotations that the axes
// stand for and D for the offset of the centres in the frame of A's tree. An entry of M_a^T C M_b
// is off from Q_a^T C Q_b by less than 4 kAxisError (each factor's rows have 1-norms below 1.74),
// one of M_a^T D by 1.74 kAxisError |D|. Boxes that do meet have |D| of at most the sum S of all
// half extents and the slack. So the distance along any of the fifteen axes, a sum of at most three
// products of such an entry and a component of D, is off by less than 3 (4 + 1.74) kAxisError S,
// and the sum of radii, at most four products of an entry and a half extent, by 4 kAxisError S. In
// all below 22 kAxisError S.
constexpr double kAxesError = 32 * FloatObb::kAxisError;

// The slack is derived for boxes along the trees' axes. C is not quite a rotation: its Gram matrix
// seen from a box's own axes deviates by up to three times as much as from the tree's.
constexpr double kSlackFactor = 3;

}  // namespace

bool ObbSeparation::are_apart(std::uint32_t a, std::uint32_t b) const {
  const FloatObb& box_a = skin_a_[a];
  const FloatObb& box_b = skin_b_[b];
  const double(&c)[3][3] = frame_.rotation;
  double between[3];      // the offset from centre to centre in the frame of A's tree
  double turned[3][3];    // [axis of B's box][component in the frame of A's tree]
  double rotation[3][3];  // row-major: B's box in the frame of A's
  double size[3][3], offset[3], half_a[3], half_b[3];
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double centre_b =
        c[i][0] * box_b.centre[0] + c[i][1] * box_b.centre[1] + c[i][2] * box_b.centre[2];
    between[i] =
        (frame_.translation[i] - box_a.centre[i] * frame_.units_a) + centre_b * frame_.units_b;
    half_a[i] = box_a.half[i] * frame_.units_a;
    half_b[i] = box_b.half[i] * frame_.units_b;
    sum += half_a[i] + half_b[i];
    for (int j = 0; j < 3; ++j) {
      const float(&axis)[3] = box_b.axes[j];
      turned[j][i] = c[i][0] * axis[0] + c[i][1] * axis[1] + c[i][2] * axis[2];
    }
  }
  for (int i = 0; i < 3; ++i) {
    const float(&axis)[3] = box_a.axes[i];
    offset[i] = axis[0] * between[0] + axis[1] * between[1] + axis[2] * between[2];
    for (int j = 0; j < 3; ++j) {
      rotation[i][j] = axis[0] * turned[j][0] + axis[1] * turned[j][1] + axis[2] * turned[j][2];
      size[i][j] = std::abs(rotation[i][j]);
    }
  }
  return are_boxes_apart({rotation, size, offset, half_a, half_b},
                         kSlackFactor * frame_.slack + kAxesError * sum);
}

bool ObbSeparation::is_first_larger(std::uint32_t a, std::uint32_t b) const {
  const float(&half_a)[3] = skin_a_[a].half;
  const float(&half_b)[3] = skin_b_[b].half;
  return (half_a[0] + half_a[1] + half_a[2]) * frame_.units_a >=
         (half_b[0] + half_b[1] + half_b[2]) * frame_.units_b;
}

}  // namespace graze::bvh
