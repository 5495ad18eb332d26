#include <graze/engine/view/writing/packed_view.h>

#include <graze/engine/version.h>
#include <graze/engine/view/packing/word_arrays.h>
#include <graze/engine/view/writing/frame_places.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <cstring>

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

/// Words of frames of different lengths, one after the other.
class ListsOfFrames {
 public:
  explicit ListsOfFrames(std::uint32_t width) : width_(width) {}

  std::vector<float>& numbers() { return numbers_; }
  void end_frame() { starts_.push_back(static_cast<std::uint32_t>(numbers_.size() / width_)); }

  Json add_to(WordArrays& arrays) const {
    const std::size_t starts = arrays.add(starts_, 1);
    return {{"starts", starts}, {"list", arrays.add(numbers_, width_)}};
  }

 private:
  std::uint32_t width_;
  std::vector<std::uint32_t> starts_ = {0};
  std::vector<float> numbers_;
};

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
                 {"marks", marks()}};
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

  Json marks() {
    ListsOfFrames curves(6), lines(6), contacts(7), gaps(7);
    Json labels = Json::array();
    for (std::size_t f = 0; f < view_.frames.size(); ++f) {
      const ShownFrame& frame = view_.frames[f];
      const NumberFrame& place = place_of(f);
      for (const Vector3d& point : frame.curves)
        append(place.numbers(point), curves.numbers());
      for (const Vector3d& point : frame.lines)
        append(place.numbers(point), lines.numbers());
      for (const ShownContact& contact : frame.contacts) {
        append(place.numbers(contact.point), contacts.numbers());
        append(contact.normal.cast<float>(), contacts.numbers());
        contacts.numbers().push_back(place.length(contact.depth));
      }
      for (const ShownGap& gap : frame.gaps) {
        append(place.numbers(gap.point_a), gaps.numbers());
        append(place.numbers(gap.point_b), gaps.numbers());
        gaps.numbers().push_back(place.length(gap.distance));
      }
      for (const ShownLabel& label : frame.labels)
        labels.push_back({{"frame", f},
                          {"at", json_of(place.numbers(label.at).cast<double>())},
                          {"text", label.text}});
      for (ListsOfFrames* lists : {&curves, &lines, &contacts, &gaps})
        lists->end_frame();
    }
    Json out = {{"triangles", marked_triangles()}};
    out["curves"] = curves.add_to(arrays_);
    out["lines"] = lines.add_to(arrays_);
    out["contacts"] = contacts.add_to(arrays_);
    out["gaps"] = gaps.add_to(arrays_);
    out["labels"] = std::move(labels);
    return out;
  }

  /// Of each body those frames alone in which some are.
  Json marked_triangles() {
    struct Marked {
      std::vector<std::uint32_t> frames, starts = {0}, list;
    };
    std::map<std::uint32_t, Marked> marked;
    for (std::size_t f = 0; f < view_.frames.size(); ++f) {
      for (const auto& [body, triangles] : view_.frames[f].triangles) {
        Marked& of_body = marked[body];
        of_body.frames.push_back(static_cast<std::uint32_t>(f));
        of_body.list.insert(of_body.list.end(), triangles.begin(), triangles.end());
        of_body.starts.push_back(static_cast<std::uint32_t>(of_body.list.size()));
      }
    }
    Json list = Json::array();
    for (const auto& [body, of_body] : marked) {
      Json entry = {{"body", body}};
      entry["frames"] = arrays_.add(of_body.frames, 1);
      entry["starts"] = arrays_.add(of_body.starts, 1);
      entry["list"] = arrays_.add(of_body.list, 1);
      list.push_back(std::move(entry));
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
