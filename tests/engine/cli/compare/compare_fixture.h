#pragma once

#include <graze/engine/cli/compare/compare_run.h>
#include <graze/engine/cli/replay/case_list.h>
#include <graze/engine/cli/replay/replay_run.h>
#include <graze/engine/compare/run/record/journal.h>
#include <gtest/gtest.h>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/compare/engine_doubles.h"
#include "tests/files/temporary_directory.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::cli {

using compare::EngineEntry;

inline std::string off_of(const Mesh& mesh) {
  std::ostringstream file;
  file.precision(17);
  file << "OFF\n" << mesh.vertices().size() << ' ' << mesh.triangles().size() << " 0\n";
  for (const Eigen::Vector3d& v : mesh.vertices())
    file << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  for (const TriangleIndices& t : mesh.triangles())
    file << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  return file.str();
}

/// `graze compare` of a torus and a box, among engines that are wrong on purpose.
class CliCompare : public testing::Test {
 protected:
  CliCompare() {
    options_.mesh_a = directory_.write("a.off", off_of(tests::make_torus(1, 0.25, 10, 8)));
    options_.mesh_b = directory_.write("b.off", off_of(tests::make_box({0.5, 0.5, 0.5})));
    options_.cases = directory_.path("found");
    options_.threads = 2;
    options_.keep = 1;
    options_.random = 12;
    options_.shrink_seconds = 1000;  // what is found must not depend on how busy a machine is
  }

  static std::vector<EngineEntry> graze_and(std::unique_ptr<compare::Engine> other) {
    std::vector<EngineEntry> engines;
    engines.push_back({"graze", compare::make_graze_engine()});
    engines.push_back({other->name().engine, std::move(other)});
    engines.push_back({"absent", nullptr});
    return engines;
  }
  static std::vector<EngineEntry> with_wrong_fcl() {
    return graze_and(compare::make_wrong_sign_engine("fcl"));
  }

  /// graze whose distances are off, and the wrong one.
  static std::vector<EngineEntry> graze_changed_by(double error) {
    std::vector<EngineEntry> engines = with_wrong_fcl();
    engines.front().engine = compare::make_off_engine("graze", error);
    return engines;
  }

  /// The lines of a record with the sums that they should have: what is wrong in them is no damage.
  static std::string sealed_again(const std::string& text) {
    std::istringstream lines(text);
    std::string out;
    for (std::string line; std::getline(lines, line);) {
      const std::size_t sum = line.rfind(",\"sum\":\"");
      out += compare::sealed(sum == line.npos ? line : line.substr(0, sum) + "}") + "\n";
    }
    return out;
  }

  /// Runs, and keeps what was written.
  template <typename Run>
  ExitCode run(Run&& body) {
    std::FILE* stream = std::tmpfile();
    Output output(stream);
    const ExitCode code = body(output);
    out_.assign(static_cast<std::size_t>(std::ftell(stream)), ' ');
    std::rewind(stream);
    EXPECT_EQ(std::fread(out_.data(), 1, out_.size(), stream), out_.size());
    std::fclose(stream);
    return code;
  }
  ExitCode compare(const std::vector<EngineEntry>& engines) {
    return run([&](Output& output) { return run_compare(options_, engines, output); });
  }

  std::vector<std::filesystem::path> found() const {
    return std::filesystem::exists(options_.cases) ? case_files({options_.cases})
                                                   : std::vector<std::filesystem::path>();
  }

  std::string read(const std::string& name) const {
    std::ifstream file(directory_.path() / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  tests::TemporaryDirectory directory_;
  CompareOptions options_;
  std::string out_;
};

}  // namespace graze::cli
