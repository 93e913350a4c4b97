// SPDX-License-Identifier: Apache-2.0
#include "xr.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "sentences.hpp"

namespace swage::openxr {
namespace {

constexpr const char* kLoader = "libopenxr_loader.so.1";
constexpr const char* kExtensions[] = {XR_MND_HEADLESS_EXTENSION_NAME, XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME};

template <class Function>
bool find(const Xr& xr, XrInstance instance, const char* name, Function& out, std::string& why) {
  PFN_xrVoidFunction found = nullptr;
  if (xr.GetInstanceProcAddr(instance, name, &found) != XR_SUCCESS || found == nullptr) {
    why = say::kLacks(name);
    return false;
  }
  out = reinterpret_cast<Function>(found);
  return true;
}

bool find_all(Xr& x, XrInstance i, std::string& why) {
  return find(x, i, "xrDestroyInstance", x.DestroyInstance, why) && find(x, i, "xrGetInstanceProperties", x.GetInstanceProperties, why) &&
         find(x, i, "xrGetSystem", x.GetSystem, why) && find(x, i, "xrCreateSession", x.CreateSession, why) &&
         find(x, i, "xrDestroySession", x.DestroySession, why) && find(x, i, "xrBeginSession", x.BeginSession, why) &&
         find(x, i, "xrEndSession", x.EndSession, why) && find(x, i, "xrPollEvent", x.PollEvent, why) &&
         find(x, i, "xrStringToPath", x.StringToPath, why) && find(x, i, "xrCreateActionSet", x.CreateActionSet, why) &&
         find(x, i, "xrCreateAction", x.CreateAction, why) &&
         find(x, i, "xrSuggestInteractionProfileBindings", x.SuggestInteractionProfileBindings, why) &&
         find(x, i, "xrAttachSessionActionSets", x.AttachSessionActionSets, why) &&
         find(x, i, "xrCreateActionSpace", x.CreateActionSpace, why) && find(x, i, "xrCreateReferenceSpace", x.CreateReferenceSpace, why) &&
         find(x, i, "xrLocateSpace", x.LocateSpace, why) && find(x, i, "xrSyncActions", x.SyncActions, why) &&
         find(x, i, "xrGetActionStateFloat", x.GetActionStateFloat, why) && find(x, i, "xrGetActionStateBoolean", x.GetActionStateBoolean, why) &&
         find(x, i, "xrConvertTimespecTimeToTimeKHR", x.ConvertTimespecTimeToTimeKHR, why);
}

// "" where the runtime has all required extensions
std::string missing_extension(const Xr& xr, std::string& why) {
  PFN_xrEnumerateInstanceExtensionProperties enumerate = nullptr;
  if (!find(xr, XR_NULL_HANDLE, "xrEnumerateInstanceExtensionProperties", enumerate, why)) return "?";
  uint32_t n = 0;
  const XrResult result = enumerate(nullptr, 0, &n, nullptr);
  std::vector<XrExtensionProperties> all(n, {XR_TYPE_EXTENSION_PROPERTIES, nullptr, "", 0});
  if (result != XR_SUCCESS || enumerate(nullptr, n, &n, all.data()) != XR_SUCCESS) {
    why = say::kNoRuntime();
    return "?";
  }
  for (const char* wanted : kExtensions)
    if (std::none_of(all.begin(), all.end(), [&](const auto& e) { return std::strcmp(e.extensionName, wanted) == 0; })) {
      why = say::kNeedsPictures(wanted);
      return wanted;
    }
  return "";
}

}  // namespace

bool make_instance(Xr& xr, XrInstance& instance, std::string& why) {
  static void* const library = dlopen(kLoader, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    why = say::kNoLoader(kLoader);
    return false;
  }
  xr.GetInstanceProcAddr = reinterpret_cast<PFN_xrGetInstanceProcAddr>(dlsym(library, "xrGetInstanceProcAddr"));
  if (xr.GetInstanceProcAddr == nullptr || !missing_extension(xr, why).empty()) return false;
  PFN_xrCreateInstance create = nullptr;
  if (!find(xr, XR_NULL_HANDLE, "xrCreateInstance", create, why)) return false;
  XrInstanceCreateInfo info{};
  info.type = XR_TYPE_INSTANCE_CREATE_INFO;
  std::strcpy(info.applicationInfo.applicationName, "Swage");
  info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 0);
  info.enabledExtensionCount = static_cast<uint32_t>(std::size(kExtensions));
  info.enabledExtensionNames = kExtensions;
  if (const XrResult result = create(&info, &instance); result != XR_SUCCESS) {
    why = say::kNotStarted(static_cast<int>(result));
    return false;
  }
  if (find_all(xr, instance, why)) return true;
  if (xr.DestroyInstance != nullptr) xr.DestroyInstance(instance);
  return false;
}

}  // namespace swage::openxr
