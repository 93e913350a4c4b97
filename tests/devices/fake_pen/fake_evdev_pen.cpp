// SPDX-License-Identifier: Apache-2.0
//
// In the place of devices/tablet/evdev_pen.cpp: a pen at the other end of a socket, so that the driver runs as it is in a whole lesson.
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>

#include "tablet/evdev_pen.hpp"
#include "tablet/sentences.hpp"

namespace swage::tablet {

std::string open_pen(const std::string& path, const std::string&, OpenPen& out) {
  const int file = socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::copy_n(path.begin(), std::min(path.size(), sizeof address.sun_path - 1), address.sun_path);
  if (file < 0 || connect(file, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    if (file >= 0) ::close(file);
    return say::kNoTablet("");
  }
  // as of a middle-sized tablet: 200 units per mm, 216 x 135 mm, 8192 steps of pressure
  out = {file, "Fake pen", {{0, 43200, 200}, {0, 27000, 200}, {0, 8191, 0}, {0, 63, 0}, {-64, 63, 57}, {-64, 63, 57}}};
  return "";
}

}  // namespace swage::tablet
