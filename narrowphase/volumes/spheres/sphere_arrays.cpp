#include <graze/bvh/error.h>
#include <graze/narrowphase/volumes/sphere_arrays.h>
#include <graze/narrowphase/volumes/spheres/array_elements.h>
#include <string>

namespace graze::narrowphase {
namespace {

void check_length(std::span<const double> array, const char* name, std::size_t expected,
                  const char* what) {
  if (array.size() == expected) return;
  throw InputError(std::string(what) + ": array " + name + " has " + std::to_string(array.size()) +
                   " elements, the first " + std::to_string(expected));
}

}  // namespace

void check_lengths(const SphereArray& spheres, const char* what) {
  check_length(spheres.y, "y", spheres.size(), what);
  check_length(spheres.z, "z", spheres.size(), what);
  check_length(spheres.radius, "radius", spheres.size(), what);
}

void check_lengths(const AabbArray& boxes, const char* what) {
  const char* min_names[] = {"min x", "min y", "min z"};
  const char* max_names[] = {"max x", "max y", "max z"};
  for (std::size_t i = 0; i < 3; ++i) {
    check_length(boxes.min[i], min_names[i], boxes.size(), what);
    check_length(boxes.max[i], max_names[i], boxes.size(), what);
  }
}

Sphere element(const SphereArray& spheres, std::size_t index) {
  return {{spheres.x[index], spheres.y[index], spheres.z[index]}, spheres.radius[index]};
}

Aabb element(const AabbArray& boxes, std::size_t index) {
  return {{boxes.min[0][index], boxes.min[1][index], boxes.min[2][index]},
          {boxes.max[0][index], boxes.max[1][index], boxes.max[2][index]}};
}

}  // namespace graze::narrowphase
