#include <graze/bvh/skins/sphere_separation.h>

namespace graze::bvh {

// The slack covers an error in each coordinate by twice its size, so its Euclidean norm as well. It
// is at least 128 u (tau + 16), with |T| = tau and spheres within 2 of it, which leaves room for
// the rounding of this test: a few u of tau + 8. A square that overflows proves nothing unless the
// other one is finite.
bool SphereSeparation::are_apart(std::uint32_t a, std::uint32_t b) const {
  const FloatSphere& sphere_a = skin_a_[a];
  const FloatSphere& sphere_b = skin_b_[b];
  const double(&r)[3][3] = frame_.rotation;
  double square = 0;
  for (int i = 0; i < 3; ++i) {
    const double turned =
        r[i][0] * sphere_b.centre[0] + r[i][1] * sphere_b.centre[1] + r[i][2] * sphere_b.centre[2];
    const double offset =
        (frame_.translation[i] - sphere_a.centre[i] * frame_.units_a) + turned * frame_.units_b;
    square += offset * offset;
  }
  const double radii =
      sphere_a.radius * frame_.units_a + sphere_b.radius * frame_.units_b + frame_.slack;
  return square > radii * radii;
}

bool SphereSeparation::is_first_larger(std::uint32_t a, std::uint32_t b) const {
  return skin_a_[a].radius * frame_.units_a >= skin_b_[b].radius * frame_.units_b;
}

}  // namespace graze::bvh
