// Many rays, poses and motions at a world in one call, by one thread and by all, beside the same
// questions in a loop, and beside other libraries asked in one. Contestants take turns, and medians
// are compared: of a clock on the wall, for that is what threads are to save, and of the
// processors' time, which a busy machine disturbs less. Prints a table and writes JSON. Exit code 1
// if a batch answers otherwise than the loop.

#include <graze/engine/world/world_batch.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/benchmark/common/processor_name.h"
#include "tests/benchmark/common/stopwatch.h"
#include "tests/benchmark/world_batches/peer.h"

namespace graze::benchmark {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string output;
  std::size_t bodies = 10000;
  std::size_t elements = 30000;
  int rounds = 7;
  std::vector<int> threads = {1, 0};
};

struct Contestant {
  std::string name;
  /// How many elements meet something; nothing for no such question. Answers that differ from those
  /// of the loop are counted.
  std::function<std::optional<std::size_t>(Question)> ask;
};

/// What the world itself answers in a loop, and in one call.
template <typename Answer>
struct Ways {
  std::function<Answer(std::size_t)> single;
  std::function<std::vector<Answer>(const BatchSettings&)> batch;
};

template <typename T>
bool meets(const std::vector<T>& list) {
  return !list.empty();
}
bool meets(const std::optional<BodyRayHit>& hit) {
  return hit.has_value();
}
bool meets(const std::optional<BodyCast>& met) {
  return met.has_value();
}
bool meets(const std::optional<BodyDistance>& nearest) {
  return nearest && nearest->distance.distance == 0;
}

/// The library's own contestants: answers stay until the next round, so that freeing the last ones
/// is part of each turn of both.
class Graze {
 public:
  explicit Graze(const Questions& all) : all_(all) {
    for (const PlacedShape& body : all.bodies)
      world_.add({body.shape, body.pose});
    world_.update();
  }

  std::size_t ask_loop(Question question) {
    return with_ways(question, [&](const auto& ways, auto& expected) {
      const std::size_t count = all_.poses.size();
      expected.clear();
      expected.reserve(count);
      for (std::size_t i = 0; i < count; ++i)
        expected.push_back(ways.single(i));
      return count_of(expected);
    });
  }

  std::size_t ask_batch(Question question, int threads) {
    return with_ways(question, [&](const auto& ways, const auto&) {
      return count_of(ways.batch({.threads = threads}));
    });
  }

  /// Whether the batch answers what the loop did last, bit for bit.
  bool is_same(Question question, int threads) {
    return with_ways(question, [&](const auto& ways, const auto& expected) -> std::size_t {
             return ways.batch({.threads = threads}) == expected ? 1 : 0;
           }) == 1;
  }

 private:
  template <typename Answer>
  static std::size_t count_of(const std::vector<Answer>& answers) {
    std::size_t count = 0;
    for (const Answer& answer : answers)
      count += meets(answer);
    return count;
  }

  PlacedShapeView probe_at(std::size_t i) const { return {all_.probe, all_.poses[i]}; }

  template <typename Use>
  std::size_t with_ways(Question question, const Use& use) {
    const ShapeInPoses poses(all_.probe, all_.poses);
    switch (question) {
      case Question::Rays:
        return use(Ways<std::optional<BodyRayHit>>{
                       [&](std::size_t i) { return world_.cast_ray(all_.rays[i]); },
                       [&](const BatchSettings& batch) {
                         return cast_rays(world_, all_.rays, {}, batch);
                       }},
                   rays_);
      case Question::Touching:
        return use(Ways<std::vector<BodyId>>{
                       [&](std::size_t i) { return world_.find_touching(probe_at(i)); },
                       [&](const BatchSettings& b) { return find_touching(world_, poses, {}, b); }},
                   touching_);
      case Question::Within:
        return use(Ways<std::vector<BodyDistance>>{
                       [&](std::size_t i) { return world_.find_within(probe_at(i), kClearance); },
                       [&](const BatchSettings& b) {
                         return find_within(world_, poses, kClearance, {}, b);
                       }},
                   within_);
      case Question::Closest:
        return use(Ways<std::optional<BodyDistance>>{
                       [&](std::size_t i) { return world_.find_closest(probe_at(i)); },
                       [&](const BatchSettings& b) { return find_closest(world_, poses, {}, b); }},
                   closest_);
      case Question::Casts:
        break;
    }
    return use(
        Ways<std::optional<BodyCast>>{[&](std::size_t i) {
                                        return world_.cast({all_.probe, all_.motions[i]});
                                      },
                                      [&](const BatchSettings& b) {
                                        return cast(world_, {all_.probe, all_.motions}, {}, {}, b);
                                      }},
        casts_);
  }

  const Questions& all_;
  World world_;
  // What the loop answered last.
  std::vector<std::optional<BodyRayHit>> rays_;
  std::vector<std::vector<BodyId>> touching_;
  std::vector<std::vector<BodyDistance>> within_;
  std::vector<std::optional<BodyDistance>> closest_;
  std::vector<std::optional<BodyCast>> casts_;
};

std::vector<std::unique_ptr<BatchPeer>> make_peers([[maybe_unused]] const Questions& all) {
  std::vector<std::unique_ptr<BatchPeer>> peers;
#ifdef GRAZE_HAS_BULLET
  peers.push_back(make_bullet(all));
#else
  std::puts("without Bullet, which was not found");
#endif
#ifdef GRAZE_HAS_FCL
  peers.push_back(make_fcl(all));
#else
  std::puts("without FCL, which was not found");
#endif
  return peers;
}

std::string name_of_batch(int threads) {
  return threads == 0   ? "batch, all threads"
         : threads == 1 ? "batch, one thread"
                        : "batch, " + std::to_string(threads) + " threads";
}

Json measured(Question question, const std::vector<Contestant>& contestants,
              const Options& options) {
  std::vector<std::vector<double>> times(contestants.size()), busy(contestants.size());
  std::vector<std::optional<std::size_t>> hits(contestants.size());
  for (int round = 0; round <= options.rounds; ++round) {
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      const std::size_t who = (i + static_cast<std::size_t>(round)) % contestants.size();
      const Stopwatch watch;
      const std::clock_t began = std::clock();
      hits[who] = contestants[who].ask(question);
      const double spent = 1e6 * static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
      const double taken = watch.microseconds();
      if (round == 0) continue;  // which warms up
      times[who].push_back(taken / static_cast<double>(options.elements));
      busy[who].push_back(spent / static_cast<double>(options.elements));
    }
  }
  Json rows = Json::array();
  const double loop = median(times[0]), busy_loop = median(busy[0]);
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    if (!hits[i]) continue;
    const double time = median(times[i]), spent = median(busy[i]);
    std::printf("%-9s %-20s %8.3f us %6.2f  of processors %8.3f us %6.2f  %6.2f %% meet\n",
                name_of(question), contestants[i].name.c_str(), time, loop / time, spent,
                busy_loop / spent,
                100 * static_cast<double>(*hits[i]) / static_cast<double>(options.elements));
    rows.push_back({{"question", name_of(question)},
                    {"contestant", contestants[i].name},
                    {"microseconds", time},
                    {"speed", loop / time},
                    {"processor_microseconds", spent},
                    {"processor_speed", busy_loop / spent},
                    {"meet", *hits[i]}});
  }
  std::fflush(stdout);
  return rows;
}

int run(const Options& options) {
  const Questions all = make_questions(options.bodies, options.elements);
  Graze graze(all);
  const auto peers = make_peers(all);
  std::vector<Contestant> contestants{
      {"loop", [&](Question question) { return graze.ask_loop(question); }}};
  for (const int threads : options.threads) {
    contestants.push_back({name_of_batch(threads), [&graze, threads](Question question) {
                             return graze.ask_batch(question, threads);
                           }});
  }
  for (const auto& peer : peers) {
    contestants.push_back(
        {peer->name(), [&](Question question) { return peer->ask(question, all); }});
  }
  Json rows = Json::array();
  int status = 0;
  for (const Question question : kQuestions) {
    for (const Json& row : measured(question, contestants, options))
      rows.push_back(row);
    for (const int threads : options.threads) {
      if (graze.is_same(question, threads)) continue;
      std::printf("%s: %s answers otherwise\n", name_of(question), name_of_batch(threads).c_str());
      status = 1;
    }
  }
  if (!options.output.empty()) {
    std::ofstream(options.output) << Json{{"processor", processor_name()},
                                          {"cores", std::thread::hardware_concurrency()},
                                          {"bodies", options.bodies},
                                          {"elements", options.elements},
                                          {"rounds", options.rounds},
                                          {"rows", rows}}
                                         .dump(1)
                                  << '\n';
  }
  return status;
}

}  // namespace
}  // namespace graze::benchmark

int main(int argc, char** argv) try {
  graze::benchmark::Options options;
  CLI::App app("Many questions at a world in one call, beside the same in a loop");
  app.add_option("--output", options.output, "JSON file");
  app.add_option("--bodies", options.bodies, "of the world")->check(CLI::Range(1, 10000000));
  app.add_option("--elements", options.elements, "of each question")
      ->check(CLI::Range(1, 100000000));
  app.add_option("--rounds", options.rounds, "repetitions")->check(CLI::Range(1, 1000));
  app.add_option("--threads", options.threads, "of batches; 0: all (default 1 0)")
      ->check(CLI::Range(0, 1024));
  CLI11_PARSE(app, argc, argv);
  return graze::benchmark::run(options);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
