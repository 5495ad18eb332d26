// graze::View: what it refuses, what of a page is text, and its files.

#include <graze/bvh/error.h>
#include <graze/engine/view/packing/packed_text.h>
#include <graze/engine/view/view.h>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

#include "tests/engine/view/unpacked_page.h"
#include "tests/files/temporary_directory.h"

namespace graze::tests {
namespace {

using Eigen::Vector3d;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

template <typename Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

TEST(ViewRefusals, WhatCannotBeShownIsRefusedWithItsPlace) {
  View view;
  const ViewBody box = view.add(Box{{1, 1, 1}}, {.name = "box"});
  EXPECT_EQ(refusal([&] { view.page(); }), "a view without a frame shows nothing");
  view.begin_frame({.label = "start"});
  const std::vector<std::uint32_t> triangles = {0, 12};
  const std::vector<Vector3d> curve = {{0, 0, 0}, {kNan, 0, 0}};
  EXPECT_EQ(refusal([&] { view.mark_triangles(box, triangles); }),
            "frame 0, start: 'box' is marked, but does not stand there");
  view.place(box, Pose::Identity());
  EXPECT_EQ(refusal([&] { view.mark_triangles(box, triangles); }),
            "frame 0, start: 'box' has no triangle 12, but 12");
  EXPECT_EQ(refusal([&] { view.place({1}, Pose::Identity()); }), "body 1: the view has 1");
  EXPECT_EQ(refusal([&] { view.mark_triangles({9}, {}); }), "body 9: the view has 1");
  EXPECT_EQ(refusal([&] { view.add_curve(curve); }),
            "frame 0, start: a point of a curve is not finite");
  EXPECT_EQ(refusal([&] {
              view.add_line({0, 0, 0}, {0, INFINITY, 0});
            }),
            "frame 0, start: an end of a line is not finite");
  EXPECT_EQ(refusal([&] {
              view.add_contact({0, 0, 0}, {0, 0, 0}, 1);
            }),
            "frame 0, start: the normal of a contact is 0");
  EXPECT_EQ(refusal([&] {
              view.add_contact({0, 0, 0}, {0, 0, 1}, -1);
            }),
            "frame 0, start: the depth of a contact is negative or not finite");
  EXPECT_EQ(refusal([&] {
              view.add_gap({0, 0, 0}, {0, 0, 1}, kNan);
            }),
            "frame 0, start: a distance is negative or not finite");
  EXPECT_EQ(refusal([&] {
              view.add_label({kNan, 0, 0}, "x");
            }),
            "frame 0, start: the place of a label is not finite");
  EXPECT_EQ(refusal([&] {
              view.add_point({0, kNan, 0});
            }),
            "frame 0, start: a point is not finite");
  EXPECT_EQ(refusal([&] {
              view.add_plane({.point = {0, 0, 0}, .normal = {0, 0, 0}});
            }),
            "frame 0, start: the normal of a plane is 0");
  EXPECT_EQ(refusal([&] {
              view.add_plane({.point = {0, 0, 0}, .normal = {0, 0, 1}, .half_extent = 0});
            }),
            "frame 0, start: the extent of a plane is 0");
  EXPECT_EQ(refusal([&] { view.add_pair(box, box); }),
            "frame 0, start: 'box' is no pair with itself");
  EXPECT_EQ(refusal([&] { view.add_pair(box, {3}); }), "body 3: the view has 1");
  const std::vector<Obb> none = {{Pose::Identity(), {1, -1, 1}}};
  EXPECT_EQ(refusal([&] { view.add_boxes(box, 100, {}); }),
            "boxes of 'box': level 100, not 0 to 99");
  EXPECT_NE(refusal([&] { view.add_boxes(box, 0, none); }).find("box 0 of 'box'"),
            std::string::npos);
  EXPECT_EQ(refusal([&] {
              view.begin_frame({.facts = {{"gap", kNan}}});
            }),
            "frame 1: 'gap' is not finite");
  EXPECT_EQ(refusal([&] { View({.segments = 7}); }), "ViewSettings::segments is 7, not 8 to 1024");
  EXPECT_EQ(refusal([&] {
              view.add(HalfSpace{{0, 0, 1}, 0}, {.half_space_extent = 0});
            }),
            "ViewBodySettings::half_space_extent is not positive or not finite");
  Pose nowhere = Pose::Identity();
  nowhere.translation().x() = kNan;
  Pose skew = Pose::Identity();
  skew.linear()(0, 0) = 2;
  EXPECT_THROW(view.place(box, skew), PoseError);
  EXPECT_THROW(view.place(box, nowhere), PoseError);
  // Nothing of all that has gone into the page.
  const UnpackedPage page(view.page());
  EXPECT_EQ(page.json()["frames"].size(), 1u);
  EXPECT_EQ(page.json()["bodies"].size(), 1u);
  EXPECT_TRUE(page.json()["marks"]["boxes"].empty());
  for (const char* kind : {"curves", "lines", "points", "contacts", "gaps", "planes", "pairs"})
    EXPECT_TRUE(page.words(page.json()["marks"][kind]["list"]).empty()) << kind;
}

TEST(ViewRefusals, FilesAppearWholeOrAreNamed) {
  const TemporaryDirectory folder;
  View view;
  view.place(view.add(Box{{1, 1, 1}}), Pose::Identity());
  view.write(folder.path("page.html"));
  std::ifstream file(folder.path("page.html"), std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), view.page());
  try {
    view.write(folder.path("none/page.html"));
    FAIL() << "written into a folder that is not there";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("none/page.html: cannot be written"),
              std::string::npos)
        << error.what();
  }
}

// RFC 4648, section 10.
TEST(PackedText, Base64IsThatOfTheStandard) {
  const std::vector<std::pair<std::string, std::string>> vectors = {{"", ""},
                                                                    {"f", "Zg=="},
                                                                    {"fo", "Zm8="},
                                                                    {"foo", "Zm9v"},
                                                                    {"foob", "Zm9vYg=="},
                                                                    {"fooba", "Zm9vYmE="},
                                                                    {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : vectors)
    EXPECT_EQ(view::base64(bytes), text);
  std::string all;
  for (int i = 0; i < 256; ++i)
    all += static_cast<char>(i);
  EXPECT_EQ(bytes_of_base64(view::base64(all)), all);
}

TEST(PackedText, GzipComesBackWhateverItsLength) {
  for (const std::size_t size : {0u, 1u, 65536u, (1u << 20) - 1, 1u << 20, (1u << 21) + 7}) {
    std::string bytes(size, 'x');
    for (std::size_t i = 0; i < size; i += 7)
      bytes[i] = static_cast<char>(i * 2654435761u >> 13);
    EXPECT_EQ(gunzipped(view::gzipped(bytes)), bytes) << size;
  }
}

}  // namespace
}  // namespace graze::tests
