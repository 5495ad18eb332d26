// `graze simulate --record`, and what `graze replay` and `graze view` make of the file.

#include <graze/engine/record/read_recording.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/engine/cli/command_test.h"
#include "tests/engine/view/unpacked_page.h"

namespace graze::tests {
namespace {

using nlohmann::json;

constexpr const char* kScene =
    R"({"graze_scene": 1, "note": "a ball falls", "step": 0.25, "steps": 8,
 "shapes": [{"name": "ball", "sphere": {"radius": 1}},
            {"name": "floor", "half_space": {"normal": [0, 0, 1]}}],
 "bodies": [
  {"name": "floor", "shape": "floor", "motion": "static"},
  {"name": "the ball", "shape": "ball", "pose": {"position": [0, 0, 2.1]}, "path": {"velocity": [0, 0, -1]}}]})";

class CliRecord : public CommandTest {
 protected:
  CliRecord() { write("fall.json", kScene); }

  void record(const std::string& scene, const std::string& file,
              std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"simulate", scene, "--record", file};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const CommandResult result = graze(arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
  }

  std::string bytes_of(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

TEST_F(CliRecord, ARunIsRepeatedWithAnyNumberOfThreads) {
  record("fall.json", "fall.recording", {"--contacts"});
  for (const char* threads : {"1", "3"}) {
    const CommandResult result =
        graze({"replay", "fall.recording", "--threads", threads, "--work"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, std::string("fall.recording: by graze ") + GRAZE_VERSION +
                              ", 9 updates\nno difference: now, graze " + GRAZE_VERSION +
                              ", threads " + threads + "\n");
  }
  const CommandResult result = graze({"replay", "fall.recording", "--json"});
  const json said = json::parse(result.out);
  EXPECT_EQ(said["file"], "fall.recording");
  EXPECT_EQ(said["updates"], 9);
  EXPECT_EQ(said["complete"], true);
  EXPECT_EQ(said["differing"], 0);
  EXPECT_FALSE(said.contains("difference"));
}

TEST_F(CliRecord, ScenesOfThePackageAreRepeated) {
  const std::string data = GRAZE_DATA_DIR;
  for (const char* scene : {"shapes", "parts", "terrain", "fast"}) {
    record(data + "/scenes/" + scene + ".json", "run.recording", {"--steps", "40"});
    const CommandResult result = graze({"replay", "run.recording", "--threads", "2", "--work"});
    EXPECT_EQ(result.exit_code, 0) << scene << ": " << result.out << result.err;
  }
}

TEST_F(CliRecord, WhatTheCommandPrintsIsWhatItPrintsWithout) {
  const CommandResult alone = graze({"simulate", "fall.json", "--contacts", "--json"});
  const CommandResult recorded =
      graze({"simulate", "fall.json", "--contacts", "--json", "--record", "x.recording"});
  EXPECT_EQ(recorded.out, alone.out);
}

TEST_F(CliRecord, TwoRunsAreHeldAgainstEachOther) {
  std::string other = kScene;
  other.replace(other.find("2.1]"), 4, "2.3]");
  write("other.json", other);
  record("fall.json", "fall.recording");
  record("fall.json", "again.recording", {"--threads", "2"});
  record("other.json", "other.recording");
  record("fall.json", "short.recording", {"--steps", "3"});
  EXPECT_EQ(graze({"replay", "fall.recording", "--against", "again.recording", "--work"}).exit_code,
            0);
  const CommandResult result =
      graze({"replay", "fall.recording", "--against", "other.recording", "--json"});
  EXPECT_EQ(result.exit_code, 1);
  const json said = json::parse(result.out)["difference"];
  EXPECT_EQ(said["update"], 0);
  EXPECT_EQ(said["what"], "change 1");
  EXPECT_EQ(said["is_input"], true);
  const CommandResult brief = graze({"replay", "fall.recording", "--against", "short.recording"});
  EXPECT_EQ(brief.exit_code, 1);
  EXPECT_NE(brief.out.find("update 4, t = 1 s: updates\n  recorded: goes on\n"), std::string::npos)
      << brief.out;
}

TEST_F(CliRecord, ACutOffRunIsRepeatedAsFarAsItGoesAndADamagedOneIsRefused) {
  record("fall.json", "fall.recording");
  const std::string bytes = bytes_of("fall.recording");
  write("cut.recording", bytes.substr(0, bytes.size() - 20));
  const CommandResult cut = graze({"replay", "cut.recording"});
  EXPECT_EQ(cut.exit_code, 0);
  EXPECT_NE(cut.out.find("8 updates, then cut off\n"), std::string::npos) << cut.out;
  std::string damaged = bytes;
  damaged[bytes.size() - 40] = static_cast<char>(damaged[bytes.size() - 40] ^ 4);
  write("damaged.recording", damaged);
  for (const char* command : {"replay", "view"}) {
    const CommandResult result = graze({command, "damaged.recording"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err.find("graze: damaged.recording: byte "), 0u) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "graze-view.html"));
  }
}

TEST_F(CliRecord, AnInterruptedRunCanBeRepeated) {
  std::string longer = kScene;
  longer.replace(longer.find("\"steps\": 8"), 10, "\"steps\": 9000000");
  write("long.json", longer);
  const CommandResult stopped =
      interrupt_graze(folder_, {"simulate", "long.json", "--record", "long.recording"}, [this] {
        std::error_code ignored;
        return std::filesystem::file_size(folder_ / "long.recording", ignored) > 2000 && !ignored;
      });
  EXPECT_EQ(stopped.exit_code, 130);
  EXPECT_EQ(stopped.err.find("graze: interrupted: long.recording has the steps until "), 0u)
      << stopped.err;
  const CommandResult result = graze({"replay", "long.recording", "--json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(json::parse(result.out)["complete"], true);
}

TEST_F(CliRecord, ThePageShowsEachUpdateOrWhatIsAskedFor) {
  record("fall.json", "fall.recording");
  const CommandResult result = graze({"view", "fall.recording", "-o", "fall.html", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(json::parse(result.out)["pictures"], 9);
  const UnpackedPage page(bytes_of("fall.html"));
  const auto& frames = page.json()["frames"];
  ASSERT_EQ(frames.size(), 9u);
  EXPECT_EQ(frames[2]["label"], "t = 0.5 s, update 2");
  EXPECT_EQ(frames[4]["state"], "clear");
  EXPECT_EQ(frames[5]["state"], "touching");
  EXPECT_EQ(page.json()["bodies"][1]["name"], "the ball");
  EXPECT_TRUE(page.marks("contacts", 7, 4).empty());
  EXPECT_FALSE(page.marks("contacts", 7, 5).empty());
  const auto pairs = page.json()["marks"]["pairs"];
  const std::vector<std::uint32_t> starts = page.words(pairs["starts"]);
  EXPECT_EQ(starts[5], 0u) << "nothing touches before";
  EXPECT_EQ(starts[6], 1u);
  EXPECT_EQ(page.words(pairs["list"])[0], 0u);
  EXPECT_EQ(page.words(pairs["list"])[1], 1u);
  const CommandResult thinned =
      graze({"view", "fall.recording", "-o", "few.html", "--every", "4", "--json"});
  EXPECT_EQ(json::parse(thinned.out)["pictures"], 4) << "0, 4, 8, and 5, where the two touch";
  EXPECT_NE(UnpackedPage(bytes_of("few.html")).json()["notes"].dump().find("one update of 4"),
            std::string::npos);
}

/// The JSON of a GLB, and the numbers of an accessor of floats.
struct Glb {
  explicit Glb(std::string of) : bytes(std::move(of)) {
    json_length = u32(12);
    file = json::parse(bytes.substr(20, json_length));
  }
  std::uint32_t u32(std::size_t at) const {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
  }
  std::vector<float> floats(std::size_t accessor, std::size_t width) const {
    const json& of = file["accessors"][accessor];
    const json& view = file["bufferViews"][of["bufferView"].get<std::size_t>()];
    std::vector<float> numbers(width * of["count"].get<std::size_t>());
    EXPECT_EQ(view["byteLength"], numbers.size() * sizeof(float));
    std::memcpy(numbers.data(),
                bytes.data() + 28 + json_length + view["byteOffset"].get<std::size_t>(),
                numbers.size() * sizeof(float));
    return numbers;
  }

  std::string bytes;
  std::size_t json_length = 0;
  json file;
};

TEST_F(CliRecord, AnotherProgramSeesTheSameMotion) {
  record("fall.json", "fall.recording");
  const CommandResult result = graze({"view", "fall.recording", "-o", "fall.glb", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(json::parse(result.out)["pictures"], 9);
  const Glb glb(bytes_of("fall.glb"));
  EXPECT_EQ(glb.bytes.substr(0, 4), "glTF");
  EXPECT_EQ(glb.u32(4), 2u);
  EXPECT_EQ(glb.u32(8), glb.bytes.size());
  EXPECT_EQ(glb.file["asset"]["version"], "2.0");
  EXPECT_EQ(glb.file["meshes"].size(), 2u);
  ASSERT_EQ(glb.file["nodes"].size(), 3u) << "two bodies, and what turns z up";
  EXPECT_EQ(glb.file["nodes"][1]["name"], "the ball");
  const json& channels = glb.file["animations"][0]["channels"];
  ASSERT_EQ(channels.size(), 2u) << "the floor stands";
  EXPECT_EQ(channels[0]["target"], (json{{"node", 1}, {"path", "translation"}}));
  const json& sampler = glb.file["animations"][0]["samplers"][0];
  const std::vector<float> times = glb.floats(sampler["input"].get<std::size_t>(), 1);
  const std::vector<float> ways = glb.floats(sampler["output"].get<std::size_t>(), 3);
  ASSERT_EQ(times.size(), 9u);
  ASSERT_EQ(ways.size(), 27u);
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_FLOAT_EQ(times[i], 0.25F * static_cast<float>(i));
    EXPECT_NEAR(ways[3 * i + 2], 2.1F - times[i], 1e-6);
  }
  EXPECT_EQ(graze({"view", "fall.recording", "-o", "x.glb", "--open"}).exit_code, 2);
}

TEST_F(CliRecord, OptionsThatDoNotGoTogetherAreRefused) {
  record("fall.json", "fall.recording");
  const auto refuse = [&](std::vector<std::string> arguments, const std::string& why) {
    const CommandResult result = graze(arguments);
    EXPECT_EQ(result.exit_code, 2) << why;
    EXPECT_NE(result.err.find(why), std::string::npos) << result.err;
  };
  refuse({"simulate", "fall.json", "--record", "fall.json"}, "--record");
  refuse({"replay", "fall.recording", "fall.recording"}, "a recording is replayed by itself");
  refuse({"replay", "fall.recording", "--same"}, "are about cases: here is a recording");
  refuse({"replay", "fall.json", "--work"}, "are about a recording: here is none");
  refuse({"replay", "fall.recording", "--against", "fall.json"},
         "fall.json: byte 0: is no recording of a world");
  refuse({"replay", "fall.recording", "--against", "fall.recording", "--threads", "2"},
         "--threads is about repeating a recording");
  refuse({"view", "fall.recording", "--pose-b", "1 0 0 0 0 1 0 0 0 0 1 0"},
         "are not about recordings");
  refuse({"view", "fall.json", "--every", "2"}, "--every is about a recording");
}

}  // namespace
}  // namespace graze::tests
