#include "samples/render/picture.h"

#include <gtest/gtest.h>

#include <graze/bvh/error.h>
#include <fstream>
#include <sstream>

namespace graze::render {
namespace {

Mesh tetrahedron() {
  const std::vector<Eigen::Vector3d> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<TriangleIndices> triangles{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return Mesh(std::span<const Eigen::Vector3d>(vertices),
              std::span<const TriangleIndices>(triangles));
}

Picture picture_of(const Mesh& mesh) {
  return {"Say \"title\"",
          {{"thing", mesh, Pose::Identity(), kSteel, {2}}},
          {{"view", {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 2, Cut{{0, 0, 0}, {1, 0, 0}, {0}}}}};
}

std::filesystem::path scene_path() {
  return std::filesystem::path(testing::TempDir()) / "graze_picture_test.pov";
}

TEST(Picture, TheSceneHoldsWhatWasGiven) {
  const Mesh mesh = tetrahedron();
  write_scene(scene_path(), picture_of(mesh));
  std::ostringstream text;
  text << std::ifstream(scene_path()).rdbuf();
  std::filesystem::remove(scene_path());
  for (const char* part : {"Say \\\"title\\\"", "<1000, 0, 0>", "<0, 3, 2>, 1", "<1, 2, 3>, 0",
                           "clipped_by { plane { <1, 0, 0>, 0 } }"}) {
    EXPECT_NE(text.str().find(part), std::string::npos) << part;
  }
}

TEST(Picture, WhatDoesNotExistIsRefused) {
  const Mesh mesh = tetrahedron();
  Picture bad_mark = picture_of(mesh);
  bad_mark.parts[0].marked = {4};
  EXPECT_THROW(write_scene(scene_path(), bad_mark), InputError);
  Picture bad_cut = picture_of(mesh);
  bad_cut.panels[0].cut->parts = {1};
  EXPECT_THROW(write_scene(scene_path(), bad_cut), InputError);
  EXPECT_THROW(write_scene("no/such/folder/scene.pov", picture_of(mesh)), Error);
}

}  // namespace
}  // namespace graze::render
