#include <graze/engine/view/writing/packed_view.h>

#include <graze/engine/version.h>
#include <graze/engine/view/packing/word_arrays.h>
#include <graze/engine/view/writing/frame_places.h>
#include <graze/engine/view/writing/packed_marks.h>

#include <nlohmann/json.hpp>

#include <bit>
#include <cstdint>
#include <cstdio>

namespace graze::view {
namespace {

using Eigen::Vector3d;
using Json = nlohmann::ordered_json;

constexpr std::string_view kMagic = "GRAZEVW1";

const char* word_for(ViewState state) {
  switch (state) {
    case ViewState::Touching:
      return "touching";
    case ViewState::Clear:
      return "clear";
    case ViewState::Unknown:
      return "unknown";
    case ViewState::Unsaid:
      break;
  }
  return "";
}

Json json_of(const Vector3d& point) {
  return Json::array({point.x(), point.y(), point.z()});
}

void append(const Eigen::Vector3f& point, std::vector<float>& out) {
  out.insert(out.end(), point.begin(), point.end());
}

/// Returns the low word of each coordinate's double, then the high one.
std::vector<std::uint32_t> exact_words(const std::vector<Vector3d>& vertices) {
  std::vector<std::uint32_t> words;
  words.reserve(6 * vertices.size());
  for (const Vector3d& vertex : vertices) {
    for (const double coordinate : vertex) {
      const auto bits = std::bit_cast<std::uint64_t>(coordinate);
      words.push_back(static_cast<std::uint32_t>(bits));
      words.push_back(static_cast<std::uint32_t>(bits >> 32));
    }
  }
  return words;
}

/// Packs one view.
class Packer {
 public:
  explicit Packer(const ShownView& view) : view_(view), places_(frame_places(view)) {}

  std::string packed() {
    const ViewSettings& settings = view_.settings;
    Json page = {{"title", settings.title},
                 {"unit", settings.unit},
                 {"made_by", std::string("graze ") + library_version()},
                 {"notes", settings.notes},
                 {"meshes", meshes()},
                 {"bodies", bodies()},
                 {"places", places()},
                 {"frames", frames()},
                 {"marks", packed_marks(view_, places_, frames_of_shapes_, arrays_)}};
    Json& arrays = page["arrays"] = Json::array();
    for (const WordArray& array : arrays_.places())
      arrays.push_back(
          {{"offset", array.offset}, {"words", array.words}, {"stride", array.stride}});
    // Names of files may hold any bytes.
    const std::string text = page.dump(-1, ' ', false, Json::error_handler_t::replace);
    std::string out(kMagic);
    append_length(text.size(), out);
    append_length(arrays_.bytes().size(), out);
    return out + text + arrays_.bytes();
  }

 private:
  static void append_length(std::size_t length, std::string& out) {
    constexpr std::size_t kMost = 0xffffffff;
    if (length > kMost)
      throw InputError("a view of more than 4 GiB: no browser would open its page");
    for (unsigned i = 0; i < 4; ++i)
      out += static_cast<char>(length >> 8 * i & 0xff);
  }

  const NumberFrame& place_of(std::size_t frame) const {
    return places_.places[places_.of_frame[frame]];
  }

  Json meshes() {
    Json list = Json::array();
    for (const ShownShape& shape : view_.shapes) {
      frames_of_shapes_.push_back(number_frame(shape.bounds));
      const NumberFrame& frame = frames_of_shapes_.back();
      std::vector<float> positions;
      positions.reserve(3 * shape.surface.vertices.size());
      for (const Vector3d& vertex : shape.surface.vertices)
        append(frame.numbers(vertex), positions);
      std::vector<std::uint32_t> indices;
      indices.reserve(3 * shape.surface.triangles.size());
      for (const TriangleIndices& triangle : shape.surface.triangles)
        indices.insert(indices.end(), triangle.begin(), triangle.end());
      const std::size_t at = arrays_.add(positions, 3);
      Json mesh = {{"positions", at},
                   {"indices", arrays_.add(indices, 3)},
                   {"origin", json_of(frame.center)},
                   {"scale", frame.scale}};
      if (shape.surface.is_boundless) mesh["boundless"] = true;
      if (shape.surface.vertices.size() <= view_.settings.most_exact_vertices)
        mesh["exact"] = arrays_.add(exact_words(shape.surface.vertices), 6);
      list.push_back(std::move(mesh));
    }
    return list;
  }

  Json bodies() {
    std::vector<std::vector<std::uint32_t>> frames(view_.bodies.size());
    std::vector<std::vector<float>> poses(view_.bodies.size());
    for (std::size_t f = 0; f < view_.frames.size(); ++f) {
      for (const auto& [body, pose] : view_.frames[f].poses) {
        const NumberFrame& own = frames_of_shapes_[view_.bodies[body].shape];
        frames[body].push_back(static_cast<std::uint32_t>(f));
        const Eigen::Quaterniond turn = Eigen::Quaterniond(pose.linear()).normalized();
        const Eigen::Vector3d at = pose * own.center;
        for (const double number : turn.coeffs())
          poses[body].push_back(static_cast<float>(number));
        append(place_of(f).numbers(at), poses[body]);
      }
    }
    Json list = Json::array();
    for (std::size_t b = 0; b < view_.bodies.size(); ++b) {
      const ShownBodyData& body = view_.bodies[b];
      const std::size_t at = arrays_.add(frames[b], 1);
      Json entry = {{"name", body.name},
                    {"mesh", body.shape},
                    {"frames", at},
                    {"poses", arrays_.add(poses[b], 7)}};
      if (body.color) {
        std::array<char, 8> text;
        std::snprintf(text.data(), text.size(), "#%02x%02x%02x", (*body.color)[0], (*body.color)[1],
                      (*body.color)[2]);
        entry["color"] = text.data();
      }
      list.push_back(std::move(entry));
    }
    return list;
  }

  Json places() const {
    Json list = Json::array();
    for (const NumberFrame& place : places_.places)
      list.push_back({{"center", json_of(place.center)}, {"scale", place.scale}});
    return list;
  }

  Json frames() const {
    Json list = Json::array();
    for (std::size_t f = 0; f < view_.frames.size(); ++f) {
      const ViewFrame& said = view_.frames[f].said;
      Json facts = Json::array();
      for (const ViewFact& fact : said.facts)
        facts.push_back({{"name", fact.name}, {"value", fact.value}, {"length", fact.is_length}});
      list.push_back({{"label", said.label},
                      {"state", word_for(said.state)},
                      {"says", said.says},
                      {"facts", std::move(facts)},
                      {"note", said.note},
                      {"change", said.is_change},
                      {"place", places_.of_frame[f]}});
    }
    return list;
  }

  const ShownView& view_;
  FramePlaces places_;
  std::vector<NumberFrame> frames_of_shapes_;
  WordArrays arrays_;
};

}  // namespace

std::string packed_view(const ShownView& view) {
  return Packer(view).packed();
}

}  // namespace graze::view
