// A world: bodies that come, move, sleep and go; which pairs touch; what is near; islands; and
// back to where it was.

#include "samples/examples/example.h"

using examples::at;
using examples::expect;

namespace {

const graze::Shape kBall = graze::Sphere{{0, 0, 0}, 0.5};

void pairs_over_time(graze::World& world, graze::BodyId floor, graze::BodyId ball) {
  world.move(ball, at(0, 0, 0.5));
  const graze::WorldUpdate update = world.update();
  expect(update.begun.size() == 1 && update.contacts.size() == 1, "the ball has come to the floor");
  expect(world.pairs().size() == 1 && world.contacts().size() == 1, "all pairs, all contacts");

  const graze::WorldSnapshot before = world.snapshot();
  world.move(std::vector{ball}, std::vector{at(0, 0, 3)});  // many at once: all or none
  expect(world.update().ended.size() == 1, "and has left it");
  world.restore(before);
  expect(world.pairs().size() == 1, "there it is again");

  world.exclude(floor, ball);
  world.update();
  expect(world.pairs().empty(), "two bodies that never meet");
  world.include(floor, ball);
  world.set_pair_filter([](graze::BodyId, graze::BodyId) { return true; });  // asked last
  world.update();
  expect(world.pairs().size() == 1, "they may again");

  world.sleep(ball);
  expect(!world.is_awake(ball), "what sleeps costs nothing");
  world.wake(ball);
  expect(world.is_awake(ball), "until it wakes");
}

void what_a_body_is(graze::World& world, graze::BodyId ball) {
  world.set_user_data(ball, 7);
  world.set_filter(ball, {.category = 2});
  world.set_kind(ball, graze::BodyKind::Kinematic);
  world.set_role(ball, graze::Role::Sensor);
  expect(world.user_data(ball) == 7 && world.filter(ball).category == 2, "as it was set");
  expect(world.kind(ball) == graze::BodyKind::Kinematic, "moved by its user");
  expect(world.role(ball) == graze::Role::Sensor, "is told, and has no contacts");
  world.set_kind(ball, graze::BodyKind::Dynamic);
  world.set_role(ball, graze::Role::Solid);
  world.set_shape(ball, graze::Box{{0.5, 0.5, 0.5}});
  expect(world.shape(ball).shape()->kind() == graze::ShapeKind::Box, "it has become a box");
  expect(world.pose(ball).translation().z() == 0.5, "where it was");
}

/// Contacts may begin before bodies touch.
void what_has_a_margin(graze::World& world, graze::BodyId ball) {
  world.set_margin(ball, 0.125);
  world.move(ball, at(0, 0, 0.5625));  // a box of half size 0.5 by now, above the floor
  const graze::WorldUpdate update = world.update();
  expect(world.margin(ball) == 0.125 && update.ended.size() == 1, "they do not touch any more");
  expect(update.begun_near.size() == 1 && world.near_pairs().size() == 1, "but are near");
  expect(update.contacts[0].manifold[0].depth == -0.0625, "negative: how far apart they are");
  world.set_margin(ball, 0);
  world.move(ball, at(0, 0, 0.5));
  expect(world.update().ended_near.size() == 1, "none without a margin");
}

/// A body may be so fast that it is behind a wall in the next step.
void what_is_fast(graze::World& world) {
  const graze::BodyId bullet = world.add({graze::Sphere{{0, 0, 0}, 0.001}, at(-20, 0, 8)},
                                         {.detection = graze::Detection::Continuous});
  const graze::BodyId wall = world.add({graze::Box{{0.001, 1, 1}}, at(-10, 0, 8)});
  expect(world.detection(bullet) == graze::Detection::Continuous, "it is swept");
  world.update();
  world.move(bullet, at(0, 0, 8));
  const graze::WorldUpdate update = world.update();
  expect(update.begun.empty() && update.first_contacts.size() == 1, "it met the wall on its way");
  const graze::BodyFirstContact& met = update.first_contacts[0];
  expect(met.contact.low < 0.5 && met.contact.low > 0.499 && met.normal.x() > 0.99, "half-way");
  world.move(bullet, graze::RigidMotion(at(0, 0, 8), {.shift = {0, 30, 0}}));
  expect(world.update().first_contacts.empty(), "and nothing on another");
  world.set_detection(bullet, graze::Detection::Discrete);
  world.remove(bullet);
  world.remove(wall);
}

void what_is_near(graze::World& world, graze::BodyId floor, graze::BodyId ball) {
  expect(world.find_in_box({{-1, -1, 0.25}, {1, 1, 1}}) == std::vector{ball}, "whose box is there");
  expect(world.find_touching({kBall, at(0, 0, 1)}) == std::vector{ball}, "whom a shape touches");
  expect(world.find_within({kBall, at(0, 0, 4)}, 2.75).size() == 1, "who is within a clearance");
  expect(world.find_closest({kBall, at(0, 0, 4)})->id == ball, "who is nearest");
  const graze::Ray down{{0, 0, 4}, {0, 0, -1}};
  expect(world.cast_ray(down)->id == ball, "whom a ray meets first");
  const std::vector<graze::BodyRayHit> hits = world.cast_ray_all(down);
  expect(hits.size() == 2 && hits[1].id == floor, "and behind that");

  // Many rays, or a shape in many poses, which threads share.
  const auto met = graze::cast_rays(world, std::vector<graze::Ray>{down, {{9, 9, 9}, {0, 0, 1}}});
  expect(met[0]->id == ball && !met[1], "the same of many rays");
  const auto behind = graze::cast_ray_all(world, std::vector<graze::Ray>{down});
  expect(behind[0].size() == 2, "and all that each meets");
  const graze::Shape probe = kBall;
  const std::vector<graze::Pose> poses = {at(0, 0, 1), at(0, 0, 40)};
  const graze::ShapeInPoses probes(probe, poses);
  expect(graze::find_touching(world, probes)[0] == std::vector{ball}, "whom it touches in each");
  expect(graze::find_within(world, probes, 0.5)[1].empty(), "who is near in each");
  expect(graze::find_closest(world, probes, {}, {.threads = 1})[1]->id == ball, "who is nearest");

  // A ball of a millimetre, by a hundred metres in one step, at a ball and at the floor behind it.
  const graze::Shape bullet = graze::Sphere{{0, 0, 0}, 0.001};
  const graze::RigidMotion shot(at(0, 0, 50), {.shift = {0, 0, -100}});
  expect(world.cast({bullet, shot})->id == ball, "to whom a shape in motion comes first");
  const std::vector<graze::BodyCast> casts = world.cast_all({bullet, shot});
  expect(casts.size() == 2 && casts[1].id == floor, "and then");
  expect(casts[0].contact.low <= casts[0].contact.high, "never late, and with a witness");

  // In many motions, which threads share.
  const std::vector<graze::RigidMotion> shots = {shot, graze::RigidMotion(at(0, 0, 50))};
  const graze::ShapeInMotions volley(bullet, shots);
  expect(graze::cast(world, volley)[0]->id == ball, "to whom it comes first in each");
  expect(graze::cast_all(world, volley)[1].empty(), "all to whom it comes in each");
}

/// A robot in its cell: two worlds, of which one stands in the other in a pose.
void a_world_in_another() {
  graze::World cell, robot;
  const graze::BodyId table = cell.add({graze::Box{{1, 1, 0.5}}, at(0, 0, 0)});
  const graze::BodyId post = cell.add({graze::Box{{0.1, 0.1, 2}}, at(3, 0, 0)});
  const graze::BodyId arm = robot.add({kBall, at(0, 0, 0)});
  robot.add({kBall, at(0, 0, 1)});
  expect(cell.find_touching({robot, at(0, 0, 1)}).size() == 1, "who of the one meets whom");
  expect(cell.find_within({robot, at(0, 0, 2)}, 1).size() == 1, "who comes how near");
  const auto nearest = cell.find_closest({robot, at(2, 0, 2)});
  expect(nearest->a == post && nearest->b == arm, "which two are nearest");
  expect(cell.find_closest_pair()->b == post && cell.find_closest_pair()->a == table,
         "which two of one world");
}

/// Which bodies there are, who touches whom, and who hangs together.
void who_is_with_whom() {
  graze::World world({.number = 1, .islands = true});  // its ids are refused by other worlds
  const graze::BodyId ground =
      world.add({graze::Box{{5, 5, 0.5}}, at(0, 0, -0.5)}, {.kind = graze::BodyKind::Static});
  const graze::BodyId lower = world.add({kBall, at(0, 0, 0.5)});
  const graze::BodyId upper = world.add({kBall, at(0, 0, 1.5)});
  const graze::BodyId apart = world.add({kBall, at(3, 0, 0.5)});
  world.update();
  expect(world.bodies().size() == 4, "all bodies");
  expect(world.touching(lower) == std::vector{ground, upper}, "whom one touches");
  expect(world.pairs(lower).size() == 2 && world.near_pairs(lower).empty(), "as pairs");
  expect(world.contacts(upper).size() == 1, "and where");
  expect(world.islands().size() == 2, "static bodies join no island");
  expect(world.island(upper) == std::vector{lower, upper}, "what a solver wakes together");
  world.sleep(world.island(lower));
  expect(!world.is_awake(upper) && world.is_awake(apart), "a whole island sleeps");
  world.wake(world.island(lower));
}

/// A ball that has come through an open sheet is pushed out in front of it.
void what_is_behind_counts() {
  const std::vector<Eigen::Vector3d> corners = {{-2, -2, 0}, {2, -2, 0}, {0, 3, 0}};
  const std::vector<graze::TriangleIndices> triangles = {{0, 1, 2}};
  const graze::MeshSides sides = graze::MeshSides::one_sided(0.5);
  expect(sides.thickness() == 0.5, "metres behind the surface");
  graze::World world;
  world.add({graze::Mesh(corners, triangles)}, {.kind = graze::BodyKind::Static, .sides = sides});
  world.add({graze::Sphere{{0, 0, 0}, 0.25}, at(0, 0, -0.5)});
  const graze::WorldUpdate update = world.update();
  expect(update.contacts.size() == 1, "it is behind the sheet, and touches it nowhere");
  expect(std::abs(update.contacts[0].manifold[0].depth - 0.75) < 1e-9, "until it lies in front");
}

void which_contacts_go_on() {
  graze::World world;
  world.add({graze::Box{{5, 5, 0.5}}, at(0, 0, -0.5)}, {.kind = graze::BodyKind::Static});
  const graze::BodyId ball = world.add({kBall, at(0, 0, 0.499)});
  graze::ContactTracker tracker;
  tracker.take(world, world.update());
  const std::uint64_t first = tracker.ids(0)[0];
  world.move(ball, at(0.1, 0, 0.499));
  tracker.take(world, world.update());
  expect(tracker.ids(0)[0] == first && tracker.size() == 1, "a ball that rolls has one contact");
}

/// Counts what a renderer would show.
class Counter : public graze::WorldDrawer {
 public:
  void line(const graze::DrawnLine&) override { ++lines; }
  void point(const graze::DrawnPoint&) override { ++points; }
  void label(const graze::DrawnLabel&) override { ++labels; }
  int lines = 0, points = 0, labels = 0;
};

void how_it_looks(const graze::World& world) {
  Counter all;
  graze::draw(world, all, {.has_boxes = true, .has_labels = true});
  expect(all.lines > 12 && all.labels == static_cast<int>(world.size()), "lines and words");
  Counter box;
  graze::draw(graze::Shape(graze::Box{{1, 1, 1}}), box);
  expect(box.lines == 12, "of a shape alone");
}

}  // namespace

int main() {
  graze::World world({.threads = 1});
  const graze::BodyId floor =
      world.add({graze::Box{{5, 5, 0.5}}, at(0, 0, -0.5)}, {.kind = graze::BodyKind::Static});
  const graze::BodyId ball = world.add({graze::share(kBall), at(0, 0, 3)});
  world.update();
  pairs_over_time(world, floor, ball);
  what_a_body_is(world, ball);
  world.update();
  what_has_a_margin(world, ball);
  what_is_fast(world);
  what_is_near(world, floor, ball);
  a_world_in_another();
  who_is_with_whom();
  which_contacts_go_on();
  world.update();
  how_it_looks(world);
  world.remove(ball);
  expect(!world.contains(ball) && world.size() == 1, "it is gone");
  expect(world.sides(floor).kind() == graze::Sides::Surface, "what is in a mesh may count, too");
  what_is_behind_counts();
}
