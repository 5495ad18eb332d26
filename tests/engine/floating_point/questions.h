#pragma once

#include <bit>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/engine/floating_point/inputs.h"

namespace graze::tests {

/// All bits of an answer.
class Words {
 public:
  void add(std::uint64_t word) { list_.push_back(word); }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  void add(const Eigen::Vector3d& p) {
    for (int i = 0; i < 3; ++i)
      add(p.data()[i]);
  }
  void add(const Pose& pose) {
    for (int i = 0; i < 16; ++i)
      add(pose.data()[i]);
  }
  void add(const Aabb& box) { add(box.min), add(box.max); }
  void add(const Obb& box) { add(box.pose), add(box.half_extents); }
  void add(const Sphere& ball) { add(ball.centre), add(ball.radius); }
  void add(const KDop<18>& kdop) {
    for (const auto* list : {&kdop.min, &kdop.max})
      for (const double number : *list)
        add(number);
  }
  void add(const TrianglePairs& pairs) {
    for (const TrianglePair& pair : pairs)
      add(std::uint64_t{pair.a} << 32 | pair.b);
  }
  void add(const TriangleList& list) {
    for (const std::uint32_t index : list)
      add(std::uint64_t{index});
  }
  void add(const std::string& text) {
    for (const char c : text)
      add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  }
  void add(bool is) { add(std::uint64_t{is}); }

  const std::vector<std::uint64_t>& list() const { return list_; }

 private:
  std::vector<std::uint64_t> list_;
};

/// One that the library answers. All is done anew each time, from the meshes on.
struct Question {
  const char* name;
  std::function<void(const Inputs&, Words&)> ask;
};

std::vector<Question> triangle_questions();
std::vector<Question> volume_questions();
std::vector<Question> mesh_questions(int threads);
std::vector<Question> world_questions(int threads);
std::vector<Question> file_questions();

/// Those that share their work among threads, about large inputs.
std::vector<Question> parallel_questions(int threads);

/// Trees, bit by bit, which are built in parallel.
Question tree_question();

/// Those of all kinds.
std::vector<Question> all_questions(int threads);

/// Also what is refused, and by which words.
std::vector<std::uint64_t> answer(const Question& question, const Inputs& inputs);

}  // namespace graze::tests
