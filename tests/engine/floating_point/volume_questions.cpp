#include <array>

#include "tests/engine/floating_point/questions.h"

namespace graze::tests {
namespace {

void add_hits(Words& words, const std::vector<std::uint8_t>& hits) {
  for (const std::uint8_t hit : hits)
    words.add(std::uint64_t{hit});
}

void ask_overlaps(const Inputs& in, Words& words) {
  words.add(intersects(in.box_a, in.box_b)), words.add(intersects(in.obb_a, in.obb_b));
  words.add(intersects(in.box_a, in.obb_b)), words.add(intersects(in.obb_a, in.box_b));
  words.add(intersects(in.ball_a, in.ball_b)), words.add(intersects(in.ball_a, in.box_a));
  words.add(intersects(in.box_b, in.ball_a)), words.add(intersects(in.ball_a, in.obb_a));
  words.add(intersects(in.obb_b, in.ball_a)), words.add(intersects(in.ellipsoid, in.box_a));
  words.add(intersects(in.box_b, in.ellipsoid));
  for (const Aabb& box : in.boxes) {
    words.add(intersects(in.box_a, box)), words.add(intersects(in.ball_a, box));
    words.add(intersects(in.obb_a, box)), words.add(intersects(in.ellipsoid, box));
  }
}

void ask_hollow_overlaps(const Inputs& in, Words& words) {
  for (const Aabb& box : in.boxes) {
    words.add(intersects(in.ball_a, HollowAabb{box}));
    words.add(intersects(HollowAabb{box}, in.ball_b));
    words.add(intersects(HollowSphere{in.ball_a}, box));
    words.add(intersects(box, HollowSphere{in.ball_b}));
    words.add(intersects(HollowSphere{in.ball_a}, HollowAabb{box}));
    words.add(intersects(HollowAabb{box}, HollowSphere{in.ball_b}));
  }
}

void ask_contains(const Inputs& in, Words& words) {
  const KDop<18> kdop = bounding_kdop(in.vertices_a);
  for (const Eigen::Vector3d& point : in.vertices_b) {
    words.add(contains(in.box_a, point)), words.add(contains(in.obb_a, point));
    words.add(contains(in.ball_a, point)), words.add(contains(kdop, point));
  }
  words.add(contains(in.box_a, in.box_b));
}

void ask_merged(const Inputs& in, Words& words) {
  words.add(merged(in.box_a, in.box_b)), words.add(merged(in.obb_a, in.obb_b));
  words.add(merged(in.ball_a, in.ball_b));
  words.add(merged(bounding_kdop(in.vertices_a), bounding_kdop(in.vertices_b)));
}

void ask_sizes(const Inputs& in, Words& words) {
  const KDop<18> kdop = bounding_kdop(in.vertices_a);
  words.add(volume(in.box_a)), words.add(volume(in.obb_a)), words.add(volume(in.ball_a));
  words.add(volume(kdop));
  words.add(surface(in.box_a)), words.add(surface(in.obb_a)), words.add(surface(in.ball_a));
  words.add(surface(kdop));
}

void ask_boxes(const Inputs& in, Words& words) {
  AabbList boxes, others;
  for (std::size_t i = 0; i < in.boxes.size(); ++i)
    boxes.add(in.boxes[i]), others.add(in.boxes_later[i]);
  std::vector<std::uint8_t> hits(boxes.size());
  intersects(in.box_a, boxes, hits), add_hits(words, hits);
  intersects(boxes, others, hits), add_hits(words, hits);
  intersects(in.ball_a, boxes.view(), hits), add_hits(words, hits);
}

void ask_many(const Inputs& in, Words& words) {
  KDopList kdops;
  kdops.add(bounding_kdop(in.vertices_a)), kdops.add(bounding_kdop(in.vertices_b));
  ObbList turned;
  turned.add(in.obb_a), turned.add(in.obb_b);
  std::vector<std::uint8_t> hits(2);
  intersects(kdops[0], kdops, hits), add_hits(words, hits);
  intersects(kdops, kdops, hits), add_hits(words, hits);
  for (const Aabb& box : in.boxes) {
    const auto corners = std::array{box.min, box.max};
    words.add(intersects(kdops[0], bounding_kdop(corners)));
  }
  intersects(in.obb_b, turned, hits), add_hits(words, hits);
  intersects(turned, turned, hits), add_hits(words, hits);
  words.add(turned[0]);
}

void ask_balls(const Inputs& in, Words& words) {
  std::vector<double> x, y, z, radius;
  for (const Eigen::Vector3d& p : in.vertices_a) {
    x.push_back(p.data()[0]), y.push_back(p.data()[1]), z.push_back(p.data()[2]);
    radius.push_back(in.ball_b.radius);
  }
  const SphereArray balls{x, y, z, radius};
  std::vector<std::uint8_t> hits(x.size());
  intersects(in.ball_a, balls, hits), add_hits(words, hits);
  intersects(in.box_a, balls, hits), add_hits(words, hits);
  intersects(balls, balls, hits), add_hits(words, hits);
  AabbList boxes;
  for (std::size_t i = 0; i < x.size(); ++i)
    boxes.add(in.boxes[i % in.boxes.size()]);
  intersects(balls, boxes.view(), hits), add_hits(words, hits);
}

/// What is refused where numbers are next to each other.
void ask_checks(const Inputs& in, Words& words) {
  for (const auto& [low, high] :
       {std::pair{&in.box_a, &in.box_b}, std::pair{&in.box_b, &in.box_a}}) {
    try {
      check_box(Aabb{low->min, high->max}, "box");
      words.add(true);
    } catch (const InputError& error) {
      words.add(std::string(error.what()));
    }
  }
  check_box(in.obb_a, "box"), check_sphere(in.ball_a, "ball"), check_ray(in.ray, "ray");
  check_ellipsoid(in.ellipsoid, "ellipsoid"), check_kdop(bounding_kdop(in.vertices_a), "kdop");
  words.add(check_rigid(in.pose_a, "pose")), words.add(rotation_deviation(in.pose_b));
  words.add(check_pose(in.pose_a, "pose"));
}

}  // namespace

std::vector<Question> volume_questions() {
  return {{"overlaps", ask_overlaps},
          {"overlaps of hollow volumes", ask_hollow_overlaps},
          {"contains", ask_contains},
          {"merged", ask_merged},
          {"volume and surface", ask_sizes},
          {"overlaps of lists of boxes", ask_boxes},
          {"overlaps of other lists", ask_many},
          {"overlaps of arrays of balls", ask_balls},
          {"checks of what is given", ask_checks}};
}

}  // namespace graze::tests
