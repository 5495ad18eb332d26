// Coming from FCL: each block does what the FCL code in its comment does. fcl_migration A B [DZ]

#include <graze/graze.h>
#include <cstdio>
#include <cstdlib>

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

    // fcl::CollisionRequestd request;  // num_max_contacts = 1, enable_contact = false
    // bool hit = fcl::collide(&m1, tf1, &m2, tf2, request, result) > 0;
    const bool is_hit = graze::intersects({a}, {b, pose});
    std::printf("hit: %s\n", is_hit ? "yes" : "no");

    // request.num_max_contacts = N;  ... result.getContact(i).b1, .b2
    // Triangles by their indices in the files; sorted, each pair once, and it says if there are
    // more.
    const graze::TrianglePairs pairs = graze::find_triangle_pairs({a}, {b, pose}, {.limit = 100});
    std::printf("pairs: %zu%s\n", pairs.size(),
                pairs.completeness == graze::Completeness::Complete ? "" : " or more");

    // request.enable_contact = true;  ... contact.pos, contact.normal, contact.penetration_depth
    // One contact for each piece of the intersection, not several for each pair of triangles; the
    // normal points from A to B, as FCL's does, and the depth is never negative.
    const graze::MeshContacts contacts = graze::find_contacts({a}, {b, pose});
    for (const graze::MeshContact& contact : contacts)
      std::printf("contact: %g m deep\n", contact.depth);

    // fcl::DistanceRequestd request(true); fcl::distance(&m1, tf1, &m2, tf2, request, result);
    // result.min_distance, result.nearest_points[0], [1]
    // 0 where they meet, never negative, and both points are in the common frame.
    const graze::MeshDistance gap = graze::distance({a}, {b, pose});
    std::printf("apart: %.17g m\n", gap.distance);

    // fcl::distance(...) <= clearance
    const bool is_near = graze::within({a}, {b, pose}, 1e-4);  // without finding the distance
    std::printf("within 0.1 mm: %s\n", is_near ? "yes" : "no");

    // fcl::collide(&m1, tf1, &box, tf_box, request, result): a mesh and a shape.
    const graze::Obb box{pose, {0.005, 0.005, 0.005}};  // FCL's Box has whole lengths, not half
    std::printf("in the box: %zu triangles\n", graze::find_triangles({a}, box).size());

    // Two answers to one question that cannot both be right would be a bug, here as there.
    return is_hit == (gap.distance == 0) && is_hit == !pairs.empty() ? 0 : 1;
  } catch (const graze::Error& error) {
    std::fprintf(stderr, "fcl_migration: %s\n", error.what());
    return 1;
  }
}
