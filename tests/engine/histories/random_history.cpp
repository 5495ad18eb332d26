#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/engine/broad_phase/box_histories.h"
#include "tests/engine/histories/history.h"

namespace graze::tests {
namespace {

using Eigen::Vector3d;
using test::Chance;

/// A closed surface of 8 * 4^level triangles: an octahedron divided, its corners on a ball.
Mesh ball_mesh(double radius, int level) {
  std::vector<Vector3d> corners{{1, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  std::vector<TriangleIndices> faces{{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2},
                                     {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}};
  const auto between = [&](std::uint32_t a, std::uint32_t b) {
    const Vector3d sum = corners[a] + corners[b];
    const double length = std::sqrt(sum.x() * sum.x() + sum.y() * sum.y() + sum.z() * sum.z());
    const Vector3d point(sum.x() / length, sum.y() / length, sum.z() / length);
    const auto found = std::find(corners.begin(), corners.end(), point);
    if (found == corners.end()) corners.push_back(point);
    return static_cast<std::uint32_t>(std::find(corners.begin(), corners.end(), point) -
                                      corners.begin());
  };
  for (; level > 0; --level) {
    std::vector<TriangleIndices> finer;
    for (const auto& [a, b, c] : faces) {
      const std::uint32_t ab = between(a, b), bc = between(b, c), ca = between(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    faces = finer;
  }
  for (Vector3d& corner : corners)
    corner *= radius;
  return Mesh(corners, faces);
}

/// An open surface of 2 * cells^2 triangles, whole heights 0 and 1.
Mesh plate_mesh(double size, std::uint32_t cells) {
  std::vector<Vector3d> corners;
  std::vector<TriangleIndices> faces;
  for (std::uint32_t y = 0; y <= cells; ++y) {
    for (std::uint32_t x = 0; x <= cells; ++x)
      corners.emplace_back(size * x, size * y, size * ((x * y) % 3 == 1 ? 0.25 : 0));
  }
  for (std::uint32_t y = 0; y < cells; ++y) {
    for (std::uint32_t x = 0; x < cells; ++x) {
      const std::uint32_t at = y * (cells + 1) + x;
      faces.push_back({at, at + 1, at + cells + 2});
      faces.push_back({at, at + cells + 2, at + cells + 1});
    }
  }
  return Mesh(corners, faces);
}

ConvexHull corners_of_box(double x, double y, double z) {
  return ConvexHull(std::vector<Vector3d>{{x, y, z},
                                          {x, y, -z},
                                          {x, -y, z},
                                          {x, -y, -z},
                                          {-x, y, z},
                                          {-x, y, -z},
                                          {-x, -y, z},
                                          {-x, -y, -z}});
}

void add_kinds(std::vector<Shape>& shapes, double s) {
  const std::vector<Vector3d> octahedron{{s, 0, 0},  {0, s, 0},  {0, 0, s},
                                         {-s, 0, 0}, {0, -s, 0}, {0, 0, -s}};
  shapes.insert(shapes.end(),
                {Sphere{{0, 0, 0}, s}, Sphere{{0.5 * s, 0, -s}, 0.5 * s}, Box{{s, s, s}},
                 Box{{0.5 * s, s, 2 * s}}, Capsule{0.5 * s, s}, Cylinder{s, s}, Cone{s, s},
                 Ellipsoid{{0, 0, 0}, {s, 0.5 * s, s}}, ConvexHull(octahedron),
                 corners_of_box(s, s, 0.5 * s), ball_mesh(s, 1), plate_mesh(0.5 * s, 4)});
}

/// Five by four heights on a lattice: steps, a flat part, slopes.
HeightField terrain(double size, bool has_floats) {
  std::vector<float> floats;
  std::vector<std::uint16_t> shorts;
  for (std::uint32_t row = 0; row < 4; ++row) {
    for (std::uint32_t column = 0; column < 5; ++column) {
      const std::uint32_t height = (row * column) % 3 == 1 ? 2 : column > 3 ? 1 : 0;
      floats.push_back(static_cast<float>(height));
      shorts.push_back(static_cast<std::uint16_t>(height));
    }
  }
  const HeightFieldSettings settings{
      .spacing_x = size, .spacing_y = size, .height_scale = size / 4};
  return has_floats ? HeightField(5, 4, floats, settings) : HeightField(5, 4, shorts, settings);
}

class Author {
 public:
  Author(Setting setting, std::uint64_t seed)
      : setting_(setting),
        chance_(seed),
        shape_count_(static_cast<std::uint32_t>(palette_of(setting).size())) {}

  History write(std::size_t count) {
    History history{setting_, {}};
    std::vector<Operation>& all = history.operations;
    while (all.size() < count) {
      const std::uint32_t changes = chance_.one_in(12) ? chance_.below(40) : chance_.below(5);
      for (std::uint32_t i = 0; i < changes; ++i)
        change(all);
      if (chance_.one_in(6)) ask(all);
      all.push_back({.verb = Verb::Update});
      if (chance_.one_in(40)) save(all);
      if (chance_.one_in(80) && saved_once_) restore(all);
    }
    all.resize(count);
    return history;
  }

 private:
  struct Being {
    std::uint32_t name;
    Pose pose;
  };

  void change(std::vector<Operation>& all) {
    const std::uint32_t what = chance_.below(40);
    if (beings_.size() < 4 || (what < 4 && beings_.size() < 36)) return add(all);
    Being& being = beings_[chance_.below(static_cast<std::uint32_t>(beings_.size()))];
    Operation next{.body = being.name};
    switch (what) {
      case 4:
      case 5:
        next.verb = Verb::Remove;
        being = beings_.back();
        beings_.pop_back();
        break;
      case 6:
        next.verb = Verb::SetFilter;
        next.settings.filter = random_filter();
        break;
      case 7:
        next.verb = Verb::SetMotion;
        next.settings.kind = random_motion();
        break;
      case 8:
        next.verb = Verb::SetRole;
        next.settings.role = random_role();
        break;
      case 9:
        next.verb = Verb::SetShape;
        next.number = chance_.below(shape_count_);
        break;
      case 10:
      case 11:
        next.verb = chance_.one_in(3) ? Verb::Include : Verb::Exclude;
        next.number = beings_[chance_.below(static_cast<std::uint32_t>(beings_.size()))].name;
        break;
      case 12:
        next.verb = chance_.one_in(2) ? Verb::Sleep : Verb::Wake;
        break;
      case 13:
        if (!chance_.one_in(10)) return;
        next.verb = Verb::FilterPairs;
        next.body = 0;
        next.number = chance_.one_in(2) ? 0 : 2 + chance_.below(4);
        break;
      default: {
        const bool follows =
            !all.empty() && (all.back().verb == Verb::Move || all.back().verb == Verb::MoveToo);
        next.verb = follows && chance_.one_in(3) ? Verb::MoveToo : Verb::Move;
        next.pose = being.pose = chance_.one_in(6) ? random_pose() : stepped(being.pose);
      }
    }
    all.push_back(next);
  }

  void add(std::vector<Operation>& all) {
    Operation next{.verb = Verb::Add, .body = next_name_++};
    next.number = chance_.below(shape_count_);
    next.settings.kind = random_motion();
    next.settings.role = random_role();
    if (chance_.one_in(3)) next.settings.filter = random_filter();
    next.pose = random_pose();
    beings_.push_back({next.body, next.pose});
    all.push_back(next);
  }

  void ask(std::vector<Operation>& all) {
    Operation question;
    question.verb =
        static_cast<Verb>(static_cast<std::uint32_t>(Verb::AskTouching) + chance_.below(5));
    question.number = chance_.below(shape_count_);
    question.pose = random_pose();
    const double size = size_here();
    const Vector3d here = question.pose.translation(), there = random_pose().translation();
    if (question.verb == Verb::AskWithin) {
      question.values[0] =
          chance_.one_in(3) ? size * chance_.below(3) : size * chance_.between(0, 2);
    } else if (question.verb == Verb::AskRay) {
      Vector3d way = there - here;
      if (way.isZero() || chance_.one_in(3)) {
        way = Vector3d::Unit(static_cast<int>(chance_.below(3))) * size;
        if (chance_.one_in(2)) way = -way;
      }
      for (int k = 0; k < 3; ++k) {
        question.values[static_cast<std::size_t>(k)] = here[k];
        question.values[static_cast<std::size_t>(k) + 3] = way[k];
      }
      question.values[6] = chance_.one_in(2) ? std::numeric_limits<double>::infinity()
                                             : size * chance_.between(0, 6);
    } else if (question.verb == Verb::AskBox) {
      for (int k = 0; k < 3; ++k) {
        question.values[static_cast<std::size_t>(k)] = std::min(here[k], there[k]);
        question.values[static_cast<std::size_t>(k) + 3] = std::max(here[k], there[k]);
      }
    }
    all.push_back(question);
  }

  void save(std::vector<Operation>& all) {
    all.push_back({.verb = Verb::Save});
    saved_ = beings_;
    saved_once_ = true;
  }
  void restore(std::vector<Operation>& all) {
    all.push_back({.verb = Verb::Restore});
    beings_ = saved_;
  }

  BodyKind random_motion() {
    return static_cast<BodyKind>(chance_.one_in(2) ? 2 : chance_.below(3));
  }
  Role random_role() { return chance_.one_in(6) ? Role::Sensor : Role::Solid; }
  Filter random_filter() {
    return {1u << chance_.below(3), chance_.one_in(2) ? ~0u : chance_.below(8),
            static_cast<std::int32_t>(chance_.below(4)) - 1};
  }

  double size_here() {
    if (setting_ != Setting::Sizes) return 1;
    constexpr double kPowers[] = {1e-6, 1e-6, 1, 1e6};
    return kPowers[chance_.below(4)];
  }

  /// Mostly as it is, else an ulp off, or as little as tolerances are.
  double nudged(double value) {
    const std::uint32_t what = chance_.below(12);
    if (what < 2) return std::nextafter(value, what == 0 ? 1e300 : -1e300);
    if (what > 4) return value;
    const double tiny = std::ldexp(1.0, -20 - static_cast<int>(chance_.below(30)));
    return what == 2 ? value - tiny : value + tiny;
  }

  bool is_on_lattice() {
    return setting_ == Setting::Lattice || (setting_ == Setting::Skewed && chance_.one_in(2));
  }

  Vector3d random_place() {
    Vector3d p;
    const bool is_whole = is_on_lattice();
    for (int k = 0; k < 3; ++k) {
      p[k] = setting_ == Setting::OnePoint ? nudged(1)
             : is_whole                    ? nudged(0.5 * (static_cast<int>(chance_.below(15)) - 7))
                                           : chance_.between(-3, 3);
    }
    if (setting_ == Setting::Sizes) p *= size_here();
    if (setting_ == Setting::Far) p += Vector3d(1e7, -1e7, 1e7);
    if (setting_ == Setting::Teleports && chance_.one_in(2))
      p[static_cast<int>(chance_.below(3))] += chance_.one_in(2) ? 1e9 : -1e9;
    return p;
  }

  /// By a quaternion, term by term.
  static Eigen::Matrix3d rotation(const double (&quaternion)[4]) {
    double square = 0;
    for (const double q : quaternion)
      square += q * q;
    const double s = 2 / square;
    const auto [w, x, y, z] = quaternion;
    Eigen::Matrix3d r;
    r << 1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y),  //
        s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x),   //
        s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y);
    return r;
  }
  Eigen::Matrix3d random_rotation() {
    double q[4];
    for (double& part : q)
      part = chance_.between(-1, 1);
    if (setting_ == Setting::OnePoint || is_on_lattice()) {
      const std::uint32_t axis = 1 + chance_.below(3);
      for (double& part : q)
        part = 0;
      q[0] = 1, q[axis] = static_cast<double>(chance_.below(3)) - 1;  // none or a right angle
    }
    return rotation(q);
  }
  void skew(Pose& pose) {
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k)
        pose.matrix()(i, k) += chance_.between(-2e-7, 2e-7);
    }
  }
  Pose random_pose() {
    Pose pose = Pose::Identity();
    if (!chance_.one_in(4)) pose.linear() = random_rotation();
    if (setting_ == Setting::Skewed) skew(pose);
    pose.translation() = random_place();
    return pose;
  }

  /// The same a little on: anything from an ulp to a tenth of a size.
  Pose stepped(const Pose& pose) {
    Pose next = pose;
    // One draw to a statement: compilers order those within one as they like.
    const double size = size_here();
    const int halvings = 3 + static_cast<int>(chance_.below(30));
    const double step = size * std::ldexp(chance_.between(0.5, 1), -halvings);
    for (int k = 0; k < 3; ++k) {
      double& p = next.matrix()(k, 3);
      if (setting_ == Setting::Lattice || setting_ == Setting::OnePoint) {
        p = chance_.one_in(4) ? p + 0.5 : nudged(p);
        if (p > 4) p = -3.5;
      } else {
        p += step * chance_.between(-1, 1);
      }
    }
    if (setting_ == Setting::Lattice || setting_ == Setting::OnePoint) return next;
    const double turn[4] = {1, step * chance_.between(-1, 1), step * chance_.between(-1, 1), 0};
    const Eigen::Matrix3d turned = rotation(turn) * pose.linear();
    Pose trial = next;
    trial.linear() = turned;
    if (setting_ == Setting::Sizes || rotation_deviation(trial) > 0.9e-6)
      trial.linear() = random_rotation();
    return trial;
  }

  Setting setting_;
  Chance chance_;
  std::uint32_t shape_count_;
  std::uint32_t next_name_ = 1;
  std::vector<Being> beings_, saved_;
  bool saved_once_ = false;
};

}  // namespace

std::vector<Shape> palette_of(Setting setting) {
  std::vector<Shape> shapes;
  if (setting == Setting::Sizes) {
    for (const double size : {1e-6, 1.0, 1e6})
      add_kinds(shapes, size);
  } else {
    add_kinds(shapes, 0.5);
  }
  if (setting != Setting::OnePoint) {
    shapes.emplace_back(HalfSpace{{0, 0, 1}, -1});
    shapes.emplace_back(HalfSpace{{1, 2, -2}, -6});
  }
  if (setting == Setting::Terrains) {
    shapes.emplace_back(Plane{{0, 0, 1}, -1});
    shapes.emplace_back(Plane{{2, -1, 2}, 3});
    shapes.emplace_back(terrain(0.5, true));
    shapes.emplace_back(terrain(1, false));
  }
  return shapes;
}

History random_history(Setting setting, std::uint64_t seed, std::size_t count) {
  return Author(setting, seed).write(count);
}

}  // namespace graze::tests
