// SPDX-License-Identifier: Apache-2.0
#include "actions.hpp"

#include <cstring>
#include <string>
#include <vector>

namespace swage::openxr {
namespace {

constexpr const char* kHands[kSides] = {"/user/hand/left", "/user/hand/right"};

// components of each profile below /input, "" where there is none; the second text is for the right hand
struct Profile {
  const char* path;
  const char* trigger;
  const char* button[kButtons][kSides];
};
constexpr Profile kProfiles[] = {
    {"/interaction_profiles/khr/simple_controller", "select/click", {{"menu/click", "menu/click"}, {"", ""}}},
    {"/interaction_profiles/oculus/touch_controller", "trigger/value", {{"x/click", "a/click"}, {"y/click", "b/click"}}},
    {"/interaction_profiles/valve/index_controller", "trigger/value", {{"a/click", "a/click"}, {"b/click", "b/click"}}},
    {"/interaction_profiles/htc/vive_controller", "trigger/value", {{"trackpad/click", "trackpad/click"}, {"menu/click", "menu/click"}}},
};

XrResult make_action(const Xr& xr, const Actions& a, const char* name, const char* shown, XrActionType type, XrAction& out) {
  XrActionCreateInfo info{};
  info.type = XR_TYPE_ACTION_CREATE_INFO;
  std::strcpy(info.actionName, name);
  std::strcpy(info.localizedActionName, shown);
  info.actionType = type;
  info.countSubactionPaths = kSides;
  info.subactionPaths = a.side;
  return xr.CreateAction(a.set, &info, &out);
}

XrResult suggest(const Xr& xr, XrInstance instance, const Actions& a, const Profile& profile) {
  std::vector<XrActionSuggestedBinding> all;
  const auto bind = [&](XrAction action, int side, const std::string& component) {
    XrPath path = XR_NULL_PATH;
    if (xr.StringToPath(instance, (std::string(kHands[side]) + "/input/" + component).c_str(), &path) == XR_SUCCESS)
      all.push_back({action, path});
  };
  for (int side = 0; side < kSides; ++side) {
    bind(a.aim, side, "aim/pose");
    bind(a.trigger, side, profile.trigger);
    for (int b = 0; b < kButtons; ++b)
      if (*profile.button[b][side] != '\0') bind(a.button[b], side, profile.button[b][side]);
  }
  XrInteractionProfileSuggestedBinding info{};
  info.type = XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING;
  xr.StringToPath(instance, profile.path, &info.interactionProfile);
  info.countSuggestedBindings = static_cast<uint32_t>(all.size());
  info.suggestedBindings = all.data();
  return xr.SuggestInteractionProfileBindings(instance, &info);
}

}  // namespace

XrResult make_actions(const Xr& xr, XrInstance instance, XrSession session, Actions& a) {
  for (int side = 0; side < kSides; ++side)
    if (const XrResult r = xr.StringToPath(instance, kHands[side], &a.side[side]); r != XR_SUCCESS) return r;
  XrActionSetCreateInfo set{};
  set.type = XR_TYPE_ACTION_SET_CREATE_INFO;
  std::strcpy(set.actionSetName, "instrument");
  std::strcpy(set.localizedActionSetName, "Instrument");
  XrResult r = xr.CreateActionSet(instance, &set, &a.set);
  if (r == XR_SUCCESS) r = make_action(xr, a, "tool", "Tool", XR_ACTION_TYPE_POSE_INPUT, a.aim);
  if (r == XR_SUCCESS) r = make_action(xr, a, "jaws", "Jaws", XR_ACTION_TYPE_FLOAT_INPUT, a.trigger);
  if (r == XR_SUCCESS) r = make_action(xr, a, "first", "First button", XR_ACTION_TYPE_BOOLEAN_INPUT, a.button[0]);
  if (r == XR_SUCCESS) r = make_action(xr, a, "second", "Second button", XR_ACTION_TYPE_BOOLEAN_INPUT, a.button[1]);
  if (r != XR_SUCCESS) return r;
  // a runtime rejects unknown profiles; one known profile suffices
  int known = 0;
  for (const Profile& profile : kProfiles) known += suggest(xr, instance, a, profile) == XR_SUCCESS ? 1 : 0;
  if (known == 0) return XR_ERROR_PATH_UNSUPPORTED;
  for (int side = 0; side < kSides; ++side) {
    XrActionSpaceCreateInfo space{};
    space.type = XR_TYPE_ACTION_SPACE_CREATE_INFO;
    space.action = a.aim;
    space.subactionPath = a.side[side];
    space.poseInActionSpace.orientation.w = 1;
    r = xr.CreateActionSpace(session, &space, &a.space[side]);
    if (r != XR_SUCCESS) return r;
  }
  XrSessionActionSetsAttachInfo attach{};
  attach.type = XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO;
  attach.countActionSets = 1;
  attach.actionSets = &a.set;
  return xr.AttachSessionActionSets(session, &attach);
}

}  // namespace swage::openxr
