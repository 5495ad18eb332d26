#include "tests/compare/answer_mutants.h"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace graze::compare {
namespace {

using Eigen::Vector3d;

/// How far points are moved, metres.
constexpr std::array kShifts = {1e-3, 0.05, 30.0};

class Spoiler {
 public:
  Spoiler(const CaseAnswer& answer, RandomSource& source) : answer_(answer), source_(source) {}

  std::vector<AnswerMutant> take() {
    spoil_values();
    if (answer_.contacts) spoil_contacts(&CaseAnswer::contacts, "contacts");
    if (answer_.manifold) spoil_contacts(&CaseAnswer::manifold, "manifold");
    if (answer_.hits && !answer_.hits->empty()) spoil_hits();
    if (answer_.pairs) spoil_list(&CaseAnswer::pairs, "pairs");
    if (answer_.triangles) spoil_list(&CaseAnswer::triangles, "triangles");
    if (answer_.corners && !answer_.corners->empty()) spoil_corners();
    if (answer_.intersection && !answer_.intersection->points.empty()) spoil_intersection();
    return std::move(mutants_);
  }

 private:
  void add(const std::string& what, const std::function<void(CaseAnswer&)>& spoil) {
    CaseAnswer answer = answer_;
    spoil(answer);
    if (!is_same(answer, answer_)) mutants_.push_back({what, std::move(answer)});
  }

  Vector3d any_way(double length) {
    Vector3d way;
    do
      way = source_.vector(-1, 1);
    while (way.norm() < 0.1 || way.norm() > 1);
    return length * way.normalized();
  }

  std::size_t any_of(std::size_t count) {
    return static_cast<std::size_t>(source_.integer(0, static_cast<int>(count) - 1));
  }

  void shift(const std::string& what, const std::function<Vector3d&(CaseAnswer&)>& point) {
    for (const double length : kShifts) {
      const Vector3d way = any_way(length);
      add(what + " moved by " + std::to_string(length), [&](CaseAnswer& a) { point(a) += way; });
    }
  }

  void spoil_values() {
    if (answer_.says) add("says: the opposite", [](CaseAnswer& a) { a.says = !*a.says; });
    if (answer_.distance) {
      add("distance: negated", [](CaseAnswer& a) { *a.distance *= -1; });
      add("distance: half as long again", [](CaseAnswer& a) { *a.distance *= 1.5; });
      add("distance: three quarters", [](CaseAnswer& a) { *a.distance *= 0.75; });
      add("distance: a millimetre more", [](CaseAnswer& a) { *a.distance += 1e-3; });
    }
    if (answer_.lower_bound)
      add("lower bound: too high", [](CaseAnswer& a) { *a.lower_bound += 1e-3; });
    if (answer_.normal) {
      add("normal: reversed", [](CaseAnswer& a) { *a.normal *= -1; });
      add("normal: longer", [](CaseAnswer& a) { *a.normal *= 1.01; });
    }
    if (answer_.point_a && answer_.point_b) {
      shift("point_a", [](CaseAnswer& a) -> Vector3d& { return *a.point_a; });
      shift("point_b", [](CaseAnswer& a) -> Vector3d& { return *a.point_b; });
      add("points: swapped", [](CaseAnswer& a) { std::swap(a.point_a, a.point_b); });
    }
    if (answer_.pair) {
      add("pair: swapped", [](CaseAnswer& a) { std::swap(a.pair->a, a.pair->b); });
      add("pair: another", [](CaseAnswer& a) { a.pair->a = a.pair->a == 0 ? 1 : a.pair->a - 1; });
    }
    if (answer_.translation) {
      add("translation: negated", [](CaseAnswer& a) { *a.translation *= -1; });
      add("translation: longer", [](CaseAnswer& a) { *a.translation *= 1.25; });
      add("translation: shorter", [](CaseAnswer& a) { *a.translation *= 0.75; });
      add("translation and distance: shorter", [](CaseAnswer& a) {
        *a.translation *= 0.75;
        *a.distance *= 0.75;
      });
      add("translation and distance: longer", [](CaseAnswer& a) {
        *a.translation *= 1.25;
        *a.distance *= 1.25;
      });
    }
  }

  template <typename List>
  void spoil_contacts(List CaseAnswer::*list, const std::string& name) {
    if ((answer_.*list)->empty()) return;
    const std::size_t i = any_of((answer_.*list)->size());
    const auto at = [&](CaseAnswer & a) -> auto& {
      return (*(a.*list))[i];
    };
    add(name + ": normal reversed", [&](CaseAnswer& a) { at(a).normal *= -1; });
    add(name + ": all normals reversed", [&](CaseAnswer& a) {
      for (auto& c : *(a.*list))
        c.normal *= -1;
    });
    add(name + ": normal longer", [&](CaseAnswer& a) { at(a).normal *= 1.01; });
    add(name + ": normal turned",
        [&](CaseAnswer& a) { at(a).normal = (at(a).normal + any_way(0.1)).normalized(); });
    add(name + ": depth negated", [&](CaseAnswer& a) { at(a).depth *= -1; });
    add(name + ": depth -0.5", [&](CaseAnswer& a) { at(a).depth = -0.5; });
    add(name + ": depths doubled", [&](CaseAnswer& a) {
      for (auto& c : *(a.*list))
        c.depth *= 2;
    });
    add(name + ": depths halved", [&](CaseAnswer& a) {
      for (auto& c : *(a.*list))
        c.depth /= 2;
    });
    shift(name + ": point", [&](CaseAnswer& a) -> Vector3d& { return at(a).point; });
    add(name + ": points swapped", [&](CaseAnswer& a) { std::swap(at(a).point_a, at(a).point_b); });
    add(name + ": thrice", [&](CaseAnswer& a) {
      const auto c = at(a);
      (a.*list)->insert((a.*list)->end(), 2, c);
    });
    add(name + ": none", [&](CaseAnswer& a) { (a.*list)->clear(); });
    add(name + ": the first left out",
        [&](CaseAnswer& a) { (a.*list)->erase((a.*list)->begin()); });
  }

  void spoil_hits() {
    const auto first = [](CaseAnswer& a) -> RayHit& { return a.hits->front(); };
    add("hits: distance longer", [&](CaseAnswer& a) { first(a).distance *= 1.001; });
    add("hits: distance shorter", [&](CaseAnswer& a) { first(a).distance *= 0.999; });
    add("hits: distance negated", [&](CaseAnswer& a) { first(a).distance *= -1; });
    shift("hits: point", [&](CaseAnswer& a) -> Vector3d& { return first(a).point; });
    add("hits: normal reversed", [&](CaseAnswer& a) { first(a).normal *= -1; });
    add("hits: normal longer", [&](CaseAnswer& a) { first(a).normal *= 1.01; });
    add("hits: normal turned",
        [&](CaseAnswer& a) { first(a).normal = (first(a).normal + any_way(0.1)).normalized(); });
    add("hits: another triangle", [&](CaseAnswer& a) { ++first(a).triangle; });
    add("hits: none", [&](CaseAnswer& a) { a.hits->clear(); });
    add("hits: the last left out", [&](CaseAnswer& a) { a.hits->pop_back(); });
    add("hits: twice", [&](CaseAnswer& a) { a.hits->push_back(a.hits->back()); });
  }

  template <typename List>
  void spoil_list(List CaseAnswer::*list, const std::string& name) {
    if ((answer_.*list)->empty()) return;
    add(name + ": none", [&](CaseAnswer& a) { (a.*list)->clear(); });
    const std::size_t i = any_of((answer_.*list)->size());
    const auto place = [i](auto& values) {
      return values.begin() + static_cast<std::ptrdiff_t>(i);
    };
    add(name + ": one left out", [&](CaseAnswer& a) { (a.*list)->erase(place(*(a.*list))); });
    add(name + ": one twice", [&](CaseAnswer& a) {
      const auto value = (*(a.*list))[i];
      (a.*list)->insert(place(*(a.*list)), value);
    });
    add(name + ": backwards",
        [&](CaseAnswer& a) { std::reverse((a.*list)->begin(), (a.*list)->end()); });
  }

  void spoil_corners() {
    const std::size_t i = any_of(answer_.corners->size());
    shift("corners: one", [i](CaseAnswer& a) -> Vector3d& { return (*a.corners)[i]; });
    add("corners: none", [](CaseAnswer& a) { a.corners->clear(); });
    add("corners: one left out", [i](CaseAnswer& a) {
      a.corners->erase(a.corners->begin() + static_cast<std::ptrdiff_t>(i));
    });
  }

  void spoil_intersection() {
    const std::size_t i = any_of(answer_.intersection->points.size());
    shift("intersection: a point",
          [i](CaseAnswer& a) -> Vector3d& { return a.intersection->points[i].position; });
    add("intersection: none", [](CaseAnswer& a) { a.intersection.emplace(); });
    add("intersection: no curves", [](CaseAnswer& a) { a.intersection->curves.clear(); });
    add("intersection: no patches", [](CaseAnswer& a) { a.intersection->patches.clear(); });
    add("intersection: no touching points",
        [](CaseAnswer& a) { a.intersection->touching_points.clear(); });
  }

  const CaseAnswer& answer_;
  RandomSource& source_;
  std::vector<AnswerMutant> mutants_;
};

}  // namespace

std::vector<AnswerMutant> mutants_of(const CaseAnswer& answer, RandomSource& source) {
  return Spoiler(answer, source).take();
}

}  // namespace graze::compare
