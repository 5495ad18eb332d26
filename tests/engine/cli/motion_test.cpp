// What `graze motion` and `graze verify` answer, and that it is what the library says.

#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/rigid_certificate.h>
#include <graze/engine/mesh/rigid_contact.h>

#include <fstream>
#include <iterator>

#include "tests/engine/cli/two_meshes.h"

namespace graze::tests {
namespace {

using Json = nlohmann::ordered_json;

const std::string kBehind = "1 0 0 -10 0 1 0 0 0 0 1 0";
const std::string kAbove = "1 0 0 10 0 1 0 0 0 0 1 10";

class CliMotion : public TwoMeshes {
 protected:
  CommandResult motion(std::vector<std::string> options) const {
    options.insert(options.begin(), {"motion", "a.off", "b.off"});
    return graze(options);
  }
  Json json(const std::vector<std::string>& options) const {
    return Json::parse(json_of("motion", options));
  }
  std::string text_of(const char* name) const {
    std::ifstream file(folder_ / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  /// The certificate with one piece of its text replaced.
  void rewrite(const std::string& text, const std::string& from, const std::string& to) const {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, text.npos) << from;
    write("other.json", std::string(text).replace(at, from.size(), to));
  }
};

TEST_F(CliMotion, AnswersAreTheLibrarysBitForBit) {
  const Mesh mesh_a = load_mesh(folder_ / "a.off"), mesh_b = load_mesh(folder_ / "b.off");
  Pose start = Pose::Identity(), end = Pose::Identity();
  start.translation().x() = 10, end.translation().x() = -10;
  const RigidMotion rest(Pose::Identity()), through = RigidMotion::between(start, end);
  const RigidContact contact =
      first_contact({mesh_a, rest}, {mesh_b, through}, {.clearance = 0.25});
  ASSERT_EQ(contact.status, RigidStatus::Hit);
  const Json answer = json({"--from", kApart, "--to", kBehind, "--clearance", "0.25"});
  EXPECT_EQ(keys_of(answer),
            (Keys{"motion", "answer", "low", "high", "out_of_budget", "pose_b", "work"}));
  EXPECT_EQ(answer["answer"], "hit");
  EXPECT_EQ(answer["low"], contact.low);
  EXPECT_EQ(answer["high"], contact.high);
  EXPECT_EQ(answer["pose_b"][3], through.at(contact.high).translation().x());
  // The box ends at 1, and the ball's foremost vertex comes to its face.
  const double gap = 10 + mesh_b.bounds().min.x() - 1;
  EXPECT_NEAR(contact.low, (gap - 0.25) / 20, 1e-6);
}

TEST_F(CliMotion, APictureShowsTheFirstContact) {
  const Json answer = json({"--from", kApart, "--to", kBehind, "--picture", "met.svg"});
  EXPECT_EQ(answer["picture"], "met.svg");
  const std::string picture = text_of("met.svg");
  EXPECT_TRUE(picture.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" ")) << picture;
  EXPECT_TRUE(picture.ends_with("</svg>\n"));
  for (const char* colour : {"#1f6fb4", "#d95f02"})
    EXPECT_NE(picture.find(colour), picture.npos) << colour;
  // Nothing is drawn of what is free; of a path the first stretch that is not.
  EXPECT_FALSE(
      json({"--from", kAbove, "--to", kAbove, "--picture", "none.svg"}).contains("picture"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "none.svg"));
  write("path.txt", kApart + "\n" + kApart + "\n" + kBehind + "\n" + kApart + "\n");
  const std::vector<std::string> lines =
      lines_of(json_of("motion", {"--path", "path.txt", "--picture", "path.svg"}));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_FALSE(Json::parse(lines[0]).contains("picture"));
  EXPECT_EQ(Json::parse(lines[1])["picture"], "path.svg");
  EXPECT_FALSE(Json::parse(lines[2]).contains("picture"));
  EXPECT_EQ(motion({"--from", kApart, "--to", kBehind, "--picture", "a.off"}).exit_code, 2);
}

TEST_F(CliMotion, TurnsGoAlongAScrew) {
  // By half a turn about z, around the box: never nearer than 8 metres, though the chord goes
  // through.
  const Json around = json({"--from", kApart, "--screw", "0 0 0  0 0 1  3.141592653589793  0"});
  EXPECT_EQ(around["answer"], "free");
  EXPECT_EQ(json({"--from", kApart, "--to", kBehind})["answer"], "hit");
  const Json numbers =
      json({"--from", "1", "0",       "0", "10", "0", "1", "0", "0",  "0",    "0",
            "1",      "0", "--screw", "0", "0",  "0", "0", "0", "-1", "3.14", "-1"});
  EXPECT_EQ(numbers["answer"], "free");
}

TEST_F(CliMotion, APathIsAskedStretchByStretch) {
  write("path.txt", kApart + "\n" + kAbove + "\n" + kBehind + "\n" + kCrossing + "\n");
  const CommandResult result = motion({"--path", "path.txt"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const std::vector<std::string> lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_NE(lines[1].find("free"), std::string::npos) << lines[1];
  EXPECT_NE(lines[2].find("free"), std::string::npos) << lines[2];
  EXPECT_NE(lines[3].find("hit"), std::string::npos) << lines[3];
}

/// Also the counts of what each stretch did: trees are built for the first.
TEST_F(CliMotion, NothingDependsOnThreads) {
  std::string path;
  for (int i = 0; i < 14; ++i)
    path += kApart + "\n" + kAbove + "\n" + kBehind + "\n";
  write("path.txt", path);
  const auto told = [&](const std::string& threads) {
    return json_of("motion",
                   {"--path", "path.txt", "--threads", threads, "--picture", threads + ".svg"});
  };
  const std::string one = told("1");
  const std::vector<std::string> lines = lines_of(one);
  ASSERT_EQ(lines.size(), 41u);
  std::size_t free = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Json answer = Json::parse(lines[i]);
    EXPECT_EQ(answer["motion"], i);
    EXPECT_EQ(answer["work"]["trees_built"], i == 0 ? 4 : 0) << lines[i];
    free += answer["answer"] == "free";
  }
  EXPECT_EQ(free, 28u);  // from behind the way back leads through
  const auto without_name = [](std::string text, const std::string& name) {
    const std::size_t at = text.find(name);
    return at == text.npos ? text : text.erase(at, name.size());
  };
  for (const char* threads : {"2", "5", "0"}) {
    EXPECT_EQ(without_name(told(threads), std::string(threads) + ".svg"),
              without_name(one, "1.svg"));
    EXPECT_EQ(text_of((std::string(threads) + ".svg").c_str()), text_of("1.svg"));
  }
  EXPECT_EQ(motion({"--path", "path.txt", "--threads", "-1"}).exit_code, 2);
}

TEST_F(CliMotion, ABudgetThatEndsIsToldAndNothingIsCalledFree) {
  const Json answer = json({"--from", kApart, "--to", kBehind, "--budget", "1"});
  EXPECT_EQ(answer["answer"], "close");
  EXPECT_EQ(answer["out_of_budget"], true);
}

TEST_F(CliMotion, AProofIsWrittenAndVerified) {
  const Json answer = json({"--from", kApart, "--to", kAbove, "--certificate", "c.json"});
  EXPECT_EQ(answer["certificate"], "c.json");
  const CommandResult proved = graze({"verify", "c.json"});
  EXPECT_EQ(proved.exit_code, 0) << proved.err;
  EXPECT_TRUE(proved.out.starts_with("proved: b.off stays further than 0 m from a.off"))
      << proved.out;
  EXPECT_EQ(Json::parse(graze({"verify", "c.json", "--json"}).out)["proved"], true);
}

TEST_F(CliMotion, AProofOfSomethingElseIsRefused) {
  motion({"--from", kApart, "--to", kAbove, "--certificate", "c.json"});
  const std::string text = text_of("c.json");
  rewrite(text, "\"clearance\":\"0x0p+0\"", "\"clearance\":\"0x1p+6\"");
  EXPECT_EQ(graze({"verify", "other.json"}).exit_code, 1);
  rewrite(text, "\"shift\":[\"0x0p+0\",\"0x0p+0\",\"0x1.4p+3\"]",
          "\"shift\":[\"-0x1.4p+4\",\"0x0p+0\",\"0x0p+0\"]");
  EXPECT_EQ(graze({"verify", "other.json"}).exit_code, 1);
  rewrite(text, "\"steps\":[", "\"steps\":[\"halve_time\",");
  EXPECT_EQ(graze({"verify", "other.json"}).exit_code, 1);
  write_mesh("b.off", make_sphere(30, 8, 12));
  const CommandResult other_mesh = graze({"verify", "c.json"});
  EXPECT_EQ(other_mesh.exit_code, 1) << other_mesh.err;
  EXPECT_TRUE(other_mesh.out.starts_with("not proved: ")) << other_mesh.out;
}

TEST_F(CliMotion, WhatIsNotFreeHasNoProof) {
  const Json answer = json({"--from", kApart, "--to", kBehind, "--certificate", "c.json"});
  EXPECT_FALSE(answer.contains("certificate"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "c.json"));
}

TEST_F(CliMotion, BadInputIsRefused) {
  const std::vector<std::string> ask = {"motion", "a.off", "b.off"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), ask.begin(), ask.end());
    return more;
  };
  expect_refusal(ask, "graze: one of --to, --screw and --path says how B moves");
  expect_refusal(with({"--to", kAbove, "--path", "p.txt"}),
                 "graze: one of --to, --screw and --path says how B moves");
  expect_refusal(
      with({"--screw", "0 0 0"}),
      "graze: --screw: 3 numbers, a screw has 8: a point, an axis, an angle and a pitch");
  expect_refusal(with({"--screw", "0 0 0  0 0 0  1 0"}),
                 "graze: axis of a motion: it has no direction");
  expect_refusal(with({"--screw", "0 0 0  0 0 1  1 0", "--as-screw"}),
                 "graze: --as-screw is about motions between poses, which --screw is not");
  write("one.txt", kApart);
  expect_refusal(with({"--path", "one.txt"}), "graze: one.txt: one pose, a path has two or more");
  expect_refusal(with({"--path", "one.txt", "--certificate", "c.json"}),
                 "graze: --certificate and --path exclude each other: a proof is about one motion");
  expect_refusal(with({"--to", "2 0 0 0 0 1 0 0 0 0 1 0"}),
                 "graze: --to: not a rotation, max |R^T R - I| is 3, above 1e-06");
  write("far.txt", kApart + "\n" + kAbove + "\n1 0 0 1e160 0 1 0 0 0 0 1 0\n");
  expect_refusal(with({"--path", "far.txt"}),
                 "graze: motion 1: coordinates of the body, or squares of them, could overflow");
  write("bad.json", "{\"graze_certificate\":2}");
  expect_refusal(
      {"verify", "bad.json"},
      "graze: bad.json:1: /graze_certificate: is a version that this program does not know");
  expect_refusal({"verify", "none.json"}, "graze: none.json: does not exist");
}

}  // namespace
}  // namespace graze::tests
