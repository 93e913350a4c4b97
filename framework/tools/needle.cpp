// SPDX-License-Identifier: Apache-2.0
//
// swage needle: the library of needles, and the bench that bends them.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "host/nearest.hpp"
#include "tools/needle_bench.hpp"
#include "tools/places.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"
#include "tools/verbs.hpp"

namespace swage::tools {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Reads all files of the library, sorted by name. False with the problem printed.
bool read_library(std::vector<NeedleModel>& out) {
  std::vector<std::string> searched;
  const std::string folder = data_folder("needles", searched);
  if (folder.empty()) {
    problem(say::kNoLibrary(host::join(searched)));
    return false;
  }
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".json") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  for (const std::string& file : files) {
    const std::string wrong = read_needle(file, out.emplace_back());
    if (wrong.empty()) continue;
    problem(wrong);
    return false;
  }
  return true;
}

std::string stem(const NeedleModel& n) { return fs::path(n.file).stem().string(); }

Json to_json(const NeedleModel& n) {
  const toolkit::WireMaterial& m = n.material;
  return {{"model", stem(n)},
          {"name", n.name},
          {"file", n.file},
          {"circle_share", n.share},
          {"length_m", n.length()},
          {"wire_diameter_m", n.diameter},
          {"bending_stiffness_N_m2", toolkit::bending_stiffness(n.diameter, m.youngs)},
          {"yield_moment_N_m", toolkit::yield_moment(n.diameter, m.yield)},
          {"plastic_moment_N_m", toolkit::plastic_moment(n.diameter, m.yield)},
          {"values_sourced", n.sourced},
          {"values_assumed", n.assumed}};
}

/// Finds a model: a file by its path, or a model of the library by its file name, with or without .json. False with the problem printed.
bool find_model(const std::string& wanted, NeedleModel& out) {
  std::error_code ignored;
  if (fs::is_regular_file(wanted, ignored)) {
    const std::string wrong = read_needle(wanted, out);
    if (!wrong.empty()) problem(wrong);
    return wrong.empty();
  }
  std::vector<NeedleModel> library;
  if (!read_library(library)) return false;
  std::vector<std::string> names;
  for (const NeedleModel& n : library) {
    names.push_back(stem(n));
    if (stem(n) != wanted && stem(n) + ".json" != wanted) continue;
    out = n;
    return true;
  }
  problem(say::kNoNeedle(wanted, host::did_you_mean(wanted, names), host::join(names)));
  return false;
}

}  // namespace

int list_needles(const NeedleOptions& o) {
  std::vector<NeedleModel> library;
  if (!read_library(library)) return kProblem;
  if (o.json) {
    Json all = Json::array();
    for (const NeedleModel& n : library) all.push_back(to_json(n));
    print(all);
    return kPassed;
  }
  std::printf("%-16s %-28s %8s %8s %12s %10s %10s  %s\n", "model", "what", "wire um", "arc mm", "EI N mm2",
              "M_y N mm", "M_p N mm", "sourced / assumed");
  for (const NeedleModel& n : library) {
    const toolkit::WireMaterial& m = n.material;
    std::printf("%-16s %-28s %8.0f %8.2f %12.3f %10.3f %10.3f  %d / %d\n", stem(n).c_str(), n.name.c_str(),
                1e6 * n.diameter, 1e3 * n.length(), 1e6 * toolkit::bending_stiffness(n.diameter, m.youngs),
                1e3 * toolkit::yield_moment(n.diameter, m.yield),
                1e3 * toolkit::plastic_moment(n.diameter, m.yield), n.sourced, n.assumed);
  }
  return kPassed;
}

int bench_needle(const NeedleOptions& o) {
  NeedleModel needle;
  if (!find_model(o.model, needle)) return kProblem;
  const std::vector<NeedleFigure> figures = bench_needle(needle, o.pieces, 1e-3 * o.width_mm);
  if (o.json) {
    Json out = to_json(needle);
    out["pieces"] = o.pieces;
    out["jaw_width_m"] = 1e-3 * o.width_mm;
    for (const NeedleFigure& f : figures)
      out["figures"].push_back({{"name", f.name},
                                {"unit", f.unit},
                                {"closed_form", f.closed_form / f.scale},
                                {"bending", f.bending / f.scale},
                                {"bending_error", f.bending_error()},
                                {"reference", f.reference / f.scale},
                                {"reference_error", f.reference_error()}});
    print(out);
    return kPassed;
  }
  std::printf(
      "%s: %s. Clamped two thirds of the way back from the point: an arm of %.2f mm; %d pieces; jaws %.2f mm "
      "wide.\n\n",
      stem(needle).c_str(), needle.name.c_str(), 1e3 * needle.arm(), o.pieces, o.width_mm);
  std::printf("%-46s %-5s %12s %12s %8s %12s %8s\n", "", "", "closed form", "bending", "error", "reference",
              "error");
  for (const NeedleFigure& f : figures)
    std::printf("%-46s %-5s %12.4f %12.4f %+7.1f%% %12.4f %+7.1f%%\n", f.name.c_str(), f.unit.c_str(),
                f.closed_form / f.scale, f.bending / f.scale, 100 * f.bending_error(), f.reference / f.scale,
                100 * f.reference_error());
  return kPassed;
}

}  // namespace swage::tools
