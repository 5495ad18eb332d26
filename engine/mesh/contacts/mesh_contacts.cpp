#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/contacts/contact_normal.h>
#include <graze/engine/mesh/contacts/inner_parts.h>
#include <graze/engine/mesh/mesh_contacts.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/sweep/last_contact.h>

#include <algorithm>
#include <cmath>

namespace graze {
namespace {

using contacts::CellComplex;
using contacts::Region;

bool is_before(const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
  return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
}

/// Finds the point furthest along a direction from an origin; of several the lowest.
class Furthest {
 public:
  Furthest(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction)
      : origin_(origin.data()), direction_(direction.data()) {}

  void add(const Eigen::Vector3d& point) {
    const double* p = point.data();
    const double extent =
        ((p[0] - origin_[0]) * direction_[0] + (p[1] - origin_[1]) * direction_[1]) +
        (p[2] - origin_[2]) * direction_[2];
    if (extent < extent_ || (extent == extent_ && !is_before(point, point_))) return;
    extent_ = extent;
    for (int k = 0; k < 3; ++k)
      point_.data()[k] = p[k] + 0.0;  // this leaves no negative zeros
  }

  double extent() const { return extent_; }
  const Eigen::Vector3d& point() const { return point_; }

 private:
  const double* origin_;
  const double* direction_;
  double extent_ = -std::numeric_limits<double>::infinity();
  Eigen::Vector3d point_{0, 0, 0};
};

/// Returns the furthest of the nodes of a region, and of a mesh's parts that end there.
Furthest furthest_of(const CellComplex& complex, const Region& region, std::size_t index,
                     const contacts::InnerParts& inner, const Eigen::Vector3d& direction) {
  Furthest furthest(complex.nodes[region.nodes.front()].position, direction);
  for (std::uint32_t node : region.nodes)
    furthest.add(complex.nodes[node].position);
  for (std::uint32_t part : inner.of_region[index]) {
    for (const Eigen::Vector3d& point : inner.parts[part])
      furthest.add(point);
  }
  return furthest;
}

Eigen::Vector3d opposite(const Eigen::Vector3d& v) {
  return {-v.data()[0], -v.data()[1], -v.data()[2]};
}

class ContactQuery {
 public:
  ContactQuery(const PlacedMeshView& a, const PlacedMeshView& b, PairVolume volume, Work& work)
      : a_(a),
        b_(b),
        work_(work),
        complex_(contacts::intersect_cells(a, b, volume, &work)),
        curves_(contacts::chain_curves(complex_)),
        regions_(contacts::find_regions(complex_, curves_)) {}

  std::vector<MeshContact> contacts_by_depth() {
    std::vector<MeshContact> found;
    if (regions_.empty()) return found;
    using contacts::NodeName;
    const contacts::InnerParts inner_a = contacts::find_inner_parts(
        complex_, regions_, {a_, complex_.a, complex_.b, &NodeName::a, &NodeName::b});
    const contacts::InnerParts inner_b = contacts::find_inner_parts(
        complex_, regions_, {b_, complex_.b, complex_.a, &NodeName::b, &NodeName::a});
    for (std::size_t i = 0; i < regions_.size(); ++i)
      found.push_back(contact_of(i, inner_a, inner_b));
    std::stable_sort(found.begin(), found.end(),
                     [](const MeshContact& c, const MeshContact& d) { return c.depth > d.depth; });
    return found;
  }

  /// Appends the points of a contact whose `first_point` is still the number of the region.
  void append_points(MeshContact& contact, std::vector<Eigen::Vector3d>& points) const {
    const Region& region = regions_[contact.first_point];
    contact.first_point = static_cast<std::uint32_t>(points.size());
    contact.point_count = static_cast<std::uint32_t>(region.nodes.size());
    for (std::uint32_t node : region.nodes)
      points.push_back(complex_.nodes[node].position);
  }

 private:
  MeshContact contact_of(std::size_t index, const contacts::InnerParts& inner_a,
                         const contacts::InnerParts& inner_b) {
    const Region& region = regions_[index];
    const contacts::SweepUnits units(a_, b_);
    MeshContact contact{};
    contact.normal = contacts::contact_normal(complex_, curves_, region, a_, b_, units);
    const Eigen::Vector3d back = opposite(contact.normal);
    const Furthest deepest_a = furthest_of(complex_, region, index, inner_a, contact.normal);
    const Furthest deepest_b = furthest_of(complex_, region, index, inner_b, back);
    contact.point_a = deepest_a.point();
    contact.point_b = deepest_b.point();
    for (int k = 0; k < 3; ++k) {
      contact.point.data()[k] = 0.5 * contact.point_a.data()[k] + 0.5 * contact.point_b.data()[k];
    }
    const double width = std::max(deepest_a.extent() + deepest_b.extent(), 0.0);
    contact.depth =
        width == 0 ? 0
                   : std::min(width, contacts::last_contact(a_, b_, contact.normal, width, work_));
    contact.first_point = static_cast<std::uint32_t>(index);
    return contact;
  }

  const PlacedMeshView& a_;
  const PlacedMeshView& b_;
  Work& work_;
  CellComplex complex_;
  std::vector<contacts::CurveSteps> curves_;
  std::vector<Region> regions_;
};

}  // namespace

MeshContacts find_contacts(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                           const ContactSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> MeshContacts {
    CountedWork counted(work);
    ContactQuery query(mesh_a, mesh_b, settings.volume, counted.work());
    MeshContacts result;
    result.contacts = query.contacts_by_depth();
    if (result.contacts.size() > settings.limit) {
      result.contacts.resize(settings.limit);
      result.completeness = Completeness::LimitReached;
    }
    for (MeshContact& contact : result.contacts)
      query.append_points(contact, result.points);
    return result;
  });
}

}  // namespace graze
