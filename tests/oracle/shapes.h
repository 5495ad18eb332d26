#pragma once

#include <Eigen/Geometry>
#include <array>

#include <graze/bvh/aabb.h>
#include <graze/narrowphase/triangle.h>
#include <tests/oracle/sampler.h>

// Small helpers that every family of the corpus shares. Each rounds as doubles do: a generator that
// needs an exact result must choose numbers for which nothing is rounded.

namespace graze::oracle {

struct TrianglePair {
  Triangle a;
  Triangle b;
};

struct TriangleAndBox {
  Triangle triangle;
  Aabb box;
};

/// The function applied to each vertex.
template <typename Function>
Triangle for_each_vertex(const Triangle& t, Function function) {
  Triangle result;
  result.a = function(t.a);
  result.b = function(t.b);
  result.c = function(t.c);
  return result;
}

Triangle moved(const Triangle& t, const Eigen::Vector3d& by);
TrianglePair moved(const TrianglePair& pair, const Eigen::Vector3d& by);
TriangleAndBox moved(const TriangleAndBox& pair, const Eigen::Vector3d& by);
Triangle scaled(const Triangle& t, double factor);
TrianglePair scaled(const TrianglePair& pair, double factor);
TriangleAndBox scaled(const TriangleAndBox& pair, double factor);

/// Coordinate i becomes coordinate (i + turns) % 3.
Eigen::Vector3d turned(const Eigen::Vector3d& p, int turns);
Triangle turned(const Triangle& t, int turns);
TrianglePair turned(const TrianglePair& pair, int turns);
TriangleAndBox turned(const TriangleAndBox& pair, int turns);

/// Turned by a random number of axes.
template <typename Element>
Element turned(Sampler& sampler, const Element& element) {
  return turned(element, sampler.integer(0, 2));
}

/// a + s (b - a) + t (c - a).
Eigen::Vector3d point_at(const Triangle& t, double weight_b, double weight_c);

/// A box with these opposite corners, in any order.
Aabb box_between(const Eigen::Vector3d& p, const Eigen::Vector3d& q);

std::array<Eigen::Vector3d, 8> corners(const Aabb& box);

}  // namespace graze::oracle
