#include <graze/bvh/error.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/rigid_certificate.h>
#include <tests/fuzz/byte_shapes.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

// Law 14: looks for a time before `low` at which two meshes meet, a witness that does not, an
// answer that swapping changes, and a certificate of its own that is refused or proves what is not
// so.

using namespace graze;

namespace {

constexpr int kSamples = 32;

Mesh mesh_of(fuzz::ByteShapes& shapes) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  const int count = shapes.byte() % 4 + 1;
  for (int i = 0; i < count; ++i) {
    const Triangle t = shapes.triangle();
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), {t.a, t.b, t.c});
    triangles.push_back({first, first + 1, first + 2});
  }
  return Mesh(vertices, triangles);
}

RigidMotion motion_of(fuzz::ByteShapes& shapes) {
  const Pose start = shapes.pose();
  const int kind = shapes.byte();
  if (kind % 4 == 0) return RigidMotion::between(start, shapes.pose());
  if (kind % 4 == 1) return RigidMotion::screw_between(start, shapes.pose());
  const Triangle points = shapes.triangle();
  const double angle = std::ldexp(shapes.byte() - 128, shapes.byte() % 24 - 16);
  return {start, {.centre = points.a, .shift = points.b, .axis = points.c, .angle = angle}};
}

void fail_if(bool is_wrong, const char* what, double time) {
  if (!is_wrong) return;
  std::fprintf(stderr, "%s, at %.17g\n", what, time);
  std::abort();
}

/// Lengths and angles beside which a tolerance is no rounding: then certificates are accepted.
bool is_ordinary(const Mesh& mesh, const RigidMotion& motion) {
  constexpr double kMost = 1000;
  return mesh.bounds().max.cwiseAbs().maxCoeff() < kMost &&
         mesh.bounds().min.cwiseAbs().maxCoeff() < kMost &&
         motion.start().translation().cwiseAbs().maxCoeff() < kMost &&
         motion.centre().cwiseAbs().maxCoeff() < kMost &&
         motion.shift().cwiseAbs().maxCoeff() < kMost && std::abs(motion.angle()) < kMost;
}

void check(const Mesh& a, const RigidMotion& motion_a, const Mesh& b, const RigidMotion& motion_b,
           const RigidContactSettings& settings) {
  const RigidContact found = first_contact({a, motion_a}, {b, motion_b}, settings);
  const auto is_hit = [&](double t) {
    const PlacedMesh placed_a{a, motion_a.at(t)}, placed_b{b, motion_b.at(t)};
    return settings.clearance == 0 ? intersects(placed_a, placed_b)
                                   : within(placed_a, placed_b, settings.clearance);
  };
  for (int i = 0; i <= kSamples; ++i) {
    const double t = found.low * i / kSamples;
    const bool is_free = t < found.low || found.status == RigidStatus::Free;
    fail_if(is_free && is_hit(t), "a hit in what is called free", t);
  }
  if (found.status == RigidStatus::Hit) {
    fail_if(!is_hit(found.high), "a witness that does not hit", found.high);
    fail_if(found.high < found.low, "a witness in what is called free", found.high);
  }
  if (found.is_out_of_budget) return;
  const RigidContact mirrored = first_contact({b, motion_b}, {a, motion_a}, settings);
  fail_if(!mirrored.is_out_of_budget && !(mirrored == found), "swapped, another answer", found.low);
  const auto certificate = certify_free({a, motion_a}, {b, motion_b}, settings);
  fail_if(certificate.has_value() != (found.status == RigidStatus::Free),
          "a certificate that should not be, or none", found.low);
  if (certificate && is_ordinary(a, motion_a) && is_ordinary(b, motion_b) &&
      settings.tolerance > 0x1p-20)
    fail_if(!proves_freedom(*certificate, {a, motion_a}, {b, motion_b}), "its own is refused", 1);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::ByteShapes shapes(data, size);
  try {
    const Mesh a = mesh_of(shapes), b = mesh_of(shapes);
    const RigidMotion motion_a = motion_of(shapes), motion_b = motion_of(shapes);
    const int kind = shapes.byte();
    const double clearance = kind % 4 == 0 ? std::ldexp(1, -(kind / 4 % 16)) : 0;
    const double tolerance = std::ldexp(1, -(shapes.byte() % 40));
    check(a, motion_a, b, motion_b,
          {.clearance = clearance, .tolerance = tolerance, .budget = 1 << 12});
  } catch (const Error&) {
    // Refused at the door: motions of any length, axes of none.
  }
  return 0;
}
