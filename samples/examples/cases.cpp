// Cases: queries with their answers as files that anyone can ask again.

#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/case_mesh_file.h>
#include <graze/engine/cases/motion_case.h>
#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/to_case.h>
#include <graze/engine/cases/world_case.h>
#include <graze/engine/cases/write_case.h>

#include <filesystem>
#include <string>

#include "samples/examples/example.h"

using examples::at;
using examples::expect;

namespace {

void a_query_as_a_file(const graze::Mesh& cube, const std::filesystem::path& folder) {
  const graze::MeshDistance gap = graze::distance({cube}, {cube, at(3, 0, 0)});
  graze::Case kept = graze::to_case({cube}, {cube, at(3, 0, 0)}, gap);
  kept.note = "two cubes beside each other";
  kept.answered_by = graze::this_library();
  expect(std::string(graze::name_of(kept.ask)) == "distance", "which query it is");

  graze::write_case(folder / "gap.json", kept);
  const graze::Case read = graze::read_case(folder / "gap.json");
  expect(graze::to_json(read) == graze::to_json(kept), "the same bits");
  expect(graze::is_same(graze::answer_case(read), *read.answer), "asked again: the same answer");
  expect(graze::is_same(graze::answer_of(gap), *read.answer), "which is what the query returned");
  expect(!graze::to_plain_json(*read.answer).empty(), "for tools without hex floats");
  expect(graze::parse_case(graze::to_json(kept), "ours").note == kept.note, "from memory");
  std::filesystem::remove(folder / "gap.json");
}

void other_queries(const graze::Mesh& cube) {
  expect(*graze::to_case_within({cube}, {cube, at(3, 0, 0)}, 2, true).answer->says, "a clearance");
  const Eigen::Vector3d middle(0.5, 0.5, 0.5);
  expect(*graze::to_case_contains(cube, middle, graze::contains(cube, middle)).answer->says,
         "a point inside");
  expect(!*graze::to_case_self(cube, graze::self_intersects(cube)).answer->says, "a mesh itself");
  const graze::MeshIntersection curves =
      graze::find_intersection({cube}, {cube, at(0.5, 0.5, 0.5)});
  expect(graze::in_parts(curves).curves.size() == curves.curves.size(),
         "each with what is its own");
}

void a_mesh_by_its_file(const std::filesystem::path& data) {
  const graze::CaseMesh bolt = graze::case_mesh_of_file(data, "meshes/bolt.obj", at(0, 0, 0));
  const graze::Mesh again = graze::load_case_mesh(*bolt.file, data);  // its hash is looked at
  expect(again.triangles().size() == bolt.mesh.triangles().size(), "a case need not hold vertices");
  graze::CaseMeshes meshes;  // for many cases: each file is read once
  expect(meshes.load(*bolt.file, data) == meshes.load(*bolt.file, data), "one mesh, two handles");
}

void what_a_world_says() {
  graze::World world;
  const graze::BodyId a = world.add({graze::Box{{1, 1, 1}}});
  const graze::BodyId b = world.add({graze::Sphere{{0, 0, 0}, 1}, at(1.5, 0, 0)});
  world.update();
  expect(graze::case_body(world, b).shape.kind() == graze::ShapeKind::Sphere, "a body of a case");
  const graze::Case touch = graze::to_case(world, graze::BodyPair{a, b}, true);
  expect(*graze::answer_case(touch).says, "the two touch, as the world said");
}

void what_is_said_of_motions(const graze::Mesh& cube) {
  const graze::RigidMotion rests{at(0, 0, 0)};
  const graze::RigidMotion comes(at(4, 0, 0), {.shift = {-4, 0, 0}});
  const graze::CaseMesh a = graze::case_mesh(cube, rests), b = graze::case_mesh(cube, comes);
  const graze::RigidContact contact = graze::first_contact({cube, rests}, {cube, comes});
  const graze::Case met = graze::to_case(a, b, contact);
  expect(std::string(graze::name_of(*met.answer->status)) == "hit", "they meet on the way");
  expect(graze::motion_of(std::get<graze::CaseMesh>(*met.b)) == comes, "the motion, to the bit");
  expect(!*graze::answer_case(graze::to_case_free(a, b, false)).says, "so it is not free");

  const graze::Shape ball(graze::Sphere{{0, 0, 0}, 1});
  const graze::CaseBody c = graze::case_body(ball, rests), d = graze::case_body(ball, comes);
  const graze::RigidContactSettings near{.clearance = 0.25};
  const graze::Case shapes =
      graze::to_case(c, d, graze::first_contact({ball, rests}, {ball, comes}, near), near);
  expect(graze::contact_settings(shapes.settings).clearance == 0.25, "of shapes too");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;  // a folder to write to, and data/
  const graze::Mesh cube = examples::cube(1);
  a_query_as_a_file(cube, argv[1]);
  other_queries(cube);
  a_mesh_by_its_file(argv[2]);
  what_a_world_says();
  what_is_said_of_motions(cube);
}
