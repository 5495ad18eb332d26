#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace graze::tests {

/// What a page holds, read by nothing of graze: as engine/view/README.md describes it.
class UnpackedPage {
 public:
  /// Throws std::runtime_error for what is no page.
  explicit UnpackedPage(const std::string& page);

  const nlohmann::json& json() const { return json_; }

  /// An array by its number.
  std::vector<std::uint32_t> words(const nlohmann::json& number) const;
  std::vector<float> floats(const nlohmann::json& number) const;

  /// Vertices of a body in a frame, in the common frame.
  std::vector<Eigen::Vector3d> vertices(std::size_t body, std::size_t frame) const;

  /// Corners of its triangles there, one after the other.
  std::vector<Eigen::Vector3d> corners(std::size_t body, std::size_t frame) const;

  /// Floats of the marks of a kind in a frame.
  std::vector<float> marks(const char* kind, std::size_t width, std::size_t frame) const;

  /// A point of a frame in the common frame.
  Eigen::Vector3d world(std::size_t frame, const Eigen::Vector3d& numbers) const;

 private:
  nlohmann::json json_;
  std::string arrays_;
};

/// The bytes that a gzip file holds. Throws std::runtime_error.
std::string gunzipped(std::string_view bytes);

/// The bytes of Base64. Throws std::runtime_error.
std::string bytes_of_base64(std::string_view text);

}  // namespace graze::tests
