#include "tests/narrowphase/volumes/obb_cases.h"

#include <Eigen/Geometry>
#include <cmath>

namespace graze {
namespace {

Obb random_box(RandomSource& random) {
  Obb box{Pose::Identity(), random.vector(0, 1)};
  box.pose.linear() = random_rotation(random);
  box.pose.translation() = random.vector(-1, 1);
  return box;
}

Eigen::Matrix3d turned(double angle, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/// One of the 24 ways to turn a cube onto itself.
Eigen::Matrix3d lattice_rotation(RandomSource& random) {
  const int turn = static_cast<int>(random.integer(0, 2));
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i)
    m(i, (i + turn) % 3) = random.integer(0, 1) == 0 ? 1 : -1;
  if (m.determinant() < 0) m = -m;
  return m;
}

void loosen(Pose& pose, RandomSource& random) {
  const double amount = std::pow(10, random.uniform(-12, -6.6));
  for (int i = 0; i < 3; ++i)
    pose.linear().col(i) += amount * random.vector(-1, 1);
  if (rotation_deviation(pose) > kMaxRotationDeviation) pose.linear() = random_rotation(random);
}

void scale(ObbCase& pair, double factor) {
  pair.a.half_extents *= factor;
  pair.b.half_extents *= factor;
  pair.a.pose.translation() *= factor;
}

void arrange(Lie lie, ObbCase& pair, RandomSource& random) {
  const int i = static_cast<int>(random.integer(0, 2));
  const int j = static_cast<int>(random.integer(0, 2));
  Pose& a = pair.a.pose;
  Pose& b = pair.b.pose;
  switch (lie) {
    case Lie::Any:
      break;
    case Lie::Faces:
      b.linear() = a.linear();
      pair.way = a.linear().col(i);
      break;
    case Lie::Edges:
      pair.way = a.linear().col(i).cross(b.linear().col(j)).normalized();
      break;
    case Lie::ParallelEdges:
    case Lie::NearlyParallel:
      b.linear() = a.linear() * turned(random.uniform(0, 7), Eigen::Vector3d::Unit(i));
      if (lie == Lie::NearlyParallel) {
        const double angle = std::pow(10, random.uniform(-17, -1));
        b.linear() = b.linear() * turned(angle, random.vector(-1, 1));
        pair.way = a.linear().col(i).cross(b.linear().col(i)).normalized();
      }
      break;
    case Lie::Flat:
      pair.a.half_extents[i] = 0;
      if (random.integer(0, 1) == 0) pair.a.half_extents[j] = 0;
      if (random.integer(0, 1) == 0) pair.b.half_extents[j] = 0;
      break;
    case Lie::Points:
      pair.a.half_extents.setZero();
      if (random.integer(0, 1) == 0) pair.b.half_extents.setZero();
      break;
    case Lie::FarFromOrigin:
      a.translation() = random.vector(-1e9, 1e9);
      break;
    case Lie::Scaled:
      scale(pair, std::pow(10, random.uniform(-150, 150)));
      break;
    case Lie::UnequalSizes:
      pair.b.half_extents *= std::pow(10, random.uniform(-9, 9));
      break;
    case Lie::Lattice:
      a.linear() = lattice_rotation(random);
      b.linear() = lattice_rotation(random);
      a.translation() = random.lattice_point(-3, 3);
      pair.a.half_extents = random.lattice_point(0, 2);
      pair.b.half_extents = random.lattice_point(0, 2);
      pair.way = Eigen::Vector3d::Unit(i);
      break;
    case Lie::NotQuiteRigid:
      loosen(a, random);
      loosen(b, random);
      break;
  }
}

}  // namespace

const char* name_of(Lie lie) {
  switch (lie) {
    case Lie::Any:
      return "any";
    case Lie::Faces:
      return "faces";
    case Lie::Edges:
      return "edges";
    case Lie::ParallelEdges:
      return "parallel edges";
    case Lie::NearlyParallel:
      return "nearly parallel";
    case Lie::Flat:
      return "flat";
    case Lie::Points:
      return "points";
    case Lie::FarFromOrigin:
      return "far from the origin";
    case Lie::Scaled:
      return "scaled";
    case Lie::UnequalSizes:
      return "unequal sizes";
    case Lie::Lattice:
      return "lattice";
    case Lie::NotQuiteRigid:
      return "not quite rigid";
  }
  return "";
}

Obb ObbCase::b_at(double distance) const {
  Obb moved = b;
  moved.pose.translation() = a.pose.translation() + distance * way;
  return moved;
}

double ObbCase::size() const {
  return a.half_extents.sum() + b.half_extents.sum();
}

ObbCase random_case(Lie lie, RandomSource& random) {
  ObbCase pair;
  pair.a = random_box(random);
  pair.b = random_box(random);
  pair.way = random.vector(-1, 1).normalized();
  arrange(lie, pair, random);
  if (pair.way.norm() < 0.5) pair.way = Eigen::Vector3d::UnitX();  // a product of parallel edges
  return pair;
}

Eigen::Matrix3d random_rotation(RandomSource& random) {
  const Eigen::Vector3d imaginary = random.vector(-1, 1);
  const double real = random.uniform(-1, 1);
  return Eigen::Quaterniond(real, imaginary[0], imaginary[1], imaginary[2])
      .normalized()
      .toRotationMatrix();
}

}  // namespace graze
