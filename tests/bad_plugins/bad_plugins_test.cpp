// SPDX-License-Identifier: Apache-2.0
//
// What the host alone can catch; watchdog, sentinel and void attempts are tested with step and session.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "../temp_folder.hpp"
#include "host/catalogue.hpp"
#include "host/malloc_guard.hpp"
#include "host/sentences.hpp"
#include "host/trial.hpp"
#include "host/units.hpp"

using namespace swage::host;
using testing::ElementsAre;
using testing::EndsWith;
using testing::IsEmpty;

namespace {

namespace fs = std::filesystem;

const std::string kBundles = BAD_PLUGINS_DIR;

std::string library(const std::string& id) { return kBundles + "/" + id + "/" + id + ".so"; }

const Catalogue& catalogue() {
  static const Catalogue* const found = [] {
    Catalogue::Options options;
    options.plugin_dirs = {kBundles};
    options.install_dir = "/nowhere";
    options.use_environment = false;
    options.describe_limit_s = 60;  // of a busy machine; nothing here takes long
    return new Catalogue(options);
  }();
  return *found;
}

std::string reason(const std::string& id) {
  for (const auto& r : catalogue().refused())
    if (r.id == id) return r.reason;
  return "not refused";
}

// one instance, configured with its defaults
std::unique_ptr<Trial> trial(const std::string& id) {
  std::string error;
  std::vector<PluginInfo> plugins;
  const Library* loaded = Library::load(library(id), error);
  if (loaded == nullptr || !describe(*loaded, plugins, error)) {
    ADD_FAILURE() << error;
    std::abort();
  }
  return std::make_unique<Trial>(*loaded, plugins[0], default_values(plugins[0].params));
}

std::string quarantine_of(const std::string& id) {
  const auto t = trial(id);
  EXPECT_TRUE(t->ready()) << t->error();
  const uint64_t dropped = t->run(100);
  EXPECT_EQ(dropped != 0, t->instance()->quarantined != 0);
  return dropped != 0 ? quarantine_text(*t->instance()) : "";
}

}  // namespace

TEST(BadPlugins, TheGoodOneIsGood) {
  const PluginInfo* ball = catalogue().find("org.example.ball");
  ASSERT_NE(ball, nullptr);
  EXPECT_EQ(ball->name, "Ball");
  EXPECT_THAT(ball->traits, ElementsAre(SWAGE_TRAIT_SOLID));
  ASSERT_EQ(ball->params.size(), 1u);
  EXPECT_EQ(ball->params[0].id, "radius");
  EXPECT_EQ(quarantine_of("org.example.ball"), "");
}

TEST(BadPlugins, OneThatCrashesOnLoadStopsNobody) {
  EXPECT_EQ(reason("org.example.bad.crashes_on_load"),
            say::kLoadCrashed("signal 11 (Segmentation fault)"));
}

TEST(BadPlugins, OneThatHangsOnLoadIsGivenUp) {
  Catalogue::Options options;
  options.install_dir = kBundles + "_hanging";
  options.use_environment = false;
  options.describe_limit_s = 1;
  const Catalogue found(options);
  EXPECT_THAT(found.plugins(), IsEmpty());
  ASSERT_EQ(found.refused().size(), 1u);
  EXPECT_EQ(found.refused()[0].reason, say::kLoadEndless(1));
}

TEST(BadPlugins, AnotherAbiIsRefusedWithASentence) {
  EXPECT_EQ(
      reason("org.example.bad.wrong_abi"),
      say::kOtherAbi("2.0", "1.0", say::kOtherMajor()));
  EXPECT_EQ(reason("org.example.bad.newer_abi"),
            say::kOtherAbi("1.1", "1.0", say::kNewerAbi()));
}

TEST(BadPlugins, FastMathIsRefusedAndUndone) {
#if defined(__x86_64__)
  const std::string sentence = say::kLoadRounding();
  EXPECT_EQ(reason("org.example.bad.fast_math"), sentence);
  // the same in this process, whose arithmetic must not change
  std::string error;
  const FpuMode before = fpu_mode();
  EXPECT_EQ(Library::load(library("org.example.bad.fast_math"), error), nullptr);
  EXPECT_EQ(error, sentence);
  EXPECT_EQ(fpu_mode(), before);
  volatile double tiny = 1e-310;
  EXPECT_GT(tiny * 0.5, 0.0);
#endif
}

TEST(BadPlugins, ContradictingTablesAndOtherLibrariesAreRefused) {
  EXPECT_EQ(
      reason("org.example.bad.bad_table"),
      "org.example.bad.bad_table: " + say::kOfParam("radius", say::kNoSiUnit("mm", unit_list())) +
          "\norg.example.bad.bad_table: " + say::kOfParam("radius", say::kIdTwice()) +
          "\norg.example.bad.bad_table: " + say::kOfParam("radius", say::kDefaultOutOfRange()));
  EXPECT_EQ(reason("org.example.bad.no_plugin"),
            say::kNoPlugin("swage_plugin_entry"));
}

TEST(BadPlugins, TheFirstOfAnIdWins) {
  ASSERT_EQ(catalogue().shadowed().size(), 1u);
  EXPECT_EQ(catalogue().shadowed()[0].id, "org.example.ball");
  EXPECT_EQ(catalogue().shadowed()[0].path, library("org.example.ball"));
  EXPECT_EQ(catalogue().shadowed()[0].by, library("org.example.bad.duplicate"));
}

TEST(BadPlugins, NoParametersIsNoFault) {
  ASSERT_NE(catalogue().find("org.example.bad.no_params"), nullptr);
  EXPECT_THAT(catalogue().find("org.example.bad.no_params")->params, IsEmpty());
  EXPECT_EQ(quarantine_of("org.example.bad.no_params"), "");
}

TEST(BadPlugins, WhatAStepCanDoWrong) {
  const auto expected = [](const std::string& name, FaultKind fault) {
    return say::kQuarantine("trial", "org.example.bad." + name, "1.0.0", text(fault), "forces", 10);
  };
  EXPECT_EQ(quarantine_of("org.example.bad.throws"), expected("throws", FaultKind::kFault));
  EXPECT_EQ(quarantine_of("org.example.bad.nan"), expected("nan", FaultKind::kNotFinite));
  EXPECT_EQ(quarantine_of("org.example.bad.huge"), expected("huge", FaultKind::kTooLarge));
#if defined(__x86_64__)
  const FpuMode before = fpu_mode();
  EXPECT_EQ(quarantine_of("org.example.bad.sets_fpu"), expected("sets_fpu", FaultKind::kFpuMode));
  EXPECT_EQ(fpu_mode(), before);
#endif
}

TEST(BadPlugins, TheSlowOneIsLateByItsOwnTime) {
  const auto slow = trial("org.example.bad.slow");
  slow->instance()->watch.budget_ns = 200'000;
  // good steps up to 9, suspicion in 10, then 20 late ones; a machine that was held up before has raised the suspicion itself
  const uint64_t last = slow->run(60);
  EXPECT_THAT(last, testing::AnyOf(29u, 30u));
  EXPECT_EQ(quarantine_text(*slow->instance()),
            say::kQuarantine("trial", "org.example.bad.slow", "1.0.0", text(FaultKind::kLate), "forces", last));
}

TEST(BadPlugins, TextInTheStepIsABreach) {
  const auto talks = trial("org.example.bad.talks");
  EXPECT_TRUE(talks->step());
  EXPECT_EQ(talks->instance()->services->role_breaches(), 1u);
}

TEST(BadPlugins, MemoryTakenInTheStepIsCounted) {
  if (!counts_allocations()) GTEST_SKIP() << "a sanitizer has an allocator of its own";
  const auto clean = trial("org.example.ball"), allocates = trial("org.example.bad.allocates");
  clean->run(10);
  allocates->run(10);
  EXPECT_EQ(clean->allocations(), 0u);
  EXPECT_EQ(allocates->allocations(), 10u);
}

TEST(BadPlugins, DeclarationsBeyondTheSceneAreRefused) {
  const auto greedy = trial("org.example.bad.greedy");
  EXPECT_FALSE(greedy->configured());
  ASSERT_EQ(greedy->problems().size(), 1u);
  EXPECT_EQ(greedy->problems()[0].message, say::kLargeState(2147483647));
  EXPECT_FALSE(trial("org.example.bad.silent")->configured());
}

TEST(Catalogue, TrustsASidecarOnlyForItsOwnBinary) {
  const swage::test::TempFolder folder;
  const std::string &dir = folder.path(), bundle = dir + "/org.example.ball";
  fs::create_directories(bundle);
  fs::copy_file(library("org.example.ball"), bundle + "/org.example.ball.so");
  Catalogue::Options options;
  options.plugin_dirs = {dir};
  options.install_dir = "/nowhere";
  options.use_environment = false;

  // a sidecar of this very binary is believed, and no child runs
  Catalogue::Options no_child = options;
  no_child.describe_program = "/bin/false";
  std::vector<PluginInfo> plugins = {*catalogue().find("org.example.ball")};
  plugins[0].name = "Told by the sidecar";
  const std::string hash = content_hash(bundle + "/org.example.ball.so");
  std::ofstream(bundle + "/plugin.json") << write_sidecar("org.example.ball.so", hash, plugins);
  const Catalogue believed(no_child);
  ASSERT_NE(believed.find("org.example.ball"), nullptr);
  EXPECT_EQ(believed.find("org.example.ball")->name, "Told by the sidecar");
  EXPECT_EQ(believed.find("org.example.ball")->library_path, bundle + "/org.example.ball.so");

  // one of another binary is not: the library describes itself
  std::ofstream(bundle + "/plugin.json") << write_sidecar("org.example.ball.so", "0000000000000000", plugins);
  EXPECT_EQ(Catalogue(options).find("org.example.ball")->name, "Ball");
  EXPECT_THAT(Catalogue(no_child).plugins(), IsEmpty());
  EXPECT_EQ(Catalogue(no_child).refused()[0].reason, say::kLoadEnded());
}

// an installation writes the paths of the loader anew and may strip a library; its program stays the one that was described
TEST(Catalogue, AnInstallationKeepsTheSidecar) {
  const swage::test::TempFolder folder;
  const auto copy_with = [&](const std::string& from, const std::string& to) {
    std::ifstream in(library("org.example.ball"), std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    const std::size_t at = bytes.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    if (at != std::string::npos) bytes.replace(at, from.size(), to);
    std::ofstream(folder / "ball.so", std::ios::binary) << bytes;
    return content_hash(folder / "ball.so");
  };
  const std::string built = content_hash(library("org.example.ball"));
  EXPECT_EQ(copy_with("$ORIGIN", std::string("$ORIG\0\0", 7)), built) << "another path";
  EXPECT_NE(copy_with(std::string("Ball\0", 5), std::string("Bill\0", 5)), built) << "another program";
  fs::copy_file(library("org.example.ball"), folder / "stripped.so");
  ASSERT_EQ(std::system(("strip " + (folder / "stripped.so")).c_str()), 0);
  EXPECT_EQ(content_hash(folder / "stripped.so"), built);
}

TEST(Catalogue, SearchesInOrder) {
  const swage::test::TempFolder folder;
  const std::string& root = folder.path();
  for (const char* name : {"given", "variable", "data/swage/plugins", "install"}) {
    const std::string bundle = root + "/" + name + "/org.example.ball";
    fs::create_directories(bundle);
    fs::copy_file(library("org.example.ball"), bundle + "/ball.so");
  }
  setenv("SWAGE_PLUGIN_PATH", (root + "/variable:/nowhere").c_str(), 1);
  setenv("XDG_DATA_HOME", (root + "/data").c_str(), 1);
  Catalogue::Options options;
  options.plugin_dirs = {root + "/given"};
  options.install_dir = root + "/install";
  const Catalogue all(options);
  std::vector<std::string> origins;
  for (const auto& s : all.searched())
    origins.push_back(s.origin + " " + s.dir.substr(root.size() * s.exists));
  EXPECT_THAT(origins,
              ElementsAre("--plugin-dir /given", "SWAGE_PLUGIN_PATH /variable", "SWAGE_PLUGIN_PATH /nowhere",
                          "user /data/swage/plugins", "install /install"));
  EXPECT_EQ(all.find("org.example.ball")->library_path, root + "/given/org.example.ball/ball.so");
  EXPECT_FALSE(all.find("org.example.ball")->stock);
  ASSERT_EQ(all.shadowed().size(), 3u);
  EXPECT_EQ(all.shadowed()[0].path, root + "/variable/org.example.ball/ball.so");

  // safe mode leaves strangers out
  options.safe_mode = true;
  const Catalogue safe(options);
  EXPECT_EQ(safe.searched().size(), 1u);
  EXPECT_TRUE(safe.find("org.example.ball")->stock);
  unsetenv("SWAGE_PLUGIN_PATH");
  unsetenv("XDG_DATA_HOME");
}

TEST(Catalogue, SaysWhyAPluginIsMissing) {
  const std::string text = catalogue().missing_text("org.example.bal");
  EXPECT_THAT(
      text, testing::StartsWith(say::kNotInstalled("org.example.bal") + say::kNearest("org.example.ball", "1.0.0") + say::kSearched.words(0) +
                                kBundles + say::kPlugins.words(0)));
  EXPECT_THAT(text, testing::HasSubstr(say::kPlugins.words(1) + ", /nowhere" + say::kAbsent() + say::kSearched.words(1) + say::kRefused.words(0) + "org.example.bad.bad_table, "));
  EXPECT_EQ(catalogue().missing_text("org.example.bad.crashes_on_load"),
            say::kUnusable("org.example.bad.crashes_on_load", library("org.example.bad.crashes_on_load"),
                           say::kLoadCrashed("signal 11 (Segmentation fault)")));
}
