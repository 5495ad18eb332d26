// `graze pair --output`: the array is what the rows of the same command say, and what the library
// says.

#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/load_mesh.h>

#include <bit>
#include <cstdint>
#include <fstream>
#include <iterator>

#include "tests/engine/cli/saved_poses.h"
#include "tests/engine/cli/two_meshes.h"

namespace graze::tests {
namespace {

using Json = nlohmann::ordered_json;

class CliAnswerFile : public TwoMeshes {
 protected:
  CliAnswerFile() {
    for (int i = 0; i < 40; ++i) {
      Pose pose = Pose::Identity();
      pose.translation() << 1.5 + 0.03125 * i, 0.25, 0.125;
      poses_.push_back(pose);
    }
    save_poses(folder_ / "poses.npy", poses_.size(), [&](std::size_t i) { return poses_[i]; });
  }

  std::string read(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  /// The rows that the command prints without a file, and what it writes to one.
  std::vector<Json> rows(const std::vector<std::string>& options) const {
    std::vector<Json> objects;
    for (const std::string& line : lines_of(json_of("pair", options)))
      objects.push_back(Json::parse(line));
    return objects;
  }

  std::string array_of(std::vector<std::string> options) const {
    options.insert(options.end(), {"--output", "answers.npy"});
    json_of("pair", options);
    return read("answers.npy");
  }

  std::vector<Pose> poses_;
};

/// NEP 1: magic, version, length of the header, a literal of Python that ends in a line's end.
struct Array {
  std::string header;
  std::string data;
};

Array parse_array(const std::string& bytes) {
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t size =
      static_cast<unsigned char>(bytes.at(8)) + 256u * static_cast<unsigned char>(bytes.at(9));
  EXPECT_EQ((10 + size) % 64, 0u);
  EXPECT_EQ(bytes.at(9 + size), '\n');
  const std::string header = bytes.substr(10, size);
  return {header.substr(0, header.find('}') + 1), bytes.substr(10 + size)};
}

std::uint64_t number_at(const std::string& bytes, std::size_t at) {
  std::uint64_t number = 0;
  for (std::size_t i = 8; i-- > 0;)
    number = number << 8 | static_cast<unsigned char>(bytes.at(at + i));
  return number;
}

TEST_F(CliAnswerFile, YesAndNoAreBooleans) {
  const std::vector<std::string> ask = {"--poses", "poses.npy", "--query", "any"};
  const std::vector<Json> expected = rows(ask);
  const Array array = parse_array(array_of(ask));
  EXPECT_EQ(array.header, "{'descr': '|b1', 'fortran_order': False, 'shape': (40,), }");
  ASSERT_EQ(array.data.size(), 40u);
  int hits = 0;
  for (std::size_t i = 0; i < 40; ++i) {
    EXPECT_EQ(array.data[i], expected[i]["intersects"] == true ? '\1' : '\0') << i;
    hits += array.data[i];
  }
  EXPECT_TRUE(hits > 0 && hits < 40);
}

TEST_F(CliAnswerFile, DistancesAreTheLibrarysToTheBit) {
  const Mesh mesh_a = load_mesh(folder_ / "a.off"), mesh_b = load_mesh(folder_ / "b.off");
  const std::vector<std::string> ask = {"--poses", "poses.npy", "--query", "distance"};
  const std::vector<Json> told = rows(ask);
  const Array array = parse_array(array_of(ask));
  EXPECT_EQ(array.header, "{'descr': '<f8', 'fortran_order': False, 'shape': (40,), }");
  ASSERT_EQ(array.data.size(), 40u * 8);
  for (std::size_t i = 0; i < 40; ++i) {
    const MeshDistance gap = distance({mesh_a}, {mesh_b, poses_[i]});
    EXPECT_EQ(number_at(array.data, 8 * i), std::bit_cast<std::uint64_t>(gap.distance)) << i;
    EXPECT_EQ(told[i]["distance"].get<double>(), gap.distance);
    EXPECT_EQ(told[i]["intersects"], gap.distance == 0);
    EXPECT_EQ(told[i]["pair"], Json::array({gap.pair.a, gap.pair.b}));
    EXPECT_EQ(told[i]["point_b"], Json::array({gap.point_b.x(), gap.point_b.y(), gap.point_b.z()}));
  }
}

TEST_F(CliAnswerFile, PairsAreRecords) {
  const std::vector<std::string> ask = {"--poses", "poses.npy"};
  const std::vector<Json> expected = rows(ask);
  const Array array = parse_array(array_of(ask));
  EXPECT_EQ(array.header,
            "{'descr': [('intersects', '|b1'), ('pairs', '<u8')], 'fortran_order': False, 'shape': "
            "(40,), }");
  ASSERT_EQ(array.data.size(), 40u * 9);
  for (std::size_t i = 0; i < 40; ++i) {
    EXPECT_EQ(array.data[9 * i] == '\1', expected[i]["intersects"] == true) << i;
    EXPECT_EQ(number_at(array.data, 9 * i + 1), expected[i]["pairs"].get<std::uint64_t>()) << i;
  }
}

TEST_F(CliAnswerFile, ThreadsAndTextChangeNothing) {
  std::string text;
  for (const Pose& pose : poses_)
    text += "1 0 0 " + std::to_string(pose.translation().x()) + " 0 1 0 0.25 0 0 1 0.125\n";
  write("poses.txt", text);
  for (const char* query : {"any", "pairs", "distance"}) {
    const std::string expected = array_of({"--poses", "poses.npy", "--query", query});
    for (const char* threads : {"0", "1", "3"})
      EXPECT_EQ(array_of({"--poses", "poses.txt", "--query", query, "--threads", threads}),
                expected);
  }
  const Array one = parse_array(array_of({"--pose-b", kCrossing, "--query", "any"}));
  EXPECT_EQ(one.data, "\1");
}

TEST_F(CliAnswerFile, StandardOutputSaysWhatTheyComeTo) {
  const std::vector<std::string> end = {"--poses", "poses.npy", "--output", "answers.npy"};
  const auto told = [&](const char* query) {
    std::vector<std::string> options = {"--query", query};
    options.insert(options.end(), end.begin(), end.end());
    return rows(options).at(0);
  };
  std::size_t hits = 0, pairs = 0;
  for (const Json& row : rows({"--poses", "poses.npy"})) {
    hits += row["intersects"] == true;
    pairs += row["pairs"].get<std::size_t>();
  }
  EXPECT_EQ(keys_of(told("any")), (Keys{"poses", "intersecting", "file", "work"}));
  const Json of_pairs = told("pairs");
  EXPECT_EQ(keys_of(of_pairs), (Keys{"poses", "intersecting", "pairs", "file", "work"}));
  EXPECT_EQ(of_pairs["poses"], 40);
  EXPECT_EQ(of_pairs["intersecting"], hits);
  EXPECT_EQ(of_pairs["pairs"], pairs);
  EXPECT_EQ(of_pairs["file"], "answers.npy");
  EXPECT_GT(of_pairs["work"]["triangle_tests"], 0);
  const Json gap = told("distance");
  EXPECT_EQ(keys_of(gap),
            (Keys{"poses", "intersecting", "least_distance", "nearest_pose", "file", "work"}));
  EXPECT_EQ(gap["least_distance"], 0);
  EXPECT_EQ(gap["nearest_pose"], 0);
  const CommandResult text = graze({"pair", "a.off", "b.off", "--pose-b", kApart, "--query",
                                    "distance", "--output", "answers.npy"});
  const Mesh ball = load_mesh(folder_ / "b.off");
  const double least = 9 + ball.bounds().min.x();
  EXPECT_TRUE(text.out.starts_with("1 pose, 0 intersect, the least distance is 8.")) << text.out;
  EXPECT_NEAR(std::stod(text.out.substr(text.out.find("is ") + 3)), least, 1e-9);
  EXPECT_TRUE(text.out.ends_with(" m in pose 0; answers in answers.npy\n")) << text.out;
}

TEST_F(CliAnswerFile, BadInputLeavesTheOldFile) {
  write("answers.npy", "old");
  write("bad.txt", kApart + "\n" + kApart + "\n2 0 0 0 0 1 0 0 0 0 1 0\n");
  const CommandResult bad =
      graze({"pair", "a.off", "b.off", "--poses", "bad.txt", "--output", "answers.npy"});
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_EQ(bad.out, "");
  EXPECT_TRUE(bad.err.starts_with("graze: bad.txt:3: ")) << bad.err;
  EXPECT_EQ(read("answers.npy"), "old");
  expect_refusal({"pair", "a.off", "b.off", "--poses", "poses.npy", "--output", "poses.npy"},
                 "graze: --output: poses.npy is the file of --poses");
  expect_refusal({"pair", "a.off", "b.off", "--output", "a.off"},
                 "graze: --output: a.off is mesh A");
  expect_refusal({"pair", "a.off", "b.off", "--output", "there/is/none"},
                 "graze: there/is/none: cannot be written: No such file or directory");
  EXPECT_EQ(graze({"pair", "a.off", "b.off", "--output", ""}).exit_code, 2);
  const std::vector<std::vector<std::string>> wrong = {
      {"--output", "x", "--list"},
      {"--output", "x", "--check", "fcl"},
      {"--query", "distance", "--list"},
      {"--query", "distance", "--check", "fcl"},
      {"--query", "distance", "--solid"},
      {"--query", "distance", "--touch", "exclude"},
      {"--query", "distance", "--volume", "obb"},
      {"--query", "distance", "--threads", "2"}};
  for (std::vector<std::string> options : wrong) {
    options.insert(options.begin(), {"pair", "a.off", "b.off"});
    const CommandResult result = graze(options);
    EXPECT_EQ(result.exit_code, 2) << options.back();
    EXPECT_EQ(lines_of(result.err).size(), 1u);
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "x"));
}

TEST_F(CliAnswerFile, AFailedWriteLeavesTheOldFile) {
  write("answers.npy", "old");
  save_poses(folder_ / "many.npy", 100'000, [&](std::size_t) { return poses_.back(); });
  const CommandResult result = run_shell(folder_,
                                         "ulimit -f 8; \"$GRAZE\" pair a.off b.off --query any "
                                         "--poses many.npy --output answers.npy");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err, "graze: answers.npy: cannot be written: File too large\n");
  EXPECT_EQ(read("answers.npy"), "old");
}

TEST_F(CliAnswerFile, ManyPosesTakeNoMoreMemory) {
  // Both are several blocks of what is held at a time.
  const auto far = [](std::size_t) {
    Pose pose = Pose::Identity();
    pose.translation() << 8, 0, 0;
    return pose;
  };
  save_poses(folder_ / "few.npy", 100'000, far);
  save_poses(folder_ / "many.npy", 400'000, far);
  const auto peak_with = [&](const char* poses) {
    return peak_memory_of_graze(folder_, {"pair", "a.off", "b.off", "--query", "any", "--poses",
                                          poses, "--output", "answers.npy", "--threads", "2"});
  };
  const long few = peak_with("few.npy");
  const long many = peak_with("many.npy");
  ASSERT_GT(few, 1000);
  ASSERT_GT(many, 0);
  // Held, the 300,000 poses more would take 28 MB.
  EXPECT_LT(many, few + 8'000) << "kB";
  EXPECT_EQ(parse_array(read("answers.npy")).data, std::string(400'000, '\0'));
}

}  // namespace
}  // namespace graze::tests
