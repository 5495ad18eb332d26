#include "samples/render/picture.h"

#include <gtest/gtest.h>

#include <graze/bvh/error.h>
#include <fstream>
#include <sstream>

#include "tests/files/temporary_directory.h"

namespace graze::render {
namespace {

Mesh tetrahedron() {
  const std::vector<Eigen::Vector3d> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<TriangleIndices> triangles{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return Mesh(vertices, triangles);
}

Picture picture_of(const Mesh& mesh) {
  return {"Say \"title\"",
          {{"thing", mesh, Pose::Identity(), kSteel, {2}}},
          {{"view", {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 2, Cut{{0, 0, 0}, {1, 0, 0}, {0}}}}};
}

TEST(Picture, TheSceneHoldsWhatWasGiven) {
  const Mesh mesh = tetrahedron();
  const tests::TemporaryDirectory directory;
  write_scene(directory.path("scene.pov"), picture_of(mesh));
  std::ostringstream text;
  text << std::ifstream(directory.path("scene.pov")).rdbuf();
  for (const char* part : {"Say \\\"title\\\"", "<1000, 0, 0>", "<0, 3, 2>, 1", "<1, 2, 3>, 0",
                           "clipped_by { plane { <1, 0, 0>, 0 } }"}) {
    EXPECT_NE(text.str().find(part), std::string::npos) << part;
  }
}

TEST(Picture, CopiesMoveWhatIsWrittenOnce) {
  const Mesh mesh = tetrahedron();
  const tests::TemporaryDirectory directory;
  Picture picture = picture_of(mesh);
  picture.parts[0].pose.translation() = Eigen::Vector3d(5, 0, 0);
  Pose copy = Pose::Identity();
  copy.translation() = Eigen::Vector3d(7, 1, 0);
  picture.parts[0].copies = {copy};
  write_scene(directory.path("scene.pov"), picture);
  std::ostringstream text;
  text << std::ifstream(directory.path("scene.pov")).rdbuf();
  const std::string moved = "object { solid_0 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 2000, 1000, 0> }";
  EXPECT_NE(text.str().find(moved), std::string::npos);
}

TEST(Picture, WhatDoesNotExistIsRefused) {
  const Mesh mesh = tetrahedron();
  const tests::TemporaryDirectory directory;
  const std::string path = directory.path("scene.pov");
  Picture bad_mark = picture_of(mesh);
  bad_mark.parts[0].marked = {4};
  EXPECT_THROW(write_scene(path, bad_mark), InputError);
  Picture bad_cut = picture_of(mesh);
  bad_cut.panels[0].cut->parts = {1};
  EXPECT_THROW(write_scene(path, bad_cut), InputError);
  EXPECT_THROW(write_scene(directory.path("no/such/folder.pov"), picture_of(mesh)), Error);
}

}  // namespace
}  // namespace graze::render
