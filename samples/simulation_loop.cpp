// Bolts and nuts pour into a bin and come to rest: a loop of a small solver around graze::World.
// simulation_loop DATA_DIR [--bodies N] [--seconds S] [--seed K] [--gltf FILE] [--picture FILE.pov]
// Exits with 1 if anything fell through the bin, flew out of it or gained energy.

#include <graze/graze.h>

#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <random>
#include <string>
#include <string_view>

#include "samples/render/picture.h"
#include "samples/simulation/bin.h"
#include "samples/simulation/contact_solver.h"
#include "samples/simulation/gltf_writer.h"

namespace {

using Eigen::Vector3d;
using graze::samples::ContactSolver;
using graze::samples::RigidBody;
using Clock = std::chrono::steady_clock;

/// Seconds of one core that this program has used: what a step costs, whatever else the machine
/// does.
double core_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

constexpr double kSteel = 7850;          // kg/m^3
constexpr double kPoured = 12;           // bodies a second
constexpr double kDrop = 0.015;          // metres from the top of the pile to what starts to fall
constexpr double kSpinDecay = 4;         // 1/s: stands for what rolling costs
constexpr double kStillSpeed = 0.05;     // m/s of any point: below, a body counts as still
constexpr double kTimeToSleep = 0.10;    // s that it stays so until it sleeps
constexpr double kUnseen = 1e-4;         // metres that a body moves before the world is told
constexpr double kFramesPerSecond = 30;  // of the animation
constexpr double kWaiting = 2;           // metres above: where it has bodies before they start

struct Options {
  std::filesystem::path data;
  int bodies = 200;
  double seconds = 20;
  std::uint64_t seed = 1;
  std::string gltf, picture;
};

struct Totals {
  double world_seconds = 0, solver_seconds = 0;
  double awake = 0, pairs = 0, contacts = 0;
  std::uint64_t at_rest = 0, apart = 0, tests = 0, found = 0;
  int steps = 0;
};

/// A shape that pours, with what the world and the solver need of it.
struct Kind {
  Kind(const graze::Mesh& of, const char* called)
      : name(called),
        mesh(of),
        shape(graze::share(of)),
        mass(graze::samples::mass_properties(of, kSteel)) {
    for (const Vector3d& vertex : of.vertices())
      reach = std::max(reach, (vertex - mass.centre).norm());
    graze::prepare(of);
  }

  const char* name;
  graze::Mesh mesh;
  std::shared_ptr<const graze::BodyShape> shape;
  graze::samples::MassProperties mass;
  double reach = 0;
};

class Simulation {
 public:
  explicit Simulation(const Options& options)
      : options_(options), random_(options.seed), solver_(settings_) {
    kinds_.reserve(2);  // bodies point into it
    kinds_.emplace_back(graze::load_mesh(options.data / "meshes/bolt.obj"), "bolt");
    kinds_.emplace_back(graze::load_mesh(options.data / "meshes/nut.stl"), "nut");
    bodies_.reserve(static_cast<std::size_t>(options.bodies));
    world_.add(bin_mesh_, graze::Pose::Identity(),
               {.motion = graze::Motion::Static, .user_data = ContactSolver::kFixed});
  }

  int run() {
    const auto start = Clock::now();
    const double core_start = core_seconds();
    std::printf(
        "  second  awake  pairs  contacts   world ms/step  solver ms/step   tested  at rest  "
        "apart\n");
    const int steps = static_cast<int>(std::lround(options_.seconds / settings_.step));
    for (int step = 0; step < steps; ++step) {
      const double time = step * settings_.step;
      if (bodies_.size() < static_cast<std::size_t>(options_.bodies) &&
          time * kPoured >= static_cast<double>(bodies_.size())) {
        pour();
      }
      advance();
      if (time * kFramesPerSecond >= static_cast<double>(times_.size())) record(time);
      if ((step + 1) % static_cast<int>(std::lround(1 / settings_.step)) == 0 || step + 1 == steps)
        report(time + settings_.step);
    }
    core_ = core_seconds() - core_start;
    wall_ = std::chrono::duration<double>(Clock::now() - start).count();
    return judge();
  }

 private:
  double uniform(double from, double to) {
    return from + (to - from) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }

  double top_of_pile() const {
    double top = 0;
    for (const RigidBody& body : bodies_) {
      if (body.stillness > 0) top = std::max(top, body.at.z() + body.reach);
    }
    return top + kinds_[0].reach;
  }

  /// Adds a body above the pile, turned at random, unless there is one in its way.
  void pour() {
    const Kind& kind = kinds_[bodies_.size() % kinds_.size()];
    const double z = top_of_pile() + kDrop;
    const double free = 0.92 * graze::samples::inner_radius(size_, z) - kind.reach;
    const double radius = free * std::sqrt(uniform(0, 1));
    const double angle = uniform(0, 6.283185307179586);
    const Vector3d at(radius * std::cos(angle), radius * std::sin(angle), z);
    const Vector3d half = Vector3d::Constant(kind.reach);
    for (const graze::BodyId id : world_.find_in_box({at - half, at + half})) {
      if (world_.user_data(id) != ContactSolver::kFixed) return;
    }
    Eigen::Quaterniond turn;
    do {  // uniform among rotations: a point of the ball of four dimensions
      for (int k = 0; k < 4; ++k)
        turn.coeffs()[k] = uniform(-1, 1);
    } while (turn.norm() > 1 || turn.norm() < 0.1);
    turn.normalize();
    RigidBody body{.id = {}, .mass = &kind.mass, .at = at, .turn = turn, .reach = kind.reach};
    body.id = world_.add(kind.shape, body.pose(), {.user_data = bodies_.size()});
    poured_energy_ += energy_of(body);
    bodies_.push_back(body);
    seen_.push_back(body);
    first_frame_.push_back(times_.size());
    frames_.emplace_back();
  }

  double energy_of(const RigidBody& body) const {
    return body.kinetic_energy() + body.mass->mass * settings_.gravity * body.at.z();
  }

  void advance() {
    const double begin = core_seconds();
    const graze::WorldUpdate update = world_.update();
    const double middle = core_seconds();
    woken_.clear();
    solver_.take(world_, update, bodies_, woken_);
    for (RigidBody& body : bodies_) {
      if (!body.is_asleep) body.velocity.z() -= settings_.gravity * settings_.step;
    }
    solver_.solve(bodies_, woken_);
    for (RigidBody& body : bodies_) {
      if (!body.is_asleep) move(body);
    }
    solver_.relax(bodies_);
    const double end = core_seconds();
    tell_world();
    totals_.solver_seconds += end - middle;
    totals_.world_seconds += (middle - begin) + (core_seconds() - end);
    count(update.work);
  }

  void move(RigidBody& body) const {
    const double step = settings_.step;
    body.spin *= 1 / (1 + step * kSpinDecay);
    body.at += step * body.velocity;
    const Eigen::Quaterniond rate(0, body.spin.x(), body.spin.y(), body.spin.z());
    body.turn.coeffs() += 0.5 * step * (rate * body.turn).coeffs();
    body.turn.normalize();
  }

  /// The world sees what moved by more than a hair; still bodies sleep, those that were hit wake.
  void tell_world() {
    moved_.clear(), poses_.clear();
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      RigidBody& body = bodies_[i];
      if (body.is_asleep) continue;
      const double turned = 2 * (body.turn * seen_[i].turn.conjugate()).vec().norm();
      if ((body.at - seen_[i].at).norm() + turned * body.reach > kUnseen) {
        seen_[i] = body;
        moved_.push_back(body.id);
        poses_.push_back(body.pose());
      }
      const double speed = body.velocity.norm() + body.spin.norm() * body.reach;
      body.stillness = speed < kStillSpeed ? body.stillness + settings_.step : 0;
    }
    world_.move(moved_, poses_);
    for (RigidBody& body : bodies_) {
      if (body.is_asleep || body.stillness < kTimeToSleep) continue;
      body.is_asleep = true;
      body.velocity = body.spin = Vector3d::Zero();
      world_.sleep(body.id);
    }
    for (const std::size_t i : woken_) {
      bodies_[i].is_asleep = false;
      bodies_[i].stillness = 0;
      world_.wake(bodies_[i].id);
    }
  }

  void count(const graze::WorldWork& work) {
    ++totals_.steps;
    for (const RigidBody& body : bodies_)
      totals_.awake += !body.is_asleep;
    totals_.pairs += static_cast<double>(solver_.pair_count());
    totals_.contacts += static_cast<double>(solver_.contact_count());
    totals_.at_rest += work.pairs_at_rest;
    totals_.apart += work.pairs_apart;
    totals_.tests += work.shape_tests;
    totals_.found += work.contacts_found;
  }

  void report(double time) {
    const double n = totals_.steps;
    const auto a_step = [&](std::uint64_t value) { return static_cast<double>(value) / n; };
    std::printf("  %6.2f  %5.0f  %5.0f  %8.0f  %14.3f  %14.3f  %7.1f  %7.1f  %5.1f\n", time,
                totals_.awake / n, totals_.pairs / n, totals_.contacts / n,
                1e3 * totals_.world_seconds / n, 1e3 * totals_.solver_seconds / n,
                a_step(totals_.tests), a_step(totals_.at_rest), a_step(totals_.apart));
    std::fflush(stdout);
    totals_ = {};
  }

  void record(double time) {
    times_.push_back(time);
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      frames_[i].push_back(bodies_[i].pose());
  }

  int judge() {
    bool is_inside = true;
    bool is_finite = true;
    std::size_t asleep = 0;
    double energy = 0;
    for (const RigidBody& body : bodies_) {
      is_inside &= body.at.z() > 0 && std::hypot(body.at.x(), body.at.y()) <
                                          graze::samples::inner_radius(size_, body.at.z());
      is_finite &= body.at.allFinite() && body.velocity.allFinite() && body.spin.allFinite();
      asleep += body.is_asleep;
      energy += energy_of(body);
    }
    double deepest = 0;
    world_.update();
    for (const graze::BodyContact& contact : world_.contacts()) {
      for (const graze::ShapeContact& point : contact.manifold)
        deepest = std::max(deepest, point.depth);
    }
    const bool is_right = is_inside && is_finite && energy < poured_energy_;
    std::printf(
        "%s: %zu of %d bodies in the bin, %zu at rest; deepest penetration %.3f mm; energy "
        "%.4g J, %.4g J when poured\n",
        is_right ? "as it must be" : "WRONG, a body left the bin or energy rose", bodies_.size(),
        options_.bodies, asleep, 1e3 * deepest, energy, poured_energy_);
    std::printf("%.2f s simulated in %.2f s, %.2f s of one core: %.2f and %.2f times real time\n",
                options_.seconds, wall_, core_, options_.seconds / wall_, options_.seconds / core_);
    return is_right ? 0 : 1;
  }

 public:
  void write_gltf(const std::string& path) const {
    graze::samples::GltfScene scene{.shapes = {}, .bodies = {}, .times = times_};
    for (const Kind& kind : kinds_)
      scene.shapes.push_back({kind.name, kind.mesh, {0.5, 0.5, 0.55}});
    scene.shapes[1].colour = {0.72, 0.53, 0.25};
    scene.shapes.push_back({"bin", bin_mesh_, {0.2, 0.25, 0.3}});
    scene.bodies.push_back({2, {graze::Pose::Identity()}});
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      graze::Pose waiting = frames_[i].empty() ? bodies_[i].pose() : frames_[i].front();
      waiting.translation().z() += kWaiting;
      std::vector<graze::Pose> poses(first_frame_[i], waiting);
      poses.insert(poses.end(), frames_[i].begin(), frames_[i].end());
      scene.bodies.push_back({i % kinds_.size(), std::move(poses)});
    }
    graze::samples::write_gltf(path, scene);
  }

  void write_picture(const std::string& path) const {
    const graze::render::Colour colours[] = {graze::render::kSteel, graze::render::kSand};
    std::vector<graze::render::Part> parts{
        {"bin", bin_mesh_, graze::Pose::Identity(), {0.45, 0.5, 0.55}, {}}};
    for (std::size_t kind = 0; kind < kinds_.size() && kind < bodies_.size(); ++kind) {
      parts.push_back(
          {kinds_[kind].name, kinds_[kind].mesh, bodies_[kind].pose(), colours[kind], {}});
      for (std::size_t i = kind + kinds_.size(); i < bodies_.size(); i += kinds_.size())
        parts.back().copies.push_back(bodies_[i].pose());
    }
    const Vector3d front(0.3, -1, 0);
    const Vector3d up(0, 0, 1);
    const Vector3d middle(0, 0, 0.5 * size_.height);
    graze::render::write_scene(path,
                               {std::to_string(bodies_.size()) + " bolts and nuts at rest in a bin",
                                parts,
                                {{.caption = "The bin cut open",
                                  .centre = middle,
                                  .towards_viewer = front + 0.45 * up,
                                  .up = up,
                                  .height = 0.19,
                                  .cut = graze::render::Cut{0.03 * front, front.normalized(), {0}}},
                                 {.caption = "From above",
                                  .centre = middle,
                                  .towards_viewer = up,
                                  .up = -front,
                                  .height = 0.19,
                                  .cut = {}}}});
  }

 private:
  Options options_;
  std::mt19937_64 random_;
  graze::samples::BinSize size_;
  graze::samples::SolverSettings settings_;
  ContactSolver solver_;
  std::vector<Kind> kinds_;
  graze::Mesh bin_mesh_ = graze::samples::make_bin({});
  graze::World world_;
  std::vector<RigidBody> bodies_, seen_;  // as they are, and as the world has them
  std::vector<std::vector<graze::Pose>> frames_;
  std::vector<std::size_t> first_frame_;
  std::vector<double> times_;
  std::vector<std::size_t> woken_;
  std::vector<graze::BodyId> moved_;
  std::vector<graze::Pose> poses_;
  Totals totals_;
  double poured_energy_ = 0;
  double wall_ = 0;  // seconds
  double core_ = 0;
};

int usage() {
  std::fprintf(stderr,
               "usage: simulation_loop DATA_DIR [--bodies N] [--seconds S] [--seed K] "
               "[--gltf FILE] [--picture FILE.pov]\n");
  return 2;
}

/// The whole text as a number; nothing, if it is none.
template <typename T>
std::optional<T> number_of(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<Options> options_of(int argc, char** argv) {
  if (argc < 2 || argc % 2 != 0) return std::nullopt;
  Options options;
  options.data = argv[1];
  for (int i = 2; i < argc; i += 2) {
    const std::string_view name = argv[i];
    const std::string_view value = argv[i + 1];
    if (name == "--bodies") {
      options.bodies = number_of<int>(value).value_or(0);
    } else if (name == "--seconds") {
      options.seconds = number_of<double>(value).value_or(0);
    } else if (name == "--seed") {
      const std::optional<std::uint64_t> seed = number_of<std::uint64_t>(value);
      if (!seed) return std::nullopt;
      options.seed = *seed;
    } else if (name == "--gltf") {
      options.gltf = value;
    } else if (name == "--picture") {
      options.picture = value;
    } else {
      return std::nullopt;
    }
  }
  const bool is_sound = options.bodies > 0 && options.bodies <= 100000 && options.seconds > 0 &&
                        options.seconds <= 1e5;
  return is_sound ? std::optional(options) : std::nullopt;
}

}  // namespace

int main(int argc, char** argv) {
  const std::optional<Options> options = options_of(argc, argv);
  if (!options) return usage();
  try {
    Simulation simulation(*options);
    const int status = simulation.run();
    if (!options->gltf.empty()) simulation.write_gltf(options->gltf);
    if (!options->picture.empty()) simulation.write_picture(options->picture);
    return status;
  } catch (const graze::Error& error) {
    std::fprintf(stderr, "simulation_loop: %s\n", error.what());
    return 1;
  }
}
