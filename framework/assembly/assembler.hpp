// SPDX-License-Identifier: Apache-2.0
//
// The parts of assemble(), in order. Each continues after an error where possible, so that one run reports all errors.
// [main]
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "assembly/assemble.hpp"
#include "host/builder.hpp"
#include "host/tables.hpp"

namespace swage::assembly {

class Assembler {
 public:
  Assembler(const LessonFile& file, const host::Catalogue& catalogue, const Overrides& overrides,
            base::Problems& problems);

  std::unique_ptr<host::Rig> run();

 private:
  /// A plugin of the file that is installed, of the right kind and version.
  const host::PluginInfo* usable(const PluginUse& use, int32_t kind);
  void check_requirements();

  /// Creates and configures an instance. `where_params`: Problem::where for parameters, "" for their places in the
  /// file.
  std::unique_ptr<host::Instance> make(const PluginUse& use, int32_t kind, const std::string& name,
                                       uint32_t object, const swage_pose& X_WO,
                                       const std::string& where_params,
                                       std::unique_ptr<host::Builder>& builder);
  void keep_files(const std::vector<host::GivenFile>& files);
  /// Adds a stream of random numbers to the saved state. None for a device: it may run on its own thread, its numbers are not in the saved
  /// state, and a replay does not use it.
  uint32_t add_random(int32_t kind);
  /// An extension of the instance, complete; reports an error when it is needed and missing.
  template <class Table>
  const Table* table(host::Instance& instance, const char* id, const PluginUse& use, bool needed = true) {
    std::string sentence;
    const Table* found = host::find_table<Table>(instance, id, needed, sentence);
    if (!sentence.empty()) error(use.pointer + "/plugin", sentence);
    return found;
  }

  void resolve_mode();
  void settle_mode();
  void add_objects();
  void add_couplings();
  void add_devices();
  void add_lesson();

  // devices.cpp: choice among the alternatives
  const DeviceChoice* choose(const LessonDevice& device, std::size_t index);
  void resolve_override();
  static void place_hand(const LessonDevice& use, host::DeviceSlot& slot);

  // bind.cpp
  void bind_follows();
  void find_pairs();
  void sort_pairs();
  void bind_couplings();
  bool offers(const LessonCoupling& use, const host::ObjectSlot& object, const char* const* needs,
              const std::string& side);
  void bind_lesson();
  void bind_sights();
  void fill_metrics();
  void fill_card();

  void error(const std::string& pointer, const std::string& message);
  void note(base::Severity severity, const std::string& pointer, const std::string& message);
  void take_reports(host::Instance& instance, const std::string& pointer);

  const LessonFile& file_;
  const host::Catalogue& catalogue_;
  const Overrides& overrides_;
  base::Problems& problems_;
  std::unique_ptr<host::Rig> rig_;
  std::set<std::string> used_;  // plugin ids that the file names
  std::string hand_;            // name of the chosen alternative, "" for the first choice
  // the override's own choice, and the index of its device
  DeviceChoice substitute_;
  std::size_t substitute_for_ = ~std::size_t{0};
};

}  // namespace swage::assembly
