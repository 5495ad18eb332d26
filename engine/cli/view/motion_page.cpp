#include <graze/engine/cli/motion/motion_page.h>

#include <graze/engine/cli/view/case_pictures.h>
#include <graze/engine/cli/view/shown_pair.h>

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace graze::cli {
namespace {

/// Nobody looks at more pictures, and a page of bolts takes some minutes.
constexpr std::size_t kMostPictures = 2000;
constexpr std::size_t kLeastTimes = 2;

/// Holds a time of a motion that is shown, and what it is besides.
struct ShownTime {
  double t;
  std::string what;  ///< stands behind the time; may be empty
};

/// Returns even times, and those that the answer names.
std::vector<ShownTime> times_of(std::size_t count, const RigidContact& contact) {
  std::vector<ShownTime> times;
  for (std::size_t i = 0; i < count; ++i)
    times.push_back({static_cast<double>(i) / static_cast<double>(count - 1), ""});
  if (contact.status == RigidStatus::Hit) times.push_back({contact.high, ", they meet"});
  if (contact.status == RigidStatus::Close)
    times.push_back({contact.low, ", free up to here, and nothing is proved behind"});
  std::stable_sort(times.begin(), times.end(),
                   [](const ShownTime& a, const ShownTime& b) { return a.t < b.t; });
  return times;
}

std::string said_of(const RigidContact& contact) {
  switch (contact.status) {
    case RigidStatus::Free:
      return "Free: proved for all times, also between these pictures.";
    case RigidStatus::Hit:
      return fmt::format("Free up to {:.9g}, and at {:.9g} they meet.", contact.low, contact.high);
    case RigidStatus::Close:
      break;
  }
  return fmt::format("Free up to {:.9g}, and there too near for a proof.", contact.low);
}

class ShownMotions final : public MotionPage {
 public:
  ShownMotions(const Mesh& mesh_a, const Pose& pose_a, const Mesh& mesh_b,
               const MotionPageSettings& settings)
      : mesh_a_(mesh_a),
        pose_a_(pose_a),
        mesh_b_(mesh_b),
        has_numbers_(settings.motions > 1),
        times_(std::clamp(kMostPictures / std::max<std::size_t>(settings.motions, 1), kLeastTimes,
                          kMotionPictures)),
        page_({.title = settings.title}),
        bodies_{page_.view.add(mesh_a, {.name = settings.name_a}),
                page_.view.add(mesh_b, {.name = settings.name_b})} {
    page_.view.add_note(fmt::format(
        "Each motion is shown at {} times, and where the answer says that they meet.", times_));
  }

  void add(const RigidMotion& motion, const RigidContact& contact) override {
    const std::string note = said_of(contact);
    const std::string which = has_numbers_ ? fmt::format("motion {}, ", count_) : std::string();
    for (const ShownTime& time : times_of(times_, contact)) {
      show_pair(
          PlacedMeshView(mesh_a_, pose_a_), PlacedMeshView(mesh_b_, motion.at(time.t)), bodies_,
          {.label = fmt::format("{}t = {:.6g}{}", which, time.t, time.what), .note = note}, page_);
    }
    ++count_;
  }

  std::string text() const override { return page_.view.page(); }

 private:
  Mesh mesh_a_;
  Pose pose_a_;
  Mesh mesh_b_;
  bool has_numbers_;
  std::size_t times_;
  ShownPage page_;
  ShownBodies bodies_;
  std::size_t count_ = 0;
};

}  // namespace

std::unique_ptr<MotionPage> make_motion_page(const Mesh& mesh_a, const Pose& pose_a,
                                             const Mesh& mesh_b,
                                             const MotionPageSettings& settings) {
  return std::make_unique<ShownMotions>(mesh_a, pose_a, mesh_b, settings);
}

}  // namespace graze::cli
