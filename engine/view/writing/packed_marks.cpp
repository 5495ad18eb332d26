#include <graze/engine/view/writing/packed_marks.h>

#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace graze::view {
namespace {

using Eigen::Vector3d;
using Json = nlohmann::ordered_json;

/// Keeps numbers of frames, in different counts, one after the other.
template <typename Number>
class ListsOfFrames {
 public:
  explicit ListsOfFrames(std::uint32_t width) : width_(width) {}

  void add(Number number) { numbers_.push_back(number); }
  void add(const Eigen::Vector3f& point) {
    numbers_.insert(numbers_.end(), point.begin(), point.end());
  }
  void end_frame() { starts_.push_back(static_cast<std::uint32_t>(numbers_.size() / width_)); }

  Json add_to(WordArrays& arrays) const {
    const std::size_t starts = arrays.add(starts_, 1);
    return {{"starts", starts}, {"list", arrays.add(numbers_, width_)}};
  }

 private:
  std::uint32_t width_;
  std::vector<std::uint32_t> starts_ = {0};
  std::vector<Number> numbers_;
};

/// Keeps contacts of frames, seven numbers each. A contact that stays as it is from frame to frame
/// stands there once, number by number, and frames say which they have.
class ContactsOfFrames {
 public:
  void add(const Eigen::Vector3f& point, const Eigen::Vector3d& exact_normal, float depth) {
    const Eigen::Vector3f normal = rounded(exact_normal);
    const std::array<float, kWidth> row = {point.x(),  point.y(),  point.z(), normal.x(),
                                           normal.y(), normal.z(), depth};
    const auto next = static_cast<std::uint32_t>(known_.size());
    const auto [known, is_new] = known_.try_emplace(std::bit_cast<Bits>(row), next);
    rows_.push_back(known->second);
    if (!is_new) return;
    for (std::size_t k = 0; k < kWidth; ++k)
      columns_[k].push_back(row[k]);
  }
  void end_frame() { starts_.push_back(static_cast<std::uint32_t>(rows_.size())); }

  Json add_to(WordArrays& arrays) const {
    std::vector<float> numbers;
    numbers.reserve(kWidth * known_.size());
    for (const std::vector<float>& column : columns_)
      numbers.insert(numbers.end(), column.begin(), column.end());
    const std::size_t starts = arrays.add(starts_, 1), rows = arrays.add(rows_, 1);
    return {{"starts", starts}, {"rows", rows}, {"list", arrays.add(numbers, 1)}};
  }

 private:
  static constexpr std::size_t kWidth = 7;
  using Bits = std::array<std::uint32_t, kWidth>;

  /// Rounds a normal, which is drawn and is no number: an eighth of a milliradian is not seen, and
  /// packs well.
  static Eigen::Vector3f rounded(const Eigen::Vector3d& normal) {
    constexpr double kSteps = 4096;
    return ((normal * kSteps).array().round() / kSteps).matrix().cast<float>();
  }

  struct Hash {
    std::size_t operator()(const Bits& bits) const {
      std::uint64_t sum = 14695981039346656037u;  // FNV-1a, by words
      for (const std::uint32_t word : bits)
        sum = (sum ^ word) * 1099511628211u;
      return static_cast<std::size_t>(sum ^ sum >> 32);
    }
  };

  std::vector<std::uint32_t> starts_ = {0}, rows_;
  std::array<std::vector<float>, kWidth> columns_;
  std::unordered_map<Bits, std::uint32_t, Hash> known_;
};

/// Packs lines, points and the like, frame by frame.
class FrameMarks {
 public:
  void add(const ShownFrame& frame, const NumberFrame& place) {
    for (const Vector3d& point : frame.curves)
      curves_.add(place.numbers(point));
    for (const Vector3d& point : frame.lines)
      lines_.add(place.numbers(point));
    for (const Vector3d& point : frame.points)
      points_.add(place.numbers(point));
    for (const ShownContact& contact : frame.contacts) {
      contacts_.add(place.numbers(contact.point), contact.normal, place.length(contact.depth));
    }
    for (const ShownGap& gap : frame.gaps) {
      gaps_.add(place.numbers(gap.point_a));
      gaps_.add(place.numbers(gap.point_b));
      gaps_.add(place.length(gap.distance));
    }
    for (const ViewPlane& plane : frame.planes) {
      planes_.add(place.numbers(plane.point));
      planes_.add(plane.normal.cast<float>());
      planes_.add(place.length(plane.half_extent));
    }
    for (const auto& [a, b] : frame.pairs) {
      pairs_.add(a);
      pairs_.add(b);
    }
    for (ListsOfFrames<float>* lists : {&curves_, &lines_, &points_, &gaps_, &planes_})
      lists->end_frame();
    contacts_.end_frame();
    pairs_.end_frame();
  }

  void add_to(Json& marks, WordArrays& arrays) const {
    marks["curves"] = curves_.add_to(arrays);
    marks["lines"] = lines_.add_to(arrays);
    marks["points"] = points_.add_to(arrays);
    marks["contacts"] = contacts_.add_to(arrays);
    marks["gaps"] = gaps_.add_to(arrays);
    marks["planes"] = planes_.add_to(arrays);
    marks["pairs"] = pairs_.add_to(arrays);
  }

 private:
  ListsOfFrames<float> curves_{6}, lines_{6}, points_{3}, gaps_{7}, planes_{7};
  ContactsOfFrames contacts_;
  ListsOfFrames<std::uint32_t> pairs_{2};
};

/// Lists for each body only those frames in which some triangles are marked.
Json marked_triangles(const ShownView& view, WordArrays& arrays) {
  struct Marked {
    std::vector<std::uint32_t> frames, starts = {0}, list;
  };
  std::map<std::uint32_t, Marked> marked;
  for (std::size_t f = 0; f < view.frames.size(); ++f) {
    for (const auto& [body, triangles] : view.frames[f].triangles) {
      Marked& of_body = marked[body];
      of_body.frames.push_back(static_cast<std::uint32_t>(f));
      of_body.list.insert(of_body.list.end(), triangles.begin(), triangles.end());
      of_body.starts.push_back(static_cast<std::uint32_t>(of_body.list.size()));
    }
  }
  Json list = Json::array();
  for (const auto& [body, of_body] : marked) {
    Json entry = {{"body", body}};
    entry["frames"] = arrays.add(of_body.frames, 1);
    entry["starts"] = arrays.add(of_body.starts, 1);
    entry["list"] = arrays.add(of_body.list, 1);
    list.push_back(std::move(entry));
  }
  return list;
}

/// Lists for each body and level the middle of a box and its three half axes, in the numbers of the
/// mesh.
Json boxes(const ShownView& view, std::span<const NumberFrame> shapes, WordArrays& arrays) {
  Json list = Json::array();
  for (std::size_t b = 0; b < view.bodies.size(); ++b) {
    const NumberFrame& own = shapes[view.bodies[b].shape];
    for (const auto& [level, of_level] : view.bodies[b].boxes) {
      std::vector<float> numbers;
      numbers.reserve(12 * of_level.size());
      const auto add = [&](const Eigen::Vector3f& three) {
        numbers.insert(numbers.end(), three.begin(), three.end());
      };
      for (const Obb& box : of_level) {
        add(own.numbers(box.pose.translation()));
        for (int axis = 0; axis < 3; ++axis)
          add(box.pose.linear().col(axis).cast<float>() * own.length(box.half_extents[axis]));
      }
      list.push_back({{"body", b}, {"level", level}, {"list", arrays.add(numbers, 12)}});
    }
  }
  return list;
}

Json labels(const ShownView& view, const FramePlaces& places) {
  Json list = Json::array();
  for (std::size_t f = 0; f < view.frames.size(); ++f) {
    for (const ShownLabel& label : view.frames[f].labels) {
      const Vector3d at = places.places[places.of_frame[f]].numbers(label.at).cast<double>();
      list.push_back(
          {{"frame", f}, {"at", Json::array({at.x(), at.y(), at.z()})}, {"text", label.text}});
    }
  }
  return list;
}

}  // namespace

Json packed_marks(const ShownView& view, const FramePlaces& places,
                  std::span<const NumberFrame> shapes, WordArrays& arrays) {
  FrameMarks of_frames;
  for (std::size_t f = 0; f < view.frames.size(); ++f)
    of_frames.add(view.frames[f], places.places[places.of_frame[f]]);
  Json marks = {{"triangles", marked_triangles(view, arrays)}};
  of_frames.add_to(marks, arrays);
  marks["boxes"] = boxes(view, shapes, arrays);
  marks["labels"] = labels(view, places);
  return marks;
}

}  // namespace graze::view
