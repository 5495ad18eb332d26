#include <graze/engine/values/text.h>
#include <graze/print.h>

#include <ostream>
#include <string>

namespace graze {

std::string to_text(const Pose& pose) {
  Text text;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 4; ++k)
      text.add(i + k == 0 ? "" : " "), text.add(pose.matrix()(i, k));
  }
  return text.str();
}

std::ostream& operator<<(std::ostream& out, const BodyId& id) {
  return out << Text("body ", id.index, ".", id.generation);
}
std::ostream& operator<<(std::ostream& out, const BoxId& id) {
  return out << Text("box ", id.index, ".", id.generation);
}
std::ostream& operator<<(std::ostream& out, const BodyPair& pair) {
  return out << pair.a << Text(" and ") << pair.b;
}
std::ostream& operator<<(std::ostream& out, const WorldBodyPair& pair) {
  return out << pair.a << Text(" and ") << pair.b;
}
std::ostream& operator<<(std::ostream& out, const BoxPair& pair) {
  return out << Text(pair.a, "-", pair.b);
}
std::ostream& operator<<(std::ostream& out, const TrianglePair& pair) {
  return out << Text(pair.a, "-", pair.b);
}
std::ostream& operator<<(std::ostream& out, const ContactFeature& feature) {
  return out << Text(feature.a, "-", feature.b);
}
std::ostream& operator<<(std::ostream& out, const Voxel& voxel) {
  return out << Text("(", std::uint32_t{voxel.i}, ", ", std::uint32_t{voxel.j}, ", ",
                     std::uint32_t{voxel.k}, ")");
}

std::ostream& operator<<(std::ostream& out, const Aabb& box) {
  return out << Text("box from ", box.min, " to ", box.max);
}
std::ostream& operator<<(std::ostream& out, const Obb& box) {
  return out << Text("box of half extents ", box.half_extents, " in pose ", to_text(box.pose));
}
std::ostream& operator<<(std::ostream& out, const Sphere& sphere) {
  return out << Text("ball around ", sphere.centre, " of radius ", sphere.radius);
}
std::ostream& operator<<(std::ostream& out, const KDop<18>& kdop) {
  Text text("18-DOP");
  for (std::size_t i = 0; i < kdop.min.size(); ++i)
    text.add(" ["), text.add(kdop.min[i]), text.add(", "), text.add(kdop.max[i]), text.add("]");
  return out << text;
}
std::ostream& operator<<(std::ostream& out, const Ray& ray) {
  return out << Text("ray from ", ray.origin, " along ", ray.direction, " for ", ray.max_distance);
}
std::ostream& operator<<(std::ostream& out, const Triangle& triangle) {
  return out << Text("triangle ", triangle.a, " ", triangle.b, " ", triangle.c);
}
std::ostream& operator<<(std::ostream& out, const VoxelGrid& grid) {
  return out << Text("grid of ", grid.counts[0], " x ", grid.counts[1], " x ", grid.counts[2],
                     " voxels of ", grid.edge, " from ", grid.origin);
}
std::ostream& operator<<(std::ostream& out, const RigidMotion& motion) {
  return out << Text("from pose ", to_text(motion.start()), " by ", motion.shift(), " and ",
                     motion.angle(), " rad about ", motion.axis(), " through ", motion.centre());
}
std::ostream& operator<<(std::ostream& out, const RigidCourse& course) {
  return out << Text("by ", course.shift, " and ", course.angle, " rad about ", course.axis,
                     " through ", course.centre);
}
std::ostream& operator<<(std::ostream& out, const RigidVelocities& velocities) {
  return out << Text("for ", velocities.duration, " s by ", velocities.linear, " m/s and ",
                     velocities.angular, " rad/s around ", velocities.body_centre);
}
std::ostream& operator<<(std::ostream& out, const Screw& screw) {
  return out << Text("by ", screw.angle, " rad about ", screw.axis, " through ", screw.point, ", ",
                     screw.pitch, " a turn");
}
std::ostream& operator<<(std::ostream& out, const PointPath& path) {
  return out << Text("from ", path.start, " to ", path.end);
}
std::ostream& operator<<(std::ostream& out, const EdgePath& path) {
  return out << path.a << Text(", ") << path.b;
}
std::ostream& operator<<(std::ostream& out, const TrianglePath& path) {
  return out << path.a << Text(", ") << path.b << Text(", ") << path.c;
}
std::ostream& operator<<(std::ostream& out, const ErrorPlace& place) {
  Text text(place.file);
  if (place == ErrorPlace{}) text.add("nowhere known");
  if (place.line)
    text.add(text.str().empty() ? "line " : ":"), text.add(std::uint64_t{*place.line});
  if (place.byte)
    text.add(text.str().empty() ? "byte " : ": byte "), text.add(std::uint64_t{*place.byte});
  if (!place.element.empty()) text.add(text.str().empty() ? "" : ": "), text.add(place.element);
  if (place.index) text.add(" "), text.add(std::uint64_t{*place.index});
  return out << text;
}

}  // namespace graze
