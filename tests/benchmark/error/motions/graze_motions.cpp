#include <graze/narrowphase/first_contact.h>

#include "tests/benchmark/error/graze_parts.h"

namespace graze::benchmark {

void add_graze_motions(Field& field) {
  constexpr auto kAsIs = [](const MotionQuery& query) { return query; };
  constexpr auto kDoMeet = [](const MotionQuery& query) {
    return query.first_contact().has_value();
  };
  add(field.moving_points, exact("graze"), kAsIs, kDoMeet);
  add(field.moving_edges, exact("graze"), kAsIs, kDoMeet);
}

}  // namespace graze::benchmark
