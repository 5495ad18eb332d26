#include "tests/engine/floating_point/questions.h"

namespace graze::tests {
namespace {

void add_distance(Words& words, const TriangleDistance& found) {
  words.add(found.distance), words.add(found.point_a), words.add(found.point_b);
}

void add_contact(Words& words, const std::optional<FirstContact>& contact) {
  words.add(contact.has_value());
  if (contact) words.add(contact->time), words.add(contact->is_at_start);
}

TrianglePath path_between(const Triangle& start, const Triangle& end) {
  return {{start.a, end.a}, {start.b, end.b}, {start.c, end.c}};
}

/// Whether triangles and volumes meet.
std::vector<Question> yes_or_no_questions() {
  return {
      {"intersects(Triangle, Triangle)",
       [](const Inputs& in, Words& words) {
         words.add(intersects(in.triangle_a, in.triangle_b));
         for (const Triangle& triangle : in.triangles)
           words.add(intersects(in.triangle_a, triangle));
       }},
      {"crosses",
       [](const Inputs& in, Words& words) {
         for (const Triangle& triangle : in.triangles)
           words.add(crosses(in.triangle_a, triangle));
       }},
      {"intersects(Triangle, Triangle, Touch)",
       [](const Inputs& in, Words& words) {
         for (const Triangle& triangle : in.triangles)
           words.add(intersects(in.triangle_b, triangle, Touch::Include));
       }},
      {"intersects(Triangle, Aabb)",
       [](const Inputs& in, Words& words) {
         for (const Triangle& triangle : in.triangles)
           words.add(intersects(triangle, in.box_a));
       }},
      {"intersects(Triangle, Obb)",
       [](const Inputs& in, Words& words) {
         for (const Triangle& triangle : in.triangles)
           words.add(intersects(triangle, in.obb_a));
       }},
      {"intersects(Triangle, Sphere)",
       [](const Inputs& in, Words& words) {
         for (const Triangle& triangle : in.triangles)
           words.add(intersects(triangle, in.ball_a));
       }},
  };
}

}  // namespace

std::vector<Question> triangle_questions() {
  std::vector<Question> questions = yes_or_no_questions();
  const std::vector<Question> others = {
      {"distance(Triangle, Triangle)",
       [](const Inputs& in, Words& words) {
         for (const Triangle& triangle : in.triangles)
           add_distance(words, distance(in.triangle_a, triangle));
       }},
      {"intersection(Triangle, Triangle)",
       [](const Inputs& in, Words& words) {
         for (const Triangle& triangle : in.triangles) {
           for (const Eigen::Vector3d& corner : intersection(in.triangle_a, triangle))
             words.add(corner);
         }
       }},
      {"cast_ray(Triangle)",
       [](const Inputs& in, Words& words) {
         for (const Triangle& triangle : in.triangles) {
           const std::optional<TriangleRayHit> hit = cast_ray(triangle, in.ray);
           words.add(hit.has_value());
           if (hit) words.add(hit->distance), words.add(hit->point), words.add(hit->normal);
         }
       }},
      {"first_contact(paths)",
       [](const Inputs& in, Words& words) {
         const TrianglePath moving = path_between(in.triangle_a, in.triangle_b);
         for (std::size_t i = 0; i + 1 < in.triangles.size(); ++i) {
           const TrianglePath other = path_between(in.triangles[i], in.triangles[i + 1]);
           add_contact(words, first_contact(moving, other));
           std::optional<FirstContact> contacts[1];
           first_contacts(std::span(&moving, 1), std::span(&other, 1), contacts);
           add_contact(words, contacts[0]);
           add_contact(words, first_contact(moving.a, other, {.start = StartContact::IsLeft}));
           add_contact(words, first_contact(moving.a, other, {.clearance = 0.0625}));
           add_contact(words, cast(in.triangle_a, in.triangles[i], in.triangles[i + 1].a));
           add_contact(words,
                       cast(in.triangle_a, Sphere{in.triangles[i].b, 0.25}, in.triangles[i + 1].a));
           add_contact(words,
                       first_contact(EdgePath{moving.a, moving.b}, EdgePath{other.b, other.c}));
         }
       }},
      {"volumes around triangles",
       [](const Inputs& in, Words& words) {
         words.add(bounding_aabb(in.triangles)), words.add(ritter_sphere(in.triangles));
         words.add(bounding_sphere(in.triangles)), words.add(bounding_kdop(in.triangles));
         words.add(ditetrahedron_box(in.triangles)), words.add(bounding_obb(in.triangles));
         words.add(covariance_box(in.triangles));
       }},
      {"volumes around points",
       [](const Inputs& in, Words& words) {
         words.add(bounding_aabb(in.vertices_a)), words.add(ritter_sphere(in.vertices_a));
         words.add(bounding_sphere(in.vertices_a)), words.add(bounding_kdop(in.vertices_a));
         words.add(ditetrahedron_box(in.vertices_a)), words.add(bounding_obb(in.vertices_a));
         words.add(covariance_box(in.vertices_a));
       }},
  };
  questions.insert(questions.end(), others.begin(), others.end());
  return questions;
}

}  // namespace graze::tests
