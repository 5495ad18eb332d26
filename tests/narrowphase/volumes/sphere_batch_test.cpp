#include <graze/bvh/error.h>
#include <graze/narrowphase/volumes/sphere_batch.h>
#include <graze/narrowphase/volumes/sphere_box.h>
#include <graze/narrowphase/volumes/sphere_overlap.h>
#include <graze/narrowphase/volumes/spheres/array_elements.h>
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/narrowphase/volumes/volume_source.h"

namespace graze {
namespace {

using Hits = std::vector<std::uint8_t>;

/// Arrays that own their memory.
struct Spheres {
  std::vector<double> x, y, z, radius;

  void add(const Sphere& sphere) {
    x.push_back(sphere.centre[0]);
    y.push_back(sphere.centre[1]);
    z.push_back(sphere.centre[2]);
    radius.push_back(sphere.radius);
  }
  SphereArray view() const { return {x, y, z, radius}; }
};

struct Boxes {
  std::vector<double> min[3], max[3];

  void add(const Aabb& box) {
    for (int i = 0; i < 3; ++i) {
      min[i].push_back(box.min[i]);
      max[i].push_back(box.max[i]);
    }
  }
  AabbArray view() const { return {{min[0], min[1], min[2]}, {max[0], max[1], max[2]}}; }
};

/// Elements `first` to the end: views that need not be aligned.
SphereArray tail(const SphereArray& a, std::size_t first) {
  return {a.x.subspan(first), a.y.subspan(first), a.z.subspan(first), a.radius.subspan(first)};
}

AabbArray tail(const AabbArray& a, std::size_t first) {
  AabbArray result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.min[i] = a.min[i].subspan(first);
    result.max[i] = a.max[i].subspan(first);
  }
  return result;
}

/// Every kind of number in turn, lattices twice, for they touch.
struct Everything {
  Spheres spheres_a, spheres_b;
  Boxes boxes;
};

Everything everything(std::size_t count, std::uint64_t seed) {
  std::vector<VolumeSource> sources;
  for (Numbers kind : kEveryKind)
    sources.emplace_back(kind, seed);
  sources.emplace_back(Numbers::Lattice, seed + 1);
  Everything result;
  for (std::size_t n = 0; n < count; ++n) {
    VolumeSource& source = sources[n % sources.size()];
    result.spheres_a.add(source.sphere());
    result.spheres_b.add(source.sphere());
    result.boxes.add(source.box());
  }
  return result;
}

/// All five batches; the first element of the arrays is the one that meets many.
std::vector<Hits> all_batches(const Everything& e, std::size_t first) {
  const SphereArray a = tail(e.spheres_a.view(), first), b = tail(e.spheres_b.view(), first);
  const AabbArray boxes = tail(e.boxes.view(), first);
  const Sphere sphere = narrowphase::element(e.spheres_a.view(), 1);
  const Aabb box = narrowphase::element(e.boxes.view(), 1);
  std::vector<Hits> hits(5, Hits(a.size(), 7));
  intersects(sphere, b, hits[0]);
  intersects(a, b, hits[1]);
  intersects(sphere, boxes, hits[2]);
  intersects(box, b, hits[3]);
  intersects(a, boxes, hits[4]);
  return hits;
}

std::vector<Hits> one_by_one(const Everything& e, std::size_t first) {
  const SphereArray a = e.spheres_a.view(), b = e.spheres_b.view();
  const AabbArray boxes = e.boxes.view();
  const Sphere sphere = narrowphase::element(a, 1);
  const Aabb box = narrowphase::element(boxes, 1);
  std::vector<Hits> hits(5);
  for (std::size_t n = first; n < a.size(); ++n) {
    const Sphere sphere_a = narrowphase::element(a, n), sphere_b = narrowphase::element(b, n);
    hits[0].push_back(intersects(sphere, sphere_b));
    hits[1].push_back(intersects(sphere_a, sphere_b));
    hits[2].push_back(intersects(sphere, narrowphase::element(boxes, n)));
    hits[3].push_back(intersects(box, sphere_b));
    hits[4].push_back(intersects(sphere_a, narrowphase::element(boxes, n)));
  }
  return hits;
}

/// The SIMD targets that this CPU has, each forced in turn.
std::vector<std::int64_t> targets() {
  hwy::SetSupportedTargetsForTest(0);
  std::vector<std::int64_t> single;
  for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1)
    single.push_back(left & -left);
  return single;
}

void force(std::int64_t target) {
  hwy::SetSupportedTargetsForTest(target);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

TEST(Law8SphereBatch, EverySimdTargetAnswersAsOneByOne) {
  const Everything e = everything(6000, 1);
  const std::vector<Hits> expected = one_by_one(e, 0);
  const std::vector<std::int64_t> all = targets();
  EXPECT_GE(all.size(), 1u);
  for (std::int64_t target : all) {
    force(target);
    EXPECT_EQ(all_batches(e, 0), expected) << hwy::TargetName(target);
  }
  force(0);
  for (const Hits& hits : expected) {
    const auto count = std::count(hits.begin(), hits.end(), 1);
    EXPECT_GT(count, 300);
    EXPECT_LT(count, 5900);
  }
}

// Squares of about the smallest double: some vanish and others do not.
TEST(Law6SphereBatch, SquaresThatUnderflowDecideNothing) {
  RandomSource random(3);
  const double scale = 0x1p-537;
  Everything e;
  for (int n = 0; n < 2000; ++n) {
    const Eigen::Vector3d centre = random.vector(-1, 1) * scale;
    e.spheres_a.add({centre, random.uniform(0, 1.2) * scale});
    const Eigen::Vector3d other = random.vector(-1, 1) * scale;
    e.spheres_b.add({other, random.uniform(0, 1.2) * scale});
    const Eigen::Vector3d corner = random.vector(-1, 1) * scale;
    e.boxes.add({corner, corner + random.vector(0, 1) * scale});
  }
  EXPECT_EQ(all_batches(e, 0), one_by_one(e, 0));
}

TEST(SphereBatch, AnyLengthAndAnyAlignment) {
  for (std::size_t count = 2; count < 42; ++count) {
    const Everything e = everything(count, count);
    for (std::size_t first : {std::size_t{0}, std::size_t{1}, std::size_t{2}})
      ASSERT_EQ(all_batches(e, first), one_by_one(e, first)) << count << ", " << first;
  }
  intersects(Sphere{{0, 0, 0}, 1}, SphereArray{}, {});
  intersects(SphereArray{}, AabbArray{}, {});
}

template <typename Call>
std::string message_of(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Law10SphereBatch, BadElementsAreNamed) {
  const Sphere sphere{{0, 0, 0}, 1};
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  for (double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (std::size_t where : {0u, 5u, 8u, 20u}) {
      for (int part = 0; part < 6; ++part) {
        Spheres spheres;
        Boxes boxes;
        for (int n = 0; n < 21; ++n) {
          spheres.add({{n % 2 * 9.0, 0, 0}, 1});
          boxes.add(box);
        }
        const Spheres good_spheres = spheres;
        const Boxes good_boxes = boxes;
        std::vector<double>* rows[] = {&spheres.x, &spheres.y, &spheres.z, &spheres.radius};
        (*rows[part % 4])[where] = bad;
        (part < 3 ? boxes.min : boxes.max)[part % 3][where] = bad;
        Hits hits(21);
        const std::string index = "[" + std::to_string(where) + "]: ";
        const auto starts = [&](const std::string& what, const std::string& message) {
          return message.rfind(what + index, 0) == 0;
        };
        EXPECT_TRUE(
            starts("spheres", message_of([&] { intersects(sphere, spheres.view(), hits); })));
        EXPECT_TRUE(starts("spheres", message_of([&] { intersects(box, spheres.view(), hits); })));
        EXPECT_TRUE(starts("spheres a", message_of([&] {
                             intersects(spheres.view(), good_spheres.view(), hits);
                           })));
        EXPECT_TRUE(starts("spheres b", message_of([&] {
                             intersects(good_spheres.view(), spheres.view(), hits);
                           })));
        EXPECT_TRUE(starts("boxes", message_of([&] { intersects(sphere, boxes.view(), hits); })));
        EXPECT_TRUE(starts(
            "boxes", message_of([&] { intersects(good_spheres.view(), boxes.view(), hits); })));
        EXPECT_TRUE(starts(
            "spheres", message_of([&] { intersects(spheres.view(), good_boxes.view(), hits); })));
      }
    }
  }
}

TEST(Law10SphereBatch, NegativeRadiiAndInvertedBoxesAreNamed) {
  Spheres spheres;
  Boxes boxes;
  spheres.add({{0, 0, 0}, 1});
  spheres.add({{0, 0, 0}, -0.5});
  boxes.add({{0, 0, 0}, {1, 1, 1}});
  boxes.add({{0, 3, 0}, {1, 2, 1}});
  Hits hits(2);
  EXPECT_EQ(message_of([&] {
              intersects(Sphere{{0, 0, 0}, 1}, spheres.view(), hits);
            }),
            "spheres[1]: the radius is negative or not finite");
  EXPECT_EQ(message_of([&] {
              intersects(Sphere{{50, 0, 0}, 1}, spheres.view(), hits);
            }),
            "spheres[1]: the radius is negative or not finite");
  EXPECT_EQ(message_of([&] {
              intersects(Sphere{{0, 0, 0}, 1}, boxes.view(), hits);
            }).substr(0, 9),
            "boxes[1]:");
  EXPECT_THROW(intersects(Sphere{{0, 0, 0}, -1}, boxes.view(), hits), InputError);
  EXPECT_THROW(intersects(Aabb{{0, 0, 1}, {0, 0, 0}}, spheres.view(), hits), InputError);
}

TEST(Law10SphereBatch, LengthsThatDifferAreRefused) {
  const Everything e = everything(4, 1);
  const SphereArray spheres = e.spheres_a.view();
  const AabbArray boxes = e.boxes.view();
  const Sphere sphere{{0, 0, 0}, 1};
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  Hits hits(4), three(3);
  EXPECT_EQ(message_of([&] { intersects(sphere, spheres, three); }),
            "hits: 3 elements for 4 pairs");
  EXPECT_EQ(message_of([&] { intersects(spheres, spheres, three); }),
            "hits: 3 elements for 4 pairs");
  EXPECT_EQ(message_of([&] { intersects(sphere, boxes, three); }), "hits: 3 elements for 4 pairs");
  EXPECT_EQ(message_of([&] { intersects(box, spheres, three); }), "hits: 3 elements for 4 pairs");
  EXPECT_EQ(message_of([&] { intersects(spheres, boxes, three); }), "hits: 3 elements for 4 pairs");
  EXPECT_EQ(message_of([&] { intersects(spheres, tail(spheres, 1), hits); }),
            "spheres b: 3 elements for 4 spheres a");
  EXPECT_EQ(message_of([&] { intersects(spheres, tail(boxes, 1), hits); }),
            "boxes: 3 elements for 4 spheres");
  SphereArray ragged = spheres;
  ragged.radius = ragged.radius.subspan(2);
  EXPECT_EQ(message_of([&] { intersects(sphere, ragged, hits); }),
            "spheres: array radius has 2 elements, the first 4");
  AabbArray ragged_boxes = boxes;
  ragged_boxes.max[1] = {};
  EXPECT_EQ(message_of([&] { intersects(sphere, ragged_boxes, hits); }),
            "boxes: array max y has 0 elements, the first 4");
}

}  // namespace
}  // namespace graze
