// What `graze contacts` answers, and that it is what the library says.

#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/mesh_contacts.h>
#include <graze/engine/mesh/separating_translation.h>

#include "tests/engine/cli/two_meshes.h"

namespace graze::tests {
namespace {

using Json = nlohmann::ordered_json;

class CliContacts : public TwoMeshes {
 protected:
  Json json(const std::vector<std::string>& options) const {
    return Json::parse(json_of("contacts", options));
  }
};

Json array_of(const Eigen::Vector3d& v) {
  return Json::array({v.x(), v.y(), v.z()});
}

TEST_F(CliContacts, AnswersAreTheLibrarysBitForBit) {
  const Mesh mesh_a = load_mesh(folder_ / "a.off");
  const Mesh mesh_b = load_mesh(folder_ / "b.off");
  Pose pose = Pose::Identity();
  pose.translation() << 1.5, 0.25, 0.125;
  const MeshContacts contacts = find_contacts({mesh_a}, {mesh_b, pose});
  ASSERT_EQ(contacts.size(), 1u);
  const Json answer = json({"--pose-b", kCrossing, "--list", "--separate"});
  EXPECT_EQ(keys_of(answer), (Keys{"contacts", "complete", "separation", "work"}));
  const Json& contact = answer["contacts"].at(0);
  EXPECT_EQ(keys_of(contact),
            (Keys{"depth", "normal", "point", "point_a", "point_b", "corners", "list"}));
  EXPECT_EQ(contact["depth"], contacts[0].depth);
  EXPECT_EQ(contact["normal"], array_of(contacts[0].normal));
  EXPECT_EQ(contact["point"], array_of(contacts[0].point));
  EXPECT_EQ(contact["point_a"], array_of(contacts[0].point_a));
  EXPECT_EQ(contact["point_b"], array_of(contacts[0].point_b));
  ASSERT_EQ(contact["list"].size(), contacts.points.size());
  EXPECT_EQ(contact["list"][0], array_of(contacts.points[0]));
  const SeparatingTranslation separation = separating_translation({mesh_a}, {mesh_b, pose});
  EXPECT_EQ(answer["separation"]["distance"], separation.distance);
  EXPECT_EQ(answer["separation"]["translation"], array_of(separation.translation));
  EXPECT_GT(answer["work"]["triangle_tests"], 0);
}

TEST_F(CliContacts, ApartIsNoContact) {
  const Json answer = json({"--pose-b", kApart});
  EXPECT_TRUE(answer["contacts"].empty());
  EXPECT_EQ(answer["complete"], true);
  EXPECT_EQ(graze({"contacts", "a.off", "b.off", "--pose-b", kApart}).out,
            "the surfaces do not meet\n");
}

TEST_F(CliContacts, LimitsSaySo) {
  const Json answer = json({"--pose-b", kCrossing, "--limit", "0"});
  EXPECT_TRUE(answer["contacts"].empty());
  EXPECT_EQ(answer["complete"], false);
  const CommandResult table =
      graze({"contacts", "a.off", "b.off", "--pose-b", kCrossing, "--limit", "0"});
  EXPECT_NE(table.out.find("there are more"), std::string::npos);
}

TEST_F(CliContacts, TheTableHasARowPerContact) {
  const CommandResult result = graze({"contacts", "a.off", "b.off", "--pose-b", kCrossing});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("depth, m"), std::string::npos);
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 2);
}

TEST_F(CliContacts, BadInputIsRefused) {
  EXPECT_EQ(graze({"contacts", "a.off"}).exit_code, 2);
  EXPECT_EQ(graze({"contacts", "a.off", "b.off", "--limit", "-1"}).exit_code, 2);
  EXPECT_EQ(graze({"contacts", "a.off", "missing.off"}).exit_code, 2);
  EXPECT_EQ(graze({"contacts", "a.off", "b.off", "--pose-b", "1 2 3"}).exit_code, 2);
}

}  // namespace
}  // namespace graze::tests
