#include <graze/bvh/error.h>
#include <graze/bvh/value/number_text.h>
#include <graze/narrowphase/motion/path_checks.h>
#include <cmath>
#include <cstring>
#include <string>

namespace graze::narrowphase {
namespace {

enum class Vertices { None, Named };

void check_thing(const PointPath* paths, int count, Vertices vertices, const char* what,
                 std::size_t number) {
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < 6; ++k) {
      const double* place = k < 3 ? paths[i].start.data() : paths[i].end.data();
      if (std::isfinite(place[k % 3])) continue;
      std::string text = what;
      if (number != kNoNumber) text.append(" ").append(std::to_string(number));
      text.append(": coordinate ").push_back("xyz"[k % 3]);
      if (vertices == Vertices::Named) text.append(" of vertex ").push_back("abc"[i]);
      text.append(k < 3 ? " at the start is not finite" : " at the end is not finite");
      if (number == kNoNumber) throw InputError(text);
      throw InputError(text,
                       {.element = std::string(what, std::strcspn(what, " ")), .index = number});
    }
  }
}

}  // namespace

void check_paths(const PointPath& point, const TrianglePath& triangle, std::size_t number) {
  check_thing(&point, 1, Vertices::None, "point", number);
  check_thing(&triangle.a, 3, Vertices::Named, "triangle", number);
}

void check_paths(const EdgePath& edge_a, const EdgePath& edge_b, std::size_t number) {
  check_thing(&edge_a.a, 2, Vertices::Named, "edge A", number);
  check_thing(&edge_b.a, 2, Vertices::Named, "edge B", number);
}

void check_paths(const TrianglePath& triangle_a, const TrianglePath& triangle_b,
                 std::size_t number) {
  check_thing(&triangle_a.a, 3, Vertices::Named, "triangle A", number);
  check_thing(&triangle_b.a, 3, Vertices::Named, "triangle B", number);
}

void check_settings(const FirstContactSettings& settings) {
  if (settings.start != StartContact::Counts && settings.start != StartContact::IsLeft)
    throw InputError("first_contact: no such policy for a contact at the start");
  if (!std::isfinite(settings.clearance) || settings.clearance < 0)
    throw InputError("first_contact: the clearance is " + bvh::number_text(settings.clearance) +
                     ", but must be finite and not negative");
}

void check_settings(const CastSettings& settings) {
  check_settings(FirstContactSettings{.start = settings.start});
}

void check_lengths(std::size_t length_a, std::size_t length_b, std::size_t contacts) {
  if (length_a == length_b && length_a == contacts) return;
  throw InputError("first contacts: arrays of " + std::to_string(length_a) + " and " +
                   std::to_string(length_b) + " elements, with room for " +
                   std::to_string(contacts) + " contacts");
}

}  // namespace graze::narrowphase
