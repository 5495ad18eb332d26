#include "tests/engine/cli/command_test.h"

#include <fstream>
#include <limits>

namespace graze::tests {

void CommandTest::write_mesh(const std::string& name, const Mesh& mesh) const {
  std::ofstream file(folder_ / name);
  file.precision(std::numeric_limits<double>::max_digits10);
  file << "OFF\n" << mesh.vertices().size() << ' ' << mesh.triangles().size() << " 0\n";
  for (const Eigen::Vector3d& v : mesh.vertices()) {
    file << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  }
  for (const TriangleIndices& t : mesh.triangles()) {
    file << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  }
}

void CommandTest::expect_refusal(const std::vector<std::string>& arguments,
                                 const std::string& line) const {
  const CommandResult result = graze(arguments);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, line + "\n");
}

}  // namespace graze::tests
