#include <graze/engine/compare/judge/judgement.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace graze::compare {
namespace {

using Fault = std::optional<std::string>;

/// Returns how many triangles a shape has; one for all but meshes.
std::size_t triangle_count(const CaseShape& shape) {
  if (const auto* mesh = std::get_if<CaseMesh>(&shape)) return mesh->mesh.triangles().size();
  const auto* body = std::get_if<CaseBody>(&shape);
  const Mesh* mesh = body != nullptr ? body->shape.as<Mesh>() : nullptr;
  return mesh != nullptr ? mesh->triangles().size() : 1;
}

Fault fault_of_triangle(std::uint32_t triangle, std::size_t count) {
  if (triangle < count) return std::nullopt;
  return std::string("names triangle ") + std::to_string(triangle) + " of " + std::to_string(count);
}

/// Keeps the sizes of the two meshes that an answer names triangles of.
class TriangleFaults {
 public:
  explicit TriangleFaults(const Case& query)
      : count_a_(triangle_count(query.a)),
        count_b_(query.b ? triangle_count(*query.b) : count_a_) {}

  Fault of(const TrianglePair& pair) const {
    Fault fault = fault_of_triangle(pair.a, count_a_);
    return fault ? fault : fault_of_triangle(pair.b, count_b_);
  }

  Fault of(const std::vector<TrianglePair>& pairs) const {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (Fault fault = of(pairs[i])) return fault;
      if (i > 0 && !(pairs[i - 1] < pairs[i])) return "a list that does not ascend";
    }
    return std::nullopt;
  }

  Fault of(const std::vector<std::uint32_t>& triangles) const {
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (Fault fault = fault_of_triangle(triangles[i], count_a_)) return fault;
      if (i > 0 && triangles[i - 1] >= triangles[i]) return "a list that does not ascend";
    }
    return std::nullopt;
  }

 private:
  std::size_t count_a_;
  std::size_t count_b_;
};

bool has_asked_part(const Case& query, const CaseAnswer& answer) {
  switch (query.ask) {
    case Ask::Pairs:
    case Ask::SelfPairs:
      return answer.pairs || answer.triangles;
    case Ask::Distance:
      return answer.distance.has_value();
    case Ask::Contacts:
      return answer.contacts || answer.manifold;
    case Ask::Intersection:
      return answer.intersection || answer.corners;
    case Ask::Separation:
      return answer.distance && answer.translation;
    case Ask::Ray:
    case Ask::RayAll:
      return answer.hits.has_value();
    case Ask::FirstContact:
      return answer.status && answer.low && answer.high;
    default:
      return answer.says.has_value();
  }
}

bool is_finite(const CaseContact& c) {
  return c.point.allFinite() && c.point_a.allFinite() && c.point_b.allFinite() &&
         c.normal.allFinite() && std::isfinite(c.depth);
}

bool is_finite(const CaseShapeContact& c) {
  if (c.point_a && !c.point_a->allFinite()) return false;
  if (c.point_b && !c.point_b->allFinite()) return false;
  return c.point.allFinite() && c.normal.allFinite() && std::isfinite(c.depth);
}

bool is_finite(const RayHit& hit) {
  return hit.point.allFinite() && hit.normal.allFinite() && !std::isnan(hit.distance);
}

bool is_finite(const Eigen::Vector3d& point) {
  return point.allFinite();
}

bool is_finite(const IntersectionPoint& point) {
  return point.position.allFinite();
}

template <typename List>
bool are_finite(const List& list) {
  return std::all_of(list.begin(), list.end(), [](const auto& part) { return is_finite(part); });
}

bool is_time(double time) {
  return time >= 0 && time <= 1;
}

Fault fault_of_times(const CaseAnswer& answer) {
  if (!answer.low || !answer.high) return std::nullopt;
  if (!is_time(*answer.low) || !is_time(*answer.high)) return "a time that is not from 0 to 1";
  if (*answer.low > *answer.high) return "times that are in the wrong order";
  return std::nullopt;
}

Fault fault_of_numbers(const CaseAnswer& answer) {
  for (const std::optional<double>* length : {&answer.distance, &answer.lower_bound}) {
    if (*length && std::isnan(**length)) return "a distance that is no number";
  }
  for (const auto* point :
       {&answer.point_a, &answer.point_b, &answer.translation, &answer.normal}) {
    if (*point && !(*point)->allFinite()) return "a point that is not finite";
  }
  if (answer.contacts && !are_finite(*answer.contacts)) return "a contact that is not finite";
  if (answer.manifold && !are_finite(*answer.manifold)) return "a contact that is not finite";
  if (answer.hits && !are_finite(*answer.hits)) return "a hit that is not finite";
  if (answer.corners && !are_finite(*answer.corners)) return "a corner that is not finite";
  if (answer.intersection && !are_finite(answer.intersection->points))
    return "a point that is not finite";
  return std::nullopt;
}

}  // namespace

std::optional<std::string> fault_of_answer(const Case& query, const CaseAnswer& answer) {
  if (!has_asked_part(query, answer)) return "answers another question";
  const TriangleFaults triangles(query);
  if (answer.pairs) {
    if (Fault fault = triangles.of(*answer.pairs)) return fault;
  }
  if (answer.triangles) {
    if (Fault fault = triangles.of(*answer.triangles)) return fault;
  }
  if (answer.pair) {
    if (Fault fault = triangles.of(*answer.pair)) return fault;
  }
  if (Fault fault = fault_of_times(answer)) return fault;
  return fault_of_numbers(answer);
}

Judgement engine_error(const std::string& why) {
  Judgement judgement;
  judgement.verdict = Verdict::Wrong;
  judgement.error_class = ErrorClass::EngineError;
  judgement.truth = "engine error: " + why;
  return judgement;
}

}  // namespace graze::compare
