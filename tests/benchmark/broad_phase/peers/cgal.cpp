// CGAL's hybrid of streaming and segment trees (Zomorodian and Edelsbrunner 2002), anew each frame.

#include <CGAL/Box_intersection_d/Box_d.h>
#include <CGAL/box_intersection_d.h>

#include "tests/benchmark/broad_phase/peers/peers.h"

namespace graze::benchmark {
namespace {

class IndexedBox
    : public CGAL::Box_intersection_d::Box_d<double, 3, CGAL::Box_intersection_d::ID_NONE> {
 public:
  IndexedBox(Aabb box, std::uint32_t index)
      : Box_d(box.min.data(), box.max.data()), index_(index) {}
  std::size_t id() const { return index_; }

 private:
  std::uint32_t index_;
};

class Cgal : public Contestant {
 public:
  void start(std::span<const Aabb> boxes) override {
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
      boxes_.emplace_back(boxes[i], i);
  }

  std::span<const BoxPair> step(std::span<const Aabb> boxes,
                                std::span<const std::uint32_t>) override {
    for (IndexedBox& box : boxes_) {
      const auto i = static_cast<std::uint32_t>(box.id());
      box = IndexedBox(boxes[i], i);
    }
    pairs_.clear();
    CGAL::box_self_intersection_d(
        boxes_.begin(), boxes_.end(), [this](const IndexedBox& s, const IndexedBox& t) {
          pairs_.push_back(
              ordered_pair(static_cast<std::uint32_t>(s.id()), static_cast<std::uint32_t>(t.id())));
        });
    return pairs_;
  }

 private:
  std::vector<IndexedBox> boxes_;
  std::vector<BoxPair> pairs_;
};

}  // namespace

void add_cgal(std::vector<Entry>& entries) {
  entries.push_back({"CGAL", [] { return std::make_unique<Cgal>(); }});
}

}  // namespace graze::benchmark
