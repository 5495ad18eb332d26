#include <graze/engine/cli/pair/answer_file.h>
#include <graze/engine/cli/pair/pair_report.h>
#include <graze/engine/files/output_file.h>
#include <graze/engine/files/source.h>
#include <graze/engine/mesh/query/batch.h>

#include <fmt/format.h>
#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

namespace graze::cli {
namespace {

/// So many poses are held at a time: 8 MiB of them.
constexpr std::size_t kBlock = std::size_t{1} << 16;

/// A thread takes so many poses at a time: enough that far ones outweigh the taking.
constexpr std::size_t kMostInAPart = 64;

/// Returns the type of an answer, as numpy writes it.
const char* dtype_of(PairQuery query) {
  switch (query) {
    case PairQuery::Any:
      return "'|b1'";
    case PairQuery::Distance:
      return "'<f8'";
    case PairQuery::Pairs:
      break;
  }
  return "[('intersects', '|b1'), ('pairs', '<u8')]";
}

/// Returns the header in version 1.0 of the format, which ends at a multiple of 64 bytes.
std::string array_header(PairQuery query, std::size_t count) {
  std::string text = fmt::format("{{'descr': {}, 'fortran_order': False, 'shape': ({},), }}",
                                 dtype_of(query), count);
  constexpr std::size_t kStart = 10, kMultiple = 64;
  const std::size_t size = (kStart + text.size() + 1 + kMultiple - 1) / kMultiple * kMultiple;
  text.resize(size - kStart - 1, ' ');
  text += '\n';
  std::string header("\x93NUMPY\x01\x00", 8);
  header += static_cast<char>(text.size() & 255);
  header += static_cast<char>(text.size() >> 8);
  return header + text;
}

/// Keeps an answer until it is written.
struct Row {
  bool intersects = false;
  std::uint64_t number = 0;  ///< the bits of the distance, or the number of pairs
};

Row row_of(const PoseAnswer& answer) {
  if (answer.gap) return {answer.intersects, std::bit_cast<std::uint64_t>(answer.gap->distance)};
  return {answer.intersects, answer.pairs ? answer.pairs->size() : 0};
}

/// Appends an answer. Numbers are written with their lowest byte first, whatever the machine.
void append(files::OutputFile& file, PairQuery query, const Row& row) {
  std::array<char, 9> bytes;
  bytes[0] = row.intersects ? '\1' : '\0';
  for (std::size_t i = 0; i < 8; ++i)
    bytes[i + 1] = static_cast<char>(row.number >> (8 * i) & 255);
  const std::string_view record(bytes.data(), bytes.size());
  file.append(query == PairQuery::Any        ? record.substr(0, 1)
              : query == PairQuery::Distance ? record.substr(1)
                                             : record);
}

void add(AnswerTotals& totals, const Row& row) {
  totals.intersecting += row.intersects ? 1 : 0;
  if (totals.query == PairQuery::Pairs) totals.pairs += row.number;
  if (totals.query == PairQuery::Distance) {
    const double distance = std::bit_cast<double>(row.number);
    if (distance < totals.least_distance) {
      totals.least_distance = distance;
      totals.nearest_pose = totals.poses;
    }
  }
  ++totals.poses;
}

}  // namespace

AnswerTotals write_answers(
    const PairJob& job, const std::string& path,
    const std::function<void(std::size_t done, std::size_t total)>& on_progress) {
  const std::size_t count = job.poses_b->size();
  files::OutputFile file(path);
  file.append(array_header(job.query, count));
  AnswerTotals totals;
  totals.query = job.query;
  std::vector<Row> rows;
  for (std::size_t first = 0; first < count; first += kBlock) {
    rows.assign(std::min(kBlock, count - first), {});
    const BatchSettings batch{
        .threads = job.threads,
        .on_progress = [&](std::size_t done, std::size_t) { on_progress(first + done, count); }};
    for_each_in_batch(rows.size(), kMostInAPart, batch, &totals.work,
                      [&](std::size_t i, Work& work) {
                        const PoseAnswer answer = ask(job, job.poses_b->at(first + i), 1);
                        work += answer.work;
                        rows[i] = row_of(answer);
                      });
    for (const Row& row : rows) {
      append(file, job.query, row);
      add(totals, row);
    }
  }
  file.finish();
  return totals;
}

std::string to_json(const AnswerTotals& totals, const std::string& path) {
  nlohmann::ordered_json json = {{"poses", totals.poses}, {"intersecting", totals.intersecting}};
  if (totals.query == PairQuery::Pairs) json["pairs"] = totals.pairs;
  if (totals.query == PairQuery::Distance) {
    json["least_distance"] = totals.least_distance;
    json["nearest_pose"] = totals.nearest_pose;
  }
  json["file"] = path;
  // File names need not be UTF-8, but JSON must be.
  std::string line = json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  line.pop_back();
  append_work(line, totals.work);
  return line + "}\n";
}

std::string to_text(const AnswerTotals& totals, const std::string& path) {
  std::string text =
      fmt::format("{} pose{}, {} intersect{}", totals.poses, totals.poses == 1 ? "" : "s",
                  totals.intersecting, totals.intersecting == 1 ? "s" : "");
  if (totals.query == PairQuery::Pairs) text += fmt::format(", {} pairs", totals.pairs);
  if (totals.query == PairQuery::Distance) {
    text += fmt::format(", the least distance is {} m in pose {}", totals.least_distance,
                        totals.nearest_pose);
  }
  return text + fmt::format("; answers in {}\n", mesh_io::printable(path));
}

}  // namespace graze::cli
