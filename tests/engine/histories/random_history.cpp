#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/engine/broad_phase/box_histories.h"
#include "tests/engine/histories/history.h"
#include "tests/engine/histories/parts_plan.h"

namespace graze::tests {
namespace {

using Eigen::Vector3d;
using test::Chance;

class Author {
 public:
  Author(Setting setting, std::uint64_t seed)
      : setting_(setting),
        chance_(seed),
        shape_count_(static_cast<std::uint32_t>(palette_of(setting).size())),
        plans_(plans_of(setting)) {}

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
    std::uint32_t number;  // its shape, or the plan of its parts
  };

  void change(std::vector<Operation>& all) {
    if (!plans_.empty() && beings_.size() >= 4 && chance_.one_in(4)) return change_parts(all);
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
        next.number = being.number = random_form();
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
    next.number = random_form();
    next.settings.kind = random_motion();
    next.settings.role = random_role();
    if (chance_.one_in(3)) next.settings.filter = random_filter();
    next.pose = random_pose();
    beings_.push_back({next.body, next.pose, next.number});
    all.push_back(next);
  }

  /// Half of all bodies have parts, where there are plans.
  std::uint32_t random_form() {
    if (plans_.empty() || chance_.one_in(2)) return chance_.below(shape_count_);
    return shape_count_ + chance_.below(static_cast<std::uint32_t>(plans_.size()));
  }

  /// One part of a body more, fewer or elsewhere; or nothing, if the body is of one piece.
  void change_parts(std::vector<Operation>& all) {
    const Being& being = beings_[chance_.below(static_cast<std::uint32_t>(beings_.size()))];
    if (being.number < shape_count_) return;
    const PartsPlan& plan = plans_[being.number - shape_count_];
    Operation next{.body = being.name};
    if (plan.grid) {
      next.verb = chance_.one_in(2) ? Verb::FillVoxels : Verb::ClearVoxels;
      const Voxel near = plan.voxels[chance_.below(static_cast<std::uint32_t>(plan.voxels.size()))];
      const std::uint16_t from[3] = {near.i, near.j, near.k};
      const bool is_one = chance_.one_in(2);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t most = plan.grid->counts[axis] - 1;
        const std::uint32_t first = std::min(from[axis] + chance_.below(3), most);
        const std::uint32_t last = is_one ? first : std::min(first + chance_.below(3), most);
        next.voxels[axis] = static_cast<std::uint16_t>(first);
        next.voxels[axis + 3] = static_cast<std::uint16_t>(last);
      }
    } else {
      constexpr Verb kVerbs[] = {Verb::AddPart,    Verb::ReplacePart, Verb::MovePart,
                                 Verb::RemovePart, Verb::MovePart,    Verb::SetPart};
      next.verb = kVerbs[chance_.below(6)];
      next.part = chance_.below(1u << 16);
      next.number = next.verb == Verb::SetPart ? chance_.below(100) : random_shape_of_part();
      next.has_filter = chance_.one_in(2);
      if (next.has_filter) next.settings.filter = random_filter();
      next.pose = random_pose_of_part();
    }
    all.push_back(next);
  }

  /// That of a part of some plan.
  std::uint32_t random_shape_of_part() {
    const PartsPlan* plan = nullptr;
    do {
      plan = &plans_[chance_.below(static_cast<std::uint32_t>(plans_.size()))];
    } while (plan->parts.empty());
    return plan->parts[chance_.below(static_cast<std::uint32_t>(plan->parts.size()))].shape;
  }
  Pose random_pose_of_part() {
    Pose pose = Pose::Identity();
    const bool is_whole = chance_.one_in(2);
    for (int k = 0; k < 3; ++k) {
      pose.matrix()(k, 3) =
          is_whole ? 0.25 * (static_cast<int>(chance_.below(7)) - 3) : chance_.between(-0.8, 0.8);
    }
    if (!is_whole) pose.linear() = random_rotation();
    if (chance_.one_in(8)) skew(pose, 1e-8);
    return pose;
  }

  void ask(std::vector<Operation>& all) {
    Operation question;
    question.verb =
        static_cast<Verb>(static_cast<std::uint32_t>(Verb::AskTouching) + chance_.below(5));
    if (!plans_.empty() && chance_.one_in(6)) question.verb = Verb::AskClosestPair;
    question.number = chance_.below(shape_count_);
    question.pose = random_pose();
    const double size = size_here();
    const Vector3d here = question.pose.translation(), there = random_pose().translation();
    if (question.verb == Verb::AskWithin) {
      question.values[0] =
          chance_.one_in(3) ? size * chance_.below(3) : size * chance_.between(0, 2);
    } else if (question.verb == Verb::AskRay) {
      Vector3d displacement = there - here;
      if (displacement.isZero() || chance_.one_in(3)) {
        displacement = Vector3d::Unit(static_cast<int>(chance_.below(3))) * size;
        if (chance_.one_in(2)) displacement = -displacement;
      }
      for (int k = 0; k < 3; ++k) {
        question.values[static_cast<std::size_t>(k)] = here[k];
        question.values[static_cast<std::size_t>(k) + 3] = displacement[k];
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
    const bool is_mixed = setting_ == Setting::Skewed || setting_ == Setting::Parts;
    return setting_ == Setting::Lattice || (is_mixed && chance_.one_in(2));
  }

  Vector3d random_place() {
    Vector3d p;
    const bool is_whole = is_on_lattice();
    // Where bodies of parts are half of all, others are small: these stand closer.
    const std::uint32_t halves = setting_ == Setting::Parts ? 4 : 7;
    const double most = setting_ == Setting::Parts ? 1.75 : 3;
    for (int k = 0; k < 3; ++k) {
      p[k] = setting_ == Setting::OnePoint ? nudged(1)
             : is_whole ? nudged(0.5 * (static_cast<int>(chance_.below(2 * halves + 1)) -
                                        static_cast<int>(halves)))
                        : chance_.between(-most, most);
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
  void skew(Pose& pose, double most) {
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k)
        pose.matrix()(i, k) += chance_.between(-most, most);
    }
  }
  Pose random_pose() {
    Pose pose = Pose::Identity();
    if (!chance_.one_in(4)) pose.linear() = random_rotation();
    if (setting_ == Setting::Skewed) skew(pose, 2e-7);
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
  std::vector<PartsPlan> plans_;
  std::uint32_t next_name_ = 1;
  std::vector<Being> beings_, saved_;
  bool saved_once_ = false;
};

/// Puts margins, motions and casts between the operations of a history, by numbers of their own:
/// what is there stays as it is.
class Inserter {
 public:
  explicit Inserter(std::uint64_t seed) : chance_(~seed) {}

  History with_motions(const History& history) {
    History more{history.setting, {}};
    more.operations.reserve(2 * history.operations.size());
    const auto shape_count = static_cast<std::uint32_t>(palette_of(history.setting).size());
    for (const Operation& operation : history.operations) {
      more.operations.push_back(operation);
      // Not between moves that are made in one call.
      if (operation.verb == Verb::Move || operation.verb == Verb::MoveToo) {
        poses_.push_back(operation.pose);
        continue;
      }
      if (operation.verb == Verb::Add) {
        poses_.push_back(operation.pose);
        names_.push_back(operation.body);
        if (chance_.one_in(3)) more.operations.push_back(margin(operation.body));
        if (chance_.one_in(4)) more.operations.push_back(detection(operation.body));
      }
      if (names_.empty()) continue;
      const std::uint32_t what = chance_.below(60);
      const std::uint32_t name = names_[chance_.below(static_cast<std::uint32_t>(names_.size()))];
      if (what == 0) more.operations.push_back(margin(name));
      if (what == 1) more.operations.push_back(detection(name));
      if (what == 2) more.operations.push_back(cast(shape_count));
    }
    return more;
  }

 private:
  double reach() { return chance_.one_in(3) ? 0.125 * chance_.below(3) : chance_.between(0, 0.3); }
  Operation margin(std::uint32_t name) {
    Operation next{.verb = Verb::SetMargin, .body = name};
    next.values[0] = reach();
    return next;
  }
  Operation detection(std::uint32_t name) {
    Operation next{.verb = Verb::SetDetection, .body = name};
    next.settings.detection = chance_.one_in(4) ? Detection::Discrete : Detection::Continuous;
    return next;
  }
  Operation cast(std::uint32_t shape_count) {
    Operation next{.verb = Verb::AskCast, .number = chance_.below(shape_count)};
    const auto count = static_cast<std::uint32_t>(poses_.size());
    next.pose = poses_[chance_.below(count)];
    next.end = poses_[chance_.below(count)];
    if (chance_.one_in(4)) next.values[0] = reach();
    return next;
  }

  Chance chance_;
  std::vector<Pose> poses_;  // that bodies had
  std::vector<std::uint32_t> names_;
};

}  // namespace

History random_history(Setting setting, std::uint64_t seed, std::size_t count) {
  const History history = Author(setting, seed).write(count);
  const bool has_motions = setting == Setting::Parts || setting == Setting::Terrains;
  return has_motions ? Inserter(seed).with_motions(history) : history;
}

}  // namespace graze::tests
