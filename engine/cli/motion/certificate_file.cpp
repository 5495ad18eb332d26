#include <graze/bvh/error.h>
#include <graze/engine/cases/text/json_cursor.h>
#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cases/text/json_tree.h>
#include <graze/engine/cli/motion/certificate_file.h>
#include <graze/engine/files/source.h>
#include <graze/engine/mesh/io/file_bytes.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace graze::cli {

using cases::JsonCursor;

namespace {

constexpr std::uint32_t kMostTriangles = std::numeric_limits<std::int32_t>::max();

std::string json_of(const RigidMotion& motion) {
  return "{\"start\":" + cases::json_pose(motion.start()) +
         ",\"centre\":" + cases::json_point(motion.centre()) +
         ",\"shift\":" + cases::json_point(motion.shift()) +
         ",\"axis\":" + cases::json_point(motion.axis()) +
         ",\"angle\":" + cases::json_number(motion.angle()) + "}";
}

std::string json_of(const std::vector<std::uint32_t>& order) {
  return cases::json_list(order, ",", [](std::uint32_t i) { return std::to_string(i); });
}

std::string json_of(const FreedomStep& step) {
  switch (step.kind) {
    case FreedomStep::Kind::Plane:
      return "{\"plane\":" + cases::json_point(step.normal) + "}";
    case FreedomStep::Kind::HalveTime:
      return "\"halve_time\"";
    case FreedomStep::Kind::DivideA:
      return "{\"divide_a\":" + std::to_string(step.count) + "}";
    case FreedomStep::Kind::DivideB:
      return "{\"divide_b\":" + std::to_string(step.count) + "}";
  }
  return {};
}

Pose read_pose(const JsonCursor& at) {
  at.require_size(12);
  Pose pose = Pose::Identity();
  for (int i = 0; i < 12; ++i)
    pose.matrix()(i / 4, i % 4) = at.item(static_cast<std::size_t>(i)).number();
  return pose;
}

RigidMotion read_motion(const JsonCursor& at) {
  at.require_keys({"start", "centre", "shift", "axis", "angle"});
  try {
    return {read_pose(at.member("start")),
            {.centre = at.member("centre").point(),
             .shift = at.member("shift").point(),
             .axis = at.member("axis").point(),
             .angle = at.member("angle").number()}};
  } catch (const CaseError&) {
    throw;
  } catch (const Error& error) {
    at.fail(error.what());
  }
}

std::vector<std::uint32_t> read_order(const JsonCursor& at) {
  std::vector<std::uint32_t> order(at.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = at.item(i).index(kMostTriangles);
  return order;
}

FreedomStep read_step(const JsonCursor& at) {
  using Kind = FreedomStep::Kind;
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  if (!at.is_object()) {
    if (at.text() != "halve_time") at.fail("is neither a step nor \"halve_time\"");
    return {Kind::HalveTime, 0, none};
  }
  at.require_keys({"plane", "divide_a", "divide_b"});
  if (at.has("plane")) return {Kind::Plane, 0, at.member("plane").point()};
  if (at.has("divide_a")) return {Kind::DivideA, at.member("divide_a").index(kMostTriangles), none};
  return {Kind::DivideB, at.member("divide_b").index(kMostTriangles), none};
}

CertificateFile certificate_of(const JsonCursor& root) {
  root.require_keys({"graze_certificate", "mesh_a", "mesh_b", "motion_a", "motion_b", "clearance",
                     "order_a", "order_b", "steps"});
  if (root.member("graze_certificate").whole(0, 1000) != 1)
    root.member("graze_certificate").fail("is a version that this program does not know");
  CertificateFile file{.mesh_a = root.member("mesh_a").text(),
                       .mesh_b = root.member("mesh_b").text(),
                       .motion_a = read_motion(root.member("motion_a")),
                       .motion_b = read_motion(root.member("motion_b")),
                       .certificate = {.clearance = root.member("clearance").number(),
                                       .order_a = read_order(root.member("order_a")),
                                       .order_b = read_order(root.member("order_b")),
                                       .steps = {}}};
  const JsonCursor steps = root.member("steps");
  file.certificate.steps.reserve(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i)
    file.certificate.steps.push_back(read_step(steps.item(i)));
  return file;
}

}  // namespace

std::string to_json(const CertificateFile& file) {
  const FreedomCertificate& proof = file.certificate;
  return "{\"graze_certificate\":1,\n\"mesh_a\":" + cases::json_string(file.mesh_a.string()) +
         ",\n\"mesh_b\":" + cases::json_string(file.mesh_b.string()) +
         ",\n\"motion_a\":" + json_of(file.motion_a) + ",\n\"motion_b\":" + json_of(file.motion_b) +
         ",\n\"clearance\":" + cases::json_number(proof.clearance) +
         ",\n\"order_a\":" + json_of(proof.order_a) + ",\n\"order_b\":" + json_of(proof.order_b) +
         ",\n\"steps\":" +
         cases::json_list(proof.steps, ",\n",
                          [](const FreedomStep& step) { return json_of(step); }) +
         "}\n";
}

CertificateFile read_certificate(const std::filesystem::path& path) {
  const std::string name = mesh_io::printable(path.string());
  mesh_io::require_regular_file(path, name);
  const std::string bytes = mesh_io::read_file(path, name);
  const cases::JsonValue tree = cases::parse_json(bytes, name);
  return certificate_of(JsonCursor(tree, name));
}

}  // namespace graze::cli
