#pragma once

#include <filesystem>

#include "samples/simulation/scenes/scene.h"

namespace graze::samples {

/// Returns the bundled gear and pinion on axles 50 mm apart: a motor turns the gear, whose teeth
/// drive the pinion by the ratio of their teeth, without any other joint. Bodies are called "gear"
/// and "pinion".
Scene gears(Extent extent, const std::filesystem::path& data);

/// The numbers of their teeth.
inline constexpr double kGearTeeth = 31, kPinionTeeth = 19;

/// Returns the bundled nut on the bundled bolt's thread, the bolt upright with its tip up, moved by
/// nothing but the nut's weight. With little friction the nut screws itself down, rattling from
/// flank to flank; with much it stays. Its body is called "nut".
Scene nut_on_bolt(double friction, Extent extent, const std::filesystem::path& data);

/// The pitch of the thread, metres.
inline constexpr double kPitch = 0.00125;

}  // namespace graze::samples
