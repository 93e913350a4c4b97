// SPDX-License-Identifier: Apache-2.0
//
// The part of SDL 2 that reads game pads, loaded when it is needed: a machine without SDL runs everything else. Names and values are
// those of SDL's stable ABI (2.0.14 and newer).
#pragma once

#include <cstdint>
#include <string>

namespace swage::gamepad {

struct SdlController;  // SDL_GameController
struct SdlJoystick;    // SDL_Joystick

enum Axis { kLeftX, kLeftY, kRightX, kRightY, kLeftTrigger, kRightTrigger };  // SDL_CONTROLLER_AXIS_*
enum Button {                                                                // SDL_CONTROLLER_BUTTON_*
  kA, kB, kX, kY, kBack, kGuide, kStart, kLeftStick, kRightStick, kLeftShoulder, kRightShoulder, kUp, kDown, kLeft, kRight, kButtons
};

struct Sdl {
  int (*InitSubSystem)(uint32_t);
  int (*SetHint)(const char*, const char*);
  const char* (*GetError)();
  int (*NumJoysticks)();
  int (*IsGameController)(int);
  SdlController* (*GameControllerOpen)(int);
  void (*GameControllerClose)(SdlController*);
  int (*GameControllerGetAttached)(SdlController*);
  int16_t (*GameControllerGetAxis)(SdlController*, int);
  uint8_t (*GameControllerGetButton)(SdlController*, int);
  const char* (*GameControllerName)(SdlController*);
  const char* (*GameControllerNameForIndex)(int);
  int (*GameControllerEventState)(int);
  void (*GameControllerUpdate)();
  SdlJoystick* (*GameControllerGetJoystick)(SdlController*);
  int (*JoystickCurrentPowerLevel)(SdlJoystick*);
};

/// Charge of a battery, 0..1: the upper limit of SDL's level (SDL_JOYSTICK_POWER_*); NaN for a wired pad or an unknown level.
double battery_of(int level);

/// SDL, loaded once per process and never unloaded. nullptr, and in `why` a sentence: what is missing and how to get it. [main]
const Sdl* load_sdl(std::string& why);

}  // namespace swage::gamepad
