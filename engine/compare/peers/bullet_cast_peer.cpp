// Asks Bullet's other casts, engines beside "bullet", which casts by advancement as its worlds do.
// They know convex shapes that do not turn, and motions alone.

#include <graze/engine/compare/peers/adaptors.h>
#include <graze/engine/compare/peers/bullet_casts.h>

#include <LinearMath/btScalar.h>
#include <string>

namespace graze::compare {
namespace {

class NoMeshes : public LoadedPair {
 public:
  std::optional<CaseAnswer> answer(const Question&, const Pose&, const Pose&) const override {
    return std::nullopt;
  }
};

class BulletCastShapes : public LoadedShapes {
 public:
  BulletCastShapes(std::span<const Shape> shapes, BulletCast how) : casts_(shapes, how) {}

  std::optional<bool> intersects(std::size_t, const Pose&, std::size_t,
                                 const Pose&) const override {
    return std::nullopt;
  }
  std::optional<CaseAnswer> answer(const Question& question, const PlacedShape& a,
                                   const PlacedShape& b) const override {
    return casts_.answer(question, a, b);
  }

 private:
  BulletCasts casts_;
};

class BulletCastEngine : public Engine {
 public:
  BulletCastEngine(std::string name, BulletCast how) : name_(std::move(name)), how_(how) {}
  CaseWitness name() const override { return {name_, std::to_string(btGetVersion())}; }
  std::optional<std::vector<Ask>> questions() const override {
    return std::vector<Ask>{Ask::FirstContact, Ask::Free};
  }
  std::unique_ptr<LoadedPair> load(const Mesh&, const Mesh&) const override {
    return std::make_unique<NoMeshes>();
  }
  std::unique_ptr<LoadedShapes> load_shapes(std::span<const Shape> shapes) const override {
    return std::make_unique<BulletCastShapes>(shapes, how_);
  }

 private:
  std::string name_;
  BulletCast how_;
};

}  // namespace

std::unique_ptr<Engine> make_bullet_cast_engine(const std::string& name) {
  if (name == "bullet-subsimplex")
    return std::make_unique<BulletCastEngine>(name, BulletCast::Subsimplex);
  if (name == "bullet-gjk") return std::make_unique<BulletCastEngine>(name, BulletCast::Gjk);
  return nullptr;
}

}  // namespace graze::compare
