// This file holds three methods for the squared distance of a centre from a box. They compute the
// same rounded differences, one for each axis: centre and nearest point of the box are both inputs.
// So one bound covers all, and one exact stage.

#include <graze/narrowphase/volumes/sphere_box.h>
#include <graze/narrowphase/volumes/spheres/sphere_distance.h>
#include <graze/narrowphase/volumes/spheres/sphere_stages.h>
#include <cmath>

namespace graze::narrowphase {

bool overlap_exactly(const Sphere& sphere, const Aabb& box) {
  const double* centre = sphere.centre.data();
  const auto nearest = nearest_point(box, centre);
  return sign_of_distance_exact(centre, nearest.data(), sphere.radius) != Sign::Positive;
}

namespace {

Decision decide_by_offset(const double* offset, const Sphere& sphere, const Aabb& box) {
  const std::optional<Sign> sure = sign_of_offset(offset, sphere.radius);
  if (sure) return {*sure == Sign::Negative, Stage::Triage};
  return {overlap_exactly(sphere, box), Stage::Exact};
}

}  // namespace

Decision decide_arvo(const Sphere& sphere, const Aabb& box) {
  double offset[3];
  for (int i = 0; i < 3; ++i) {
    const double c = sphere.centre.data()[i];
    const double low = box.min.data()[i];
    const double high = box.max.data()[i];
    offset[i] = 0;
    if (c < low) {
      offset[i] = c - low;
    } else if (c > high) {
      offset[i] = c - high;
    }
  }
  return decide_by_offset(offset, sphere, box);
}

// A rejection needs no bound: rounding is monotone and the radius a double, so that a rounded
// difference exceeds it only if the exact one does.
Decision decide_quick_rejections(const Sphere& sphere, const Aabb& box) {
  const double r = sphere.radius;
  double offset[3] = {0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    const double below = sphere.centre.data()[i] - box.min.data()[i];
    if (below < 0) {
      if (below < -r) return {false, Stage::Triage};
      offset[i] = below;
      continue;
    }
    const double above = sphere.centre.data()[i] - box.max.data()[i];
    if (above > 0) {
      if (above > r) return {false, Stage::Triage};
      offset[i] = above;
    }
  }
  return decide_by_offset(offset, sphere, box);
}

namespace {

/// Returns max(x, 0), exact or infinite, which is then unsure, in a form that no compiler turns
/// into a branch.
double positive_part(double x) {
  return 0.5 * (x + std::abs(x));
}

}  // namespace

Decision decide_branch_free(const Sphere& sphere, const Aabb& box) {
  double offset[3];
  for (int i = 0; i < 3; ++i) {
    const double c = sphere.centre.data()[i];
    offset[i] = positive_part(box.min.data()[i] - c) + positive_part(c - box.max.data()[i]);
  }
  return decide_by_offset(offset, sphere, box);
}

}  // namespace graze::narrowphase
