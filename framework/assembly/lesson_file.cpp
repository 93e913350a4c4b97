// SPDX-License-Identifier: Apache-2.0
#include "assembly/lesson_file.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "assembly/hand_shaping.hpp"
#include "assembly/lesson_text.hpp"
#include "assembly/reader.hpp"
#include "assembly/sentences.hpp"
#include "assembly/source_map.hpp"
#include "host/environment.hpp"
#include "host/nearest.hpp"
#include "host/version.hpp"
#include "snapshot/scene_card.hpp"

namespace swage::assembly {

namespace {

constexpr const char* kFormat = "swage-lesson/1";
constexpr std::size_t kMostProblems = 200;  // of one file; further ones are reported after these are corrected
constexpr std::size_t kMostUses = 128;   // objects, couplings or devices; lessons have up to twenty
constexpr std::size_t kMostChoices = 32;  // alternatives of a device; lessons have up to five
constexpr double kLeastPull = 1e-3, kMostPull = 10;  // N; a thread of 6-0 nylon parts at 2.8 N
constexpr const char* kChannels[] = {"colour", "shape", "sound", "force"};  // bits SWAGE_CHANNEL_*

class LessonParser {
 public:
  LessonParser(LessonFile& out, base::Problems& problems)
      : out_(out), teller_{[&out](const std::string& pointer) { return out.where(pointer); }, problems} {}

  void run(const Json& json) {
    ObjectReader top(json, "", "a lesson", teller_);
    if (!read_format(top)) return;
    out_.id = top.text("id", true);
    out_.title = top.text("title", true);
    out_.summary = top.text("summary", false);
    out_.goal = top.text("goal", false);
    if (const Json* reset = top.find("reset")) read_reset(*reset, top.at("reset"));
    out_.seed = top.whole("seed", 0);
    out_.rate_hz = top.quantity("rate_hz", "Hz", 1000, 200, 10000);
    out_.scene_length = top.quantity("scene_length", "m", 1e-3, 1e-6, 10);
    out_.gravity = top.vector("gravity", "m/s2", {0, 0, -9.80665});
    if (const Json* environment = top.find("environment")) read_environment(*environment, top.at("environment"));
    out_.max_time_s = top.quantity("max_time", "s", 0, 0, 86400);
    out_.mirror = top.flag("mirror", false);
    out_.tips_only = top.flag("tips_only", false);
    if (top.find("view") != nullptr) out_.view = top.choice("view", snapshot::kViews);
    if (const Json* pull = top.find("pull")) read_pull(*pull, top.at("pull"));
    read_modes(top);
    read_requirements(top);
    top.each("devices", kMostUses, [this](const Json& j, const std::string& p) { read_device(j, p); });
    if (top.need("objects") != nullptr)
      top.each("objects", kMostUses, [this](const Json& j, const std::string& p) { read_object(j, p); });
    top.each("couplings", kMostUses, [this](const Json& j, const std::string& p) { read_coupling(j, p); });
    if (const Json* lesson = top.need("lesson")) {
      ObjectReader reader(*lesson, top.at("lesson"), "the lesson's plugin", teller_);
      read_use(reader, out_.lesson);
      reader.finish();
    }
    top.finish();
    name_couplings(json);
    check_names();
  }

 private:
  bool read_format(ObjectReader& top) {
    const std::string format = top.text("format", true);
    if (format.empty() || format == kFormat) return !format.empty();
    teller_.error(top.at("format"),
                  say::kOtherFormat(format, kFormat));
    return false;
  }

  /// Reads the words of the reset button. A longer label would widen the row of buttons below the picture.
  void read_reset(const Json& json, const std::string& pointer) {
    constexpr int kLongest = 24;  // characters
    ObjectReader reader(json, pointer, "the reset of a lesson", teller_);
    out_.reset_label = reader.text("label", true);
    out_.reset_tip = reader.text("tip", false);
    const std::string& label = out_.reset_label;
    const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };  // a character of UTF-8
    if (std::count_if(label.begin(), label.end(), begins) > kLongest) teller_.error(reader.at("label"), say::kLongLabel(kLongest));
    reader.finish();
  }

  /// Reads a medium, and quantities that differ from its defaults.
  void read_environment(const Json& json, const std::string& pointer) {
    out_.environment_text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    ObjectReader reader(json, pointer, "the environment of a lesson", teller_);
    if (reader.find("medium") == nullptr) {
      if (json.is_object()) teller_.error(pointer, say::kNoMedium());
      return;
    }
    const std::string word = reader.choice("medium", host::kMedia);
    const auto found = std::find(std::begin(host::kMedia), std::end(host::kMedia), word);
    out_.environment = host::medium(static_cast<uint32_t>(SWAGE_MEDIUM_DRY + (found - std::begin(host::kMedia))));
    out_.environment.grounded = json.is_object() && json.contains("earthed_plane") ? 1 : 0;
    for (const host::EnvironmentKey& k : host::kEnvironmentKeys)
      out_.environment.*k.member = reader.quantity(k.key, k.unit, out_.environment.*k.member, k.min, k.max);
    if (out_.environment.charge != 0 && word != host::kMedia[0]) teller_.error(reader.at("charge"), say::kNoCharge(word));
    reader.finish();
  }

  void read_pull(const Json& json, const std::string& pointer) {
    ObjectReader reader(json, pointer, "the pull of a lesson's knot", teller_);
    if (reader.need("load") != nullptr) out_.pull.load = reader.quantity("load", "N", 0, kLeastPull, kMostPull);
    out_.pull.points = reader.quantity("points", "1", 0, 0, 100 - judge::kLeastOfPassed);
    reader.finish();
  }

  void read_modes(ObjectReader& top) {
    if (top.find("mode") != nullptr) out_.mode = top.choice("mode", kModes);
    if (top.find("cues") == nullptr) return;
    out_.cues = 0;
    top.each("cues", kMostUses, [&](const Json& json, const std::string& pointer) {
      const std::string word = json.is_string() ? json.get<std::string>() : "";
      const auto found = std::find(std::begin(kChannels), std::end(kChannels), word);
      if (found == std::end(kChannels))
        return teller_.error(
            pointer, say::kNoChannel(short_dump(json)));
      out_.cues |= 1u << (found - std::begin(kChannels));
    });
  }

  void read_requirements(ObjectReader& top) {
    const Json* json = top.find("requires");
    if (json == nullptr) return;
    if (!json->is_object()) {
      teller_.error(top.at("requires"), say::kNoRequirements());
      return;
    }
    for (const auto& [id, range] : json->items()) {
      const std::string pointer = top.at("requires") + "/" + pointer_step(id);
      bool valid = false;
      if (range.is_string()) host::in_range("1", range.get<std::string>(), valid);
      if (valid) {
        out_.requirements.emplace_back(id, range.get<std::string>());
      } else {
        teller_.error(pointer, say::kNoVersions(short_dump(range)));
      }
    }
  }

  void read_use(ObjectReader& reader, PluginUse& use) {
    use.plugin = reader.text("plugin", true);
    use.pointer = reader.pointer();
    const Json* params = reader.find("params");
    use.params = params != nullptr ? params->dump(-1, ' ', false, Json::error_handler_t::replace) : "{}";
  }

  void read_device(const Json& json, const std::string& pointer) {
    ObjectReader reader(json, pointer, "a device of a lesson", teller_);
    LessonDevice device;
    device.name = reader.name("name", true);
    device.choices.emplace_back();
    read_use(reader, device.choices[0]);
    device.choices[0].as = reader.name("as", false);
    // 1e-3 to 1e3: from a lever that enlarges motion to a robot under the strongest microscope
    device.motion_scale = reader.quantity("motion_scale", "1", 1, 1e-3, 1e3);
    device.force_scale = reader.quantity("force_scale", "1", 0, 0, 1e3);
    device.X_WD0 = reader.pose("pose");
    if (const Json* filters = reader.find("filters")) read_filters(*filters, reader.at("filters"), teller_, device);
    if (const Json* reaction = reader.find("reaction")) read_reaction(*reaction, reader.at("reaction"), teller_, device.reaction);
    if (const Json* coupling = reader.find("coupling")) read_hand_coupling(*coupling, reader.at("coupling"), teller_, device.coupling);
    reader.each("or", kMostChoices, [&](const Json& j, const std::string& p) {
      ObjectReader alternative(j, p, "an alternative of a device", teller_);
      DeviceChoice choice;
      choice.as = alternative.name("as", false);
      read_use(alternative, choice);
      alternative.finish();
      device.choices.push_back(std::move(choice));
    });
    reader.finish();
    out_.devices.push_back(std::move(device));
  }

  void read_object(const Json& json, const std::string& pointer) {
    ObjectReader reader(json, pointer, "an object of a lesson", teller_);
    LessonObject object;
    object.name = reader.name("name", true);
    read_use(reader, object);
    object.X_WO = reader.pose("pose");
    if (const Json* follows = reader.find("follows")) {
      ObjectReader f(*follows, reader.at("follows"), "\"follows\"", teller_);
      object.follow_pose = f.filled("pose");
      object.follow_closure = f.filled("closure");
      f.finish();
    }
    reader.finish();
    out_.objects.push_back(std::move(object));
  }

  void read_coupling(const Json& json, const std::string& pointer) {
    ObjectReader reader(json, pointer, "a coupling of a lesson", teller_);
    LessonCoupling coupling;
    coupling.name = reader.name("name", false);
    read_use(reader, coupling);
    if (const Json* between = reader.need("between")) {
      // an empty name counts as missing: no later check would find that the coupling lacks an object
      const auto named = [](const Json& j) { return j.is_string() && !j.get_ref<const std::string&>().empty(); };
      const bool two = between->is_array() && between->size() == 2 && named((*between)[0]) &&
                       named((*between)[1]);
      if (two) {
        coupling.a = (*between)[0].get<std::string>();
        coupling.b = (*between)[1].get<std::string>();
      } else {
        teller_.error(reader.at("between"), say::kNoPair(short_dump(*between)));
      }
    }
    reader.finish();
    out_.couplings.push_back(std::move(coupling));
  }

  void name_couplings(const Json& json) {
    const std::vector<std::string> names = coupling_names(json);
    for (std::size_t i = 0; i < out_.couplings.size(); ++i) out_.couplings[i].name = names[i];
  }

  void check_names() {
    std::set<std::string> names{"lesson", "swage", "environment"};
    std::vector<std::string> devices, objects;
    const auto take = [&](const std::string& name, const std::string& pointer,
                          std::vector<std::string>* list) {
      if (name.empty()) return;
      if (!names.insert(name).second) {
        teller_.error(pointer + "/name",
                      say::kTaken(name));
      } else if (list != nullptr) {
        list->push_back(name);
      }
    };
    for (const LessonDevice& d : out_.devices) take(d.name, d.choices[0].pointer, &devices);
    for (const LessonObject& o : out_.objects) take(o.name, o.pointer, &objects);
    for (const LessonCoupling& c : out_.couplings) take(c.name, c.pointer, nullptr);

    for (const LessonDevice& d : out_.devices) check_reference(d.clutch_of, devices, "device", d.choices[0].pointer + "/filters/clutch_of");
    for (const LessonObject& o : out_.objects) {
      check_reference(o.follow_pose, devices, "device", o.pointer + "/follows/pose");
      check_reference(o.follow_closure, devices, "device", o.pointer + "/follows/closure");
    }
    for (const LessonCoupling& c : out_.couplings) {
      check_reference(c.a, objects, "object", c.pointer + "/between/0");
      check_reference(c.b, objects, "object", c.pointer + "/between/1");
    }
  }

  void check_reference(const std::string& name, const std::vector<std::string>& names,
                       const std::string& what, const std::string& pointer) {
    if (name.empty() || std::find(names.begin(), names.end(), name) != names.end()) return;
    const std::string has = names.empty() ? say::kHasNone() : say::kHas(host::join(names));
    teller_.error(pointer,
                  say::kNoSuch(what, name, host::did_you_mean(name, names), has));
  }

  LessonFile& out_;
  Teller teller_;
};

}  // namespace

std::string LessonFile::folder() const {
  std::error_code ignored;
  const std::string& file = beside.empty() ? path : beside;
  return std::filesystem::absolute(file.empty() ? "." : file, ignored).parent_path().string();
}

namespace {

/// Limits the problems of a file with a thousand faults, and adds one with the number of the others. An error stays an error.
void keep_first(base::Problems& problems, std::size_t most) {
  if (problems.size() <= most) return;
  const base::Problems rest(problems.begin() + static_cast<long>(most), problems.end());
  problems.resize(most);
  problems.push_back({base::failed(rest) ? base::Severity::kError : base::Severity::kWarning,
                      problems.back().where, say::kMore(rest.size())});
}

/// Reads on in a file with duplicate keys, so that all faults are in one list.
bool read_text(const LessonText& whole, bool good, const std::string& path, LessonFile& out,
               base::Problems& problems) {
  out = {};
  out.path = path;
  out.text = whole.text;
  out.beside = whole.beside;
  out.places = whole.places;
  const std::size_t before = problems.size();
  if (whole.readable) LessonParser(out, problems).run(whole.json);
  out.faulty = !good || std::any_of(problems.begin() + static_cast<long>(before), problems.end(),
                                    [](const base::Problem& p) { return p.severity == base::Severity::kError; });
  keep_first(problems, kMostProblems);
  return !out.faulty;
}

}  // namespace

bool parse_lesson(const std::string& text, const std::string& path, LessonFile& out,
                  base::Problems& problems) {
  LessonText whole;
  const bool good = parse_lesson_text(text, path, whole, problems);
  whole.beside.clear();
  return read_text(whole, good, path, out, problems);
}

bool read_lesson_file(const std::string& path, LessonFile& out, base::Problems& problems) {
  return read_lesson_file(path, {}, out, problems);
}

bool read_lesson_file(const std::string& path, std::span<const Setting> settings, LessonFile& out,
                      base::Problems& problems) {
  LessonText whole;
  const bool good = read_lesson_text(path, settings, whole, problems);
  return read_text(whole, good, path, out, problems);
}

}  // namespace swage::assembly
