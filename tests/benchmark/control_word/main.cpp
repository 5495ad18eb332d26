// What it costs that each call reads the control word: the same few operations with and without,
// and the lightest calls of the library, where the word is right and where it is not.

#include <graze/bvh/fit/measure.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/narrowphase/volumes/sphere_overlap.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/benchmark/common/processor_name.h"
#include "tests/benchmark/common/thread_clock.h"

namespace graze::benchmark {
namespace {

// Not inlined, as a function of a library is not; each waits for what the one before returned.
[[gnu::noinline]] double bare(double x) {
  return x * 0.5 + 1;
}

[[gnu::noinline]] double reading(double x) {
  return bvh::in_standard_arithmetic([&] { return x * 0.5 + 1; });
}

double of_sphere(double x) {
  return volume(Sphere{{0, 0, 0}, x}) * 0x1p-10 + 1;
}

double of_spheres(double x) {
  return intersects(Sphere{{0, 0, 0}, 1}, Sphere{{x, 0, 0}, 1}) ? 1.0 : 1.5;
}

struct Contestant {
  const char* name;
  double (*call)(double);
  bool is_flushing;  // the program takes denormal numbers for zero, so that each call sets the word
  std::vector<double> nanoseconds;
};

double nanoseconds_of(const Contestant& contestant, int calls) {
  const std::uint64_t standard = bvh::read_control_word();
  constexpr std::uint64_t kFlushing = bvh::kStandardControlWord ^ 0x8040;
  if (contestant.is_flushing) bvh::write_control_word(kFlushing);
  const ThreadClock clock;
  double x = 1;
  for (int i = 0; i < calls; ++i)
    x = contestant.call(x);
  const double time = clock.nanoseconds();
  bvh::write_control_word(standard);
  if (!(x > 0)) std::abort();  // so that no call is left out
  return time / calls;
}

void run(int rounds, const std::string& output) {
  constexpr int kCalls = 100000;
  std::array<Contestant, 6> contestants{{{"two operations", bare, false, {}},
                                         {"the same, reading the word", reading, false, {}},
                                         {"the same, setting the word", reading, true, {}},
                                         {"volume of a sphere", of_sphere, false, {}},
                                         {"two spheres, yes or no", of_spheres, false, {}},
                                         {"the same, setting the word", of_spheres, true, {}}}};
  for (int round = 0; round < rounds; ++round) {
    for (Contestant& contestant : contestants)
      contestant.nanoseconds.push_back(nanoseconds_of(contestant, kCalls));
  }
  std::vector<double> differences;
  for (std::size_t i = 0; i < contestants[0].nanoseconds.size(); ++i)
    differences.push_back(contestants[1].nanoseconds[i] - contestants[0].nanoseconds[i]);
  nlohmann::ordered_json document{{"processor", processor_name()},
                                  {"rounds", rounds},
                                  {"nanoseconds_to_read", median(differences)},
                                  {"rows", nlohmann::ordered_json::array()}};
  for (const Contestant& contestant : contestants) {
    const double nanoseconds = median(contestant.nanoseconds);
    std::printf("%-28s %7.2f ns\n", contestant.name, nanoseconds);
    document["rows"].push_back({{"call", contestant.name}, {"nanoseconds", nanoseconds}});
  }
  std::printf("%-28s %7.2f ns\n", "to read the word", median(differences));
  std::ofstream(output) << document.dump(2) << "\n";
}

}  // namespace
}  // namespace graze::benchmark

int main(int argc, char** argv) {
  CLI::App app{"Nanoseconds a call: what it costs to read the control word"};
  std::string output = "control_word.json";
  int rounds = 101;
  app.add_option("--output", output, "where to write the figures as JSON")->capture_default_str();
  app.add_option("--rounds", rounds, "rounds, of which medians are taken")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  graze::benchmark::run(rounds, output);
}
