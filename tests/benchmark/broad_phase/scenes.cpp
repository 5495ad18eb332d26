#include "tests/benchmark/broad_phase/scenes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace graze::benchmark {

using Eigen::Vector3d;

std::uint64_t Random::bits() {
  std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 27) * 0x94d049bb133111ebu;
  return z ^ z >> 31;
}

double Random::unit() {
  return static_cast<double>(bits() >> 11) * 0x1p-53;
}

double Random::between(double low, double high) {
  return low + (high - low) * unit();
}

double Random::bell() {
  double sum = 0;
  for (int i = 0; i < 12; ++i)
    sum += unit();
  return std::clamp(sum - 6, -3.0, 3.0);
}

Vector3d Random::point(double half) {
  Vector3d p;
  for (int c = 0; c < 3; ++c)
    p[c] = between(-half, half);
  return p;
}

void Scene::place(std::uint32_t i, const Vector3d& centre, const Vector3d& half) {
  const Vector3d low = centre - half, high = centre + half;
  boxes_[i] = {low.cast<float>().cast<double>(), high.cast<float>().cast<double>()};
}

void Scene::all_move() {
  moved_.resize(boxes_.size());
  for (std::uint32_t i = 0; i < moved_.size(); ++i)
    moved_[i] = i;
}

namespace {

/// Keeps a centre within the cube by stepping back from its walls.
void reflect(Vector3d& centre, double half) {
  for (int c = 0; c < 3; ++c) {
    if (centre[c] > half) centre[c] = 2 * half - centre[c];
    if (centre[c] < -half) centre[c] = -2 * half - centre[c];
  }
}

class Brownian : public Scene {
 public:
  Brownian(std::uint32_t count, std::uint64_t seed, std::uint32_t one_in)
      : random_(seed), half_world_(0.5 * std::cbrt(2.0 * count)), one_in_(one_in) {
    boxes_.resize(count), centre_.resize(count), half_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      centre_[i] = random_.point(half_world_);
      for (int c = 0; c < 3; ++c)
        half_[i][c] = random_.between(0.25, 0.75);
      place(i, centre_[i], half_[i]);
    }
  }
  void next_frame() override {
    if (one_in_ == 1) {
      all_move();
    } else {
      moved_.clear();
      for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
        if (random_.bits() % one_in_ == 0) moved_.push_back(i);
      }
    }
    for (const std::uint32_t i : moved_) {
      centre_[i] += random_.point(0.1);
      reflect(centre_[i], half_world_);
      place(i, centre_[i], half_[i]);
    }
  }

 private:
  Random random_;
  double half_world_;
  std::uint32_t one_in_;
  std::vector<Vector3d> centre_, half_;
};

class Pile : public Scene {
 public:
  Pile(std::uint32_t count, std::uint64_t seed) : random_(seed) {
    const double layers = 10;
    half_floor_ = 0.5 * std::sqrt(count / layers);
    boxes_.resize(count), centre_.resize(count), half_.resize(count);
    centre_[0] = Vector3d(0, 0, -1);
    half_[0] = Vector3d(half_floor_ + 10, half_floor_ + 10, 1);
    place(0, centre_[0], half_[0]);
    for (std::uint32_t i = 1; i < count; ++i) {
      half_[i] = Vector3d::Constant(0.5) * random_.between(0.9, 1.1);
      drop(i);
      if (!falls(i)) centre_[i].z() = 0.5 + 0.98 * static_cast<double>(random_.bits() % 10);
      place(i, centre_[i], half_[i]);
    }
  }
  void next_frame() override {
    moved_.clear();
    for (std::uint32_t i = 1; i < boxes_.size(); ++i) {
      if (!falls(i)) continue;
      centre_[i].z() -= 0.1;
      if (centre_[i].z() < 0.5) drop(i);
      place(i, centre_[i], half_[i]);
      moved_.push_back(i);
    }
  }

 private:
  static bool falls(std::uint32_t i) { return i % 20 < 3; }
  void drop(std::uint32_t i) {
    centre_[i] = random_.point(half_floor_);
    centre_[i].z() = random_.between(0.5, 30);
  }
  Random random_;
  double half_floor_;
  std::vector<Vector3d> centre_, half_;
};

class Decades : public Scene {
 public:
  Decades(std::uint32_t count, std::uint64_t seed)
      : random_(seed), half_world_(0.5 * std::cbrt(30.0 * count)) {
    boxes_.resize(count), centre_.resize(count), half_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      centre_[i] = random_.point(half_world_);
      const double size = 0.005 * std::pow(10.0, 3 * random_.unit());
      for (int c = 0; c < 3; ++c)
        half_[i][c] = size * random_.between(0.5, 1);
      place(i, centre_[i], half_[i]);
    }
  }
  void next_frame() override {
    all_move();
    for (const std::uint32_t i : moved_) {
      centre_[i] += random_.point(0.2 * half_[i].maxCoeff());
      reflect(centre_[i], half_world_);
      place(i, centre_[i], half_[i]);
    }
  }

 private:
  Random random_;
  double half_world_;
  std::vector<Vector3d> centre_, half_;
};

class Clusters : public Scene {
 public:
  Clusters(std::uint32_t count, std::uint64_t seed)
      : random_(seed), half_world_(0.5 * std::cbrt(20.0 * count)) {
    boxes_.resize(count), offset_.resize(count), half_.resize(count);
    const std::uint32_t clusters = std::max(2u, count / kMembers);
    for (std::uint32_t k = 0; k < clusters; ++k) {
      centre_.push_back(random_.point(half_world_));
      velocity_.push_back(random_.point(2));
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      for (int c = 0; c < 3; ++c)
        offset_[i][c] = 2.5 * random_.bell();
      half_[i] = Vector3d::Constant(random_.between(0.25, 0.75));
      place(i, centre_[i % clusters] + offset_[i], half_[i]);
    }
  }
  void next_frame() override {
    all_move();
    for (std::size_t k = 0; k < centre_.size(); ++k) {
      centre_[k] += velocity_[k];
      for (int c = 0; c < 3; ++c) {
        if (std::abs(centre_[k][c]) > half_world_)
          velocity_[k][c] = -std::copysign(velocity_[k][c], centre_[k][c]);
      }
    }
    for (const std::uint32_t i : moved_) {
      offset_[i] += random_.point(0.05);
      place(i, centre_[i % centre_.size()] + offset_[i], half_[i]);
    }
  }

 private:
  static constexpr std::uint32_t kMembers = 500;
  Random random_;
  double half_world_;
  std::vector<Vector3d> centre_, velocity_, offset_, half_;
};

class Replaced : public Scene {
 public:
  Replaced(std::uint32_t count, std::uint64_t seed, std::uint32_t one_in)
      : random_(seed), half_world_(0.5 * std::cbrt(2.0 * count)), one_in_(one_in) {
    boxes_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i)
      place_anywhere(i);
  }
  void next_frame() override {
    const auto count = static_cast<std::uint32_t>(boxes_.size());
    moved_.clear();
    for (std::uint32_t k = 0; k < count / one_in_; ++k)
      moved_.push_back(static_cast<std::uint32_t>(random_.bits() % count));
    std::sort(moved_.begin(), moved_.end());
    moved_.erase(std::unique(moved_.begin(), moved_.end()), moved_.end());
    for (const std::uint32_t i : moved_)
      place_anywhere(i);
  }
  Change change() const override { return Change::IsReplaced; }

 private:
  void place_anywhere(std::uint32_t i) {
    const Vector3d centre = random_.point(half_world_);
    Vector3d half;
    for (int c = 0; c < 3; ++c)
      half[c] = random_.between(0.25, 0.75);
    place(i, centre, half);
  }
  Random random_;
  double half_world_;
  std::uint32_t one_in_;
};

}  // namespace

std::unique_ptr<Scene> make_scene(const std::string& name, std::uint32_t count,
                                  std::uint64_t seed) {
  if (name == "S1") return std::make_unique<Brownian>(count, seed, 1);
  if (name == "S2") return std::make_unique<Pile>(count, seed);
  if (name == "S3") return std::make_unique<Brownian>(count, seed, 100);
  if (name == "S4") return std::make_unique<Decades>(count, seed);
  if (name == "S5") return std::make_unique<Clusters>(count, seed);
  if (name[0] == 'R')
    return std::make_unique<Replaced>(count, seed,
                                      static_cast<std::uint32_t>(std::stoul(name.substr(1))));
  throw std::invalid_argument("unknown scene " + name);
}

}  // namespace graze::benchmark
