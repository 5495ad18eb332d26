#include <graze/bvh/error.h>
#include <graze/bvh/volume.h>
#include <string>

namespace graze {

const char* name_of(Volume volume) {
  switch (volume) {
    case Volume::Wide:
      return "wide";
    case Volume::Aabb:
      return "aabb";
    case Volume::Sphere:
      return "sphere";
    case Volume::Obb:
      return "obb";
    case Volume::KDop:
      return "kdop";
    case Volume::SphereThenAabb:
      return "sphere-aabb";
    case Volume::SphereThenObb:
      return "sphere-obb";
    case Volume::SphereThenKDop:
      return "sphere-kdop";
  }
  throw InputError("there is no volume " + std::to_string(static_cast<int>(volume)));
}

}  // namespace graze
