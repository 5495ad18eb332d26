#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/triangle_box_batch.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/narrowphase/simd_targets.h"
#include "tests/shapes/random_source.h"

namespace graze::narrowphase {
namespace {

struct Element {
  Triangle triangle;
  Aabb box;
};

void scale_by(Triangle& triangle, const Eigen::Vector3d& factors) {
  for (Eigen::Vector3d* corner : {&triangle.a, &triangle.b, &triangle.c})
    *corner = corner->cwiseProduct(factors);
}

/// Moves the box's lowest corner into the triangle's plane or onto the line of an edge, or next to
/// it by as much as the bounds are.
void put_near_triangle(Element& element, const Eigen::Vector3d& box_size, RandomSource& source) {
  const auto& [a, b, c] = element.triangle;
  const bool is_on_edge = source.integer(0, 1) == 0;
  const double s = source.uniform(-0.5, 1.5);
  const double t = is_on_edge ? 0 : source.uniform(-0.5, 1.5);
  const double away = std::ldexp((b - a).norm(), -static_cast<int>(source.integer(40, 54)));
  element.box.min = a + s * (b - a) + t * (c - a) + source.vector(-1, 1) * away;
  element.box.max = element.box.min + box_size;
}

/// Elements of every sort: apart, crossing, touching, nearly so, flat, degenerate, tiny, huge,
/// disordered, not finite.
std::vector<Element> elements_of_every_sort(std::size_t count) {
  RandomSource source(2);
  std::vector<Element> elements;
  for (std::size_t n = 0; n < count; ++n) {
    constexpr double kScales[] = {1, 1, 1e-40, 1e-76, 1e-160, 1e-310, 1e40, 1e150};
    const double scale = kScales[n % 8];
    const auto point = [&]() -> Eigen::Vector3d {
      return (n % 3 == 0 ? source.lattice_point(-2, 2) : source.vector(-1, 1)) * scale;
    };
    Element element{{point(), point(), point()}, {point(), {}}};
    const Eigen::Vector3d q = point();
    element.box.max = n % 19 == 0 ? q : element.box.min.cwiseMax(q);
    if (n % 11 == 0) element.triangle.c = element.triangle.b;
    const Eigen::Vector3d size = source.vector(0, 1) * scale;
    auto& [a, b, c] = element.triangle;
    if (n % 10 == 1) b = 0.5 * (a + c) + 0.1 * b;  // the edge from c to a is the longest
    if (n % 13 == 0) scale_by(element.triangle, {1, 1, 1e4});
    if (n % 29 == 0) scale_by(element.triangle, {1e-100, 1e-100, 1e-100});
    if (n % 5 < 2 || n % 29 == 0) put_near_triangle(element, size, source);
    if (n % 17 == 0) {
      Eigen::Vector3d* corners[3] = {&element.triangle.a, &element.triangle.b, &element.triangle.c};
      (*corners[n % 3])[static_cast<Eigen::Index>(n / 51 % 3)] =
          n % 2 == 0 ? std::nan("") : HUGE_VAL;
    }
    if (n % 23 == 0) element.box.max.z() = n % 2 == 0 ? std::nan("") : HUGE_VAL;
    elements.push_back(element);
  }
  return elements;
}

/// The verdicts of each element alone, of all at once, and of one triangle and one box against all.
struct AllVerdicts {
  std::vector<Verdict> alone, pairs, one_triangle, one_box;

  bool operator==(const AllVerdicts&) const = default;
};

std::vector<Verdict> unpacked(const std::vector<Verdicts>& blocks, std::size_t count) {
  std::vector<Verdict> all;
  for (std::size_t n = 0; n < count; ++n) {
    const Verdicts& block = blocks[n / 8];
    EXPECT_EQ(block.apart & block.touching, 0u);
    all.push_back(verdict_of((block.apart >> n % 8 & 1) != 0, (block.touching >> n % 8 & 1) != 0));
  }
  return all;
}

AllVerdicts all_verdicts(const std::vector<Element>& elements) {
  std::vector<double> columns[15];
  for (const Element& element : elements) {
    const Eigen::Vector3d* points[5] = {&element.triangle.a, &element.triangle.b,
                                        &element.triangle.c, &element.box.min, &element.box.max};
    for (std::size_t i = 0; i < 15; ++i)
      columns[i].push_back(points[i / 3]->data()[i % 3]);
  }
  TriangleRows triangles{{}, elements.size()};
  AabbRows boxes{{}, elements.size()};
  for (std::size_t i = 0; i < 9; ++i)
    triangles.row[i] = columns[i].data();
  for (std::size_t i = 0; i < 6; ++i)
    boxes.row[i] = columns[9 + i].data();
  EXPECT_TRUE(boxes[1].min == elements[1].box.min);
  std::vector<Verdicts> blocks((elements.size() + 7) / 8);
  AllVerdicts all;
  for (const Element& element : elements)
    all.alone.push_back(triage(element.triangle, element.box));
  triage(triangles, boxes, blocks.data());
  all.pairs = unpacked(blocks, elements.size());
  triage(elements[1].triangle, boxes, blocks.data());
  all.one_triangle = unpacked(blocks, elements.size());
  triage(elements[1].box, triangles, blocks.data());
  all.one_box = unpacked(blocks, elements.size());
  return all;
}

TEST(Law8TriangleBox, EverySimdTargetGivesTheSameVerdicts) {
  const std::vector<Element> elements = elements_of_every_sort(20005);
  const AllVerdicts expected = all_verdicts(elements);
  for (std::int64_t target : simd_targets()) {
    force_simd_target(target);
    EXPECT_EQ(all_verdicts(elements), expected) << hwy::TargetName(target);
  }
  force_simd_target(0);
}

/// One element at a time looks besides for a vertex in the box: it may know more, never less.
bool agrees(Verdict of_many, Verdict of_one) {
  return of_many == of_one || (of_many == Verdict::Unsure && of_one == Verdict::Yes);
}

TEST(Law6TriangleBox, ManyAtOnceAreJudgedAsEachAlone) {
  const std::vector<Element> elements = elements_of_every_sort(20005);
  const AllVerdicts all = all_verdicts(elements);
  std::size_t touching = 0, apart = 0;
  for (std::size_t n = 0; n < elements.size(); ++n) {
    const auto& [triangle, box] = elements[n];
    ASSERT_TRUE(agrees(all.pairs[n], all.alone[n])) << n;
    ASSERT_TRUE(agrees(all.one_triangle[n], triage(elements[1].triangle, box))) << n;
    ASSERT_TRUE(agrees(all.one_box[n], triage(triangle, elements[1].box))) << n;
    touching += all.pairs[n] == Verdict::Yes;
    apart += all.pairs[n] == Verdict::No;
  }
  EXPECT_GT(touching, 500u);
  EXPECT_GT(apart, 5000u);
}

TEST(Law10TriangleBox, WhatIsNotABoxIsNeverSure) {
  const Triangle triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Triangle far{{9, 9, 9}, {8, 9, 9}, {9, 8, 9}};
  for (const Triangle& t : {triangle, far}) {
    for (int k = 0; k < 3; ++k) {
      Aabb box{{-1, -1, -1}, {1, 1, 1}};
      box.min[k] = std::nextafter(1.0, 2.0);
      EXPECT_EQ(triage(t, box), Verdict::Unsure);
      box.min[k] = -HUGE_VAL;
      EXPECT_EQ(triage(t, box), Verdict::Unsure);
      box.max[k] = std::nan("");
      EXPECT_EQ(triage(t, box), Verdict::Unsure);
    }
  }
}

}  // namespace
}  // namespace graze::narrowphase
