#include <graze/engine/cases/read/read_parts.h>
#include <graze/engine/cases/text/case_words.h>
#include <graze/engine/files/source.h>

#include <limits>
#include <string>

namespace graze::cases {
namespace {

Feature read_feature(const JsonCursor& at) {
  for (const auto& [name, feature] : kFeatures) {
    if (at.text() == name) return feature;
  }
  at.fail(mesh_io::quoted(at.text()) + " is neither vertex nor edge nor face");
}

IntersectionPoint read_intersection_point(const JsonCursor& at) {
  at.require_keys({"position", "feature_a", "feature_b"});
  return {at.member("position").point(), read_feature(at.member("feature_a")),
          read_feature(at.member("feature_b"))};
}

/// Reads parts that refer to points by their indices.
class PartReader {
 public:
  explicit PartReader(std::size_t point_count) : point_count_(point_count) {}

  std::uint32_t point(const JsonCursor& at) const {
    const std::uint32_t index = at.index(std::numeric_limits<std::uint32_t>::max());
    if (index >= point_count_) {
      at.fail("there is no point " + std::to_string(index) + "; there are " +
              std::to_string(point_count_));
    }
    return index;
  }

  CaseIntersection::Curve curve(const JsonCursor& at) const {
    at.require_keys({"closed", "segments"});
    CaseIntersection::Curve curve{at.member("closed").boolean(), {}};
    const JsonCursor list = at.member("segments");
    for (std::size_t i = 0; i < list.size(); ++i) {
      const JsonCursor segment = list.item(i);
      segment.require_keys({"from", "to", "pairs"});
      curve.segments.push_back({point(segment.member("from")), point(segment.member("to")),
                                read_pairs(segment.member("pairs"))});
    }
    return curve;
  }

  std::vector<CaseIntersection::Polygon> patch(const JsonCursor& list) const {
    std::vector<CaseIntersection::Polygon> patch;
    for (std::size_t i = 0; i < list.size(); ++i) {
      const JsonCursor polygon = list.item(i);
      polygon.require_keys({"corners", "pairs"});
      const JsonCursor corners = polygon.member("corners");
      if (corners.size() < 3 || corners.size() > 6) corners.fail("are not three to six");
      CaseIntersection::Polygon& to = patch.emplace_back();
      for (std::size_t k = 0; k < corners.size(); ++k)
        to.corners.push_back(point(corners.item(k)));
      to.pairs = read_pairs(polygon.member("pairs"));
    }
    return patch;
  }

  CaseIntersection::Touch touch(const JsonCursor& at) const {
    at.require_keys({"point", "pairs"});
    return {point(at.member("point")), read_pairs(at.member("pairs"))};
  }

 private:
  std::size_t point_count_;
};

}  // namespace

CaseIntersection read_intersection(const JsonCursor& at) {
  at.require_keys({"points", "curves", "patches", "touching_points"});
  CaseIntersection result;
  const JsonCursor points = at.member("points");
  for (std::size_t i = 0; i < points.size(); ++i)
    result.points.push_back(read_intersection_point(points.item(i)));
  const PartReader reader(result.points.size());
  const JsonCursor curves = at.member("curves");
  for (std::size_t i = 0; i < curves.size(); ++i)
    result.curves.push_back(reader.curve(curves.item(i)));
  const JsonCursor patches = at.member("patches");
  for (std::size_t i = 0; i < patches.size(); ++i)
    result.patches.push_back(reader.patch(patches.item(i)));
  const JsonCursor touches = at.member("touching_points");
  for (std::size_t i = 0; i < touches.size(); ++i)
    result.touching_points.push_back(reader.touch(touches.item(i)));
  return result;
}

}  // namespace graze::cases
