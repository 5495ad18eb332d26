#pragma once

#include <graze/engine/cli/pair/pair_job.h>
#include <graze/engine/work.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>

namespace graze::cli {

/// Holds what all answers of a file come to.
struct AnswerTotals {
  PairQuery query = PairQuery::Any;
  std::size_t poses = 0;
  std::size_t intersecting = 0;
  std::uint64_t pairs = 0;
  double least_distance = std::numeric_limits<double>::infinity();
  std::size_t nearest_pose = 0;  ///< the first pose that has it
  Work work;
};

/// Asks for every pose, threads sharing them, and writes the answers in their order to a file in
/// numpy's own format (NEP 1): `any` bool of the shape (n,), `distance` float64 of the shape (n,),
/// `pairs` records of `intersects`, bool, and `pairs`, uint64. The file appears when it is whole;
/// only the answers of one block of poses are held in memory. Throws FileError, and PoseError for a
/// file of poses that has become shorter. What `on_progress` throws ends it.
AnswerTotals write_answers(
    const PairJob& job, const std::string& path,
    const std::function<void(std::size_t done, std::size_t total)>& on_progress);

/// Returns one JSON object in a line.
std::string to_json(const AnswerTotals& totals, const std::string& path);

/// Returns one line for people.
std::string to_text(const AnswerTotals& totals, const std::string& path);

}  // namespace graze::cli
