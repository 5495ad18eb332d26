#include <graze/engine/cases/read_parts.h>

#include <cmath>
#include <limits>

namespace graze::cases {
namespace {

constexpr std::uint32_t kMaxIndex = std::numeric_limits<std::int32_t>::max();

TrianglePair read_pair(const JsonCursor& at) {
  at.require_size(2);
  return {at.item(0).index(kMaxIndex), at.item(1).index(kMaxIndex)};
}

/// Reads a list that must ascend: so are the library's, and comparing is then simple.
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

double read_length(const JsonCursor& at) {
  const double length = at.number();
  if (length < 0) at.fail("is negative");
  return length;
}

CaseContact read_contact(const JsonCursor& at) {
  at.require_keys({"point", "point_a", "point_b", "normal", "depth"});
  return {at.member("point").point(), at.member("point_a").point(), at.member("point_b").point(),
          at.member("normal").point(), read_length(at.member("depth"))};
}

CaseAnswer read_distance(const JsonCursor& at) {
  at.require_keys({"distance", "point_a", "point_b", "pair"});
  CaseAnswer answer;
  answer.distance = at.member("distance").number();  // below 0 where an engine claims a touch
  if (at.has("point_a")) answer.point_a = at.member("point_a").point();
  if (at.has("point_b")) answer.point_b = at.member("point_b").point();
  if (at.has("pair")) answer.pair = read_pair(at.member("pair"));
  return answer;
}

}  // namespace

CaseAnswer read_answer(const JsonCursor& at, Ask ask, bool has_volume_b) {
  if (ask == Ask::Distance) return read_distance(at);
  CaseAnswer answer;
  if (ask == Ask::Pairs && has_volume_b) {
    at.require_keys({"triangles"});
    answer.triangles = read_ascending<std::uint32_t>(
        at.member("triangles"), [](const JsonCursor& item) { return item.index(kMaxIndex); });
  } else if (ask == Ask::Pairs || ask == Ask::SelfPairs) {
    at.require_keys({"pairs"});
    answer.pairs = read_ascending<TrianglePair>(at.member("pairs"), read_pair);
  } else if (ask == Ask::Separation) {
    at.require_keys({"distance", "translation"});
    answer.distance = read_length(at.member("distance"));
    answer.translation = at.member("translation").point();
  } else if (ask == Ask::Contacts) {
    at.require_keys({"contacts"});
    const JsonCursor list = at.member("contacts");
    answer.contacts.emplace();
    for (std::size_t i = 0; i < list.size(); ++i)
      answer.contacts->push_back(read_contact(list.item(i)));
  } else {
    at.require_keys({"says"});
    answer.says = at.member("says").boolean();
  }
  return answer;
}

}  // namespace graze::cases
