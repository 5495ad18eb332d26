#include <graze/engine/world/compound.h>
#include <graze/engine/world/voxel_map.h>

#include "tests/benchmark/compounds/contestant.h"

namespace graze::benchmark {

namespace {

std::shared_ptr<const BodyShape> shared(const Parts& parts) {
  Compound compound;
  for (const PlacedShape& part : parts)
    compound.add(part);
  return share(compound);
}

class Graze : public BodyContestant {
 public:
  std::string name() const override { return "graze"; }
  void take(const Asked& asked) override {
    asked_ = asked.parts.size() == 1 ? share(asked.parts[0].shape) : shared(asked.parts);
  }
  bool touches(const Pose& pose) override {
    return body_->touches(Pose::Identity(), *asked_, pose);
  }

 protected:
  std::shared_ptr<const BodyShape> body_, asked_;
};

class OfParts final : public Graze {
 public:
  explicit OfParts(const Parts& parts) : parts_(parts) {}
  void build() override {
    body_.reset();
    body_ = shared(parts_);
  }

 private:
  const Parts& parts_;
};

class OfVoxels final : public Graze {
 public:
  explicit OfVoxels(const Voxels& voxels) : voxels_(voxels) {}
  void build() override {
    body_.reset();
    body_ = share(VoxelMap(voxels_));
  }

 private:
  const Voxels& voxels_;
};

}  // namespace

void add_graze(const Parts& parts, Contestants& contestants) {
  contestants.push_back(std::make_unique<OfParts>(parts));
}

void add_graze(const Voxels& voxels, Contestants& contestants) {
  contestants.push_back(std::make_unique<OfVoxels>(voxels));
}

}  // namespace graze::benchmark
