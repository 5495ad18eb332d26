#include "samples/simulation/gltf_writer.h"

#include <graze/bvh/error.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>

namespace graze::samples {
namespace {

using nlohmann::json;

// These are glTF's numbers for what their names say.
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;

std::string base64(std::span<const unsigned char> bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

/// Holds one buffer, and the views and accessors that say what is where in it. glTF is
/// little-endian, as are the machines that this sample runs on.
class Buffer {
 public:
  explicit Buffer(json& file) : file_(file) {}

  /// Adds rows of `width` numbers; glTF asks for the bounds of positions and times. Returns their
  /// index.
  std::size_t add(std::span<const float> numbers, std::size_t width, bool has_bounds) {
    static constexpr const char* kTypes[] = {"", "SCALAR", "", "VEC3", "VEC4"};
    json accessor = begin(numbers, numbers.size() / width, kFloat, kTypes[width]);
    for (std::size_t k = 0; has_bounds && k < width; ++k) {
      float least = std::numeric_limits<float>::infinity();
      float most = -least;
      for (std::size_t i = k; i < numbers.size(); i += width)
        least = std::min(least, numbers[i]), most = std::max(most, numbers[i]);
      accessor["min"].push_back(least);
      accessor["max"].push_back(most);
    }
    return end(std::move(accessor));
  }

  std::size_t add(std::span<const std::uint32_t> numbers) {
    return end(begin(numbers, numbers.size(), kUnsignedInt, "SCALAR"));
  }

  void write() {
    file_["buffers"] = {{{"byteLength", bytes_.size()},
                         {"uri", "data:application/octet-stream;base64," + base64(bytes_)}}};
  }

 private:
  template <typename T>
  json begin(std::span<const T> numbers, std::size_t count, int type, const char* shape) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + numbers.size_bytes());
    std::memcpy(bytes_.data() + at, numbers.data(), numbers.size_bytes());
    file_["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", at}, {"byteLength", numbers.size_bytes()}});
    return {{"bufferView", file_["bufferViews"].size() - 1},
            {"componentType", type},
            {"count", count},
            {"type", shape}};
  }

  std::size_t end(json accessor) {
    file_["accessors"].push_back(std::move(accessor));
    return file_["accessors"].size() - 1;
  }

  json& file_;
  std::vector<unsigned char> bytes_;
};

void add_shape(const GltfShape& shape, json& file, Buffer& buffer) {
  std::vector<float> positions;
  for (const Eigen::Vector3d& p : shape.mesh.vertices()) {
    for (int k = 0; k < 3; ++k)
      positions.push_back(static_cast<float>(p[k]));
  }
  std::vector<std::uint32_t> corners;
  for (const TriangleIndices& triangle : shape.mesh.triangles())
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  file["materials"].push_back(
      {{"name", shape.name},
       {"pbrMetallicRoughness",
        {{"baseColorFactor", {shape.colour[0], shape.colour[1], shape.colour[2], 1}},
         {"metallicFactor", 0.3},
         {"roughnessFactor", 0.5}}}});
  const std::size_t position = buffer.add(positions, 3, true);
  const json primitive = {{"attributes", {{"POSITION", position}}},
                          {"indices", buffer.add(corners)},
                          {"material", file["materials"].size() - 1}};
  file["meshes"].push_back({{"name", shape.name}, {"primitives", json::array({primitive})}});
}

Eigen::Quaterniond turn_of(const Pose& pose) {
  return Eigen::Quaterniond(pose.linear()).normalized();
}

void add_channel(std::size_t node, const char* path, std::size_t times, std::size_t values,
                 json& animation) {
  animation["samplers"].push_back(
      {{"input", times}, {"output", values}, {"interpolation", "LINEAR"}});
  animation["channels"].push_back({{"sampler", animation["samplers"].size() - 1},
                                   {"target", {{"node", node}, {"path", path}}}});
}

void add_motion(const GltfBody& body, std::size_t node, std::size_t times, json& animation,
                Buffer& buffer) {
  std::vector<float> shifts, turns;
  Eigen::Quaterniond last = turn_of(body.poses.front());
  for (const Pose& pose : body.poses) {
    Eigen::Quaterniond turn = turn_of(pose);
    if (turn.dot(last) < 0) turn.coeffs() = -turn.coeffs();  // the shorter way round
    last = turn;
    for (int k = 0; k < 3; ++k)
      shifts.push_back(static_cast<float>(pose.translation()[k]));
    for (int k = 0; k < 4; ++k)
      turns.push_back(static_cast<float>(turn.coeffs()[k]));
  }
  add_channel(node, "translation", times, buffer.add(shifts, 3, false), animation);
  add_channel(node, "rotation", times, buffer.add(turns, 4, false), animation);
}

void add_bodies(const GltfScene& scene, json& file, Buffer& buffer) {
  const std::vector<float> seconds(scene.times.begin(), scene.times.end());
  json animation = {{"channels", json::array()}, {"samplers", json::array()}};
  std::size_t times = 0;
  for (const GltfBody& body : scene.bodies) {
    const std::size_t node = file["nodes"].size();
    const bool stands = body.poses.size() == 1;
    if (body.shape >= scene.shapes.size() || (!stands && body.poses.size() != scene.times.size()))
      throw InputError("glTF node " + std::to_string(node) + ": its shape or poses do not fit");
    const Eigen::Vector3d at = body.poses.front().translation();
    const Eigen::Quaterniond turn = turn_of(body.poses.front());
    file["nodes"].push_back({{"mesh", body.shape},
                             {"translation", {at.x(), at.y(), at.z()}},
                             {"rotation", {turn.x(), turn.y(), turn.z(), turn.w()}}});
    if (stands) continue;
    if (animation["channels"].empty()) times = buffer.add(seconds, 1, true);
    add_motion(body, node, times, animation, buffer);
  }
  if (!animation["channels"].empty()) file["animations"] = json::array({animation});
}

}  // namespace

void write_gltf(const std::filesystem::path& path, const GltfScene& scene) {
  json file = {{"asset", {{"version", "2.0"}, {"generator", "graze"}}}, {"scene", 0}};
  Buffer buffer(file);
  for (const GltfShape& shape : scene.shapes)
    add_shape(shape, file, buffer);
  add_bodies(scene, file, buffer);
  // glTF's y is up, ours is z: one node above all others turns them.
  json all = json::array();
  for (std::size_t i = 0; i < file["nodes"].size(); ++i)
    all.push_back(i);
  const double half = std::sqrt(0.5);
  file["nodes"].push_back(
      {{"name", "world"}, {"rotation", {-half, 0, 0, half}}, {"children", all}});
  file["scenes"] = json::array({{{"nodes", {file["nodes"].size() - 1}}}});
  buffer.write();
  std::ofstream stream(path);
  stream << file.dump() << '\n';
  stream.close();
  if (!stream) throw Error(path.string() + ": cannot be written");
}

}  // namespace graze::samples
