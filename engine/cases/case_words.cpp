#include <graze/engine/cases/case.h>
#include <graze/engine/cases/case_words.h>

#include <algorithm>
#include <array>

namespace graze {
namespace {

bool is_same(const std::optional<Eigen::Vector3d>& a, const std::optional<Eigen::Vector3d>& b) {
  return a.has_value() == b.has_value() && (!a || *a == *b);
}

bool is_same(const CaseContact& a, const CaseContact& b) {
  return a.point == b.point && a.point_a == b.point_a && a.point_b == b.point_b &&
         a.normal == b.normal && a.depth == b.depth;
}

}  // namespace

bool is_same(const CaseAnswer& a, const CaseAnswer& b) {
  if (a.contacts.has_value() != b.contacts.has_value()) return false;
  if (a.contacts &&
      !std::equal(a.contacts->begin(), a.contacts->end(), b.contacts->begin(), b.contacts->end(),
                  [](const CaseContact& s, const CaseContact& t) { return is_same(s, t); })) {
    return false;
  }
  return a.says == b.says && a.pairs == b.pairs && a.triangles == b.triangles &&
         a.distance == b.distance && is_same(a.point_a, b.point_a) &&
         is_same(a.point_b, b.point_b) && a.pair == b.pair && is_same(a.translation, b.translation);
}

const char* name_of(Ask ask) {
  for (const auto& [name, value] : cases::kAsks) {
    if (value == ask) return name;
  }
  return "?";
}

const char* name_of(const CaseShape& shape) {
  constexpr std::array kNames = {"triangle", "box", "obb", "sphere", "point", "mesh", "body"};
  static_assert(kNames.size() == std::variant_size_v<CaseShape>);
  return kNames[shape.index()];
}

}  // namespace graze
