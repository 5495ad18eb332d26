#include <graze/engine/cli/motion/motion_page.h>

#include <graze/engine/cli/output/outcome.h>

namespace graze::cli {

std::unique_ptr<MotionPage> make_motion_page(const Mesh&, const Pose&, const Mesh&,
                                             const MotionPageSettings&) {
  throw UsageError("--view: this command was built without pages");
}

}  // namespace graze::cli
