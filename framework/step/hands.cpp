// SPDX-License-Identifier: Apache-2.0
#include "step/hands.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/guard.hpp"
#include "scene/kinematics.hpp"
#include "step/limits.hpp"
#include "step/reaction.hpp"
#include "toolkit/math.hpp"
#include "toolkit/mirror.hpp"

namespace swage::step {

using toolkit::Pose;
using toolkit::Quat;
using toolkit::Vec3;

namespace {

constexpr uint32_t kHasPose = SWAGE_VALID_POSE;
constexpr uint32_t kHeld = SWAGE_VALID_POSE | SWAGE_VALID_CLOSURE | SWAGE_VALID_GRIP;
// s without a valid value after which a hand is matched again as after a clutch. Shorter gaps are drop-outs of a bus, in which a hand
// moves less than its tremor
constexpr double kLost = 0.1;
// difference of closure at which a returning hand has met the held closure
constexpr double kMet = 0.02;
// s, time constant by which the offset of a device in world coordinates fades
constexpr double kFade = 0.25;

// the nearest unit quaternion, or false when there is none
bool normalise(swage_quat& q) {
  const double n2 = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  if (!(n2 > 0.25 && n2 < 4)) return false;
  const double k = 1 / std::sqrt(n2);
  q = {k * q.w, k * q.x, k * q.y, k * q.z};
  return true;
}

// shortens a vector to `longest`
Vec3 limited(const Vec3& a, double longest) {
  const double length = std::sqrt(a.x() * a.x() + a.y() * a.y() + a.z() * a.z());
  return length > longest ? Vec3(a * (longest / length)) : a;
}

// pointer and keys, mirrored for the other hand (abi/device.h)
swage_pointer other_hand(const swage_pointer& p) {
  constexpr std::pair<uint32_t, uint32_t> kPairs[] = {
      {0, 3}, {25, 23}, {36, 37}, {44, 45}};  // A-D, Z-X, left-right, pgup-pgdn
  swage_pointer out = p;
  out.dx = -p.dx;
  out.camera = toolkit::mirrored_view(p.camera);
  for (const auto& [a, b] : kPairs) {
    const uint64_t differ = (p.keys >> a ^ p.keys >> b) & 1;
    out.keys ^= differ << a | differ << b;
  }
  return out;
}

}  // namespace

Hands::Hands(host::Rig& rig, std::vector<DevicePort*> ports)
    : rig_(rig), stops_(rig), port_(std::move(ports)) {
  const std::size_t devices = rig.devices.size();
  port_.resize(devices, nullptr);
  for (std::size_t i = 0; i < devices; ++i) {
    if (port_[i]) continue;
    own_.push_back(std::make_unique<LockstepPort>(rig.devices[i]));
    port_[i] = own_.back().get();
  }
  sample_.resize(devices);
  X_WD_.resize(devices);
  seen_.resize(devices);
  hold_.resize(devices);
  const auto shaped = [](const host::DeviceSlot& slot) { return slot.filters.shape(); };
  if (std::any_of(rig.devices.begin(), rig.devices.end(), shaped)) filter_.resize(devices);
  input_.resize(rig.objects.size());
  for (const scene::BodyInfo& body : rig.world.body) {
    const Pose X_WO = body.object < rig.objects.size() ? Pose(rig.objects[body.object].X_WO) : Pose();
    X_OB_.push_back((X_WO.inverse() * Pose(body.start)).abi());
  }
  reset();
}

void Hands::reset() noexcept {
  std::fill(sample_.begin(), sample_.end(), swage_sample{});
  for (swage_sample& s : sample_) s.pose.q.w = 1;
  std::fill(seen_.begin(), seen_.end(), uint8_t{0});
  std::fill(hold_.begin(), hold_.end(), Hold{});
  std::fill(filter_.begin(), filter_.end(), FilterMemory{});
  for (uint32_t i = 0; i < X_WD_.size(); ++i) X_WD_[i] = rig_.devices[i].X_WD0;
  for (uint32_t i = 0; i < input_.size(); ++i) {
    input_[i] = {};
    input_[i].X_WD = rig_.objects[i].X_WO;
  }
}

const swage_input* Hands::input(uint32_t object) const noexcept {
  const host::Follow& follow = rig_.objects[object].follow;
  return follow.pose_device == host::kNone && follow.closure_device == host::kNone ? nullptr
                                                                                   : &input_[object];
}

std::size_t Hands::image_size() const {
  scene::Writer count;
  save(count);
  return count.size();
}

void Hands::save(scene::Writer& out) const noexcept {
  out.put(sample_);
  out.put(X_WD_);
  out.put(input_);
  for (const uint8_t seen : seen_) out.put(uint64_t{seen});
  out.put(hold_);
  if (!filter_.empty()) out.put(filter_);
}

bool Hands::restore(scene::Reader& in) noexcept {
  in.get(sample_);
  in.get(X_WD_);
  in.get(input_);
  for (uint8_t& seen : seen_) {
    uint64_t word = 0;
    in.get(word);
    seen = static_cast<uint8_t>(word);
  }
  in.get(hold_);
  if (!filter_.empty()) in.get(filter_);
  return in.ok();
}

bool Hands::usable(uint32_t device) const noexcept {
  return rig_.devices[device].instance->quarantined.load(std::memory_order_relaxed) == 0;
}

bool Hands::gone() const noexcept {
  bool left = false;
  for (uint32_t i = 0; i < sample_.size(); ++i)
    left |= usable(i) && (sample_[i].valid & SWAGE_VALID_DONE) == 0;
  return !sample_.empty() && !left;
}

bool Hands::see() const noexcept {
  return std::any_of(rig_.devices.begin(), rig_.devices.end(),
                     [](const host::DeviceSlot& slot) { return slot.sight != nullptr; });
}

void Hands::look(const swage_sight& sight, WriteGuard& writes) noexcept {
  for (uint32_t i = 0; i < port_.size(); ++i) {
    if (rig_.devices[i].sight == nullptr || !usable(i)) continue;
    port_[i]->look(rig_.world.step, sight);
    writes.check(*rig_.devices[i].instance, host::Call::kExchange);
  }
}

void Hands::point(const swage_pointer& pointer) noexcept {
  rig_.attempt.pointer = rig_.mirror ? other_hand(pointer) : pointer;
}

void Hands::read(WriteGuard& writes) noexcept {
  scene::World& world = rig_.world;
  for (uint32_t i = 0; i < sample_.size(); ++i) {
    if (!usable(i)) continue;
    const swage_sample last = sample_[i];
    port_[i]->read(world.step, world.time(), sample_[i]);
    // the device must not have written into the scene that it was shown
    if (rig_.devices[i].sight != nullptr) writes.check(*rig_.devices[i].instance, host::Call::kExchange);

    // a number that is not finite is a fault of the device and does not reach the scene
    host::Instance& instance = *rig_.devices[i].instance;
    const double* numbers = &sample_[i].time_s;
    constexpr std::size_t kNumbers = 1 + 7 + 6 + 2;
    static_assert(offsetof(swage_sample, buttons) == offsetof(swage_sample, time_s) + 8 * kNumbers);
    const bool good =
        host::accept(instance, host::Call::kExchange, world.step, numbers, kNumbers, kAnyNumber);
    if (!good || !usable(i)) {
      sample_[i] = last;
      sample_[i].valid = 0;
      continue;
    }
    place(i);
    hold_closure(i);
  }
  for (uint32_t i = 0; i < input_.size(); ++i) map_input(i);
}

// hand space to scene: scaled down and rotated, unless the device already gives world coordinates
void Hands::place(uint32_t device) noexcept {
  const host::DeviceSlot& slot = rig_.devices[device];
  const swage_sample& sample = sample_[device];
  swage_pose pose = sample.pose;
  if (!(sample.valid & kHasPose) || !normalise(pose.q)) {
    ++hold_[device].pose_gone;
    return;
  }
  // a clutched tool stays, and its hand is matched again however short the clutch was
  if (clutched(device)) {
    hold_[device].pose_gone = std::max(hold_[device].pose_gone + 1, static_cast<uint64_t>(std::ceil(kLost / rig_.world.dt)));
    return;
  }
  if (slot.filters.shape()) pose = filtered(slot.filters, filter_[device], pose, returns(device), rig_.world.dt);
  if (!(slot.device->flags & SWAGE_DEVICE_WORLD)) {
    const double k = 1 / slot.motion_scale;
    const Pose X_WD0(slot.X_WD0), X_D0H(Vec3(k * toolkit::vec(pose.p)), toolkit::quat(pose.q));
    pose = (X_WD0 * X_D0H).abi();
    if (rig_.mirror) pose = toolkit::mirrored(pose);
  }
  meet_pose(device, pose);
  X_WD_[device] = pose;
  seen_[device] = 1;
}

// A pedal without valid values keeps its last state, as every lost hand does.
bool Hands::clutched(uint32_t device) const noexcept {
  const host::HandFilters& filters = rig_.devices[device].filters;
  const bool pedal = filters.clutch_device < sample_.size();
  const swage_sample& sample = sample_[pedal ? filters.clutch_device : device];
  const bool said = (sample.valid & SWAGE_VALID_BUTTONS) != 0 || (pedal && sample.valid == 0);
  return said && (sample.buttons & filters.clutch) != 0;
}

bool Hands::returns(uint32_t device) const noexcept {
  return seen_[device] && static_cast<double>(hold_[device].pose_gone) * rig_.world.dt >= kLost;
}

// A hand that returns after it was lost continues from the pose of its tool: the offset between both is kept or, for a device in
// world coordinates, faded out.
void Hands::meet_pose(uint32_t device, swage_pose& X_WD) noexcept {
  Hold& hold = hold_[device];
  const bool again = returns(device);
  hold.pose_gone = 0;
  if (again) {
    const Pose was(X_WD_[device]), now(X_WD);
    hold.p = toolkit::raw(Vec3(was.p - now.p));
    hold.q = toolkit::raw(Quat(now.q.conjugate() * was.q));
    hold.clutched = 1;
  }
  if (!hold.clutched) return;
  X_WD.p = toolkit::raw(Vec3(toolkit::vec(X_WD.p) + toolkit::vec(hold.p)));
  X_WD.q = toolkit::raw(Quat((toolkit::quat(X_WD.q) * toolkit::quat(hold.q)).normalized()));
  if (!(rig_.devices[device].device->flags & SWAGE_DEVICE_WORLD)) return;
  const double rest = std::max(0.0, 1 - rig_.world.dt / kFade);
  const Vec3 p = rest * toolkit::vec(hold.p), turn = rest * toolkit::log_rotation(toolkit::quat(hold.q));
  hold.p = toolkit::raw(p);
  hold.q = toolkit::raw(Quat(toolkit::exp_rotation(turn)));
  hold.clutched = p.norm() > 1e-6 * rig_.world.length || turn.norm() > 1e-6;
}

// Closure and grip are held while nothing valid comes. A hand that returns with another closure takes over the jaws
// where both are equal.
void Hands::hold_closure(uint32_t device) noexcept {
  const swage_sample& sample = sample_[device];
  Hold& hold = hold_[device];
  hold.known |= sample.valid & kHeld;
  if (!(sample.valid & SWAGE_VALID_CLOSURE)) {
    hold.closure_gone += (hold.known & SWAGE_VALID_CLOSURE) != 0;
    if (sample.valid & SWAGE_VALID_GRIP) hold.grip = sample.grip_force;
    return;
  }
  const double closure = std::clamp(sample.closure, 0.0, 1.0);
  if (static_cast<double>(hold.closure_gone) * rig_.world.dt >= kLost) hold.meeting = closure < hold.closure ? 1 : 2;
  hold.closure_gone = 0;
  const double off = closure - hold.closure;
  if (std::abs(off) <= kMet || (hold.meeting == 1 ? off > 0 : off < 0)) hold.meeting = 0;
  if (hold.meeting != 0) return;
  hold.closure = closure;
  if (sample.valid & SWAGE_VALID_GRIP) hold.grip = sample.grip_force;
}

void Hands::map_input(uint32_t object) noexcept {
  const host::Follow& follow = rig_.objects[object].follow;
  swage_input& in = input_[object];
  in.valid = 0;
  if (follow.pose_device != host::kNone && seen_[follow.pose_device]) {
    const swage_sample& s = sample_[follow.pose_device];
    in.X_WD = X_WD_[follow.pose_device];
    in.buttons = s.buttons;
    in.valid |= SWAGE_VALID_POSE | (s.valid & SWAGE_VALID_BUTTONS);
  }
  if (follow.closure_device != host::kNone) {
    const Hold& hold = hold_[follow.closure_device];
    if (hold.known & SWAGE_VALID_CLOSURE) in.closure = hold.closure;
    if (hold.known & SWAGE_VALID_GRIP) in.grip_force = hold.grip;
    in.valid |= static_cast<uint32_t>(hold.known) & (SWAGE_VALID_CLOSURE | SWAGE_VALID_GRIP);
  }
}

void Hands::follow() noexcept {
  for (uint32_t i = 0; i < input_.size(); ++i) lead(i);
}

// Moves the tool towards its hand, never faster than the limits nor through a fixed solid, and gives its bodies the twist that
// leads there: whatever the device does, contacts see a motion and not a jump.
void Hands::lead(uint32_t object) noexcept {
  const host::ObjectSlot& slot = rig_.objects[object];
  scene::World& world = rig_.world;
  const uint32_t device = slot.follow.pose_device;
  const bool led =
      device != host::kNone && seen_[device] && !slot.instance->quarantined.load(std::memory_order_relaxed);

  bool moved = false;
  Pose X_WT;  // the tool's own frame after this step
  for (uint32_t b = slot.body.first; b < slot.body.first + slot.body.count; ++b) {
    if (world.body[b].motion != SWAGE_MOTION_FOLLOWS) continue;
    const Pose X_OB(X_OB_[b]);
    if (!led) {
      world.V_WB[b] = {};
      continue;
    }
    if (!moved) {
      // where the tool is, from its first body; where the hand wants it
      const Pose X_WT0 = Pose(world.X_WB[b]) * X_OB.inverse(), X_WD(X_WD_[device]);
      const Vec3 away = X_WD.p - X_WT0.p;
      const Vec3 turn = toolkit::log_rotation(X_WD.q * X_WT0.q.conjugate());
      const Vec3 step_p = limited(away, kMaxToolSpeed * world.length * world.dt);
      const Vec3 step_q = limited(turn, kMaxToolTurn * world.dt);
      const bool arrives = step_p == away && step_q == turn;
      X_WT = arrives ? X_WD : Pose(X_WT0.p + step_p, (toolkit::exp_rotation(step_q) * X_WT0.q).normalized());
      X_WT = stops_.rest(object, X_WT0, X_WT);
      moved = true;
    }
    scene::follow(world, b, X_WT * X_OB);
  }
}

void Hands::send(const contact::ContactSet& contacts) noexcept {
  for (uint32_t d = 0; d < port_.size(); ++d) {
    if (!(rig_.devices[d].device->flags & SWAGE_DEVICE_FORCE)) continue;
    port_[d]->send(to_hand(d, felt(d, contacts)));
  }
}

// the sum of the contact forces on the tool of a device, about the tool's origin
Hands::Felt Hands::felt(uint32_t device, const contact::ContactSet& contacts) const noexcept {
  const scene::World& world = rig_.world;
  const auto led = [&](uint32_t body) {
    const uint32_t object = world.body[body].object;
    return object < rig_.objects.size() && rig_.objects[object].follow.pose_device == device;
  };
  Felt out;
  out.X_WT = Pose(X_WD_[device]);
  for (uint32_t b = 0; b < world.body.size(); ++b) {
    if (world.body[b].motion != SWAGE_MOTION_FOLLOWS || !led(b)) continue;
    out.X_WT = Pose(world.X_WB[b]) * Pose(X_OB_[b]).inverse();
    out.V_WT = world.V_WB[b];
    if (seen_[device]) out.behind_W = out.X_WT.p - toolkit::vec(X_WD_[device].p);
    break;
  }
  for (const contact::Contact& c : contacts.contact) {
    const double sign = (led(c.body_a) ? 1.0 : 0.0) - (led(c.body_b) ? 1.0 : 0.0);
    out.f_W += sign * c.f_a_W;
    out.t_W += sign * (c.p_W - out.X_WT.p).cross(c.f_a_W);
  }
  return out;
}

Hands::Felt Hands::mirrored(const Felt& tool) noexcept {
  using toolkit::raw, toolkit::vec;
  Felt out;
  out.X_WT = Pose(toolkit::mirrored(tool.X_WT.abi()));
  out.V_WT = {toolkit::mirrored(tool.V_WT.v), toolkit::mirrored_axial(tool.V_WT.w)};
  out.behind_W = vec(toolkit::mirrored(raw(tool.behind_W)));
  out.f_W = vec(toolkit::mirrored(raw(tool.f_W)));
  out.t_W = vec(toolkit::mirrored_axial(raw(tool.t_W)));
  return out;
}

// into hand space: forces by the force scale, movements by the motion scale
ToolForce Hands::to_hand(uint32_t device, const Felt& tool) const noexcept {
  const host::DeviceSlot& slot = rig_.devices[device];
  const bool in_world = (slot.device->flags & SWAGE_DEVICE_WORLD) != 0;
  const Felt felt = rig_.mirror && !in_world ? mirrored(tool) : tool;
  const Quat q_D0W = in_world ? Quat::Identity() : toolkit::quat(slot.X_WD0.q).conjugate();
  const double s = in_world ? 1 : slot.motion_scale;
  const double f = felt.f_W.norm();
  const double k = slot.force_scale * (f > 0 ? felt_force(slot.reaction, f) / f : 1);
  ToolForce out;
  out.step = rig_.world.step;
  out.time_s = rig_.world.time();
  out.force = toolkit::raw(Vec3(q_D0W * (k * felt.f_W)));
  out.torque = toolkit::raw(Vec3(q_D0W * (k * s * felt.t_W)));
  // from the pose of the device: clutch, filters and the offset of a matched hand are between it and the scene
  out.anchor = {toolkit::raw(Vec3(toolkit::vec(sample_[device].pose.p) + q_D0W * (s * felt.behind_W))),
                toolkit::raw(Quat(q_D0W * felt.X_WT.q))};
  out.anchor_twist = {toolkit::raw(Vec3(q_D0W * (s * toolkit::vec(felt.V_WT.v)))),
                      toolkit::raw(Vec3(q_D0W * toolkit::vec(felt.V_WT.w)))};
  out.stiffness = slot.coupling.stiffness;
  out.damping = slot.coupling.damping;
  return out;
}

}  // namespace swage::step
