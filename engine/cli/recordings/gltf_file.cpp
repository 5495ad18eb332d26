#include <graze/engine/cli/recordings/gltf_file.h>

#include <graze/bvh/error.h>
#include <graze/engine/version.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace graze::cli {
namespace {

using nlohmann::json;

// These are glTF's numbers for what their names say.
constexpr int kFloat = 5126, kUnsignedInt = 5125;
constexpr int kVertices = 34962, kIndices = 34963;
// These name the chunks of a GLB: "JSON" and "BIN", lowest byte first.
constexpr std::uint32_t kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;

void append_u32(std::uint32_t value, std::string& to) {
  for (int shift = 0; shift < 32; shift += 8)
    to += static_cast<char>(value >> shift & 0xff);
}

Eigen::Quaternionf turn_of(const Pose& pose) {
  return Eigen::Quaterniond(pose.linear()).normalized().cast<float>().normalized();
}

void append_chunk(std::uint32_t kind, std::string content, char filling, std::string& to) {
  content.resize((content.size() + 3) / 4 * 4, filling);
  append_u32(static_cast<std::uint32_t>(content.size()), to);
  append_u32(kind, to);
  to += content;
}

}  // namespace

GltfFile::GltfFile()
    : file_({{"asset",
              {{"version", "2.0"}, {"generator", std::string("graze ") + library_version()}}},
             {"scene", 0}}),
      animation_({{"channels", json::array()}, {"samplers", json::array()}}) {}

json GltfFile::begin(const void* numbers, std::size_t bytes, std::size_t count, int type,
                     const char* shape) {
  const std::size_t at = buffer_.size();
  buffer_.append(static_cast<const char*>(numbers), bytes);
  file_["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", at}, {"byteLength", bytes}});
  return {{"bufferView", file_["bufferViews"].size() - 1},
          {"componentType", type},
          {"count", count},
          {"type", shape}};
}

std::size_t GltfFile::end(json accessor) {
  file_["accessors"].push_back(std::move(accessor));
  return file_["accessors"].size() - 1;
}

/// Says what the view that was begun last is for.
void GltfFile::say_target(int target) {
  file_["bufferViews"].back()["target"] = target;
}

std::size_t GltfFile::add_floats(std::span<const float> numbers, std::size_t width,
                                 bool has_bounds) {
  static constexpr std::array kTypes{"", "SCALAR", "", "VEC3", "VEC4"};
  json accessor =
      begin(numbers.data(), numbers.size_bytes(), numbers.size() / width, kFloat, kTypes[width]);
  for (std::size_t k = 0; has_bounds && k < width; ++k) {
    float least = std::numeric_limits<float>::infinity(), most = -least;
    for (std::size_t i = k; i < numbers.size(); i += width)
      least = std::min(least, numbers[i]), most = std::max(most, numbers[i]);
    accessor["min"].push_back(least);
    accessor["max"].push_back(most);
  }
  return end(std::move(accessor));
}

std::size_t GltfFile::add_material(const Eigen::Vector3f& colour) {
  file_["materials"].push_back({{"doubleSided", true},
                                {"pbrMetallicRoughness",
                                 {{"baseColorFactor", {colour[0], colour[1], colour[2], 1}},
                                  {"metallicFactor", 0.1},
                                  {"roughnessFactor", 0.7}}}});
  return file_["materials"].size() - 1;
}

std::size_t GltfFile::add_mesh(std::span<const Eigen::Vector3d> vertices,
                               std::span<const TriangleIndices> triangles, std::size_t material) {
  std::vector<float> positions;
  for (const Eigen::Vector3d& vertex : vertices)
    for (int k = 0; k < 3; ++k)
      positions.push_back(static_cast<float>(vertex[k]));
  const std::size_t position = add_floats(positions, 3, true);
  say_target(kVertices);
  const std::size_t indices = end(begin(triangles.data(), triangles.size_bytes(),
                                        3 * triangles.size(), kUnsignedInt, "SCALAR"));
  say_target(kIndices);
  const json primitive = {
      {"attributes", {{"POSITION", position}}}, {"indices", indices}, {"material", material}};
  file_["meshes"].push_back({{"primitives", json::array({primitive})}});
  return file_["meshes"].size() - 1;
}

std::size_t GltfFile::add_node(const std::string& name, const Pose& pose,
                               std::optional<std::size_t> mesh,
                               const std::vector<std::size_t>& children) {
  const Eigen::Vector3f at = pose.translation().cast<float>();
  const Eigen::Quaternionf turn = turn_of(pose);
  json node = {{"name", name},
               {"translation", {at.x(), at.y(), at.z()}},
               {"rotation", {turn.x(), turn.y(), turn.z(), turn.w()}}};
  if (mesh) node["mesh"] = *mesh;
  if (!children.empty()) node["children"] = children;
  file_["nodes"].push_back(std::move(node));
  return file_["nodes"].size() - 1;
}

std::size_t GltfFile::add_times(std::span<const float> seconds) {
  return add_floats(seconds, 1, true);
}

void GltfFile::add_channel(std::size_t node, const char* path, std::size_t times,
                           std::size_t values, const char* interpolation) {
  animation_["samplers"].push_back(
      {{"input", times}, {"output", values}, {"interpolation", interpolation}});
  animation_["channels"].push_back({{"sampler", animation_["samplers"].size() - 1},
                                    {"target", {{"node", node}, {"path", path}}}});
}

void GltfFile::add_motion(std::size_t node, std::size_t times, std::span<const Pose> poses) {
  std::vector<float> translations, turns;
  Eigen::Quaternionf last = turn_of(poses.front());
  for (const Pose& pose : poses) {
    Eigen::Quaternionf turn = turn_of(pose);
    if (turn.dot(last) < 0) turn.coeffs() = -turn.coeffs();
    last = turn;
    for (int k = 0; k < 3; ++k)
      translations.push_back(static_cast<float>(pose.translation()[k]));
    for (int k = 0; k < 4; ++k)
      turns.push_back(turn.coeffs()[k]);
  }
  add_channel(node, "translation", times, add_floats(translations, 3, false), "LINEAR");
  add_channel(node, "rotation", times, add_floats(turns, 4, false), "LINEAR");
}

void GltfFile::add_presence(std::size_t node, std::size_t times, std::span<const float> is_seen) {
  std::vector<float> scales;
  for (const float seen : is_seen)
    scales.insert(scales.end(), 3, seen);
  add_channel(node, "scale", times, add_floats(scales, 3, false), "STEP");
}

std::string GltfFile::bytes(const std::vector<std::size_t>& nodes, const std::string& note) {
  const double half = std::sqrt(0.5);
  file_["nodes"].push_back(
      {{"name", "world"}, {"rotation", {-half, 0, 0, half}}, {"children", nodes}});
  file_["scenes"] = json::array({{{"nodes", {file_["nodes"].size() - 1}}}});
  if (!animation_["channels"].empty()) file_["animations"] = json::array({animation_});
  if (!note.empty()) file_["asset"]["extras"] = {{"note", note}};
  file_["buffers"] = json::array({{{"byteLength", buffer_.size()}}});
  std::string chunks;
  // A byte that is not UTF-8 becomes a mark that says so.
  append_chunk(kJsonChunk, file_.dump(-1, ' ', false, json::error_handler_t::replace), ' ', chunks);
  append_chunk(kBinaryChunk, buffer_, '\0', chunks);
  constexpr std::size_t kFront = 12;
  if (chunks.size() + kFront > std::numeric_limits<std::uint32_t>::max())
    throw InputError("glTF: more than the 4 GiB that a file can have; see --every");
  std::string file = "glTF";
  append_u32(2, file);
  append_u32(static_cast<std::uint32_t>(chunks.size() + kFront), file);
  return file + chunks;
}

}  // namespace graze::cli
