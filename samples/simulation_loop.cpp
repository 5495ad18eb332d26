// Bolts and nuts pour into a bin and come to rest, and a pellet is shot at them that would be
// through the bin's floor within a step: a loop of a small solver around graze::World.
// simulation_loop DATA_DIR [--bodies N] [--seconds S] [--shot M/S] [--seed K] [--gltf FILE]
// [--picture FILE.pov] [--record FILE] Exits with 1 if anything fell through the bin, flew out of
// it or gained energy.

#include <graze/graze.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <optional>
#include <random>
#include <string>

#include "samples/simulation/bin.h"
#include "samples/simulation/contact_solver.h"
#include "samples/simulation/options.h"
#include "samples/simulation/pellet_watch.h"
#include "samples/simulation/pile_files.h"
#include "samples/simulation/pile_recorder.h"
#include "samples/simulation/shape_mass.h"

namespace {

using Eigen::Vector3d;
using graze::samples::ContactSolver;
using graze::samples::RigidBody;
using Options = graze::samples::SimulationOptions;
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
constexpr double kPellet = 0.002;        // metres, its radius
constexpr double kFramesPerSecond = 30;  // of the animation

struct Totals {
  double world_seconds = 0, solver_seconds = 0;
  double awake = 0, pairs = 0, contacts = 0;
  std::uint64_t at_rest = 0, apart = 0, tests = 0;
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
      bounding_radius = std::max(bounding_radius, (vertex - mass.centre).norm());
    graze::prepare(of);
  }

  const char* name;
  graze::Mesh mesh;
  std::shared_ptr<const graze::BodyShape> shape;
  graze::samples::MassProperties mass;
  double bounding_radius = 0;
};

class Simulation {
 public:
  explicit Simulation(const Options& options)
      : options_(options), random_(options.seed), solver_(settings_) {
    kinds_.reserve(2);  // bodies point into it
    kinds_.emplace_back(graze::load_mesh(options.data / "meshes/bolt.obj"), "bolt");
    kinds_.emplace_back(graze::load_mesh(options.data / "meshes/nut.stl"), "nut");
    bodies_.reserve(static_cast<std::size_t>(options.bodies) + 1);
    recorder_.name(
        world_.add({bin_mesh_, graze::Pose::Identity()},
                   {.kind = graze::BodyKind::Static, .user_data = ContactSolver::kFixed}),
        "bin");
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
      if (poured() < static_cast<std::size_t>(options_.bodies)) {
        if (time * kPoured >= static_cast<double>(poured())) pour();
      } else if (options_.shot > 0 && !has_pellet()) {
        shoot();
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

  /// The pellet comes last.
  std::size_t poured() const { return frames_.size(); }
  bool has_pellet() const { return bodies_.size() > poured(); }

  double top_of_pile() const {
    double top = 0;
    for (const RigidBody& body : bodies_) {
      if (body.stillness > 0) top = std::max(top, body.at.z() + body.bounding_radius);
    }
    return top + kinds_[0].bounding_radius;
  }

  /// Adds a body above the pile, turned at random, unless there is one in its way.
  void pour() {
    const Kind& kind = kinds_[bodies_.size() % kinds_.size()];
    const double z = top_of_pile() + kDrop;
    const double free = 0.92 * graze::samples::inner_radius(size_, z) - kind.bounding_radius;
    const double radius = free * std::sqrt(uniform(0, 1));
    const double angle = uniform(0, 6.283185307179586);
    const Vector3d at(radius * std::cos(angle), radius * std::sin(angle), z);
    const Vector3d half = Vector3d::Constant(kind.bounding_radius);
    for (const graze::BodyId id : world_.find_in_box({at - half, at + half})) {
      if (world_.user_data(id) != ContactSolver::kFixed) return;
    }
    Eigen::Quaterniond turn;
    do {  // uniform among rotations: a point of the ball of four dimensions
      for (int k = 0; k < 4; ++k)
        turn.coeffs()[k] = uniform(-1, 1);
    } while (turn.norm() > 1 || turn.norm() < 0.1);
    turn.normalize();
    RigidBody body{.id = {},
                   .mass = &kind.mass,
                   .at = at,
                   .turn = turn,
                   .bounding_radius = kind.bounding_radius};
    body.id = world_.add({kind.shape, body.pose()}, {.user_data = bodies_.size()});
    recorder_.name(body.id, std::string(kind.name) + ' ' + std::to_string(bodies_.size()));
    poured_energy_ += energy_of(body);
    bodies_.push_back(body);
    seen_.push_back(body);
    first_frame_.push_back(times_.size());
    frames_.emplace_back();
  }

  /// Adds a pellet above the pile, on its way down. It is swept: in a step it goes further than the
  /// bin is high and thick.
  void shoot() {
    const Vector3d at(0, 0, top_of_pile() + kDrop);
    RigidBody body{.id = {},
                   .mass = &pellet_mass_,
                   .at = at,
                   .turn = Eigen::Quaterniond::Identity(),
                   .velocity = Vector3d(0, 0, -options_.shot),
                   .bounding_radius = kPellet};
    body.id = world_.add({pellet_shape_, body.pose()},
                         {.user_data = bodies_.size(), .detection = graze::Detection::Continuous});
    recorder_.name(body.id, "pellet");
    poured_energy_ += energy_of(body);
    bodies_.push_back(body);
    seen_.push_back(body);
    pellet_from_ = at;
  }

  /// Whether the pellet met anything on its way since the last step, and not there already: then it
  /// is put where it met the first, so that the solver finds them touching. What was left of the
  /// step is lost.
  bool stop_pellet(const graze::WorldUpdate& update) {
    double first = 2;
    for (const graze::BodyFirstContact& met : update.first_contacts) {
      const bool is_hit = met.contact.status == graze::RigidStatus::Hit;
      if (!met.is_at_start && is_hit) first = std::min(first, met.contact.high);
    }
    if (first > 1) return false;
    RigidBody& pellet = bodies_.back();
    pellet.at = pellet_from_ + first * (pellet.at - pellet_from_);
    seen_.back() = pellet;
    pellet_from_ = pellet.at;
    world_.set_detection(pellet.id, graze::Detection::Continuous);  // from where it is put
    world_.move(pellet.id, pellet.pose());
    ++pellet_stops_;
    return true;
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
    if (stop_pellet(update)) solver_.take(world_, world_.update(), bodies_, woken_);
    if (has_pellet()) pellet_watch_.see(size_, bodies_.back().at);
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
    if (has_pellet()) pellet_from_ = seen_.back().at;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      RigidBody& body = bodies_[i];
      if (body.is_asleep) continue;
      const double turned = 2 * (body.turn * seen_[i].turn.conjugate()).vec().norm();
      if ((body.at - seen_[i].at).norm() + turned * body.bounding_radius > kUnseen) {
        seen_[i] = body;
        moved_.push_back(body.id);
        poses_.push_back(body.pose());
      }
      const double speed = body.velocity.norm() + body.spin.norm() * body.bounding_radius;
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
    for (std::size_t i = 0; i < frames_.size(); ++i)
      frames_[i].push_back(bodies_[i].pose());
  }

  int judge() {
    bool is_inside = true;
    bool is_finite = true;
    std::size_t asleep = 0;
    double energy = 0;
    for (const RigidBody& body : bodies_) {
      const bool is_pellet = has_pellet() && &body == &bodies_.back();
      is_inside &=
          is_pellet ? !pellet_watch_.has_gone_through() : graze::samples::is_in_bin(size_, body.at);
      is_finite &= body.at.allFinite() && body.velocity.allFinite() && body.spin.allFinite();
      asleep += body.is_asleep && !is_pellet;
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
        is_right ? "as it must be" : "WRONG, a body left the bin or energy rose", poured(),
        options_.bodies, asleep, 1e3 * deepest, energy, poured_energy_);
    if (has_pellet()) {
      std::printf(
          "the pellet came at %.4g m/s, %.0f mm a step, and was stopped %d times on its way%s\n",
          options_.shot, 1e3 * options_.shot * settings_.step, pellet_stops_,
          pellet_watch_.has_jumped_out() ? "; it jumped out over the rim" : "");
    }
    std::printf("%.2f s simulated in %.2f s, %.2f s of one core: %.2f and %.2f times real time\n",
                options_.seconds, wall_, core_, options_.seconds / wall_, options_.seconds / core_);
    return is_right ? 0 : 1;
  }

 public:
  void write_files() {
    recorder_.finish();
    const bool is_at_rest = std::ranges::all_of(bodies_, &RigidBody::is_asleep);
    graze::samples::Pile pile{.title = std::to_string(poured()) + " bolts and nuts " +
                                       (is_at_rest ? "at rest " : "") + "in a bin",
                              .bin = bin_mesh_,
                              .bin_height = size_.height,
                              .kinds = {},
                              .bodies = {},
                              .times = times_};
    for (const Kind& kind : kinds_)
      pile.kinds.push_back({kind.name, kind.mesh});
    for (std::size_t i = 0; i < poured(); ++i)
      pile.bodies.push_back({i % kinds_.size(), bodies_[i].pose(), first_frame_[i], frames_[i]});
    if (!options_.gltf.empty()) write_animation(options_.gltf, pile);
    if (!options_.picture.empty()) write_picture(options_.picture, pile);
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
  graze::samples::PileRecorder recorder_{world_, options_.record, settings_.step};
  std::vector<RigidBody> bodies_, seen_;  // as they are, and as the world has them
  std::vector<std::vector<graze::Pose>> frames_;
  std::vector<std::size_t> first_frame_;
  std::vector<double> times_;
  std::vector<std::size_t> woken_;
  std::vector<graze::BodyId> moved_;
  std::vector<graze::Pose> poses_;
  graze::Shape pellet_shape_ = graze::Sphere{Vector3d::Zero(), kPellet};
  graze::samples::MassProperties pellet_mass_ =
      graze::samples::mass_properties(pellet_shape_, kSteel);
  Vector3d pellet_from_ = Vector3d::Zero();  // where it was at the last update
  int pellet_stops_ = 0;
  graze::samples::PelletWatch pellet_watch_;
  Totals totals_;
  double poured_energy_ = 0;
  double wall_ = 0;  // seconds
  double core_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  const std::optional<Options> options = graze::samples::simulation_options(argc, argv);
  if (!options) {
    std::fprintf(stderr, "usage: %s\n", Options::kUsage);
    return 2;
  }
  try {
    Simulation simulation(*options);
    const int status = simulation.run();
    simulation.write_files();
    return status;
  } catch (const graze::Error& error) {
    std::fprintf(stderr, "simulation_loop: %s\n", error.what());
    return 1;
  }
}
