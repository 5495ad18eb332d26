#include <graze/engine/values/text.h>
#include <graze/print.h>

#include <cstdint>
#include <ostream>

namespace graze {

std::ostream& operator<<(std::ostream& out, const ShapeCast& cast) {
  return out << FirstContact{cast.time, cast.is_at_start}
             << Text(", point ", cast.point, ", normal ", cast.normal);
}
std::ostream& operator<<(std::ostream& out, const ShapeDistance& gap) {
  return out << Text("distance ", gap.distance, " from ", gap.point_a, " to ", gap.point_b,
                     ", normal ", gap.normal, ", at least ", gap.lower_bound,
                     gap.status == PairStatus::Converged ? "" : ", not converged");
}
std::ostream& operator<<(std::ostream& out, const ShapeSeparation& apart) {
  return out << Text("separation ", apart.distance, " from ", apart.point_a, " to ", apart.point_b,
                     ", normal ", apart.normal,
                     apart.status == PairStatus::Converged ? "" : ", not converged");
}
std::ostream& operator<<(std::ostream& out, const ShapeContact& contact) {
  return out << Text("[depth ", contact.depth, ", normal ", contact.normal, ", from ",
                     contact.point_a, " to ", contact.point_b, ", features ")
             << contact.feature << Text("]");
}
std::ostream& operator<<(std::ostream& out, const Manifold& manifold) {
  return write_list(out, manifold, "contacts");
}
/// Writes two bodies, and their parts if one has a number other than 0.
template <typename Pair>
static std::ostream& write_pair(std::ostream& out, const Pair& pair, std::uint32_t part_a,
                                std::uint32_t part_b) {
  out << pair << Text(": ");
  if (part_a != 0 || part_b != 0) out << Text("parts ", part_a, " and ", part_b, ", ");
  return out;
}
std::ostream& operator<<(std::ostream& out, const BodyContact& contact) {
  const Manifold& manifold = contact.manifold;
  return write_pair(out, contact.pair, manifold.part_a(), manifold.part_b()) << manifold;
}
std::ostream& operator<<(std::ostream& out, const BodyPairDistance& found) {
  return write_pair(out, WorldBodyPair{found.a, found.b}, found.part_a, found.part_b)
         << found.distance;
}
std::ostream& operator<<(std::ostream& out, const BodyFirstContact& found) {
  return write_pair(out, found.pair, found.part_a, found.part_b)
         << found.contact
         << Text(found.is_at_start ? ", touching at the start" : "", ", point ", found.point,
                 ", normal ", found.normal);
}
/// Writes a body, and its part if that has a number other than 0.
static std::ostream& write_found(std::ostream& out, const BodyId& id, std::uint32_t part) {
  out << id;
  if (part != 0) out << Text(", part ", part);
  return out << Text(": ");
}
std::ostream& operator<<(std::ostream& out, const BodyDistance& found) {
  return write_found(out, found.id, found.part) << found.distance;
}
std::ostream& operator<<(std::ostream& out, const BodyRayHit& found) {
  return write_found(out, found.id, found.part) << found.hit;
}
std::ostream& operator<<(std::ostream& out, const BodyCast& found) {
  return write_found(out, found.id, found.part) << found.contact;
}

std::ostream& operator<<(std::ostream& out, const WorldUpdate& update) {
  return out << Text(update.begun.size(), " begun, ", update.ended.size(), " ended, ",
                     update.moved.size(), " moved, ", update.contacts.size(), " contacts, ",
                     update.begun_near.size(), " begun near, ", update.ended_near.size(),
                     " ended near, ", update.first_contacts.size(), " first contacts");
}

}  // namespace graze
