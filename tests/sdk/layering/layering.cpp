// SPDX-License-Identifier: Apache-2.0
#include "layering.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace swage::test {

namespace fs = std::filesystem;

namespace {

constexpr const char* kTops[] = {"framework", "plugins", "devices", "lessons", "console"};
constexpr const char* kMoreTops[] = {"resources", "tests", "scripts"};

// headers of the Linux and C libraries that have a folder or end in .h
const std::set<std::string> kSystemFolders = {"sys", "linux", "netinet", "arpa", "bits", "gnu"};

/// All files below the given tops, as paths relative to the root, sorted; fixture trees of this test are left out.
template <class Tops>
std::vector<std::string> files_below(const fs::path& root, const Tops& tops) {
  std::vector<std::string> files;
  for (const char* top : tops) {
    if (!fs::exists(root / top)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      const std::string path = fs::relative(entry.path(), root).generic_string();
      if (entry.is_regular_file() && path.find("sdk/layering/broken_tree/") == std::string::npos)
        files.push_back(path);
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<const char*> all_tops() {
  std::vector<const char*> tops(std::begin(kTops), std::end(kTops));
  tops.insert(tops.end(), std::begin(kMoreTops), std::end(kMoreTops));
  return tops;
}

int lines_of(const fs::path& file) {
  std::ifstream in(file);
  int lines = 0;
  for (std::string line; std::getline(in, line);) ++lines;
  return lines;
}

bool ends_with_any(const std::string& path, std::initializer_list<const char*> ends) {
  return std::any_of(ends.begin(), ends.end(), [&](const char* end) { return path.ends_with(end); });
}

std::vector<std::string> split(const std::string& path) {
  std::vector<std::string> parts;
  std::istringstream in(path);
  for (std::string part; std::getline(in, part, '/');) parts.push_back(part);
  return parts;
}

/// Where a file stands: its rule in layers.txt and the name of its own room.
struct Place {
  std::string rule, room;
};

Place place_of(const std::string& path) {
  const std::vector<std::string> parts = split(path);
  if (path.starts_with("framework/sdk/include/swage/abi/")) return {"sdk/abi", "sdk/abi"};
  if (parts[0] == "framework") return {parts[1], parts[1]};
  if (parts[0] == "console" || parts.size() < 3) return {parts[0], parts[0]};
  return {parts[0], parts[0] + "/" + parts[1]};
}

/// What an include reaches for: {kind of thing, what to look up in layers.txt, header as written}.
struct Target {
  bool is_system = false;
  std::string room;  // room or library
  std::string file;  // room/file.hpp, for rules that name one file
};

bool is_room(const std::string& name, const Layers& layers) {
  return layers.may.contains(name) && !std::count(std::begin(kTops), std::end(kTops), name);
}

Target target_of(const fs::path& root, const std::string& header, bool quoted, const Place& from,
                 const Layers& layers) {
  const std::vector<std::string> parts = split(header);
  if (header.starts_with("swage/abi/")) return {false, "sdk/abi", header};
  if (header.starts_with("swage/")) return {false, "sdk", header};
  if (parts.size() > 1 && parts[0] == "..") return {false, "another folder by ..", header};
  if (parts.size() > 1 && is_room(parts[0], layers)) return {false, parts[0], header};
  if (parts.size() > 1 && std::count(std::begin(kTops), std::end(kTops), parts[0])) {
    const bool own = parts[0] == from.rule;
    return {false, own && from.room != from.rule ? parts[0] + "/" + parts[1] : parts[0], header};
  }
  const bool beside = from.room != from.rule;  // "jaws/jaw.hpp" from another bundle of the same parent
  if (beside && parts.size() > 1 && fs::is_directory(root / from.rule / parts[0]))
    return {false, from.rule + "/" + parts[0], header};
  if (quoted) return {false, from.room, header};
  if (parts.size() > 1) return {kSystemFolders.contains(parts[0]), parts[0], header};
  if (header.size() > 1 && header[0] == 'Q' && std::isupper(static_cast<unsigned char>(header[1])))
    return {false, "Qt", header};
  return {true, header, header};
}

/// Qt modules are written QtCore/QObject, QtSql/..., Qt3DCore/...; "Qt" in layers.txt opens all of them.
bool allowed(const Target& target, const std::set<std::string>& may) {
  if (may.contains(target.room) || may.contains(target.file)) return true;
  return target.room.starts_with("Qt") && may.contains("Qt");
}

/// The rule of the room, with what its own folder is given on top.
std::set<std::string> may_include(const Place& place, const Layers& layers) {
  std::set<std::string> may;
  for (const std::string& key : {place.rule, place.room}) {
    const auto rule = layers.may.find(key);
    if (rule != layers.may.end()) may.insert(rule->second.begin(), rule->second.end());
  }
  may.insert(place.room);
  return may;
}

/// The header that a line includes, with whether it is quoted; "" when it includes none.
std::string included(const std::string& line, bool& quoted) {
  size_t at = line.find_first_not_of(" \t");
  if (at == std::string::npos || line[at] != '#') return "";
  at = line.find_first_not_of(" \t", at + 1);
  if (at == std::string::npos || line.compare(at, 7, "include") != 0) return "";
  at = line.find_first_of("<\"", at);
  if (at == std::string::npos) return "";
  quoted = line[at] == '"';
  return line.substr(at + 1, line.find(quoted ? '"' : '>', at + 1) - at - 1);
}

void check_file(const fs::path& root, const std::string& path, const Layers& layers,
                std::vector<std::string>& out) {
  const Place place = place_of(path);
  if (!layers.may.contains(place.rule)) {
    out.push_back(path + ": layers.txt has no room \"" + place.rule + "\"");
    return;
  }
  const std::set<std::string> may = may_include(place, layers);
  const auto never = layers.never.find(place.rule);
  std::ifstream in(root / path);
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    bool quoted = false;
    const std::string header = included(line, quoted);
    if (header.empty()) continue;
    const Target target = target_of(root, header, quoted, place, layers);
    const std::string where = path + ":" + std::to_string(number) + ": " + place.room;
    if (target.is_system) {
      if (never != layers.never.end() && never->second.contains(header))
        out.push_back(where + " does without <" + header + ">");
    } else if (!allowed(target, may)) {
      out.push_back(where + " may not include " + target.room + " (" + header + ")");
    }
  }
}

}  // namespace

Layers Layers::read(const fs::path& file) {
  Layers layers;
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    line.erase(std::find(line.begin(), line.end(), '#'), line.end());
    if (line.find_first_not_of(' ') == std::string::npos) continue;
    const size_t colon = line.find(':');
    if (colon == std::string::npos)
      throw std::runtime_error(file.string() + ":" + std::to_string(number) + ": no colon");
    std::istringstream head(line.substr(0, colon)), words(line.substr(colon + 1));
    std::string room, kind;
    head >> room >> kind;
    if (!kind.empty() && kind != "never")
      throw std::runtime_error(file.string() + ":" + std::to_string(number) + ": \"" + kind +
                               "\" is not \"never\"");
    std::set<std::string>& set = kind.empty() ? layers.may[room] : layers.never[room];
    for (std::string word; words >> word;) set.insert(word);
  }
  return layers;
}

std::vector<std::string> include_violations(const fs::path& root, const Layers& layers) {
  std::vector<std::string> out;
  for (const std::string& path : files_below(root, kTops)) {
    const bool source = ends_with_any(path, {".hpp", ".cpp", ".h", ".c"});
    if (source && !path.starts_with("framework/sdk/guide/")) check_file(root, path, layers, out);
  }
  return out;
}

std::vector<std::string> spdx_violations(const fs::path& root) {
  std::vector<std::string> out;
  for (const std::string& path : files_below(root, all_tops())) {
    if (!ends_with_any(path, {".hpp", ".cpp", ".h", ".c", ".inc", ".cmake", ".sh", "/CMakeLists.txt"}))
      continue;
    std::ifstream in(root / path);
    std::string first, second;
    std::getline(in, first);
    std::getline(in, second);
    const std::string sign = "SPDX-License-Identifier: ";
    const bool script = first.starts_with("#!");
    if ((script ? second : first).find(sign) == std::string::npos) out.push_back(path + ": no SPDX line");
  }
  return out;
}

std::vector<std::string> length_violations(const fs::path& root) {
  constexpr int kMost = 400;
  std::vector<std::string> out;
  for (const std::string& path : files_below(root, all_tops())) {
    if (!ends_with_any(path, {".hpp", ".cpp", ".h", ".c"})) continue;
    const int lines = lines_of(root / path);
    if (lines > kMost)
      out.push_back(path + ": " + std::to_string(lines) + " lines; a file has at most " +
                    std::to_string(kMost));
  }
  return out;
}

std::vector<std::string> readme_violations(const fs::path& root) {
  std::vector<std::string> rooms;
  if (fs::exists(root / "framework"))
    for (const auto& entry : fs::directory_iterator(root / "framework"))
      if (entry.is_directory() && entry.path().filename() != "cmake")
        rooms.push_back("framework/" + entry.path().filename().string());
  for (const char* top : {"plugins", "devices", "lessons", "console", "resources", "scripts", "tests"})
    if (fs::exists(root / top)) rooms.push_back(top);
  std::sort(rooms.begin(), rooms.end());

  std::vector<std::string> out;
  for (const std::string& room : rooms)
    if (!fs::exists(root / room / "README.md")) out.push_back(room + ": no README.md");
  for (const std::string& path : files_below(root, all_tops())) {
    // the guide is a book, not a room
    if (!path.ends_with("/README.md") || path.starts_with("framework/sdk/guide/")) continue;
    const int lines = lines_of(root / path);
    if (lines >= 30)
      out.push_back(path + ": " + std::to_string(lines) + " lines; a room is told in under 30");
  }
  return out;
}

}  // namespace swage::test
