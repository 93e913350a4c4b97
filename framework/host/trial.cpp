// SPDX-License-Identifier: Apache-2.0
#include "host/trial.hpp"

#include <cmath>
#include <utility>

#include "base/hash.hpp"
#include "host/malloc_guard.hpp"
#include "host/tables.hpp"
#include "scene/chain.hpp"
#include "scene/kinematics.hpp"
#include "scene/view.hpp"

namespace swage::host {

namespace {

// N and N m; a thousand times the forces of a hand on a scene
constexpr double kMaxForce = 1e3;
constexpr double kAnyNumber = 1e300;
// the given path: an oscillation of a millimetre, five times a second
constexpr double kAmplitude = 1e-3, kRate = 2 * M_PI * 5;

}  // namespace

Trial::Trial(const Library& library, const PluginInfo& plugin, ParamValues values) {
  world_.random.push_back(0);
  instance_ = Instance::create(plugin, library, "trial", {&world_, nullptr}, 0, 1, error_);
  if (!instance_) return;
  const swage_pose identity{{0, 0, 0}, {1, 0, 0, 0}};
  builder_ = std::make_unique<Builder>(Builder::Owner{plugin.kind, "trial", 0, identity, {}}, world_, script_,
                                       problems_);
  configured_ = instance_->configure(std::move(values), *builder_, error_);
  for (base::Problem& p : instance_->services->take_reports()) problems_.push_back(std::move(p));
  random_start_ = world_.random[0];
  if (!configured_ || !instance_->activate(world_.dt, error_)) return;
  if (plugin.kind == SWAGE_KIND_OBJECT) {
    solver_2_ = find_table<swage_solver_2>(*instance_, SWAGE_EXT_SOLVER_2, false, error_);
    solver_ = find_table<swage_solver>(*instance_, SWAGE_EXT_SOLVER, false, error_);
    object_ = find_table<swage_object>(*instance_, SWAGE_EXT_OBJECT, true, error_);
  }
  if (plugin.kind == SWAGE_KIND_DEVICE) open_device();
  ready_ = error_.empty();
  if (ready_) reset();  // reset comes before the first step, as in the contract
  for (base::Problem& p : instance_->services->take_reports()) problems_.push_back(std::move(p));
}

void Trial::open_device() {
  const auto* device = find_table<swage_device>(*instance_, SWAGE_EXT_DEVICE, true, error_);
  swage_result opened = SWAGE_ERROR;
  if (device == nullptr) return;
  guarded(*instance_, Call::kOpen, 0, [&] {
    opened = device->open(instance_->raw);
    return SWAGE_OK;
  });
  // missing hardware is no fault of the plugin
  if (opened >= 0) device_ = device;
}

Trial::~Trial() {
  if (device_ != nullptr)
    guarded(*instance_, Call::kClose, world_.step, [&] { device_->close(instance_->raw); });
}

template <class F>
bool Trial::call(Call which, F&& f) {
  const uint64_t before = thread_allocations();
  const bool kept = guarded(*instance_, which, world_.step, f);
  allocations_ += thread_allocations() - before;
  return kept;
}

bool Trial::step() {
  const ScopedRole rt(SWAGE_THREAD_RT);
  ++world_.step;
  move();
  return object_ != nullptr ? step_object() : device_ == nullptr || step_device();
}

uint64_t Trial::run(uint64_t n) {
  for (uint64_t i = 0; i < n; ++i)
    if (!step()) return world_.step;
  return 0;
}

// moves the bodies on the given path, whatever the forces
void Trial::move() {
  const double t = world_.time(), s = std::sin(kRate * t), c = std::cos(kRate * t);
  const double offset = kAmplitude * s, speed = kAmplitude * kRate * c;
  for (std::size_t i = 0; i < world_.body.size(); ++i) {
    const int32_t motion = world_.body[i].motion;
    if (motion != SWAGE_MOTION_DYNAMIC && motion != SWAGE_MOTION_FOLLOWS) continue;
    world_.X_WB[i] = world_.body[i].start;
    world_.X_WB[i].p.x += offset;
    world_.V_WB[i] = {{speed, 0, 0}, {0, 0, 0}};
  }
  for (std::size_t i = 0; i < world_.hinge.size(); ++i) {
    const scene::HingeInfo& hinge = world_.hinge[i];
    const double middle = 0.5 * (hinge.min + hinge.max), half = 0.5 * (hinge.max - hinge.min);
    world_.hinge_angle[i] = middle + half * s;
    world_.hinge_rate[i] = half * kRate * c;
    world_.X_WB[hinge.child] =
        scene::hinged(hinge, toolkit::Pose(world_.X_WB[hinge.parent]), world_.hinge_angle[i]).abi();
  }
  for (std::size_t i = 0; i < world_.particle_mass.size(); ++i) world_.particle_v_W[3 * i] = speed;
  world_.F_B_W.assign(world_.F_B_W.size(), {});
  world_.particle_f_W.assign(world_.particle_f_W.size(), 0);
  input_ = {{{offset, 0, 0}, {1, 0, 0, 0}},
            0.5 + 0.5 * s,
            0.3 + 0.3 * s,
            0,
            SWAGE_VALID_POSE | SWAGE_VALID_CLOSURE | SWAGE_VALID_GRIP};
}

bool Trial::step_object() {
  const swage_object_step view = scene::view(world_,
                                             {builder_->body, builder_->particle, builder_->shape,
                                              builder_->hinge, builder_->state, builder_->signal},
                                             &input_);
  const auto sound = [&](Call which, const void* data, std::size_t n, double limit) {
    return accept(*instance_, which, world_.step, static_cast<const double*>(data), n, limit);
  };
  bool good = call(Call::kForces, [&] { return object_->forces(instance_->raw, &view); }) &&
              sound(Call::kForces, view.F_B_W, 6 * view.n_body, kMaxForce) &&
              sound(Call::kForces, view.particle_f_W, 3 * view.n_particle, kMaxForce) &&
              sound(Call::kForces, view.drive, 4 * view.n_hinge, kAnyNumber);
  const auto advance = solver_2_ != nullptr ? solver_2_->advance : solver_ != nullptr ? solver_->advance : nullptr;
  chain_before_ = world_.plugin_state;
  if (advance != nullptr)
    good = call(Call::kAdvance, [&] { return advance(instance_->raw, &view); }) &&
           sound(Call::kAdvance, view.X_WB, 7 * view.n_body, kAnyNumber) &&
           sound(Call::kAdvance, view.V_WB, 6 * view.n_body, kAnyNumber) && good;
  return call(Call::kFinish, [&] { return object_->finish(instance_->raw, &view); }) &&
         sound(Call::kFinish, view.signal, view.n_signal, kAnyNumber) &&
         sound(Call::kFinish, view.state, view.n_state, kAnyNumber) && good;
}

std::string Trial::chain_fault() const {
  for (const scene::ChainInfo& info : world_.chain) {
    const scene::ChainView now(world_, info), before(chain_before_.data(), info);
    for (uint32_t i = 0; i < now.vertices(); ++i) {
      const std::string vertex = "vertex " + std::to_string(i) + " of a chain";
      if (i > 0 && !(now.s(i) > now.s(i - 1))) return vertex + " has an arc length that does not rise.";
      if (!(now.radius(i) >= 0)) return vertex + " begins a piece with a radius below 0.";
      // a vertex moved along the material, or rotated further than its velocity predicts, differs by a share of its displacement
      const toolkit::Vec3 way = now.p(i) - before.p(i), led = world_.dt * now.v(i);
      if (now.s(i) == before.s(i) && (way - led).norm() > 1e-3 * way.norm() + 1e-9 * world_.length)
        return vertex + " is not where its velocity leads.";
    }
  }
  return "";
}

bool Trial::step_device() {
  const bool lockstep = (device_->flags & SWAGE_DEVICE_LOCKSTEP) != 0;
  const ScopedRole role(lockstep ? SWAGE_THREAD_RT : SWAGE_THREAD_IO);
  swage_command command{};
  command.time_s = world_.time();
  command.anchor.q = {1, 0, 0, 0};
  if (!call(Call::kExchange, [&] { return device_->exchange(instance_->raw, &command, &sample_); }))
    return false;
  const double* pose = &sample_.pose.p.x;
  return (sample_.valid & SWAGE_VALID_POSE) == 0 ||
         accept(*instance_, Call::kExchange, world_.step, pose, 7, kAnyNumber);
}

void Trial::reset() {
  const ScopedRole rt(SWAGE_THREAD_RT);
  world_.step = 0;
  world_.random[0] = random_start_;
  for (std::size_t i = 0; i < world_.body.size(); ++i) world_.X_WB[i] = world_.body[i].start;
  world_.V_WB.assign(world_.V_WB.size(), {});
  world_.plugin_state.assign(world_.plugin_state.size(), 0);
  world_.signal.assign(world_.signal.size(), 0);
  for (const scene::Shape& shape : world_.shape)
    if (shape.kind == SWAGE_SHAPE_CHAIN) scene::place_chain(world_, shape);
  if (object_ == nullptr) return;
  const swage_object_step view = scene::view(world_,
                                             {builder_->body, builder_->particle, builder_->shape,
                                              builder_->hinge, builder_->state, builder_->signal},
                                             &input_);
  call(Call::kReset, [&] { object_->reset(instance_->raw, &view); });
}

uint64_t Trial::hash() const {
  base::Hash h;
  const auto add = [&h](const auto& list) { h.add(list.data(), list.size() * sizeof(list[0])); };
  add(world_.X_WB);
  add(world_.V_WB);
  add(world_.F_B_W);
  add(world_.particle_f_W);
  add(world_.drive);
  add(world_.plugin_state);
  add(world_.signal);
  add(world_.random);
  if (device_ != nullptr)
    h.add(&sample_.pose, sizeof sample_.pose).add(sample_.closure).add(sample_.grip_force);
  return h.value();
}

}  // namespace swage::host
