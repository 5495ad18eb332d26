#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/cases/text/case_words.h>
#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cases/write_case.h>

#include <cmath>

namespace graze {
namespace {

using cases::json_list;

std::string text_of(const TrianglePair& pair) {
  return std::string("[") + std::to_string(pair.a) + "," + std::to_string(pair.b) + "]";
}

std::string pairs_text(const std::vector<TrianglePair>& pairs) {
  return json_list(pairs, ",", [](const TrianglePair& pair) { return text_of(pair); });
}

std::string text_of(Feature feature) {
  for (const auto& [name, value] : cases::kFeatures) {
    if (value == feature) return cases::json_string(name);
  }
  return "\"?\"";
}

std::string yes_or_no(bool is_so) {
  return is_so ? "true" : "false";
}

/// Writes an object, of which members are added in turn.
class ObjectText {
 public:
  ObjectText& add(const char* key, const std::string& value) {
    text_ += (text_.empty() ? "{\"" : ",\"") + std::string(key) + "\":" + value;
    return *this;
  }
  std::string text() const { return text_.empty() ? "{}" : text_ + "}"; }

 private:
  std::string text_;
};

/// Says how the numbers of an answer are written.
struct NumberText {
  std::string (*number)(double);

  std::string distance(double value) const {
    return std::isinf(value) ? cases::json_string(cases::kInfinite) : number(value);
  }
  std::string point(const Eigen::Vector3d& p) const {
    return std::string("[") + number(p.x()) + "," + number(p.y()) + "," + number(p.z()) + "]";
  }
  std::string item(const CaseContact& contact) const {
    return ObjectText()
        .add("point", point(contact.point))
        .add("point_a", point(contact.point_a))
        .add("point_b", point(contact.point_b))
        .add("normal", point(contact.normal))
        .add("depth", number(contact.depth))
        .text();
  }
  std::string item(const CaseShapeContact& contact) const {
    ObjectText out;
    out.add("point", point(contact.point));
    if (contact.point_a) out.add("point_a", point(*contact.point_a));
    if (contact.point_b) out.add("point_b", point(*contact.point_b));
    return out.add("normal", point(contact.normal))
        .add("depth", number(contact.depth))
        .add("feature_a", cases::json_bits(contact.feature.a))
        .add("feature_b", cases::json_bits(contact.feature.b))
        .text();
  }
  std::string item(const RayHit& hit) const {
    ObjectText out;
    out.add("distance", distance(hit.distance))
        .add("point", point(hit.point))
        .add("normal", point(hit.normal));
    if (hit.triangle != kNoTriangle) out.add("triangle", std::to_string(hit.triangle));
    return out.text();
  }
  std::string item(const IntersectionPoint& p) const {
    return ObjectText()
        .add("position", point(p.position))
        .add("feature_a", text_of(p.feature_a))
        .add("feature_b", text_of(p.feature_b))
        .text();
  }
  std::string item(const Eigen::Vector3d& p) const { return point(p); }

  template <typename Item>
  std::string list(const std::vector<Item>& items) const {
    return json_list(items, ",", [this](const Item& each) { return item(each); });
  }
};

std::string text_of(const CaseIntersection::Segment& segment) {
  return ObjectText()
      .add("from", std::to_string(segment.from))
      .add("to", std::to_string(segment.to))
      .add("pairs", pairs_text(segment.pairs))
      .text();
}

std::string text_of(const CaseIntersection::Curve& curve) {
  const auto segment_text = [](const CaseIntersection::Segment& each) { return text_of(each); };
  return ObjectText()
      .add("closed", yes_or_no(curve.is_closed))
      .add("segments", json_list(curve.segments, ",", segment_text))
      .text();
}

std::string text_of(const CaseIntersection::Polygon& polygon) {
  const auto index_text = [](std::uint32_t index) { return std::to_string(index); };
  return ObjectText()
      .add("corners", json_list(polygon.corners, ",", index_text))
      .add("pairs", pairs_text(polygon.pairs))
      .text();
}

std::string text_of(const std::vector<CaseIntersection::Polygon>& patch) {
  return json_list(patch, ",",
                   [](const CaseIntersection::Polygon& polygon) { return text_of(polygon); });
}

std::string text_of(const CaseIntersection::Touch& touch) {
  return ObjectText()
      .add("point", std::to_string(touch.point))
      .add("pairs", pairs_text(touch.pairs))
      .text();
}

std::string text_of(const CaseIntersection& intersection, const NumberText& numbers) {
  const auto part_text = [](const auto& part) { return text_of(part); };
  return ObjectText()
      .add("points", numbers.list(intersection.points))
      .add("curves", json_list(intersection.curves, ",", part_text))
      .add("patches", json_list(intersection.patches, ",", part_text))
      .add("touching_points", json_list(intersection.touching_points, ",", part_text))
      .text();
}

std::string answer_text(const CaseAnswer& answer, const NumberText& numbers) {
  ObjectText out;
  if (answer.says) out.add("says", yes_or_no(*answer.says));
  if (answer.pairs) out.add("pairs", pairs_text(*answer.pairs));
  if (answer.triangles) {
    const auto index_text = [](std::uint32_t t) { return std::to_string(t); };
    out.add("triangles", json_list(*answer.triangles, ",", index_text));
  }
  if (answer.distance) out.add("distance", numbers.distance(*answer.distance));
  if (answer.lower_bound) out.add("lower_bound", numbers.number(*answer.lower_bound));
  if (answer.is_converged) out.add("converged", yes_or_no(*answer.is_converged));
  if (answer.normal) out.add("normal", numbers.point(*answer.normal));
  if (answer.point_a) out.add("point_a", numbers.point(*answer.point_a));
  if (answer.point_b) out.add("point_b", numbers.point(*answer.point_b));
  if (answer.pair) out.add("pair", text_of(*answer.pair));
  if (answer.translation) out.add("translation", numbers.point(*answer.translation));
  if (answer.contacts) out.add("contacts", numbers.list(*answer.contacts));
  if (answer.manifold) out.add("manifold", numbers.list(*answer.manifold));
  if (answer.intersection) out.add("intersection", text_of(*answer.intersection, numbers));
  if (answer.corners) out.add("corners", numbers.list(*answer.corners));
  if (answer.hits) out.add("hits", numbers.list(*answer.hits));
  if (answer.status) out.add("status", cases::json_string(name_of(*answer.status)));
  if (answer.low) out.add("low", numbers.number(*answer.low));
  if (answer.high) out.add("high", numbers.number(*answer.high));
  return out.text();
}

}  // namespace

std::string to_json(const CaseAnswer& answer) {
  return bvh::in_standard_arithmetic(
      [&]() -> std::string { return answer_text(answer, {cases::json_number}); });
}

std::string to_plain_json(const CaseAnswer& answer) {
  return bvh::in_standard_arithmetic(
      [&]() -> std::string { return answer_text(answer, {cases::json_plain_number}); });
}

}  // namespace graze
