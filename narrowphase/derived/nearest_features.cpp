#include <graze/narrowphase/derived/nearest_features.h>
#include <graze/narrowphase/derived/optimality.h>
#include <algorithm>
#include <cassert>

namespace graze::narrowphase {
namespace {

/// A claim holds where its sign is surely positive: then the pair of nearest points is unique, and
/// the triangles, which a plane separates strictly, do not meet.
struct SureProof {
  bool has_length(Step) const { return true; }
  bool holds_dot(Step p, Step q) const { return dot_filter(p, q) == Sign::Positive; }
  bool holds_triple(Step p, Step q, Step r) const {
    return triple_filter(p, q, r) == Sign::Positive;
  }
  bool holds_cross_products(Step p, Step q, Step r, Step s) const {
    return crosses_filter(p, q, r, s) == Sign::Positive;
  }
  Sign side(Step p, Step q, Step r) const { return triple_filter(p, q, r).value_or(Sign::Zero); }
};

struct ExactProof {
  bool has_length(Step p) const { return !std::equal(p.from, p.from + 3, p.to); }
  bool holds_dot(Step p, Step q) const { return sign_of_dot(p, q) != Sign::Negative; }
  bool holds_triple(Step p, Step q, Step r) const {
    return sign_of_triple(p, q, r) != Sign::Negative;
  }
  bool holds_cross_products(Step p, Step q, Step r, Step s) const {
    return sign_of_cross_products(p, q, r, s) != Sign::Negative;
  }
  Sign side(Step p, Step q, Step r) const { return sign_of_triple(p, q, r); }
};

template <typename Proof>
bool are_nearest(const Proof& proof, const OrderedTriangles& t, const FeaturePair& pair) {
  const bool is_vertex_a = pair.kind_a == Feature::Vertex;
  const bool is_vertex_b = pair.kind_b == Feature::Vertex;
  if (is_vertex_a && is_vertex_b) {
    return are_nearest_vertices(proof, t.a, pair.index_a, t.b, pair.index_b);
  }
  if (pair.kind_a == Feature::Face)
    return are_nearest_vertex_and_face(proof, t.b, pair.index_b, t.a);
  if (pair.kind_b == Feature::Face)
    return are_nearest_vertex_and_face(proof, t.a, pair.index_a, t.b);
  if (is_vertex_a) return are_nearest_vertex_and_edge(proof, t.a, pair.index_a, t.b, pair.index_b);
  if (is_vertex_b) return are_nearest_vertex_and_edge(proof, t.b, pair.index_b, t.a, pair.index_a);
  return are_nearest_edges(proof, t.a, pair.index_a, t.b, pair.index_b);
}

/// Asks each pair of features that may hold a pair of nearest points: the corners of the set of all
/// such pairs do.
template <typename OnPair>
bool any_feature_pair(OnPair&& on_pair) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (on_pair({Feature::Vertex, i, Feature::Vertex, j})) return true;
      if (on_pair({Feature::Vertex, i, Feature::Edge, j})) return true;
      if (on_pair({Feature::Edge, i, Feature::Vertex, j})) return true;
    }
  }
  for (int i = 0; i < 3; ++i) {
    if (on_pair({Feature::Vertex, i, Feature::Face, 0})) return true;
    if (on_pair({Feature::Face, 0, Feature::Vertex, i})) return true;
    for (int j = 0; j < 3; ++j) {
      if (on_pair({Feature::Edge, i, Feature::Edge, j})) return true;
    }
  }
  return false;
}

}  // namespace

std::optional<FeaturePair> find_surely_nearest(const OrderedTriangles& triangles) {
  const FeaturePair guess = guess_nearest(triangles);
  if (are_nearest(SureProof(), triangles, guess)) return guess;
  return std::nullopt;
}

FeaturePair find_nearest_exactly(const OrderedTriangles& triangles) {
  FeaturePair found{};
  const bool is_found = any_feature_pair([&](const FeaturePair& pair) {
    found = pair;
    return are_nearest(ExactProof(), triangles, pair);
  });
  assert(is_found);
  static_cast<void>(is_found);
  return found;
}

}  // namespace graze::narrowphase
