// `graze compare` in parts, `graze merge`, and records that are damaged.

#include <graze/bvh/error.h>
#include <graze/engine/cli/compare/merge_run.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/compare/run/poses/block_cache.h>
#include <graze/engine/compare/run/poses/pose_source.h>
#include <graze/engine/compare/run/record/place_block.h>
#include <graze/engine/compare/run/record/time_code.h>
#include <graze/engine/compare/run/trial_threads.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/pose_text.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/engine/cli/compare/compare_fixture.h"

namespace graze::cli {
namespace {

class CliCompareParts : public CliCompare {
 protected:
  CliCompareParts() {
    options_.random = 100;
    options_.keep = 0;
    options_.is_json = true;
  }

  std::string part_file(std::size_t number) const {
    return directory_.path("part" + std::to_string(number));
  }

  /// Runs all parts, and returns their records.
  std::vector<std::string> run_parts(std::size_t count) {
    std::vector<std::string> files;
    for (std::size_t number = 1; number <= count; ++number) {
      options_.part = std::to_string(number) + "/" + std::to_string(count);
      options_.resume = part_file(number);
      files.push_back(options_.resume);
      EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
    }
    options_.part.clear();
    options_.resume.clear();
    return files;
  }

  ExitCode merge(const MergeOptions& options) {
    return run([&](Output& output) { return run_merge(options, output); });
  }

  std::string refusal(const MergeOptions& options) {
    try {
      merge(options);
    } catch (const CaseError& error) {
      return error.what();
    }
    return "none";
  }

  /// The summary line, without what hangs on times.
  static std::string totals(const std::string& out) {
    const std::size_t at = out.rfind("{\"summary\"");
    nlohmann::json summary = nlohmann::json::parse(out.substr(at, out.find('\n', at) - at));
    for (nlohmann::json& engine : summary["summary"]) {
      engine.erase("median_us");
      engine.erase("total_us");
    }
    return summary.dump();
  }

  /// Every pose of a record, without times.
  static std::vector<std::string> poses_in(const std::string& path) {
    compare::JournalReader file(path);
    std::vector<std::string> poses;
    for (std::string line; file.next(line);) {
      const cases::JsonValue tree = cases::parse_json(line, file.place());
      for (compare::PlaceRecord& record : compare::read_place_block(
               {tree, file.place()}, file.head().engines, poses.size(), file.head().places)) {
        for (compare::AnswerRecord& answer : record.answers)
          answer.time = 0;
        poses.push_back(to_json(record, "pose"));
      }
    }
    return poses;
  }
};

TEST_F(CliCompareParts, EightPartsAreOneRun) {
  options_.save = directory_.path("whole");
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  const std::string whole = totals(out_);
  options_.save.clear();
  std::vector<std::string> parts = run_parts(8);
  std::reverse(parts.begin(), parts.end());  // in whatever order they are named
  const std::string all = directory_.path("all");
  EXPECT_EQ(merge({.parts = parts, .save = all, .is_json = true}), ExitCode::Answered);
  EXPECT_EQ(totals(out_), whole);
  const std::vector<std::string> merged = poses_in(all);
  EXPECT_EQ(merged.size(), 100u);
  EXPECT_EQ(merged, poses_in(directory_.path("whole")));
  // The merged record is that of a run that is done: with it nothing is asked.
  options_.resume = all;
  const std::string record = read("all");
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  EXPECT_EQ(read("all"), record);
  EXPECT_EQ(totals(out_), whole);
  EXPECT_EQ(merge({.parts = parts, .fail_on = {"fcl:real"}}), ExitCode::Failed);
  EXPECT_EQ(merge({.parts = parts, .fail_on = {"graze"}}), ExitCode::Answered);
  EXPECT_THROW(compare(graze_and(compare::make_watched_engine("fcl", [] {}))), UsageError)
      << "another version of an engine";
}

TEST_F(CliCompareParts, WhatDoesNotFitIsRefusedByName) {
  std::vector<std::string> parts = run_parts(3);
  const std::vector<std::string> two = {parts[0], parts[2]};
  EXPECT_EQ(refusal({.parts = two}), "part 2 of 3 is missing");
  EXPECT_EQ(refusal({.parts = {parts[0], parts[1]}}), "part 3 of 3 is missing");
  EXPECT_EQ(refusal({.parts = {parts[0], parts[1], parts[1], parts[2]}}),
            parts[1] + ": is part 2 of 3, and so is " + parts[1]);
  options_.seed = 9;
  options_.part = "2/3";
  options_.resume = directory_.path("other");
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  EXPECT_EQ(refusal({.parts = {parts[0], options_.resume, parts[2]}}),
            options_.resume + ": is not of the job of " + parts[0] +
                ": poses of B random 100, seed 9, not random 100, seed 1");
  const std::string text = read("part2");
  directory_.write("part2", text.substr(0, text.find('\n') + 1));
  EXPECT_EQ(refusal({.parts = parts}),
            parts[1] + ": has 0 of its 33 poses: the command that made it goes on with it");
  options_.save = directory_.path("all");
  EXPECT_THROW(merge({.parts = parts, .save = parts[0]}), UsageError) << "what is read";
}

TEST_F(CliCompareParts, APartNeedsARecordAndANumber) {
  for (const char* part : {"1", "0/3", "4/3", "1/0", "a/3", "1/101", "-1/3", "1/3/4"}) {
    options_.part = part;
    options_.resume = directory_.path("run");
    EXPECT_THROW(compare(with_wrong_fcl()), UsageError) << part;
  }
  options_.part = "1/3";
  options_.resume.clear();
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError) << "nothing to merge";
}

/// One character of a line, wherever it stands.
TEST_F(CliCompareParts, ADamagedRecordIsKnownByItsLine) {
  options_.resume = directory_.path("run");
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  const std::string whole = read("run");
  for (std::size_t at = 1; at < whole.size(); at += 997) {
    if (whole[at] == '\n') continue;
    std::string text = whole;
    text[at] = text[at] == '0' ? '1' : '0';
    directory_.write("run", text);
    const auto number = 1 + std::count(whole.begin(), whole.begin() + static_cast<long>(at), '\n');
    const std::string line = options_.resume + ":" + std::to_string(number);
    try {
      compare(with_wrong_fcl());
      ADD_FAILURE() << at;
    } catch (const Error& error) {
      EXPECT_TRUE(std::string(error.what()).find(line) != std::string::npos ||
                  std::string(error.what()).find("--resume: ") == 0)
          << error.what();
    }
    EXPECT_EQ(read("run"), text) << "a file that is refused is left as it is";
  }
}

/// Wherever a run is killed, it goes on with what it had.
TEST_F(CliCompareParts, ARecordCutAnywhereIsGoneOnWith) {
  options_.random = 24;
  options_.resume = directory_.path("run");
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  const std::string whole = read("run");
  const std::string first = totals(out_);
  for (std::size_t size = 0; size < whole.size(); size += whole.size() / 16) {
    directory_.write("run", whole.substr(0, size));
    EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered) << size;
    EXPECT_EQ(totals(out_), first);
    EXPECT_EQ(poses_in(options_.resume).size(), 24u);
  }
}

TEST_F(CliCompareParts, TwoRunsDoNotShareARecord) {
  options_.resume = directory_.path("run");
  const compare::JournalFile other(options_.resume);
  try {
    compare(with_wrong_fcl());
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_EQ(std::string(error.what()), options_.resume + ": another run is writing it");
  }
}

TEST_F(CliCompareParts, AgreedPosesTakeAFewBytes) {
  options_.query = "any";
  options_.random = 4000;
  options_.save = directory_.path("run");
  std::vector<EngineEntry> engines;
  for (const char* name : {"graze", "b", "c", "d", "e"})
    engines.push_back({name, compare::make_off_engine(name, 0)});
  EXPECT_EQ(compare(engines), ExitCode::Answered);
  EXPECT_LT(read("run").size(), 4000u * 16) << "five engines, yes or no";
  options_.query = "pairs";
  engines.resize(2);
  EXPECT_EQ(compare(engines), ExitCode::Answered);
  EXPECT_LT(read("run").size(), 4000u * 24) << "two engines and the digest of a list";
  EXPECT_EQ(poses_in(options_.save).size(), 4000u);
}

/// Whatever takes long, and on however many threads: in order, and nothing is held that is far
/// ahead.
TEST(RunInOrder, HandsOnEverythingOnceAndInOrder) {
  for (const std::size_t threads : {1, 3, 8}) {
    for (const std::size_t end : {0, 1, 7, 100, 5000, 40000}) {
      std::size_t next = 3;
      std::atomic<std::size_t> ahead = 0;
      std::atomic<std::size_t> most_ahead = 0;
      compare::run_in_order<std::size_t>(
          {.first = 3, .end = end, .threads = threads, .most_at_once = 64},
          [](std::size_t place) { return place; },
          [&](std::size_t place, std::size_t token) {
            EXPECT_EQ(place, token);
            if (place % 97 == 0) std::this_thread::yield();
            const std::size_t now = ++ahead;
            if (now > most_ahead) most_ahead = now;
            return place;
          },
          [&](const std::vector<std::size_t>& places) {
            for (const std::size_t place : places) {
              EXPECT_EQ(place, next++);
              --ahead;
            }
            return true;
          });
      EXPECT_EQ(next, std::max<std::size_t>(end, 3));
      EXPECT_LE(most_ahead, 64 * 5 * threads + threads);
    }
  }
}

TEST(RunInOrder, StopsWithoutAHole) {
  std::size_t next = 0;
  compare::run_in_order<std::size_t>(
      {.end = 100000, .threads = 4}, [](std::size_t) { return 0; },
      [](std::size_t place, int) { return place; },
      [&](const std::vector<std::size_t>& places) {
        for (const std::size_t place : places)
          EXPECT_EQ(place, next++);
        return next < 5000;
      });
  EXPECT_GE(next, 5000u);
  EXPECT_LT(next, 100000u);
  EXPECT_THROW(compare::run_in_order<std::size_t>(
                   {.end = 1000, .threads = 4}, [](std::size_t) { return 0; },
                   [](std::size_t place, int) {
                     if (place == 500) throw InputError("at 500");
                     return place;
                   },
                   [&](const std::vector<std::size_t>& places) { return places.front() < 500; }),
               InputError);
}

/// A part makes its poses without those before it, and they are those of the whole.
TEST(PoseSource, DrawsAnyPoseByItself) {
  const Mesh a = tests::make_torus(1, 0.25, 10, 8);
  const Mesh b = tests::make_box({0.5, 0.5, 0.5});
  const auto whole = compare::random_pose_source(CaseMesh(a, Pose::Identity()), b, 3000, 5);
  const std::vector<Pose> first = compare::random_poses({a}, b, 1024, 5);
  for (std::size_t i = 0; i < first.size(); ++i)
    ASSERT_TRUE(whole->at(i).matrix() == first[i].matrix()) << i;
  const auto again = compare::random_pose_source(CaseMesh(a, Pose::Identity()), b, 3000, 5);
  for (const std::size_t i : {2999, 1500, 1024, 0})
    EXPECT_TRUE(again->at(i).matrix() == whole->at(i).matrix()) << i;
  EXPECT_FALSE(whole->at(1024).matrix() == whole->at(0).matrix());
  const auto grazing = compare::grazing_pose_source(CaseMesh(a, Pose::Identity()), b, 1030, 5);
  for (const std::size_t i : {1025, 1024, 3})
    EXPECT_EQ(intersects({a}, {b, grazing->at(i)}), i % 2 == 0) << i;
}

/// Whoever waits for a block makes one of the next: all of them once, and none beyond the end.
TEST(PoseSourceThreads, BlocksAreMadeAheadByThoseWhoWait) {
  std::atomic<std::size_t> makers = 0;
  std::atomic<std::size_t> most = 0;
  std::mutex mutex;
  std::map<std::size_t, int> made;
  const compare::BlockCache<std::size_t> blocks(
      [&](std::size_t block) {
        most = std::max<std::size_t>(most, ++makers);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        --makers;
        const std::lock_guard lock(mutex);
        ++made[block];
        return std::vector<std::size_t>{block};
      },
      6);
  std::vector<std::thread> threads;
  for (int i = 0; i < 3; ++i) {
    threads.emplace_back([&] {
      for (std::size_t block = 0; block < 6; ++block)
        EXPECT_EQ(blocks.at(block)->front(), block);
    });
  }
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(made.size(), 6u);
  for (const auto& [block, count] : made)
    EXPECT_EQ(count, 1) << block;
  EXPECT_GT(most, 1u) << "at the same time";
}

TEST(PoseSource, OfATextStaysInIt) {
  tests::TemporaryDirectory directory;
  std::string text;
  for (int i = 0; i < 2100; ++i) {
    if (i % 7 == 0) text += " \n";
    text += "1 0 0 " + std::to_string(i) + " 0 1 0 0 0 0 1 0" + (i == 2099 ? "" : "\n");
  }
  const auto poses =
      compare::pose_file(directory.write("poses.txt", text), Aabb{{0, 0, 0}, {1, 1, 1}});
  ASSERT_EQ(poses->size(), 2100u);
  for (const std::size_t i : {2099, 1024, 1023, 0, 2048})
    EXPECT_EQ(poses->at(i)(0, 3), static_cast<double>(i));
  EXPECT_EQ(poses->key(), compare::pose_list(load_poses(directory.path("poses.txt")))->key());
  directory.write("poses.txt", text + "\n1 2\n");
  try {
    compare::pose_file(directory.path("poses.txt"), Aabb{{0, 0, 0}, {1, 1, 1}});
    FAIL() << "a line of two numbers";
  } catch (const PoseError& error) {
    EXPECT_NE(std::string(error.what()).find("poses.txt:2401: 2 numbers"), std::string::npos)
        << error.what();
  }
}

TEST(TimeCode, IsOffByLessThanAThousandth) {
  using compare::recorded_time;
  for (const double exact : {0.0, 1.0, 3.0, 0.5, 1024.0, 1023.0, 65.5})
    EXPECT_EQ(recorded_time(exact), exact);
  for (double time = 1e-5; time < 1e12; time *= 1.0137) {
    const double coded = recorded_time(time);
    EXPECT_LE(std::abs(coded - time), time * 0x1p-11) << time;
    EXPECT_EQ(recorded_time(coded), coded) << "once is enough";
  }
  EXPECT_GT(recorded_time(1e-300), 0);
  EXPECT_LT(recorded_time(INFINITY), 1e14);
  EXPECT_EQ(recorded_time(NAN), 0);
  EXPECT_EQ(recorded_time(-1), 0);
}

TEST(TimeCode, MediansAreThoseOfAList) {
  compare::TimeMedian times;
  EXPECT_EQ(times.median(), 0);
  std::vector<double> list;
  for (int i = 0; i < 1001; ++i) {
    list.push_back(compare::recorded_time(1 + (i * 7919) % 1001 * 0.25));
    times.add(list.back());
  }
  std::nth_element(list.begin(), list.begin() + 500, list.end());
  EXPECT_EQ(times.median(), list[500]);
}

}  // namespace
}  // namespace graze::cli
