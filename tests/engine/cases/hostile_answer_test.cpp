// Answers and settings that are none are refused by one line that names the file and the place.

#include <graze/bvh/error.h>
#include <graze/engine/cases/read_case.h>
#include <gtest/gtest.h>
#include <string>

namespace graze {
namespace {

constexpr const char* kOneTriangle =
    R"({"mesh": {"vertices": [[0,0,0],[1,0,0],[0,1,0]], "triangles": [[0,1,2]]}})";
constexpr const char* kTriangle = R"({"triangle": [[0,0,0],[1,0,0],[0,1,0]]})";
constexpr const char* kBody = R"({"body": {"sphere": {"radius": 1}}})";
constexpr const char* kRay = R"({"ray": {"origin": [0,0,1], "direction": [0,0,-1]}})";
constexpr const char* kBox = R"({"box": {"min": [0,0,0], "max": [1,1,1]}})";

std::string refusal_of(const std::string& text) {
  try {
    parse_case(text, "c");
  } catch (const CaseError& error) {
    return error.what();
  }
  return "";
}

/// A case in two lines: what is asked, and the answer.
struct Asked {
  std::string question;
  std::string a = kOneTriangle;
  std::string b = kOneTriangle;
  std::string settings = "{}";

  std::string with(const std::string& answer) const {
    return R"({"graze_case": 1, "question": ")" + question + R"(", "settings": )" + settings +
           R"(, "a": )" + a + (b.empty() ? "" : R"(, "b": )" + b) + ",\n\"answer\": " + answer +
           R"(, "answered_by": {"engine": "x"}})";
  }
  std::string alone() const {
    return R"({"graze_case": 1, "question": ")" + question + R"(", "settings": )" + settings +
           R"(, "a": )" + a + (b.empty() ? "" : R"(, "b": )" + b) + "}";
  }
};

TEST(HostileAnswer, Rays) {
  const Asked ray{.question = "ray", .b = kRay};
  EXPECT_EQ(refusal_of(ray.with(R"({"hits": []})")), "");
  const std::string hit = R"({"distance": 1, "point": [0,0,0], "normal": [0,0,1], "triangle": 0})";
  EXPECT_EQ(refusal_of(ray.with(R"({"hits": [)" + hit + "]}")), "");
  EXPECT_EQ(refusal_of(ray.with(R"({"hits": [)" + hit + "," + hit + "]}")),
            "c:2: /answer/hits: has more hits than the first");
  EXPECT_EQ(
      refusal_of(ray.with(
          R"({"hits": [{"distance": 1, "point": [0,0,0], "normal": [0,0,1], "triangle": 1}]})")),
      "c:2: /answer: there is no triangle 1");
  EXPECT_EQ(refusal_of(ray.with(R"({"hits": [{"distance": -1}]})")),
            "c:2: /answer/hits/0/distance: is negative");
  EXPECT_EQ(refusal_of(ray.with(R"({"hits": [{"distance": "endless"}]})")).substr(0, 39),
            "c:2: /answer/hits/0/distance: \"endless\"");
  EXPECT_EQ(refusal_of(Asked{.question = "ray", .a = kTriangle, .b = kRay}.with(R"({"hits": [)" +
                                                                                hit + "]}")),
            "c:2: /answer/hits/0/triangle: there is one triangle only");
  EXPECT_EQ(refusal_of(Asked{.question = "ray_all", .a = kBody, .b = kRay}.alone()),
            "c:1: /question: no query answers \"ray_all\" for a body and a ray");
  EXPECT_EQ(refusal_of(Asked{.question = "any", .b = kRay}.alone()),
            "c:1: /question: no query answers \"any\" for a mesh and a ray");
  const auto other = [](const std::string& text) {
    return Asked{.question = "ray", .b = R"({"ray": )" + text + "}"}.alone();
  };
  EXPECT_EQ(refusal_of(other(R"({"origin": [0,0,1], "direction": [0,0,0]})")).substr(0, 12),
            "c:1: /b/ray:");
  EXPECT_EQ(refusal_of(other(R"({"origin": [0,0,1], "direction": [0,0,1], "max_distance": -1})"))
                .substr(0, 12),
            "c:1: /b/ray:");
  EXPECT_EQ(refusal_of(other(R"({"origin": [0,0,1]})")), "c:1: /b/ray: has no \"direction\"");
}

TEST(HostileAnswer, Intersections) {
  const Asked meshes{.question = "intersection"};
  const auto with = [&](const std::string& points, const std::string& curves,
                        const std::string& patches, const std::string& touches) {
    return refusal_of(meshes.with(R"({"intersection": {"points": [)" + points +
                                  R"(], "curves": [)" + curves + R"(], "patches": [)" + patches +
                                  R"(], "touching_points": [)" + touches + "]}}"));
  };
  const std::string point = R"({"position": [0,0,0], "feature_a": "edge", "feature_b": "face"})";
  const std::string place = "c:2: /answer/intersection/";
  EXPECT_EQ(with("", "", "", ""), "");
  EXPECT_EQ(with(point, "", "", R"({"point": 0, "pairs": [[0,0]]})"), "");
  EXPECT_EQ(with(point, "", "", R"({"point": 1, "pairs": []})"),
            place + "touching_points/0/point: there is no point 1; there are 1");
  EXPECT_EQ(
      with(point, R"({"closed": true, "segments": [{"from": 0, "to": 4294967295, "pairs": []}]})",
           "", ""),
      place + "curves/0/segments/0/to: there is no point 4294967295; there are 1");
  EXPECT_EQ(with(point, R"({"closed": 1, "segments": []})", "", ""),
            place + "curves/0/closed: is a number, not a boolean");
  EXPECT_EQ(with(point, "", R"([{"corners": [0, 0], "pairs": []}])", ""),
            place + "patches/0/0/corners: are not three to six");
  EXPECT_EQ(with(point, "", R"([{"corners": [0, 0, 0, 0, 0, 0, 0], "pairs": []}])", ""),
            place + "patches/0/0/corners: are not three to six");
  EXPECT_EQ(with(point, "", "", R"({"point": 0, "pairs": [[0,1]]})"),
            "c:2: /answer: there is no pair of triangles 0 and 1");
  EXPECT_EQ(with(R"({"position": [0,0,0], "feature_a": "side", "feature_b": "face"})", "", "", ""),
            place + "points/0/feature_a: \"side\" is neither vertex nor edge nor face");
  const Asked triangles{.question = "intersection", .a = kTriangle, .b = kTriangle};
  EXPECT_EQ(refusal_of(triangles.with(R"({"corners": [[0,0,0],[1,0,0],[0,1,0]]})")), "");
  EXPECT_EQ(refusal_of(triangles.with(
                R"({"corners": [[0,0,0],[0,0,0],[0,0,0],[0,0,0],[0,0,0],[0,0,0],[0,0,0]]})")),
            "c:2: /answer/corners: has more than 6 points");
  EXPECT_EQ(refusal_of(triangles.with(R"({"intersection": {}})")),
            "c:2: /answer: unknown key \"intersection\"; there are corners");
}

TEST(HostileAnswer, Bodies) {
  const Asked gap{.question = "distance", .a = kBody, .b = kBody};
  EXPECT_EQ(refusal_of(gap.with(R"({"distance": 1, "lower_bound": 0.5, "converged": true})")), "");
  EXPECT_EQ(refusal_of(gap.with(R"({"distance": "infinite"})")), "");
  EXPECT_EQ(refusal_of(gap.with(R"({"distance": "nan"})")).substr(0, 23),
            "c:2: /answer/distance: ");
  EXPECT_EQ(refusal_of(gap.with(R"({"distance": 1, "lower_bound": -1})")),
            "c:2: /answer/lower_bound: is negative");
  EXPECT_EQ(refusal_of(gap.with(R"({"distance": 1, "pair": [0, 0]})")).substr(0, 32),
            "c:2: /answer: unknown key \"pair\"");
  const Asked contacts{.question = "contacts", .a = kBody, .b = kBody};
  const auto contact = [](const std::string& feature) {
    return R"({"point": [0,0,0], "normal": [0,0,1], "depth": 0, "feature_a": "0x0", "feature_b": )" +
           feature + "}";
  };
  const std::string good = contact("\"0xffffffffffffffff\"");
  EXPECT_EQ(refusal_of(contacts.with(R"({"manifold": [)" + good + "]}")), "");
  EXPECT_EQ(parse_case(contacts.with(R"({"manifold": [)" + good + "]}"), "c")
                .answer->manifold->front()
                .feature.b,
            ~std::uint64_t{0});
  const std::string place = "c:2: /answer/manifold/0/feature_b: ";
  for (const char* text : {"\"0x\"", "\"0x10000000000000000\"", "\"12\"", "\"0xG\"", "\"0x-1\""}) {
    EXPECT_EQ(refusal_of(contacts.with(R"({"manifold": [)" + contact(text) + "]}")),
              place + text + " is not 0x and up to 16 digits 0-9 a-f");
  }
  EXPECT_EQ(refusal_of(contacts.with(R"({"manifold": [)" + contact("1") + "]}")),
            place + "is a number, not a string");
  EXPECT_EQ(refusal_of(contacts.with(R"({"contacts": []})")),
            "c:2: /answer: unknown key \"contacts\"; there are manifold");
  // Points on the surfaces may be missing, both or one, and must be points.
  const auto with_point = [&](const std::string& point) {
    return contacts.with(R"({"manifold": [{"point_b": )" + point + "," + good.substr(1) + "]}");
  };
  const auto read = parse_case(with_point("[1,2,3]"), "c").answer->manifold->front();
  EXPECT_EQ(read.point_b, Eigen::Vector3d(1, 2, 3));
  EXPECT_FALSE(read.point_a.has_value());
  EXPECT_EQ(refusal_of(with_point("[1,2]")).substr(0, 32), "c:2: /answer/manifold/0/point_b:");
}

/// A setting that the query does not have would be ignored: another question than was meant.
TEST(HostileAnswer, SettingsOfOtherQueries) {
  const auto refused = [](const Asked& asked) { return refusal_of(asked.alone()); };
  EXPECT_EQ(refused({.question = "any", .settings = R"({"touch": "exclude"})"}), "");
  EXPECT_EQ(refused({.question = "pairs", .settings = R"({"touch": "exclude", "limit": 3})"}), "");
  EXPECT_EQ(refused({.question = "any", .b = kBox, .settings = R"({"interior": "solid"})"}), "");
  EXPECT_EQ(refused({.question = "separation", .settings = R"({"direction": [0,0,1]})"}), "");
  EXPECT_EQ(refused({.question = "self_pairs", .b = "", .settings = R"({"kind": "neighbour"})"}),
            "");
  for (const char* kind : {"intersecting", "crossing"})  // the word of cases that are kept
    EXPECT_EQ(refused({.question = "self_pairs",
                       .b = "",
                       .settings = R"({"kind": ")" + std::string(kind) + R"("})"}),
              "");
  EXPECT_EQ(refused({.question = "contacts", .settings = R"({"touch": "exclude"})"}),
            "c:1: /settings/touch: such a query has no choice but \"include\"");
  EXPECT_EQ(refused({.question = "any", .b = kBox, .settings = R"({"touch": "exclude"})"}),
            "c:1: /settings/touch: such a query has no choice but \"include\"");
  EXPECT_EQ(
      refused({.question = "any", .a = kBody, .b = kBody, .settings = R"({"interior": "solid"})"}),
      "c:1: /settings/interior: such a query has no choice but \"surface\"");
  EXPECT_EQ(
      refused({.question = "any", .settings = R"({"touch": "exclude", "interior": "solid"})"}),
      "c:1: /settings/interior: \"solid\" needs \"touch\" to be \"include\"");
  EXPECT_EQ(refused({.question = "any", .settings = R"({"direction": [0,0,1]})"}),
            "c:1: /settings/direction: only \"separation\" has a direction");
  EXPECT_EQ(refused({.question = "separation", .settings = R"({"direction": [0,0,0]})"}),
            "c:1: /settings/direction: is zero");
  EXPECT_EQ(refused({.question = "any", .settings = R"({"limit": 1})"}),
            "c:1: /settings/limit: only \"pairs\" and \"self_pairs\" have a limit");
  EXPECT_EQ(refused({.question = "pairs", .settings = R"({"limit": -1})"}),
            "c:1: /settings/limit: is not a whole number from 0 to 4294967295");
  EXPECT_EQ(refused({.question = "pairs", .settings = R"({"kind": "neighbour"})"}),
            "c:1: /settings/kind: only \"self_pairs\" has a kind");
  EXPECT_EQ(refused({.question = "within", .settings = R"({"touch": "include"})"}),
            "c:1: \"within\" needs settings with a clearance");
}

}  // namespace
}  // namespace graze
