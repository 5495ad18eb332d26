// Where two meshes meet: curves and patches of their surfaces, contacts, and how far to move one to
// part them.

#include <cmath>

#include "samples/examples/example.h"

using examples::at;
using examples::expect;

int main() {
  const graze::Mesh cube = examples::cube(1);

  // Two corners reach into each other: the surfaces meet in one closed curve.
  const graze::MeshIntersection crossing =
      graze::find_intersection({cube}, {cube, at(0.5, 0.5, 0.5)});
  expect(crossing.curves.size() == 1 && crossing.curves[0].is_closed, "one loop");
  for (const graze::IntersectionSegment& segment : crossing.segments_of(crossing.curves[0])) {
    const Eigen::Vector3d& from = crossing.points[segment.from].position;
    const Eigen::Vector3d& to = crossing.points[segment.to].position;
    expect((to - from).norm() <= 1, "no segment is longer than an edge");
    expect(!crossing.pairs_of(segment).empty(), "each lies in triangles of both");
  }

  // Face on face: coplanar triangles meet in polygons, which form a patch.
  const graze::MeshIntersection resting = graze::find_intersection({cube}, {cube, at(0, 0, 1)});
  expect(resting.patches.size() == 1, "one patch");
  for (const graze::IntersectionPolygon& polygon : resting.polygons_of(resting.patches[0]))
    expect(polygon.corner_count >= 3, "of polygons");

  // One contact for each connected piece.
  const graze::MeshContacts contacts = graze::find_contacts({cube}, {cube, at(0, 0, 0.75)});
  expect(contacts.size() == 1, "one piece of surface, one contact");
  const graze::MeshContact& contact = contacts[0];
  expect(std::abs(contact.normal.z()) > 0.99, "the normal leads from A to B");
  expect(std::abs(contact.depth - 0.25) < 1e-9, "they reach a quarter into each other");
  expect(contacts.points_of(contact).size() >= 4, "the corners of the piece");

  // The last contact along a direction, and the best of some directions.
  const graze::SeparatingTranslation up =
      graze::separating_translation({cube}, {cube, at(0, 0, 0.75)}, Eigen::Vector3d(0, 0, 1));
  expect(std::abs(up.distance - 0.25) < 1e-9, "a quarter upward parts them");
  expect(!graze::intersects({cube}, {cube, up.pose_b}), "as the next query says");
  const graze::SeparatingTranslation best =
      graze::separating_translation({cube}, {cube, at(0, 0, 0.75)});
  expect(best.distance <= up.distance * (1 + 1e-9), "no direction that was tried is shorter");
}
