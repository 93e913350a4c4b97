// SPDX-License-Identifier: Apache-2.0
//
// An OpenXR runtime without a headset, that the system's loader loads and that checks its caller: order of the life cycle, handles,
// attached actions. fake_* is for the test.
#include <time.h>

#define XR_USE_TIMESPEC
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

#include <cstring>
#include <deque>
#include <map>
#include <mutex>
#include <string>

namespace {

// the loader's side of the boundary between loader and runtime (OpenXR loader specification, "Runtime interface negotiation")
struct LoaderInfo {
  int type;
  uint32_t version;
  size_t size;
  uint32_t least_interface, most_interface;
  XrVersion least_api, most_api;
};
struct RuntimeRequest {
  int type;
  uint32_t version;
  size_t size;
  uint32_t interface_version;
  XrVersion api;
  PFN_xrGetInstanceProcAddr get;
};

struct Hand {
  double p[3] = {0, 0, 0}, q[4] = {1, 0, 0, 0}, v[3] = {0, 0, 0};
  XrSpaceLocationFlags flags = 15;  // valid and tracked
  float trigger = 0;
  uint32_t buttons = 0;
};

struct Fake {
  std::recursive_mutex lock;
  std::string wrong;
  std::deque<XrSessionState> states;
  std::map<std::string, XrPath> paths;
  std::map<XrAction, std::string> actions;
  std::string without;  // an extension that it has not got
  Hand hand[2];
  bool plugged = true, headset = true, instance = false, session = false, running = false, attached = false, focused = true, knows_touch = true;
  bool instance_loss = false;
  int bindings = 0, instances = 0, syncs = 0;
  uint64_t next = 100;
};
Fake& fake() {
  static Fake f;
  return f;
}
using Guard = std::lock_guard<std::recursive_mutex>;

void blame(const std::string& what) {
  if (fake().wrong.find(what) == std::string::npos) fake().wrong += what + "; ";
}
template <class Handle>
Handle made() {
  return reinterpret_cast<Handle>(++fake().next);
}
// what every call of a runtime that has gone says
#define THERE(needed, text)                                   \
  const Guard guard(fake().lock);                             \
  if (!fake().plugged) return XR_ERROR_INSTANCE_LOST;         \
  if (!(needed)) return blame(text), XR_ERROR_VALIDATION_FAILURE

XrResult enumerate(const char*, uint32_t room, uint32_t* n, XrExtensionProperties* out) {
  const Guard guard(fake().lock);
  const char* const all[] = {XR_MND_HEADLESS_EXTENSION_NAME, XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME, "XR_EXT_hand_tracking"};
  uint32_t count = 0;
  for (const char* name : all) {
    if (fake().without == name) continue;
    if (room > count && out != nullptr) std::strcpy(out[count].extensionName, name);
    ++count;
  }
  *n = count;
  return XR_SUCCESS;
}

XrResult create_instance(const XrInstanceCreateInfo* info, XrInstance* out) {
  const Guard guard(fake().lock);
  if (!fake().plugged) return XR_ERROR_RUNTIME_UNAVAILABLE;
  if (fake().instance) return blame("two instances in one process"), XR_ERROR_LIMIT_REACHED;
  if (info->enabledExtensionCount != 2) blame("an instance without the extensions");
  fake().instance = true;
  ++fake().instances;
  *out = made<XrInstance>();
  return XR_SUCCESS;
}
XrResult destroy_instance(XrInstance) {
  const Guard guard(fake().lock);
  if (fake().session) blame("an instance destroyed before its session");
  fake().instance = fake().session = fake().running = fake().attached = false;
  fake().states.clear();
  return XR_SUCCESS;
}
XrResult properties(XrInstance, XrInstanceProperties* out) {
  std::strcpy(out->runtimeName, "Fake runtime");
  return XR_SUCCESS;
}
XrResult system_of(XrInstance, const XrSystemGetInfo*, XrSystemId* out) {
  THERE(true, "");
  *out = 1;
  return fake().headset ? XR_SUCCESS : XR_ERROR_FORM_FACTOR_UNAVAILABLE;
}
XrResult create_session(XrInstance, const XrSessionCreateInfo* info, XrSession* out) {
  THERE(info->next == nullptr && info->systemId == 1, "a session with pictures, or of no system");
  fake().session = true;
  fake().states = {XR_SESSION_STATE_IDLE, XR_SESSION_STATE_READY};
  *out = made<XrSession>();
  return XR_SUCCESS;
}
XrResult destroy_session(XrSession) {
  const Guard guard(fake().lock);
  fake().session = fake().running = false;
  return XR_SUCCESS;
}
XrResult begin(XrSession, const XrSessionBeginInfo*) {
  THERE(!fake().running, "begun twice");
  fake().running = true;
  for (const auto s : {XR_SESSION_STATE_SYNCHRONIZED, XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_FOCUSED}) fake().states.push_back(s);
  return XR_SUCCESS;
}
XrResult end(XrSession) {
  THERE(fake().running, "ended before it began");
  fake().running = false;
  fake().states.push_back(XR_SESSION_STATE_IDLE);
  return XR_SUCCESS;
}
XrResult poll(XrInstance, XrEventDataBuffer* out) {
  THERE(fake().instance, "events of no instance");
  if (fake().instance_loss) {
    out->type = XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING;
    fake().instance_loss = false;
    return XR_SUCCESS;
  }
  if (fake().states.empty()) return XR_EVENT_UNAVAILABLE;
  auto& event = reinterpret_cast<XrEventDataSessionStateChanged&>(*out);
  event.type = XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED;
  event.session = reinterpret_cast<XrSession>(fake().next);  // replaced by the session's own below
  event.state = fake().states.front();
  fake().states.pop_front();
  return XR_SUCCESS;
}

XrResult path(XrInstance, const char* text, XrPath* out) {
  const Guard guard(fake().lock);
  *out = fake().paths.try_emplace(text, fake().paths.size() + 1).first->second;
  return XR_SUCCESS;
}
XrResult action_set(XrInstance, const XrActionSetCreateInfo*, XrActionSet* out) {
  THERE(true, "");
  *out = made<XrActionSet>();
  return XR_SUCCESS;
}
XrResult action(XrActionSet, const XrActionCreateInfo* info, XrAction* out) {
  THERE(info->countSubactionPaths == 2, "an action that does not tell the hands apart");
  *out = made<XrAction>();
  fake().actions[*out] = info->actionName;
  return XR_SUCCESS;
}
XrResult suggest(XrInstance, const XrInteractionProfileSuggestedBinding* info) {
  THERE(!fake().attached, "bindings after attaching");
  const auto touch = fake().paths.find("/interaction_profiles/oculus/touch_controller");
  if (!fake().knows_touch && touch != fake().paths.end() && info->interactionProfile == touch->second) return XR_ERROR_PATH_UNSUPPORTED;
  fake().bindings += static_cast<int>(info->countSuggestedBindings);
  return XR_SUCCESS;
}
XrResult attach(XrSession, const XrSessionActionSetsAttachInfo* info) {
  THERE(!fake().attached && info->countActionSets == 1, "attached twice");
  fake().attached = true;
  return XR_SUCCESS;
}
// the handle of a hand's space is that of the hand: 1, 2; the reference's is 9
XrResult action_space(XrSession, const XrActionSpaceCreateInfo* info, XrSpace* out) {
  THERE(fake().actions[info->action] == "tool", "a space of an action without a pose");
  *out = reinterpret_cast<XrSpace>(uint64_t{info->subactionPath == fake().paths["/user/hand/left"] ? 1u : 2u});
  return XR_SUCCESS;
}
XrResult reference(XrSession, const XrReferenceSpaceCreateInfo* info, XrSpace* out) {
  THERE(info->referenceSpaceType == XR_REFERENCE_SPACE_TYPE_LOCAL, "another reference");
  *out = reinterpret_cast<XrSpace>(uint64_t{9});
  return XR_SUCCESS;
}
XrResult sync(XrSession, const XrActionsSyncInfo*) {
  THERE(fake().running && fake().attached, "actions asked of a session that does not run");
  ++fake().syncs;
  return fake().focused ? XR_SUCCESS : XR_SESSION_NOT_FOCUSED;
}
XrResult convert(XrInstance, const timespec* t, XrTime* out) {
  *out = int64_t{t->tv_sec} * 1'000'000'000 + t->tv_nsec;
  return XR_SUCCESS;
}
XrResult locate(XrSpace space, XrSpace base, XrTime time, XrSpaceLocation* out) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  XrTime is = 0;
  convert(XR_NULL_HANDLE, &now, &is);
  THERE(reinterpret_cast<uint64_t>(base) == 9 && time > 0 && is - time < 1'000'000'000, "a place at no time");
  const Hand& h = fake().hand[reinterpret_cast<uint64_t>(space) - 1];
  out->locationFlags = h.flags;
  const auto f = [](double x) { return static_cast<float>(x); };
  out->pose.position = {f(h.p[0]), f(h.p[1]), f(h.p[2])};
  out->pose.orientation = {f(h.q[1]), f(h.q[2]), f(h.q[3]), f(h.q[0])};
  if (auto* velocity = static_cast<XrSpaceVelocity*>(out->next)) {
    velocity->velocityFlags = XR_SPACE_VELOCITY_LINEAR_VALID_BIT | XR_SPACE_VELOCITY_ANGULAR_VALID_BIT;
    velocity->linearVelocity = {f(h.v[0]), f(h.v[1]), f(h.v[2])};
    velocity->angularVelocity = {0, 0, 0};
  }
  return XR_SUCCESS;
}
const Hand& hand_of(const XrActionStateGetInfo* info) { return fake().hand[info->subactionPath == fake().paths["/user/hand/left"] ? 0 : 1]; }
XrResult get_float(XrSession, const XrActionStateGetInfo* info, XrActionStateFloat* out) {
  THERE(fake().actions[info->action] == "jaws", "a number of an action that has none");
  out->currentState = hand_of(info).trigger;
  out->isActive = XR_TRUE;
  return XR_SUCCESS;
}
XrResult get_boolean(XrSession, const XrActionStateGetInfo* info, XrActionStateBoolean* out) {
  THERE(true, "");
  const std::string& name = fake().actions[info->action];
  out->currentState = (hand_of(info).buttons & (name == "first" ? 1u : 2u)) != 0 ? XR_TRUE : XR_FALSE;
  out->isActive = XR_TRUE;
  return XR_SUCCESS;
}

XrSession the_session = XR_NULL_HANDLE;
XrResult create_and_remember(XrInstance i, const XrSessionCreateInfo* info, XrSession* out) {
  const XrResult r = create_session(i, info, out);
  the_session = *out;
  return r;
}
XrResult poll_of_session(XrInstance i, XrEventDataBuffer* out) {
  const XrResult r = poll(i, out);
  if (out->type == XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED) reinterpret_cast<XrEventDataSessionStateChanged&>(*out).session = the_session;
  return r;
}

template <class Function>
PFN_xrVoidFunction plain(Function* f) {
  return reinterpret_cast<PFN_xrVoidFunction>(f);
}

XrResult get(XrInstance, const char* name, PFN_xrVoidFunction* out) {
  static const std::map<std::string, PFN_xrVoidFunction> all = {
      {"xrGetInstanceProcAddr", plain(get)},
      {"xrEnumerateInstanceExtensionProperties", plain(enumerate)},
      {"xrCreateInstance", plain(create_instance)},
      {"xrDestroyInstance", plain(destroy_instance)},
      {"xrGetInstanceProperties", plain(properties)},
      {"xrGetSystem", plain(system_of)},
      {"xrCreateSession", plain(create_and_remember)},
      {"xrDestroySession", plain(destroy_session)},
      {"xrBeginSession", plain(begin)},
      {"xrEndSession", plain(end)},
      {"xrPollEvent", plain(poll_of_session)},
      {"xrStringToPath", plain(path)},
      {"xrCreateActionSet", plain(action_set)},
      {"xrCreateAction", plain(action)},
      {"xrSuggestInteractionProfileBindings", plain(suggest)},
      {"xrAttachSessionActionSets", plain(attach)},
      {"xrCreateActionSpace", plain(action_space)},
      {"xrCreateReferenceSpace", plain(reference)},
      {"xrLocateSpace", plain(locate)},
      {"xrSyncActions", plain(sync)},
      {"xrGetActionStateFloat", plain(get_float)},
      {"xrGetActionStateBoolean", plain(get_boolean)},
      {"xrConvertTimespecTimeToTimeKHR", plain(convert)},
  };
  const auto found = all.find(name);
  *out = found == all.end() ? nullptr : found->second;
  return found == all.end() ? XR_ERROR_FUNCTION_UNSUPPORTED : XR_SUCCESS;
}

}  // namespace

extern "C" {

XrResult xrNegotiateLoaderRuntimeInterface(const LoaderInfo* loader, RuntimeRequest* request) {
  if (loader == nullptr || request == nullptr || request->size < sizeof(RuntimeRequest)) return XR_ERROR_INITIALIZATION_FAILED;
  request->interface_version = 1;
  request->api = XR_MAKE_VERSION(1, 0, 20);
  request->get = get;
  return XR_SUCCESS;
}

void fake_reset() {
  const Guard guard(fake().lock);
  Fake& f = fake();
  f.wrong.clear();
  f.without.clear();
  f.hand[0] = f.hand[1] = {};
  f.plugged = f.headset = f.focused = f.knows_touch = true;
  f.instance_loss = false;
  f.bindings = f.instances = f.syncs = 0;
}
void fake_place(int side, double x, double y, double z) {
  const Guard guard(fake().lock);
  fake().hand[side].p[0] = x, fake().hand[side].p[1] = y, fake().hand[side].p[2] = z;
}
void fake_turn(int side, double w, double x, double y, double z) {
  const Guard guard(fake().lock);
  const double q[4] = {w, x, y, z};
  std::memcpy(fake().hand[side].q, q, sizeof q);
}
void fake_velocity(int side, double x) {
  const Guard guard(fake().lock);
  fake().hand[side].v[0] = x;
}
void fake_flags(int side, unsigned flags) {
  const Guard guard(fake().lock);
  fake().hand[side].flags = flags;
}
void fake_squeeze(int side, double trigger, unsigned buttons) {
  const Guard guard(fake().lock);
  fake().hand[side].trigger = static_cast<float>(trigger);
  fake().hand[side].buttons = buttons;
}
void fake_plug(int there) {
  const Guard guard(fake().lock);
  fake().plugged = there != 0;
}
void fake_state(int state) {
  const Guard guard(fake().lock);
  fake().states.push_back(static_cast<XrSessionState>(state));
}
void fake_instance_loss() {
  const Guard guard(fake().lock);
  fake().instance_loss = true;
}
void fake_headset(int there) { fake().headset = there != 0; }
void fake_focus(int there) { fake().focused = there != 0; }
void fake_touch(int known) { fake().knows_touch = known != 0; }
void fake_without(const char* extension) { fake().without = extension; }
int fake_bindings() { return fake().bindings; }
int fake_instances() { return fake().instances; }
int fake_running() { return fake().running ? 1 : 0; }
const char* fake_wrong() { return fake().wrong.c_str(); }
}
