// Coming from FCL: each block does what the FCL code in its comment does. fcl_migration A B [DZ]

#include <graze/graze.h>
#include <cstdio>
#include <cstdlib>

namespace {

void print(const char* what, const Eigen::Vector3d& p) {
  std::printf("%s (%g, %g, %g)", what, p.x(), p.y(), p.z());
}

/// Two meshes. Whether the answers, to questions about one thing, can all be right.
bool ask_meshes(const graze::Mesh& a, const graze::Mesh& b, const graze::Pose& pose) {
  // fcl::CollisionRequestd request;  // num_max_contacts = 1, enable_contact = false
  // bool hit = fcl::collide(&m1, tf1, &m2, tf2, request, result) > 0;
  const bool is_hit = graze::intersects({a}, {b, pose});
  std::printf("hit: %s\n", is_hit ? "yes" : "no");

  // request.num_max_contacts = N;  ... result.getContact(i).b1, .b2
  // Triangles by their indices in the files; sorted, each pair once, and it says if there are more.
  const graze::TrianglePairs pairs = graze::find_triangle_pairs({a}, {b, pose}, {.limit = 100});
  std::printf("pairs: %zu%s\n", pairs.size(),
              pairs.completeness == graze::Completeness::Complete ? "" : " or more");

  // request.enable_contact = true;  ... contact.pos, contact.normal, contact.penetration_depth
  // One contact for each piece of the intersection, not several for each pair of triangles; the
  // normal points from A to B, as FCL's does, and the depth is never negative.
  const graze::MeshContacts contacts = graze::find_contacts({a}, {b, pose});
  for (const graze::MeshContact& contact : contacts) {
    std::printf("contact: %g m deep", contact.depth);
    print(", at", contact.point);
    print(", normal", contact.normal);
    std::printf("\n");
  }

  // fcl::DistanceRequestd request(true); fcl::distance(&m1, tf1, &m2, tf2, request, result);
  // result.min_distance, result.nearest_points[0], [1]
  // 0 where they meet, never negative, and both points are in the common frame.
  const graze::MeshDistance gap = graze::distance({a}, {b, pose});
  std::printf("apart: %.17g m", gap.distance);
  print(", nearest points", gap.point_a);
  print(" and", gap.point_b);
  std::printf("\n");

  // fcl::distance(...) <= clearance
  const bool is_near = graze::within({a}, {b, pose}, 1e-4);  // without finding the distance
  std::printf("within 0.1 mm: %s\n", is_near ? "yes" : "no");

  // In FCL, too, a mesh inside another does not collide with it. Closed meshes may be asked as
  // solids.
  if (a.topology().is_closed && b.topology().is_closed) {
    const bool is_solid_hit = graze::intersects({a}, {b, pose}, {.hit = graze::Hit::Solid});
    std::printf("as solids: %s\n", is_solid_hit ? "yes" : "no");
  }
  return is_hit == (gap.distance == 0) && is_hit == !pairs.empty() && is_hit == !contacts.empty();
}

/// A mesh or a shape, and a shape.
void ask_shapes(const graze::Mesh& a, const graze::Pose& pose) {
  // fcl::collide(&m1, tf1, &box, tf_box, request, result): a mesh and a shape.
  const graze::Obb box{pose, {0.005, 0.005, 0.005}};  // FCL's Box has whole lengths, not half
  std::printf("in the box: %zu triangles\n", graze::find_triangles({a}, box).size());
  // fcl::Sphered ball(0.002); a transform that moves it
  const graze::Sphere ball{pose.translation(), 0.002};
  std::printf("the ball touches: %s\n", graze::intersects({a}, ball) ? "yes" : "no");

  // fcl::Capsuled(radius, length), Cylinderd, Coned, Ellipsoidd, Convexd, Halfspaced: any two
  // shapes, or a shape and a mesh. Lengths are halves here, and the axis is z in both.
  const graze::ShapeDistance apart =
      graze::distance({graze::Capsule{0.001, 0.004}, graze::Pose::Identity()},
                      {graze::Cone{0.002, 0.003}, graze::Pose(Eigen::Translation3d(0, 0, 0.02))});
  std::printf("capsule and cone: %g m apart\n", apart.distance);
}

/// fcl::DynamicAABBTreeCollisionManagerd manager; manager.registerObject(&object); object.
/// setTransform(tf); manager.update(); manager.collide(&data, callback);
void ask_world(const graze::Mesh& a, const graze::Mesh& b, const graze::Pose& pose) {
  graze::World world;
  const graze::BodyId body = world.add({a, graze::Pose::Identity()}, {});
  world.add({b, pose}, {});
  world.update();
  std::printf("in the world: %zu pairs of bodies", world.pairs().size());
  // No callback: lists of all pairs that touch, and of those that began and ended.
  world.move(body, graze::Pose(Eigen::Translation3d(1, 0, 0)));
  const graze::WorldUpdate update = world.update();
  std::printf(", %zu ended\n", update.ended.size());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4) {
    std::fprintf(stderr, "usage: fcl_migration A B [DZ in metres]\n");
    return 2;
  }
  try {
    // fcl::BVHModel<fcl::OBBRSSd> m; m.beginModel(); m.addSubModel(points, triangles);
    // m.endModel(); A mesh is immutable and checked; its tree is built by the first query that
    // needs it.
    const graze::Mesh a = graze::load_mesh(argv[1]);  // or graze::Mesh(points, triangles)
    const graze::Mesh b = graze::load_mesh(argv[2]);

    // fcl::Transform3d tf; tf.setIdentity(); tf.translation() << 0, 0, dz;
    graze::Pose pose = graze::Pose::Identity();  // an Eigen::Isometry3d converts to it
    if (argc == 4) pose.translation().z() = std::strtod(argv[3], nullptr);

    const bool is_consistent = ask_meshes(a, b, pose);
    ask_shapes(a, pose);
    ask_world(a, b, pose);
    return is_consistent ? 0 : 1;
  } catch (const graze::Error& error) {
    std::fprintf(stderr, "fcl_migration: %s\n", error.what());
    return 1;
  }
}
