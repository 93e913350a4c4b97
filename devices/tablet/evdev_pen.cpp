// SPDX-License-Identifier: Apache-2.0
#include "evdev_pen.hpp"

#include <fcntl.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "nodes/nodes.hpp"
#include "sentences.hpp"

namespace swage::tablet {

namespace {

bool has(const unsigned char* bits, int code) { return (bits[code / 8] >> (code % 8) & 1) != 0; }

AxisRange range(int file, int code) {
  input_absinfo info{};
  if (ioctl(file, EVIOCGABS(code), &info) < 0) return {};
  return {info.minimum, info.maximum, info.resolution};
}

// false when the device is not a pen
bool ask(int file, OpenPen& out) {
  unsigned char keys[KEY_MAX / 8 + 1]{}, axes[ABS_MAX / 8 + 1]{};
  if (ioctl(file, EVIOCGBIT(EV_KEY, sizeof keys), keys) < 0 || ioctl(file, EVIOCGBIT(EV_ABS, sizeof axes), axes) < 0) return false;
  if (!has(keys, BTN_TOOL_PEN) || !has(axes, ABS_X) || !has(axes, ABS_Y)) return false;
  char name[128]{};
  if (ioctl(file, EVIOCGNAME(sizeof name - 1), name) >= 0) out.name = name;
  const auto get = [&](int code) { return has(axes, code) ? range(file, code) : AxisRange{}; };
  out.ranges = {get(ABS_X), get(ABS_Y), get(ABS_PRESSURE), get(ABS_DISTANCE), get(ABS_TILT_X), get(ABS_TILT_Y)};
  int clock = CLOCK_MONOTONIC;
  ioctl(file, EVIOCSCLOCKID, &clock);
  return out.ranges.x.present() && out.ranges.y.present();
}

// 1: a pen, 0: another device, -1: may not be opened (errno)
int try_open(const std::string& path, OpenPen& out) {
  const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return -1;
  out.file = file;
  if (ask(file, out)) return 1;
  ::close(file);
  out = {};
  return 0;
}

}  // namespace

std::string open_pen(const std::string& path, const std::string& like, OpenPen& out) {
  out = {};
  if (!path.empty()) {
    const int found = try_open(path, out);
    if (found == 1) return "";
    if (found == 0) return say::kNoPen(path);
    return errno == EACCES ? say::kMayNotRead(path, say::kRights()) : say::kNotOpened(path, std::strerror(errno));
  }
  std::vector<std::string> nodes;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(nodes::place("/dev/input"), ignored))
    if (entry.path().filename().string().starts_with("event")) nodes.push_back(entry.path().string());
  std::sort(nodes.begin(), nodes.end());
  for (const std::string& node : nodes) {
    const int found = try_open(node, out);
    if (found != 1) continue;
    if (out.name.find(like) != std::string::npos) return "";
    ::close(out.file);
    out = {};
  }
  if (const std::string pen = nodes::closed_input(nodes::Tells::kPen); !pen.empty()) return say::kClosed(pen, say::kRights());
  return say::kNoTablet(like.empty() ? "" : say::kCalled(like));
}

}  // namespace swage::tablet
