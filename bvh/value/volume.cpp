#include <graze/bvh/error.h>
#include <graze/bvh/volume.h>
#include <string>

namespace graze {
namespace {

[[noreturn]] void refuse(int volume) {
  throw InputError("there is no volume " + std::to_string(volume));
}

}  // namespace

const char* name_of(Volume volume) {
  switch (volume) {
    case Volume::Aabb:
      return "aabb";
    case Volume::Sphere:
      return "sphere";
    case Volume::Obb:
      return "obb";
    case Volume::KDop:
      return "kdop";
  }
  refuse(static_cast<int>(volume));
}

const char* name_of(PairVolume volume) {
  const std::optional<Volume> binary = binary_volume(volume);
  return binary ? name_of(*binary) : "wide";
}

std::optional<Volume> binary_volume(PairVolume volume) {
  switch (volume) {
    case PairVolume::WideObb:
      return std::nullopt;
    case PairVolume::Aabb:
      return Volume::Aabb;
    case PairVolume::Sphere:
      return Volume::Sphere;
    case PairVolume::Obb:
      return Volume::Obb;
    case PairVolume::KDop:
      return Volume::KDop;
  }
  refuse(static_cast<int>(volume));
}

}  // namespace graze
