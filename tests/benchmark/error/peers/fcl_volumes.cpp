// FCL's own volumes: what its trees ask at their inner nodes.

#include <fcl/math/bv/OBB.h>
#include <fcl/math/bv/kDOP.h>

#include "tests/benchmark/error/peers/peers.h"

static_assert(EIGEN_MAX_ALIGN_BYTES == 16, "compile this file without -march or -mavx flags");

namespace graze::benchmark {
namespace {

fcl::OBBd to_fcl(const Obb& box) {
  return {box.pose.linear(), box.pose.translation(), box.half_extents};
}

struct Boxes {
  fcl::OBBd a;
  fcl::OBBd b;
};

using FclKDop = fcl::KDOP<double, 18>;

FclKDop to_fcl(const Triangle& t) {
  FclKDop result(t.a);
  result += t.b;
  result += t.c;
  return result;
}

struct KDops {
  FclKDop a;
  FclKDop b;
};

}  // namespace

void add_fcl_volumes(Field& field) {
  const Label label{"FCL", Origin::Peer, "double", std::nullopt};
  add(
      field.obb_pairs, label,
      [](const ObbPair& pair) {
        return Boxes{to_fcl(pair.a), to_fcl(pair.b)};
      },
      [](const Boxes& pair) { return pair.a.overlap(pair.b); });
  add(
      field.kdop_pairs, label,
      [](const KDopPair& pair) {
        return KDops{to_fcl(pair.a), to_fcl(pair.b)};
      },
      [](const KDops& pair) { return pair.a.overlap(pair.b); });
}

}  // namespace graze::benchmark
