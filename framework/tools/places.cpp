// SPDX-License-Identifier: Apache-2.0
#include "tools/places.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "record/address.hpp"
#include "session/knot_copy.hpp"
#include "tools/sentences.hpp"

namespace swage::tools {

namespace fs = std::filesystem;

std::string program_folder() {
  std::error_code ignored;
  return fs::read_symlink("/proc/self/exe", ignored).parent_path().string();
}

std::string beside(const std::string& program) {
  const std::string path = (fs::path(program_folder()) / program).string();
  return access(path.c_str(), X_OK) == 0 ? path : "";
}

void become(const std::string& program, const std::vector<std::string>& arguments) {
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  execv(program.c_str(), argv.data());
}

bool has_display() {
  const auto set = [](const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && value[0] != '\0';
  };
  return set("DISPLAY") || set("WAYLAND_DISPLAY");
}

std::string data_folder(const std::string& name, std::vector<std::string>& searched) {
  const fs::path here = program_folder();
  std::error_code ignored;
  const auto look = [&](const fs::path& folder) {
    searched.push_back(folder.lexically_normal().string());
    return fs::is_directory(folder, ignored);
  };
  if (look(here.parent_path() / "share/swage" / name)) return searched.back();
  // a build folder is two or three levels below its source tree
  fs::path up = here;
  for (int i = 0; i < 4 && up.has_relative_path(); ++i, up = up.parent_path())
    if (look(up / "resources" / name) || look(up / name)) return searched.back();
  return "";
}

std::string pull_lesson() {
  std::vector<std::string> searched;
  const std::string folder = data_folder("lessons/series", searched);
  return folder.empty() ? "" : folder + "/" + session::kPullLesson;
}

std::string template_folder(std::vector<std::string>& searched) {
  return data_folder("plugin_template", searched);
}

std::string store_place(const std::string& given) {
  return given.empty() ? record::Store::default_path() : given;
}

std::unique_ptr<record::Store> existing_store(const std::string& where, std::string& error) {
  std::error_code ignored;
  error = record::address_problem(where);
  if (!error.empty()) return nullptr;
  if (record::is_postgres(where) || fs::exists(where, ignored)) return record::Store::open_as_allowed(where, error);
  error = say::kNoStore(where);
  return nullptr;
}

bool find_attempt(record::Store& store, const std::string& meant, record::AttemptRow& out,
                  std::string& error) {
  if (store.attempt(meant, out)) return true;
  std::vector<record::AttemptRow> candidates;
  if (!store.trouble().empty()) {
    error = store.trouble();
    return false;
  }
  std::vector<record::AttemptRow> all = store.attempts("");
  if (!store.trouble().empty()) {
    error = store.trouble();
    return false;
  }
  for (record::AttemptRow& a : all)
    if (meant == "last" || a.id.starts_with(meant)) candidates.push_back(std::move(a));
  if (candidates.empty()) {
    error = meant == "last" ? say::kNoAttemptYet()
                            : say::kNoAttempt(meant);
    return false;
  }
  // newest first
  if (meant != "last" && candidates.size() > 1) {
    error = say::kManyAttempts(meant, candidates.size());
    return false;
  }
  out = candidates.front();
  return true;
}

bool load_attempt(const std::string& what, const std::string& store_given, record::Recording& out, std::string& id, std::string& error) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(what, ignored)) return record::read_recording(what, "", out, error);
  if (what.ends_with(".swage")) {
    error = say::kNoFile(what);
    return false;
  }
  const std::string where = store_place(store_given);
  const auto store = existing_store(where, error);
  record::AttemptRow row;
  if (!store || !find_attempt(*store, what, row, error)) return false;
  id = row.id;
  return record::read_recording(where, row.id, out, error);
}

}  // namespace swage::tools
