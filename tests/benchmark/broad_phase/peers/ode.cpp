// ODE's hash space. Its boxes are centres and lengths in double, which these floats survive; each
// candidate is tested all the same.

#include <ode/ode.h>

#include "tests/benchmark/broad_phase/peers/peers.h"

namespace graze::benchmark {
namespace {

class Ode : public Contestant {
 public:
  Ode() {
    dInitODE2(0);
    space_ = dHashSpaceCreate(nullptr);
    dHashSpaceSetLevels(space_, -8, 12);
  }
  ~Ode() override {
    dSpaceDestroy(space_);
    dCloseODE();
  }

  void start(std::span<const Aabb> boxes) override {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const Eigen::Vector3d side = boxes[i].max - boxes[i].min;
      geoms_.push_back(dCreateBox(space_, side[0], side[1], side[2]));
      dGeomSetData(geoms_.back(), reinterpret_cast<void*>(i));
      place(i, boxes[i]);
    }
  }

  std::span<const BoxPair> step(std::span<const Aabb> boxes,
                                std::span<const std::uint32_t> moved) override {
    for (const std::uint32_t i : moved)
      place(i, boxes[i]);
    pairs_.clear();
    boxes_ = boxes;
    dSpaceCollide(space_, this, [](void* self, dGeomID s, dGeomID t) {
      static_cast<Ode*>(self)->meet(index(s), index(t));
    });
    return pairs_;
  }

 private:
  static std::uint32_t index(dGeomID geom) {
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(dGeomGetData(geom)));
  }
  void place(std::size_t i, const Aabb& box) {
    const Eigen::Vector3d side = box.max - box.min;
    const Eigen::Vector3d centre = 0.5 * (box.min + box.max);
    dGeomBoxSetLengths(geoms_[i], side[0], side[1], side[2]);
    dGeomSetPosition(geoms_[i], centre[0], centre[1], centre[2]);
  }
  void meet(std::uint32_t s, std::uint32_t t) {
    if (share_point(boxes_[s], boxes_[t])) pairs_.push_back(ordered_pair(s, t));
  }

  dSpaceID space_;
  std::vector<dGeomID> geoms_;
  std::span<const Aabb> boxes_;
  std::vector<BoxPair> pairs_;
};

}  // namespace

void add_ode(std::vector<Entry>& entries) {
  entries.push_back({"ODE hash space", [] { return std::make_unique<Ode>(); }});
}

}  // namespace graze::benchmark
