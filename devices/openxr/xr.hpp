// SPDX-License-Identifier: Apache-2.0
//
// The part of OpenXR that is used, loaded at run time through its loader.
#pragma once

#include <time.h>

#define XR_USE_TIMESPEC
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

#include <string>

namespace swage::openxr {

/// Functions of one instance.
struct Xr {
  PFN_xrGetInstanceProcAddr GetInstanceProcAddr;
  PFN_xrDestroyInstance DestroyInstance;
  PFN_xrGetInstanceProperties GetInstanceProperties;
  PFN_xrGetSystem GetSystem;
  PFN_xrCreateSession CreateSession;
  PFN_xrDestroySession DestroySession;
  PFN_xrBeginSession BeginSession;
  PFN_xrEndSession EndSession;
  PFN_xrPollEvent PollEvent;
  PFN_xrStringToPath StringToPath;
  PFN_xrCreateActionSet CreateActionSet;
  PFN_xrCreateAction CreateAction;
  PFN_xrSuggestInteractionProfileBindings SuggestInteractionProfileBindings;
  PFN_xrAttachSessionActionSets AttachSessionActionSets;
  PFN_xrCreateActionSpace CreateActionSpace;
  PFN_xrCreateReferenceSpace CreateReferenceSpace;
  PFN_xrLocateSpace LocateSpace;
  PFN_xrSyncActions SyncActions;
  PFN_xrGetActionStateFloat GetActionStateFloat;
  PFN_xrGetActionStateBoolean GetActionStateBoolean;
  PFN_xrConvertTimespecTimeToTimeKHR ConvertTimespecTimeToTimeKHR;
};

/// Creates an instance of the active runtime, for input without images (XR_MND_headless). False and the reason, a sentence with the
/// remedy. [main or io], one thread at a time
bool make_instance(Xr& xr, XrInstance& instance, std::string& why);

}  // namespace swage::openxr
