// SPDX-License-Identifier: Apache-2.0
#include "runtime.hpp"

#include <algorithm>
#include <cmath>

#include "sentences.hpp"

namespace swage::openxr {
namespace {

constexpr XrSpaceLocationFlags kTracked = XR_SPACE_LOCATION_POSITION_VALID_BIT | XR_SPACE_LOCATION_ORIENTATION_VALID_BIT |
                                          XR_SPACE_LOCATION_POSITION_TRACKED_BIT | XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT;
constexpr XrSpaceVelocityFlags kMoving = XR_SPACE_VELOCITY_LINEAR_VALID_BIT | XR_SPACE_VELOCITY_ANGULAR_VALID_BIT;
constexpr double kFarthest = 100;  // m; a position farther away is not valid
constexpr int kMostEvents = 64;    // per read: a broken runtime may send an endless series

Vec3 vec(const XrVector3f& v) { return {v.x, v.y, v.z}; }

}  // namespace

std::shared_ptr<Runtime> Runtime::share(std::string& why) {
  static std::mutex lock;
  static std::weak_ptr<Runtime> shared;
  const std::lock_guard<std::mutex> guard(lock);
  if (auto there = shared.lock()) {
    const std::lock_guard<std::mutex> its(there->lock_);
    if (!there->lost_) return there;
    why = say::kEnded();
    return nullptr;  // until its last owner releases it
  }
  std::shared_ptr<Runtime> made(new Runtime);
  if (!made->connect(why)) return nullptr;
  shared = made;
  return made;
}

Runtime::~Runtime() {
  if (session_ != XR_NULL_HANDLE) xr_.DestroySession(session_);
  if (instance_ != XR_NULL_HANDLE) xr_.DestroyInstance(instance_);
}

bool Runtime::connect(std::string& why) {
  if (!make_instance(xr_, instance_, why)) return false;
  XrInstanceProperties properties{};
  properties.type = XR_TYPE_INSTANCE_PROPERTIES;
  if (xr_.GetInstanceProperties(instance_, &properties) == XR_SUCCESS) name_ = properties.runtimeName;
  XrSystemGetInfo wanted{};
  wanted.type = XR_TYPE_SYSTEM_GET_INFO;
  wanted.formFactor = XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
  XrSystemId system = XR_NULL_SYSTEM_ID;
  if (const XrResult result = xr_.GetSystem(instance_, &wanted, &system); result != XR_SUCCESS) {
    why = say::kNoHeadset(name_, static_cast<int>(result));
    return false;
  }
  XrSessionCreateInfo session{};
  session.type = XR_TYPE_SESSION_CREATE_INFO;
  session.systemId = system;
  XrReferenceSpaceCreateInfo space{};
  space.type = XR_TYPE_REFERENCE_SPACE_CREATE_INFO;
  space.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_LOCAL;
  space.poseInReferenceSpace.orientation.w = 1;
  XrResult result = xr_.CreateSession(instance_, &session, &session_);
  if (result == XR_SUCCESS) result = xr_.CreateReferenceSpace(session_, &space, &local_);
  if (result == XR_SUCCESS) result = make_actions(xr_, instance_, session_, actions_);
  if (result == XR_SUCCESS) return true;
  why = say::kNoSession(name_, static_cast<int>(result));
  return false;
}

// True on success; errors after which the connection is lost set lost_.
bool Runtime::good(XrResult result) {
  lost_ |= result == XR_ERROR_INSTANCE_LOST || result == XR_ERROR_SESSION_LOST || result == XR_ERROR_RUNTIME_FAILURE ||
           result == XR_ERROR_RUNTIME_UNAVAILABLE || result == XR_ERROR_HANDLE_INVALID;
  return result == XR_SUCCESS;
}

void Runtime::hear_events() {
  for (int i = 0; i < kMostEvents && !lost_; ++i) {
    XrEventDataBuffer event{};
    event.type = XR_TYPE_EVENT_DATA_BUFFER;
    if (!good(xr_.PollEvent(instance_, &event))) return;
    if (event.type == XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING) lost_ = true;
    if (event.type != XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED) continue;
    const auto& changed = reinterpret_cast<const XrEventDataSessionStateChanged&>(event);
    if (changed.session != session_) continue;
    if (changed.state == XR_SESSION_STATE_READY) {
      XrSessionBeginInfo begin{};
      begin.type = XR_TYPE_SESSION_BEGIN_INFO;
      begin.primaryViewConfigurationType = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;  // ignored in a session without images
      running_ = good(xr_.BeginSession(session_, &begin));
    } else if (changed.state == XR_SESSION_STATE_STOPPING) {
      running_ = false;
      good(xr_.EndSession(session_));
    } else if (changed.state == XR_SESSION_STATE_EXITING || changed.state == XR_SESSION_STATE_LOSS_PENDING) {
      lost_ = true;
    }
  }
}

bool Runtime::read(int side, Controller& out) {
  const std::lock_guard<std::mutex> guard(lock_);
  out = {};
  if (!lost_) hear_events();
  if (lost_) return false;
  if (!running_) return true;
  const XrActiveActionSet active{actions_.set, XR_NULL_PATH};
  XrActionsSyncInfo sync{};
  sync.type = XR_TYPE_ACTIONS_SYNC_INFO;
  sync.countActiveActionSets = 1;
  sync.activeActionSets = &active;
  // a session without focus has no input: nothing is tracked then
  if (good(xr_.SyncActions(session_, &sync))) read_controller(side, out);
  return !lost_;
}

void Runtime::read_controller(int side, Controller& out) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  XrTime time = 0;
  if (!good(xr_.ConvertTimespecTimeToTimeKHR(instance_, &now, &time))) return;
  XrSpaceVelocity velocity{};
  velocity.type = XR_TYPE_SPACE_VELOCITY;
  XrSpaceLocation place{};
  place.type = XR_TYPE_SPACE_LOCATION;
  place.next = &velocity;
  if (!good(xr_.LocateSpace(actions_.space[side], local_, time, &place))) return;
  const auto& q = place.pose.orientation;
  const Quat direction(q.w, q.x, q.y, q.z);
  const Vec3 p = vec(place.pose.position);
  out.time_s = static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  out.tracked = (place.locationFlags & kTracked) == kTracked && p.norm() < kFarthest && std::abs(direction.norm() - 1) < 0.1;
  if (!out.tracked) return;
  out.X_DA = Pose(p, direction.normalized());
  out.v_D = vec(velocity.linearVelocity), out.w_D = vec(velocity.angularVelocity);
  out.moving = (velocity.velocityFlags & kMoving) == kMoving && out.v_D.allFinite() && out.w_D.allFinite();

  XrActionStateGetInfo which{};
  which.type = XR_TYPE_ACTION_STATE_GET_INFO;
  which.action = actions_.trigger;
  which.subactionPath = actions_.side[side];
  XrActionStateFloat trigger{};
  trigger.type = XR_TYPE_ACTION_STATE_FLOAT;
  if (good(xr_.GetActionStateFloat(session_, &which, &trigger)) && trigger.isActive == XR_TRUE && std::isfinite(trigger.currentState))
    out.trigger = std::clamp(static_cast<double>(trigger.currentState), 0.0, 1.0);
  out.buttons = buttons(side);
}

uint32_t Runtime::buttons(int side) {
  uint32_t out = 0;
  for (uint32_t b = 0; b < kButtons; ++b) {
    XrActionStateGetInfo which{};
    which.type = XR_TYPE_ACTION_STATE_GET_INFO;
    which.action = actions_.button[b];
    which.subactionPath = actions_.side[side];
    XrActionStateBoolean state{};
    state.type = XR_TYPE_ACTION_STATE_BOOLEAN;
    if (good(xr_.GetActionStateBoolean(session_, &which, &state)) && state.isActive == XR_TRUE && state.currentState == XR_TRUE) out |= 1u << b;
  }
  return out;
}

}  // namespace swage::openxr
