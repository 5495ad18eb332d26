#include <graze/engine/cases/read_case.h>
#include <graze/engine/compare/referee.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>

#include <filesystem>

// Replays the triangles of data/regressions through each stage; tests/compare replays all cases
// there as queries. A wrong answer that is found anywhere becomes a case there.

namespace graze {
namespace {

template <typename Other>
void expect_answer(const Triangle& triangle, const Other& other, bool is_hit) {
  EXPECT_EQ(intersects(triangle, other), is_hit);
  EXPECT_EQ(narrowphase::intersects_exactly(triangle, other), is_hit);
  EXPECT_EQ(compare::referee_intersects(triangle, other), is_hit)
      << "the file contradicts the referee";
}

TEST(Regressions, KeepTheirAnswersInEachStage) {
  int pairs = 0;
  int boxes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(GRAZE_DATA_DIR "/regressions")) {
    if (entry.path().extension() != ".json") continue;
    SCOPED_TRACE(entry.path().filename().string());
    const Case query = read_case(entry.path());
    const auto* triangle = std::get_if<Triangle>(&query.a);
    if (triangle == nullptr || query.ask != Ask::Any) continue;
    if (query.answered_by.engine != "referee") continue;  // others have been wrong
    if (const auto* other = std::get_if<Triangle>(&*query.b)) {
      expect_answer(*triangle, *other, *query.answer->says);
      ++pairs;
    } else if (const auto* box = std::get_if<Aabb>(&*query.b)) {
      expect_answer(*triangle, *box, *query.answer->says);
      ++boxes;
    }
  }
  EXPECT_GE(pairs, 27);
  EXPECT_GE(boxes, 22);
}

}  // namespace
}  // namespace graze
