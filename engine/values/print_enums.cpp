#include <graze/engine/values/text.h>
#include <graze/print.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string_view>

namespace graze {
namespace {

/// Writes the name of an enumerator, or the number of what is none.
template <std::size_t N, typename Enum>
std::ostream& write_name(std::ostream& out, Enum value, const std::string_view (&names)[N]) {
  const auto index = static_cast<std::size_t>(value);
  return out << (index < N ? Text(names[index]) : Text("no enumerator: ", std::uint64_t{index}));
}

/// Writes the name of an enumerator as name_of() says it, which refuses what is none.
template <typename Enum, std::size_t N>
std::ostream& write_name_of(std::ostream& out, Enum value, const std::array<Enum, N>& all) {
  if (std::find(all.begin(), all.end(), value) != all.end()) return out << Text(name_of(value));
  return out << Text("no enumerator: ", static_cast<std::uint64_t>(value));
}

}  // namespace

std::ostream& operator<<(std::ostream& out, Touch value) {
  return write_name(out, value, {"including touches", "without touches"});
}
std::ostream& operator<<(std::ostream& out, StartContact value) {
  return write_name(out, value, {"start counts", "start is left"});
}
std::ostream& operator<<(std::ostream& out, IntersectionKind value) {
  return write_name(out, value, {"nothing", "point", "segment", "polygon"});
}
std::ostream& operator<<(std::ostream& out, Feature value) {
  return write_name(out, value, {"vertex", "edge", "face"});
}
std::ostream& operator<<(std::ostream& out, Hit value) {
  return write_name(out, value, {"touching", "crossing", "solid"});
}
std::ostream& operator<<(std::ostream& out, Interior value) {
  return write_name(out, value, {"surface", "solid"});
}
std::ostream& operator<<(std::ostream& out, Completeness value) {
  return write_name(out, value, {"complete", "limit reached"});
}
std::ostream& operator<<(std::ostream& out, SelfPairKind value) {
  return write_name(out, value, {"intersecting", "neighbour"});
}
std::ostream& operator<<(std::ostream& out, VoxelFill value) {
  return write_name(out, value, {"surface", "solid"});
}
std::ostream& operator<<(std::ostream& out, PreparedFor value) {
  return write_name(out, value, {"pairs", "all"});
}
std::ostream& operator<<(std::ostream& out, MeetingFeatures value) {
  return write_name(out, value,
                    {"vertex and face", "face and vertex", "edge and edge", "at the start"});
}
std::ostream& operator<<(std::ostream& out, RigidStatus value) {
  return write_name(out, value, {"free", "hit", "close"});
}
std::ostream& operator<<(std::ostream& out, FreedomStep::Kind value) {
  return write_name(out, value, {"plane", "halve time", "divide A", "divide B"});
}
std::ostream& operator<<(std::ostream& out, Sides value) {
  return write_name(out, value, {"surface", "solid", "one-sided"});
}
std::ostream& operator<<(std::ostream& out, BodyKind value) {
  return write_name(out, value, {"static", "kinematic", "dynamic"});
}
std::ostream& operator<<(std::ostream& out, Detection value) {
  return write_name(out, value, {"discrete", "continuous"});
}
std::ostream& operator<<(std::ostream& out, Role value) {
  return write_name(out, value, {"solid", "sensor"});
}
std::ostream& operator<<(std::ostream& out, PairStatus value) {
  return write_name(out, value, {"converged", "not converged"});
}
std::ostream& operator<<(std::ostream& out, PairMethod value) {
  return write_name(
      out, value,
      {"exact spheres", "exact sphere and box", "axes of boxes", "closed form", "cores", "plane",
       "planes", "mesh and plane", "mesh and volume", "mesh and core", "meshes"});
}
std::ostream& operator<<(std::ostream& out, Drawn value) {
  return write_name(out, value, {"shape", "box", "contact", "island"});
}
std::ostream& operator<<(std::ostream& out, Volume value) {
  return write_name_of(out, value, kVolumes);
}
std::ostream& operator<<(std::ostream& out, PairVolume value) {
  return write_name_of(out, value, kPairVolumes);
}
std::ostream& operator<<(std::ostream& out, ShapeKind value) {
  return write_name_of(out, value, kShapeKinds);
}

}  // namespace graze
