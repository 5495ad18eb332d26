#include <graze/engine/cases/read/read_parts.h>
#include <graze/engine/cases/text/case_words.h>
#include <graze/engine/files/source.h>

#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace graze::cases {
namespace {

constexpr std::uint32_t kMaxIndex = std::numeric_limits<std::int32_t>::max();

/// Reads a list that must ascend. The library's lists do, and two that ascend are simple to
/// compare.
template <typename Item, typename Read>
std::vector<Item> read_ascending(const JsonCursor& at, Read&& read) {
  std::vector<Item> items;
  items.reserve(at.size());
  for (std::size_t i = 0; i < at.size(); ++i) {
    items.push_back(read(at.item(i)));
    if (i > 0 && !(items[i - 1] < items[i])) at.item(i).fail("the list does not ascend");
  }
  return items;
}

double read_length_or_infinity(const JsonCursor& at) {
  const double length = at.number_or_infinite();
  if (length < 0) at.fail("is negative");
  return length;
}

CaseContact read_contact(const JsonCursor& at) {
  at.require_keys({"point", "point_a", "point_b", "normal", "depth"});
  return {at.member("point").point(), at.member("point_a").point(), at.member("point_b").point(),
          at.member("normal").point(), at.member("depth").number()};  // below 0 where the two are
                                                                      // merely near
}

/// Reads a point that older files do not have.
std::optional<Eigen::Vector3d> read_point_if_any(const JsonCursor& at, std::string_view key) {
  if (!at.has(key)) return std::nullopt;
  return at.member(key).point();
}

/// Reads which parts meet, which only graze tells. Without that each contact is of parts of its
/// own.
ContactFeature read_feature(const JsonCursor& at, std::uint32_t number) {
  if (!at.has("feature_a") && !at.has("feature_b")) return {number, number};
  return {at.member("feature_a").bits(), at.member("feature_b").bits()};
}

CaseShapeContact read_shape_contact(const JsonCursor& at, std::uint32_t number) {
  at.require_keys({"point", "point_a", "point_b", "normal", "depth", "feature_a", "feature_b"});
  return {at.member("point").point(),       read_point_if_any(at, "point_a"),
          read_point_if_any(at, "point_b"), at.member("normal").point(),
          at.member("depth").number(),  // some engines write depths below 0: merely near
          read_feature(at, number)};
}

CaseAnswer read_manifold(const JsonCursor& at) {
  at.require_keys({"manifold"});
  const JsonCursor list = at.member("manifold");
  CaseAnswer answer;
  answer.manifold.emplace();
  for (std::size_t i = 0; i < list.size(); ++i)
    answer.manifold->push_back(read_shape_contact(list.item(i), static_cast<std::uint32_t>(i)));
  return answer;
}

CaseAnswer read_contacts(const JsonCursor& at) {
  at.require_keys({"contacts"});
  const JsonCursor list = at.member("contacts");
  CaseAnswer answer;
  answer.contacts.emplace();
  for (std::size_t i = 0; i < list.size(); ++i)
    answer.contacts->push_back(read_contact(list.item(i)));
  return answer;
}

void read_points(const JsonCursor& at, CaseAnswer& answer) {
  answer.distance =
      at.member("distance").number_or_infinite();  // below 0 where an engine claims a touch
  if (at.has("point_a")) answer.point_a = at.member("point_a").point();
  if (at.has("point_b")) answer.point_b = at.member("point_b").point();
}

CaseAnswer read_distance(const JsonCursor& at) {
  at.require_keys({"distance", "point_a", "point_b", "pair"});
  CaseAnswer answer;
  read_points(at, answer);
  if (at.has("pair")) answer.pair = read_pair(at.member("pair"));
  return answer;
}

CaseAnswer read_body_distance(const JsonCursor& at) {
  at.require_keys({"distance", "lower_bound", "converged", "normal", "point_a", "point_b"});
  CaseAnswer answer;
  read_points(at, answer);
  if (at.has("lower_bound")) answer.lower_bound = read_length(at.member("lower_bound"));
  if (at.has("converged")) answer.is_converged = at.member("converged").boolean();
  if (at.has("normal")) answer.normal = at.member("normal").point();
  return answer;
}

CaseAnswer read_corners(const JsonCursor& at) {
  at.require_keys({"corners"});
  const JsonCursor list = at.member("corners");
  if (list.size() > 6) list.fail("has more than 6 points");
  CaseAnswer answer;
  answer.corners.emplace();
  for (std::size_t i = 0; i < list.size(); ++i)
    answer.corners->push_back(list.item(i).point());
  return answer;
}

CaseAnswer read_hits(const JsonCursor& at, const Case& query) {
  at.require_keys({"hits"});
  const JsonCursor list = at.member("hits");
  if (query.ask == Ask::Ray && list.size() > 1) list.fail("has more hits than the first");
  CaseAnswer answer;
  answer.hits.emplace();
  for (std::size_t i = 0; i < list.size(); ++i) {
    const JsonCursor hit = list.item(i);
    hit.require_keys({"distance", "point", "normal", "triangle"});
    answer.hits->push_back({.distance = read_length_or_infinity(hit.member("distance")),
                            .point = hit.member("point").point(),
                            .normal = hit.member("normal").point()});
    if (!hit.has("triangle")) continue;
    if (std::holds_alternative<Triangle>(query.a)) {
      hit.member("triangle").fail("there is one triangle only");
    }
    answer.hits->back().triangle = hit.member("triangle").index(kMaxIndex);
  }
  return answer;
}

CaseAnswer read_list(const JsonCursor& at, const Case& query) {
  CaseAnswer answer;
  const bool is_of_pairs = !query.b || std::holds_alternative<CaseMesh>(*query.b);
  at.require_keys({is_of_pairs ? "pairs" : "triangles"});
  if (is_of_pairs) {
    answer.pairs = read_pairs(at.member("pairs"));
  } else {
    answer.triangles = read_ascending<std::uint32_t>(
        at.member("triangles"), [](const JsonCursor& item) { return item.index(kMaxIndex); });
  }
  return answer;
}

CaseAnswer read_separation(const JsonCursor& at) {
  at.require_keys({"distance", "translation"});
  CaseAnswer answer;
  answer.distance = read_length(at.member("distance"));
  answer.translation = at.member("translation").point();
  return answer;
}

RigidStatus read_status(const JsonCursor& at) {
  for (const auto& [name, status] : kStatuses)
    if (at.text() == name) return status;
  at.fail(mesh_io::quoted(at.text()) + " is none of free, hit and close");
}

double read_time(const JsonCursor& at) {
  const double time = at.number();
  if (!(time >= 0 && time <= 1)) at.fail("is no time from 0 to 1");
  return time;
}

CaseAnswer read_first_contact(const JsonCursor& at) {
  at.require_keys({"status", "low", "high"});
  CaseAnswer answer;
  answer.status = read_status(at.member("status"));
  answer.low = read_time(at.member("low"));
  answer.high = read_time(at.member("high"));
  if (*answer.low > *answer.high) at.member("low").fail("is later than \"high\"");
  if (*answer.status == RigidStatus::Free && *answer.low < 1)
    at.member("low").fail("is not 1, up to which all is free");
  return answer;
}

}  // namespace

double read_length(const JsonCursor& at) {
  const double length = at.number();
  if (length < 0) at.fail("is negative");
  return length;
}

TrianglePair read_pair(const JsonCursor& at) {
  at.require_size(2);
  return {at.item(0).index(kMaxIndex), at.item(1).index(kMaxIndex)};
}

std::vector<TrianglePair> read_pairs(const JsonCursor& at) {
  return read_ascending<TrianglePair>(at, read_pair);
}

CaseAnswer read_answer(const JsonCursor& at, const Case& query) {
  CaseAnswer answer;
  const bool is_of_bodies = std::holds_alternative<CaseBody>(query.a);
  switch (query.ask) {
    case Ask::Pairs:
    case Ask::SelfPairs:
      return read_list(at, query);
    case Ask::Distance:
      return is_of_bodies ? read_body_distance(at) : read_distance(at);
    case Ask::Contacts:
      return is_of_bodies ? read_manifold(at) : read_contacts(at);
    case Ask::Intersection:
      if (std::holds_alternative<Triangle>(query.a)) return read_corners(at);
      at.require_keys({"intersection"});
      answer.intersection = read_intersection(at.member("intersection"));
      return answer;
    case Ask::Separation:
      return read_separation(at);
    case Ask::Ray:
    case Ask::RayAll:
      return read_hits(at, query);
    case Ask::FirstContact:
      return read_first_contact(at);
    default:
      at.require_keys({"says"});
      answer.says = at.member("says").boolean();
      return answer;
  }
}

}  // namespace graze::cases
