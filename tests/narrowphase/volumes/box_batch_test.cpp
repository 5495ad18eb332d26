#include <graze/bvh/error.h>
#include <graze/narrowphase/volumes/aabb_list.h>
#include <graze/narrowphase/volumes/aabb_overlap.h>
#include <graze/narrowphase/volumes/kdop_list.h>
#include <graze/narrowphase/volumes/kdop_overlap.h>
#include <graze/narrowphase/volumes/obb_list.h>
#include <graze/narrowphase/volumes/obb_overlap.h>
#include <graze/narrowphase/volumes/sphere_batch.h>
#include <graze/narrowphase/volumes/sphere_box.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tests/narrowphase/volumes/obb_cases.h"
#include "tests/narrowphase/volumes/simd_targets.h"
#include "tests/narrowphase/volumes/volume_source.h"

namespace graze {
namespace {

using Hits = std::vector<std::uint8_t>;

KDop<18> random_kdop(VolumeSource& source) {
  KDop<18> kdop;
  for (std::size_t slab = 0; slab < KDop<18>::kSlabs; ++slab) {
    const double p = source.coordinate(), q = source.coordinate();
    // Wide in most slabs: of nine, few should separate.
    const bool is_wide = source.random().integer(0, 9) < 9;
    kdop.min[slab] = is_wide ? -std::abs(p) : std::min(p, q);
    kdop.max[slab] = is_wide ? std::abs(q) : std::max(p, q);
  }
  return kdop;
}

template <typename List, typename Volume>
struct Pairs {
  using VolumeType = Volume;
  List a, b;

  void add(const Volume& volume_a, const Volume& volume_b) {
    a.add(volume_a);
    b.add(volume_b);
  }
};

using AabbPairs = Pairs<AabbList, Aabb>;
using KDopPairs = Pairs<KDopList, KDop<18>>;
using ObbPairs = Pairs<ObbList, Obb>;

AabbPairs aabb_pairs(std::size_t count) {
  AabbPairs pairs;
  for (Numbers kind : kEveryKind) {
    VolumeSource source(kind, 1);
    for (std::size_t n = 0; n < count; ++n) {
      const Aabb a = source.box();
      pairs.add(a, source.box());
    }
  }
  return pairs;
}

KDopPairs kdop_pairs(std::size_t count) {
  KDopPairs pairs;
  for (Numbers kind : kEveryKind) {
    VolumeSource source(kind, 2);
    for (std::size_t n = 0; n < count; ++n) {
      const KDop<18> a = random_kdop(source);
      pairs.add(a, random_kdop(source));
    }
  }
  return pairs;
}

/// At any distance, at the border of the single test and beyond the range where it is sure.
ObbPairs obb_pairs(std::size_t count) {
  ObbPairs pairs;
  RandomSource random(3);
  for (std::size_t n = 0; n < count * kLies; ++n) {
    const ObbCase pair = random_case(kEveryLie[n % kLies], random);
    double distance = random.uniform(0, 1) * pair.size();
    if (n % 3 != 0) {
      const Border border = find_border(0, 4 * pair.size() + 1e-6,
                                        [&](double s) { return intersects(pair.a, pair.b_at(s)); });
      distance = n % 3 == 1 ? border.hit : border.apart;
    }
    Obb a = pair.a, b = pair.b_at(distance);
    if (n % 97 == 0) a.half_extents[0] = 0x1p1000;
    if (n % 89 == 0) b.pose.translation() *= 1e308;
    if (n % 83 == 0) b = a;
    if (n % 79 == 0) {  // two points, apart by so little that they may not be called so
      a = b = Obb{Pose::Identity(), {0, 0, 0}};
      b.pose.translation().x() = 0x1p-1074 * random.integer(0, 3);
    }
    if (!b.pose.matrix().allFinite()) b = a;
    n % 2 == 0 ? pairs.add(a, b) : pairs.add(b, a);
  }
  return pairs;
}

template <typename P>
Hits one_by_one(const P& pairs) {
  Hits hits;
  for (std::size_t n = 0; n < pairs.a.size(); ++n)
    hits.push_back(intersects(pairs.a[n], pairs.b[n]));
  return hits;
}

template <typename P>
Hits one_by_one(const typename P::VolumeType& one, const P& pairs) {
  Hits hits;
  for (std::size_t n = 0; n < pairs.b.size(); ++n)
    hits.push_back(intersects(one, pairs.b[n]));
  return hits;
}

template <typename P>
void expect_batch_as_single(const P& pairs) {
  const Hits expected = one_by_one(pairs);
  const std::size_t chosen[] = {0, 1, pairs.a.size() / 2, pairs.a.size() - 1};
  std::vector<Hits> expected_of_one;
  for (std::size_t one : chosen)
    expected_of_one.push_back(one_by_one(pairs.a[one], pairs));
  const auto hits_in_all = std::count(expected.begin(), expected.end(), 1);
  EXPECT_GT(hits_in_all * 20, static_cast<std::ptrdiff_t>(expected.size()));
  EXPECT_LT(hits_in_all * 20, static_cast<std::ptrdiff_t>(19 * expected.size()));
  EXPECT_GE(simd_targets().size(), 1u);
  for (std::int64_t target : simd_targets()) {
    force_simd_target(target);
    Hits hits(expected.size(), 7);
    intersects(pairs.a, pairs.b, hits);
    EXPECT_EQ(hits, expected) << hwy::TargetName(target);
    EXPECT_EQ(one_by_one(pairs), expected) << hwy::TargetName(target);
    for (std::size_t k = 0; k < 4; ++k) {
      std::fill(hits.begin(), hits.end(), std::uint8_t{7});
      intersects(pairs.a[chosen[k]], pairs.b, hits);
      EXPECT_EQ(hits, expected_of_one[k]) << hwy::TargetName(target);
    }
  }
  force_simd_target(0);
}

TEST(Law8BoxBatch, EverySimdTargetAnswersAsOneByOne) {
  expect_batch_as_single(aabb_pairs(5000));
  expect_batch_as_single(kdop_pairs(5000));
  expect_batch_as_single(obb_pairs(2500));
}

/// Each length from 0; no byte beyond it is written.
template <typename P>
void expect_any_length(const P& all) {
  for (std::int64_t target : simd_targets()) {
    force_simd_target(target);
    P some;
    for (std::size_t size = 0; size < 35; ++size) {
      Hits hits(size + 16, 7);
      Hits expected = one_by_one(some);
      expected.resize(size + 16, 7);
      intersects(some.a, some.b, std::span(hits).first(size));
      ASSERT_EQ(hits, expected) << size << " by " << hwy::TargetName(target);
      expected = one_by_one(all.a[0], some);
      expected.resize(size + 16, 7);
      std::fill(hits.begin(), hits.end(), std::uint8_t{7});
      intersects(all.a[0], some.b, std::span(hits).first(size));
      ASSERT_EQ(hits, expected) << size << " by " << hwy::TargetName(target);
      some.add(all.a[size], all.b[size]);
    }
  }
  force_simd_target(0);
}

TEST(BoxBatch, AnyLength) {
  expect_any_length(aabb_pairs(20));
  expect_any_length(kdop_pairs(20));
  expect_any_length(obb_pairs(20));
}

TEST(BoxBatch, ListsGiveBackWhatTheyWereGiven) {
  VolumeSource source(Numbers::Generic, 5);
  RandomSource random(5);
  AabbList boxes;
  KDopList kdops;
  ObbList oriented;
  const Aabb box = source.box();
  const KDop<18> kdop = random_kdop(source);
  const Obb obb = random_case(Lie::Any, random).a;
  for (int n = 0; n < 9; ++n) {
    boxes.add(n == 4 ? box : source.box());
    kdops.add(n == 4 ? kdop : random_kdop(source));
    oriented.add(n == 4 ? obb : random_case(Lie::Any, random).a);
  }
  EXPECT_EQ(boxes[4].min, box.min);
  EXPECT_EQ(boxes[4].max, box.max);
  EXPECT_EQ(kdops[4].min, kdop.min);
  EXPECT_EQ(kdops[4].max, kdop.max);
  EXPECT_EQ(oriented[4].half_extents, obb.half_extents);
  EXPECT_EQ(oriented[4].pose.matrix(), obb.pose.matrix());
  EXPECT_EQ(boxes.size() + kdops.size() + oriented.size(), 27u);
  boxes.clear();
  kdops.clear();
  oriented.clear();
  EXPECT_EQ(boxes.size() + kdops.size() + oriented.size(), 0u);
  boxes.add(box);
  EXPECT_EQ(boxes[0].max, box.max);
}

TEST(BoxBatch, AListOfBoxesIsAViewForSpheres) {
  VolumeSource source(Numbers::Lattice, 6);
  AabbList boxes;
  for (int n = 0; n < 100; ++n)
    boxes.add(source.box());
  const Sphere sphere{{0, 0, 0}, 1};
  Hits hits(100, 7);
  intersects(sphere, boxes.view(), hits);
  for (std::size_t n = 0; n < 100; ++n)
    EXPECT_EQ(hits[n] == 1, intersects(sphere, boxes[n]));
}

template <typename Call>
std::string message_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Law10BoxBatch, BadElementsAreNamedAndNotAdded) {
  AabbList boxes;
  KDopList kdops;
  ObbList oriented;
  KDop<18> kdop{};
  Obb obb{Pose::Identity(), {1, 1, 1}};
  for (int n = 0; n < 3; ++n) {
    boxes.add({{0, 0, 0}, {1, 1, 1}});
    kdops.add(kdop);
    oriented.add(obb);
  }
  kdop.max[7] = -1;
  obb.half_extents.z() = std::nan("");
  EXPECT_EQ(message_of([&] {
              boxes.add({{0, 2, 0}, {1, 1, 1}});
            }),
            "boxes[3]: minimum exceeds maximum in coordinate y");
  EXPECT_EQ(message_of([&] { kdops.add(kdop); }), "k-DOPs[3]: minimum exceeds maximum in slab 7");
  EXPECT_EQ(message_of([&] { oriented.add(obb); }),
            "boxes[3]: half extent z is negative or not finite");
  obb.pose.linear() *= 2;
  EXPECT_THROW(oriented.add(obb), PoseError);
  EXPECT_EQ(boxes.size() + kdops.size() + oriented.size(), 9u);
}

/// With lists of three.
template <typename P>
void expect_lengths_checked(const P& three, const typename P::VolumeType& bad,
                            const std::string& name) {
  P four = three;
  four.add(three.a[0], three.b[0]);
  Hits hits(4);
  EXPECT_EQ(message_of([&] { intersects(three.a, three.b, hits); }),
            "hits: 4 elements for 3 pairs");
  EXPECT_EQ(message_of([&] { intersects(three.a[0], three.b, hits); }),
            "hits: 4 elements for 3 pairs");
  EXPECT_EQ(message_of([&] { intersects(four.a, three.b, hits); }),
            name + " b: 3 elements for 4 " + name + " a");
  EXPECT_THROW(intersects(bad, four.b, hits), InputError);
}

TEST(Law10BoxBatch, LengthsThatDifferAndABadOneAreRefused) {
  AabbPairs boxes;
  KDopPairs kdops;
  ObbPairs oriented;
  for (int n = 0; n < 3; ++n) {
    boxes.add({{0, 0, 0}, {1, 1, 1}}, {{0, 0, 0}, {1, 1, 1}});
    kdops.add({}, {});
    oriented.add({Pose::Identity(), {1, 1, 1}}, {Pose::Identity(), {1, 1, 1}});
  }
  KDop<18> bad_kdop{};
  bad_kdop.min[2] = 1;
  expect_lengths_checked(boxes, Aabb{{2, 0, 0}, {1, 1, 1}}, "boxes");
  expect_lengths_checked(kdops, bad_kdop, "k-DOPs");
  expect_lengths_checked(oriented, Obb{Pose::Identity(), {1, -1, 1}}, "boxes");
}

}  // namespace
}  // namespace graze
