#include "tests/engine/view/unpacked_page.h"

#include <zlib.h>

#include <array>
#include <cstring>
#include <stdexcept>

#include <Eigen/Geometry>

namespace graze::tests {
namespace {

Eigen::Vector3d point_of(const nlohmann::json& list) {
  return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

std::uint32_t length_at(std::string_view bytes, std::size_t at) {
  std::uint32_t length = 0;
  for (std::size_t i = 0; i < 4; ++i)
    length |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << 8 * i;
  return length;
}

std::string_view between(const std::string& text, std::string_view before, std::string_view after) {
  const std::size_t from = text.find(before);
  if (from == text.npos) throw std::runtime_error("no " + std::string(before));
  const std::size_t to = text.find(after, from);
  if (to == text.npos) throw std::runtime_error("no " + std::string(after));
  return std::string_view(text).substr(from + before.size(), to - from - before.size());
}

}  // namespace

std::string gunzipped(std::string_view bytes) {
  z_stream stream = {};
  if (inflateInit2(&stream, 15 + 16) != Z_OK) throw std::runtime_error("zlib");
  std::string copy(bytes), out;
  stream.next_in = reinterpret_cast<Bytef*>(copy.data());
  stream.avail_in = static_cast<uInt>(copy.size());
  int status = Z_OK;
  while (status == Z_OK) {
    std::array<char, 1 << 15> part;
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = static_cast<uInt>(part.size());
    status = inflate(&stream, Z_NO_FLUSH);
    out.append(part.data(), part.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (status != Z_STREAM_END) throw std::runtime_error("no gzip");
  return out;
}

std::string bytes_of_base64(std::string_view text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  std::uint32_t bits = 0, count = 0;
  if (text.size() % 4 != 0) throw std::runtime_error("no Base64");
  while (!text.empty() && text.back() == '=')
    text.remove_suffix(1);
  for (const char c : text) {
    const std::size_t digit = digits.find(c);
    if (digit == digits.npos) throw std::runtime_error("no Base64");
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    out += static_cast<char>(bits >> count & 0xff);
  }
  return out;
}

UnpackedPage::UnpackedPage(const std::string& page) {
  const std::string bytes = gunzipped(bytes_of_base64(
      between(page, "<script id=\"data\" type=\"application/octet-stream\">", "</script>")));
  if (!bytes.starts_with("GRAZEVW1")) throw std::runtime_error("another format");
  const std::size_t json_size = length_at(bytes, 8), array_size = length_at(bytes, 12);
  if (16 + json_size + array_size != bytes.size()) throw std::runtime_error("another length");
  json_ = nlohmann::json::parse(bytes.substr(16, json_size));
  arrays_ = bytes.substr(16 + json_size);
}

std::vector<std::uint32_t> UnpackedPage::words(const nlohmann::json& number) const {
  const nlohmann::json& place = json_.at("arrays").at(number.get<std::size_t>());
  const auto offset = place.at("offset").get<std::size_t>();
  const auto count = place.at("words").get<std::size_t>();
  const auto stride = place.at("stride").get<std::size_t>();
  std::vector<std::uint32_t> words(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t zigzag = 0;
    for (std::size_t plane = 0; plane < 4; ++plane)
      zigzag |= static_cast<std::uint32_t>(
                    static_cast<unsigned char>(arrays_.at(offset + plane * count + i)))
                << 8 * plane;
    words[i] = ((zigzag >> 1) ^ (~(zigzag & 1u) + 1u)) + (i < stride ? 0 : words[i - stride]);
  }
  return words;
}

std::vector<float> UnpackedPage::floats(const nlohmann::json& number) const {
  const std::vector<std::uint32_t> bits = words(number);
  std::vector<float> floats(bits.size());
  if (!bits.empty()) std::memcpy(floats.data(), bits.data(), 4 * bits.size());
  return floats;
}

Eigen::Vector3d UnpackedPage::world(std::size_t frame, const Eigen::Vector3d& numbers) const {
  const nlohmann::json& place =
      json_.at("places").at(json_["frames"].at(frame)["place"].get<std::size_t>());
  return point_of(place["center"]) + place["scale"].get<double>() * numbers;
}

std::vector<Eigen::Vector3d> UnpackedPage::vertices(std::size_t body, std::size_t frame) const {
  const nlohmann::json& of_body = json_.at("bodies").at(body);
  const nlohmann::json& mesh = json_.at("meshes").at(of_body["mesh"].get<std::size_t>());
  const std::vector<std::uint32_t> frames = words(of_body["frames"]);
  const std::vector<float> poses = floats(of_body["poses"]), positions = floats(mesh["positions"]);
  std::vector<Eigen::Vector3d> found;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (frames[i] != frame) continue;
    const float* pose = poses.data() + 7 * i;
    const Eigen::Quaterniond turn(pose[3], pose[0], pose[1], pose[2]);
    const Eigen::Vector3d origin = world(frame, {pose[4], pose[5], pose[6]});
    for (std::size_t v = 0; v + 2 < positions.size(); v += 3)
      found.emplace_back(origin +
                         mesh["scale"].get<double>() *
                             (turn.normalized() *
                              Eigen::Vector3d(positions[v], positions[v + 1], positions[v + 2])));
  }
  return found;
}

std::vector<Eigen::Vector3d> UnpackedPage::corners(std::size_t body, std::size_t frame) const {
  const std::vector<Eigen::Vector3d> all = vertices(body, frame);
  std::vector<Eigen::Vector3d> found;
  const auto mesh = json_.at("bodies").at(body)["mesh"].get<std::size_t>();
  for (const std::uint32_t index : words(json_.at("meshes").at(mesh)["indices"]))
    found.push_back(all.at(index));
  return found;
}

std::vector<float> UnpackedPage::marks(const char* kind, std::size_t width,
                                       std::size_t frame) const {
  const nlohmann::json& mark = json_.at("marks").at(kind);
  const std::vector<std::uint32_t> starts = words(mark["starts"]);
  const std::vector<float> list = floats(mark["list"]);
  if (mark.contains("rows")) {
    const std::vector<std::uint32_t> rows = words(mark["rows"]);
    std::vector<float> found;
    found.reserve(width * (starts.at(frame + 1) - starts.at(frame)));
    for (std::uint32_t i = starts[frame]; i < starts[frame + 1]; ++i)
      for (std::size_t k = 0; k < width; ++k)
        found.push_back(list.at(k * (list.size() / width) + rows.at(i)));
    return found;
  }
  return {list.begin() + static_cast<std::ptrdiff_t>(width * starts.at(frame)),
          list.begin() + static_cast<std::ptrdiff_t>(width * starts.at(frame + 1))};
}

}  // namespace graze::tests
