#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/bvh/value/element_error.h>
#include <graze/narrowphase/volumes/boxes/batch_sizes.h>
#include <graze/narrowphase/volumes/sphere_batch.h>
#include <graze/narrowphase/volumes/sphere_box.h>
#include <graze/narrowphase/volumes/sphere_overlap.h>
#include <graze/narrowphase/volumes/spheres/array_elements.h>
#include <graze/narrowphase/volumes/spheres/sphere_distance.h>
#include <graze/narrowphase/volumes/spheres/sphere_kernels.h>
#include <graze/narrowphase/volumes/spheres/sphere_stages.h>
#include <algorithm>
#include <string>

namespace graze {
namespace {

using narrowphase::BoxRows;
using narrowphase::SphereRows;

SphereRows rows(const SphereArray& spheres) {
  return {spheres.x.data(), spheres.y.data(), spheres.z.data(), spheres.radius.data()};
}

SphereRows rows(const Sphere& sphere) {
  const double* centre = sphere.centre.data();
  return {centre, centre + 1, centre + 2, &sphere.radius};
}

BoxRows rows(const AabbArray& boxes) {
  return {boxes.min[0].data(), boxes.min[1].data(), boxes.min[2].data(),
          boxes.max[0].data(), boxes.max[1].data(), boxes.max[2].data()};
}

BoxRows rows(const Aabb& box) {
  const double* min = box.min.data();
  const double* max = box.max.data();
  return {min, min + 1, min + 2, max, max + 1, max + 2};
}

std::string name_of(const char* array, std::size_t index) {
  return std::string(array) + "[" + std::to_string(index) + "]";
}

Sphere checked(const SphereArray& spheres, std::size_t index, const char* name) {
  Sphere sphere = narrowphase::element(spheres, index);
  bvh::at_element(name, index, [&] { bvh::check_sphere(sphere, name_of(name, index).c_str()); });
  return sphere;
}

Aabb checked(const AabbArray& boxes, std::size_t index, const char* name) {
  Aabb box = narrowphase::element(boxes, index);
  bvh::at_element(name, index, [&] { bvh::check_box(box, name_of(name, index).c_str()); });
  return box;
}

/// Asks `overlap` about each pair that the kernel left unsure, in order: so that the first bad
/// element is named, for every bad one is unsure. The kernel's rounded stage is that of decide():
/// for what it leaves unsure only the exact stage is left.
template <typename Overlap>
void decide_unsure(std::span<std::uint8_t> hits, const Overlap& overlap) {
  auto unsure = hits.begin();
  while ((unsure = std::find(unsure, hits.end(), narrowphase::kUnsure)) != hits.end()) {
    *unsure = overlap(static_cast<std::size_t>(unsure - hits.begin()));
    ++unsure;
  }
}

}  // namespace

void intersects(const Sphere& sphere, const SphereArray& spheres, std::span<std::uint8_t> hits) {
  bvh::in_standard_arithmetic([&] {
    bvh::check_sphere(sphere, "sphere");
    narrowphase::check_lengths(spheres, "spheres");
    narrowphase::check_hits(hits, spheres.size());
    narrowphase::judge_one_sphere(rows(sphere), rows(spheres), hits.size(), hits.data());
    decide_unsure(hits, [&](std::size_t i) {
      return narrowphase::overlap_exactly(sphere, checked(spheres, i, "spheres"));
    });
  });
}

void intersects(const SphereArray& spheres_a, const SphereArray& spheres_b,
                std::span<std::uint8_t> hits) {
  bvh::in_standard_arithmetic([&] {
    narrowphase::check_lengths(spheres_a, "spheres a");
    narrowphase::check_lengths(spheres_b, "spheres b");
    narrowphase::check_pairs(spheres_a.size(), spheres_b.size(), "spheres");
    narrowphase::check_hits(hits, spheres_a.size());
    narrowphase::judge_sphere_pairs(rows(spheres_a), rows(spheres_b), hits.size(), hits.data());
    decide_unsure(hits, [&](std::size_t i) {
      const Sphere a = checked(spheres_a, i, "spheres a");
      return narrowphase::overlap_exactly(a, checked(spheres_b, i, "spheres b"));
    });
  });
}

void intersects(const Sphere& sphere, const AabbArray& boxes, std::span<std::uint8_t> hits) {
  bvh::in_standard_arithmetic([&] {
    bvh::check_sphere(sphere, "sphere");
    narrowphase::check_lengths(boxes, "boxes");
    narrowphase::check_hits(hits, boxes.size());
    narrowphase::judge_sphere_and_boxes(rows(sphere), rows(boxes), hits.size(), hits.data());
    decide_unsure(hits, [&](std::size_t i) {
      return narrowphase::overlap_exactly(sphere, checked(boxes, i, "boxes"));
    });
  });
}

void intersects(const Aabb& box, const SphereArray& spheres, std::span<std::uint8_t> hits) {
  bvh::in_standard_arithmetic([&] {
    bvh::check_box(box, "box");
    narrowphase::check_lengths(spheres, "spheres");
    narrowphase::check_hits(hits, spheres.size());
    narrowphase::judge_box_and_spheres(rows(box), rows(spheres), hits.size(), hits.data());
    decide_unsure(hits, [&](std::size_t i) {
      return narrowphase::overlap_exactly(checked(spheres, i, "spheres"), box);
    });
  });
}

void intersects(const SphereArray& spheres, const AabbArray& boxes, std::span<std::uint8_t> hits) {
  bvh::in_standard_arithmetic([&] {
    narrowphase::check_lengths(spheres, "spheres");
    narrowphase::check_lengths(boxes, "boxes");
    if (spheres.size() != boxes.size()) {
      throw InputError("boxes: " + std::to_string(boxes.size()) + " elements for " +
                       std::to_string(spheres.size()) + " spheres");
    }
    narrowphase::check_hits(hits, spheres.size());
    narrowphase::judge_sphere_box_pairs(rows(spheres), rows(boxes), hits.size(), hits.data());
    decide_unsure(hits, [&](std::size_t i) {
      const Sphere sphere = checked(spheres, i, "spheres");
      return narrowphase::overlap_exactly(sphere, checked(boxes, i, "boxes"));
    });
  });
}

}  // namespace graze
