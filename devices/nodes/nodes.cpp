// SPDX-License-Identifier: Apache-2.0
#include "nodes/nodes.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

namespace swage::nodes {
namespace {

namespace fs = std::filesystem;

std::string first_line(const fs::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line;
}

/// The value of a line "key=value", "" without one.
std::string value_of(const fs::path& file, const std::string& key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(key + "=")) return line.substr(key.size() + 1);
  return "";
}

/// Entries of a folder whose names begin with `begin`, sorted.
std::vector<fs::path> entries(const std::string& folder, const std::string& begin) {
  std::vector<fs::path> out;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(place(folder), ignored))
    if (entry.path().filename().string().starts_with(begin)) out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

bool closed(const std::string& node, int how) {
  const int file = ::open(node.c_str(), how | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (file < 0) return errno == EACCES;
  ::close(file);
  return false;
}

/// True when bit `code` is set in the kernel's words, hexadecimal, the highest one first.
bool has_bit(const std::string& words, unsigned code) {
  std::vector<uint64_t> word;
  std::istringstream in(words);
  for (std::string one; in >> one;) word.push_back(std::strtoull(one.c_str(), nullptr, 16));
  constexpr unsigned kBits = 8 * sizeof(long);
  const std::size_t from_end = code / kBits;
  return from_end < word.size() && (word[word.size() - 1 - from_end] >> (code % kBits) & 1) != 0;
}

std::string named(const std::string& name, const std::string& node) { return (name.empty() ? "A device" : name) + " (" + node + ")"; }

}  // namespace

std::string place(std::string_view path) {
  const char* const root = std::getenv("SWAGE_DEVICE_ROOT");
  return (root != nullptr ? std::string(root) : std::string()) + std::string(path);
}

std::string closed_input(Tells kind) {
  for (const fs::path& device : entries("/sys/class/input", "event")) {
    if (!has_bit(first_line(device / "device/capabilities/key"), static_cast<unsigned>(kind))) continue;
    const std::string node = place("/dev/input/" + device.filename().string());
    if (closed(node, O_RDONLY)) return named(first_line(device / "device/name"), node);
  }
  return "";
}

std::string closed_of_maker(uint16_t vendor) {
  for (const fs::path& device : entries("/sys/class/hidraw", "hidraw")) {
    // HID_ID=0003:00002988:00000304: bus, maker, product
    const std::string id = value_of(device / "device/uevent", "HID_ID");
    if (id.size() < 13 || std::strtoul(id.substr(5, 8).c_str(), nullptr, 16) != vendor) continue;
    const std::string node = place("/dev/" + device.filename().string());
    if (closed(node, O_RDWR)) return named(value_of(device / "device/uevent", "HID_NAME"), node);
  }
  for (const fs::path& device : entries("/sys/class/tty", "ttyACM")) {
    const fs::path usb = device / "device/..";
    if (std::strtoul(first_line(usb / "idVendor").c_str(), nullptr, 16) != vendor) continue;
    const std::string node = place("/dev/" + device.filename().string());
    if (closed(node, O_RDWR)) return named(first_line(usb / "product"), node);
  }
  return "";
}

}  // namespace swage::nodes
