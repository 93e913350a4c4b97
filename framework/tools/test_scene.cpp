// SPDX-License-Identifier: Apache-2.0
#include "tools/test_scene.hpp"

#include <algorithm>
#include <exception>
#include <nlohmann/json.hpp>

#include "host/guard.hpp"
#include "host/instance.hpp"
#include "host/nearest.hpp"
#include "tools/sentences.hpp"

namespace swage::tools {

namespace {

assembly::PluginUse use_of(const std::string& plugin, const std::string& params, const std::string& pointer) {
  assembly::PluginUse use;
  use.plugin = plugin;
  use.params = params;
  use.pointer = pointer;
  return use;
}

assembly::LessonObject object(const std::string& name, const std::string& plugin, const std::string& params,
                              const swage_vec3& at) {
  assembly::LessonObject out;
  static_cast<assembly::PluginUse&>(out) = use_of(plugin, params, "/objects");
  out.name = name;
  out.X_WO.p = at;
  return out;
}

assembly::LessonDevice device(const std::string& plugin, const std::string& params) {
  assembly::LessonDevice out;
  out.name = "hand";
  out.choices.emplace_back();
  static_cast<assembly::PluginUse&>(out.choices[0]) = use_of(plugin, params, "/devices/0");
  return out;
}

assembly::LessonCoupling coupling(const std::string& name, const std::string& plugin,
                                  const std::string& params, bool with_itself = false) {
  assembly::LessonCoupling out;
  static_cast<assembly::PluginUse&>(out) = use_of(plugin, params, "/couplings");
  out.name = name;
  out.a = "a";
  out.b = with_itself ? "a" : "b";
  return out;
}

assembly::LessonFile empty_lesson() {
  assembly::LessonFile f;
  f.id = "org.example.test_scene";
  f.title = "Test scene";
  f.seed = 1;
  return f;
}

// a hand that holds the instrument at rest
class StillHand final : public step::DevicePort {
 public:
  explicit StillHand(const swage_vec3& at) : at_(at) {}
  void read(uint64_t step, double time_s, swage_sample& sample) noexcept override {
    sample = {};
    sample.sequence = step + 1;
    sample.time_s = time_s;
    sample.pose = {at_, {1, 0, 0, 0}};
    sample.valid = SWAGE_VALID_POSE | SWAGE_VALID_CLOSURE;
  }
  void send(const step::ToolForce&) noexcept override {}

 private:
  const swage_vec3 at_;
};

// "a, b" -> {"a", "b"}; empty when the text does not consist of names
std::vector<std::string> names_in(const std::string& text) {
  std::vector<std::string> names(1);
  for (const char c : text) {
    const bool usual = c == '_' || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (!usual && c != ',' && c != ' ') return {};
    if (c == ',') names.emplace_back();
    if (usual) names.back() += c;
  }
  std::erase(names, std::string());
  return names;
}

template <class T>
bool finite(const std::vector<T>& values) {
  static_assert(sizeof(T) % sizeof(double) == 0);
  return host::finite(reinterpret_cast<const double*>(values.data()),
                      values.size() * sizeof(T) / sizeof(double));
}

}  // namespace

std::string Stepped::fault() const {
  const scene::World& w = engine->world();
  for (const host::Instance* instance : host::instances(*rig))
    if (instance->quarantined.load() != 0) return host::quarantine_text(*instance);
  if (finite(w.X_WB) && finite(w.V_WB) && finite(w.particle_p_W) && finite(w.particle_v_W) &&
      finite(w.hinge_angle) && finite(w.plugin_state) && finite(w.signal))
    return "";
  return say::kWorldNotFinite(w.step);
}

std::string Stepped::run(uint64_t steps) {
  for (uint64_t i = 0; i < steps; ++i) {
    engine->step();
    if (std::string f = fault(); !f.empty()) return f;
  }
  return "";
}

TestScene::TestScene(const host::PluginInfo& plugin, const host::Catalogue& catalogue)
    : plugin_(plugin), catalogue_(catalogue) {
  const host::PluginInfo* mouse = catalogue.find("swage.device.mouse");
  if (mouse != nullptr) hand_ = mouse->id;
  // required texts of a lesson name objects, which this scene provides
  const bool needs = std::any_of(plugin.params.begin(), plugin.params.end(), [&](const auto& p) {
    return p.required() && !(plugin.kind == SWAGE_KIND_LESSON && p.type == SWAGE_PARAM_TEXT);
  });
  if (needs) {
    skipped_ = say::kNeedsParams();
  } else {
    find_led();
    if (plugin.kind == SWAGE_KIND_COUPLING) find_pair();
    if (plugin.kind == SWAGE_KIND_LESSON) find_stage();
    find_thread();
  }
}

TestScene::TestScene(const host::PluginInfo& plugin, const host::Catalogue& catalogue, const assembly::LessonFile& lesson)
    : plugin_(plugin), catalogue_(catalogue), lesson_(&lesson) {
  const assembly::LessonFile f = lesson_file({});
  std::vector<const assembly::PluginUse*> uses = {&f.lesson};
  for (const auto& o : f.objects) uses.push_back(&o);
  for (const auto& c : f.couplings) uses.push_back(&c);
  for (const auto& d : f.devices) uses.push_back(&d.choices[0]);
  const bool used = std::any_of(uses.begin(), uses.end(), [&](const auto* use) { return use->plugin == plugin.id; });
  std::string why;
  if (!used)
    skipped_ = say::kLessonWithout(lesson.path);
  else if (!assembles(f, why))
    skipped_ = say::kLessonNotBuilt(lesson.path, why);
  else
    find_thread();
}

uint32_t TestScene::subject(const Wish& wish) const {
  if (lesson_ == nullptr) return wish.with_neighbour ? 1 : 0;
  for (uint32_t i = 0; i < lesson_->objects.size(); ++i)
    if (lesson_->objects[i].plugin == plugin_.id) return i;
  return 0;
}

// the lesson's file, with the wished parameters at every use of the plugin; a device under test becomes the first choice
assembly::LessonFile TestScene::lesson_file(const Wish& wish) const {
  assembly::LessonFile f = *lesson_;
  const auto give = [&](assembly::PluginUse& use) {
    if (use.plugin != plugin_.id) return;
    nlohmann::json all = nlohmann::json::parse(use.params, nullptr, false);
    if (!all.is_object()) all = nlohmann::json::object();
    all.update(nlohmann::json::parse(wish.params));
    use.params = all.dump();
  };
  for (auto& object : f.objects) give(object);
  for (auto& coupling : f.couplings) give(coupling);
  give(f.lesson);
  for (auto& device : f.devices) {
    const auto own = std::find_if(device.choices.begin(), device.choices.end(),
                                  [&](const auto& choice) { return choice.plugin == plugin_.id; });
    if (own != device.choices.end()) std::iter_swap(device.choices.begin(), own);
    for (auto& choice : device.choices) give(choice);
  }
  return f;
}

void TestScene::find_thread() {
  base::Problems ignored;
  if (plugin_.kind != SWAGE_KIND_DEVICE || !skipped_.empty()) return;
  const auto rig = assembly::assemble(file({}), catalogue_, {}, ignored);
  if (!rig) return;
  for (const host::DeviceSlot& slot : rig->devices)
    if (slot.instance->plugin_id == plugin_.id) on_thread_ = (slot.device->flags & SWAGE_DEVICE_LOCKSTEP) == 0;
}

bool TestScene::assembles(const assembly::LessonFile& file, std::string& error) const {
  base::Problems problems;
  if (assembly::assemble(file, catalogue_, {}, problems) != nullptr) return true;
  for (const base::Problem& p : problems)
    if (p.severity == base::Severity::kError) error = p.message;
  return false;
}

bool TestScene::follows(const std::string& object_plugin) const {
  return std::find(led_.begin(), led_.end(), object_plugin) != led_.end();
}

// finds objects that follow a hand
void TestScene::find_led() {
  std::string ignored;
  if (hand_.empty()) return;
  for (const host::PluginInfo* p : catalogue_.of_kind(SWAGE_KIND_OBJECT)) {
    assembly::LessonFile f = empty_lesson();
    f.objects.push_back(object("subject", p->id, "{}", {}));
    if (assembles(f, ignored)) continue;
    f.objects.back().follow_pose = f.objects.back().follow_closure = "hand";
    f.devices.push_back(device(hand_, "{}"));
    if (assembles(f, ignored)) led_.push_back(p->id);
  }
}

// finds the first two objects that the coupling can bind, or one with itself, if necessary with a coupling that detects their contacts
void TestScene::find_pair() {
  std::string why = say::kNoObject(), last;
  const std::string finders[] = {"", "swage.coupling.contact"};
  for (const host::PluginInfo* a : catalogue_.of_kind(SWAGE_KIND_OBJECT))
    for (const host::PluginInfo* b : catalogue_.of_kind(SWAGE_KIND_OBJECT))
      for (const std::string& finder : finders) {
        if (!finder.empty() && catalogue_.find(finder) == nullptr) continue;
        between_[0] = a->id;
        between_[1] = b->id;
        finder_ = finder;
        if (assembles(file({}), last)) return;
        why = last;
      }
  for (const host::PluginInfo* a : catalogue_.of_kind(SWAGE_KIND_OBJECT))
    for (const std::string& finder : finders) {
      if (!finder.empty() && catalogue_.find(finder) == nullptr) continue;
      between_[0] = a->id, between_[1].clear(), finder_ = finder;
      if (assembles(file({}), last)) return;
    }
  skipped_ = say::kNoPair(why);
}

bool TestScene::is_a(const std::string& object_plugin, const char* trait) const {
  const host::PluginInfo* p = catalogue_.find(object_plugin);
  return p != nullptr && std::find(p->traits.begin(), p->traits.end(), trait) != p->traits.end();
}

bool TestScene::is_led() const {
  const assembly::LessonFile f = file({});
  return std::any_of(f.objects.begin(), f.objects.end(),
                     [](const auto& o) { return !o.follow_pose.empty(); });
}

// Finds objects for a lesson. Its text parameters are taken as names of objects, and bind() accepts or refuses the plugins: every
// assignment of installed plugins to names is tried until one is accepted.
void TestScene::find_stage() {
  constexpr std::size_t kMostCasts = 400;
  std::vector<std::string> plugins;
  for (const host::PluginInfo* p : catalogue_.of_kind(SWAGE_KIND_OBJECT)) plugins.push_back(p->id);
  for (const host::Param& p : plugin_.params) {
    if (p.type != SWAGE_PARAM_TEXT || (!p.required() && p.default_text.empty())) continue;
    std::vector<std::string> names = names_in(p.default_text);
    if (names.empty()) names.push_back("thing_" + std::to_string(stage_.size() + 1));
    casting_[p.id] = host::join(names);
    for (const std::string& name : names) stage_.push_back({name, ""});
  }
  std::string why = say::kNoObject();
  std::size_t casts = 1;
  for (std::size_t i = 0; i < stage_.size(); ++i) casts *= plugins.size();
  for (std::size_t cast = 0; cast < std::min(casts, kMostCasts); ++cast) {
    std::size_t rest = cast;
    for (Actor& actor : stage_) {
      actor.plugin = plugins[rest % plugins.size()];
      rest /= plugins.size();
    }
    if (assembles(file({}), why)) return;
  }
  skipped_ = say::kNoCast(why);
}

// the wished parameters, with the names of the objects
std::string TestScene::stage_params(const std::string& wished) const {
  nlohmann::json all = nlohmann::json::parse(wished);
  for (const auto& [id, name] : casting_) all[id] = name;
  return all.dump();
}

void TestScene::set_stage(assembly::LessonFile& f, const Wish& wish) const {
  // 10 characteristic lengths apart
  for (std::size_t i = 0; i < stage_.size(); ++i)
    f.objects.push_back(object(stage_[i].name, stage_[i].plugin, "{}",
                               {wish.at.x + 0.01 * static_cast<double>(i), wish.at.y, wish.at.z}));
  // every gripper gets contact and grasp with every graspable object
  for (const Actor& a : stage_)
    for (const Actor& b : stage_) {
      if (!is_a(a.plugin, SWAGE_TRAIT_GRIPPER) || !is_a(b.plugin, SWAGE_TRAIT_GRASPABLE)) continue;
      for (const std::string& what : {std::string("contact"), std::string("grasp")}) {
        if (catalogue_.find("swage.coupling." + what) == nullptr) continue;
        f.couplings.push_back(coupling(what + "_" + b.name, "swage.coupling." + what, "{}"));
        f.couplings.back().a = a.name;
        f.couplings.back().b = b.name;
      }
    }
  static_cast<assembly::PluginUse&>(f.lesson) = use_of(plugin_.id, stage_params(wish.params), "/lesson");
}

assembly::LessonFile TestScene::file(const Wish& wish) const {
  if (lesson_ != nullptr) return lesson_file(wish);
  // m, 100 characteristic lengths: too far for any interaction
  constexpr double kFar = 0.1;
  assembly::LessonFile f = empty_lesson();
  if (plugin_.kind == SWAGE_KIND_OBJECT) {
    if (wish.with_neighbour)
      f.objects.push_back(
          object("neighbour", plugin_.id, wish.params, {wish.at.x + kFar, wish.at.y, wish.at.z}));
    f.objects.push_back(object("subject", plugin_.id, wish.params, wish.at));
  } else if (plugin_.kind == SWAGE_KIND_COUPLING) {
    f.objects.push_back(object("a", between_[0], "{}", wish.at));
    const bool with_itself = between_[1].empty();
    if (!with_itself) f.objects.push_back(object("b", between_[1], "{}", wish.at));
    if (!finder_.empty()) f.couplings.push_back(coupling("finder", finder_, "{}", with_itself));
    f.couplings.push_back(coupling("subject", plugin_.id, wish.params, with_itself));
  } else if (plugin_.kind == SWAGE_KIND_LESSON) {
    set_stage(f, wish);
  } else {
    f.devices.push_back(device(plugin_.id, wish.params));
  }
  for (assembly::LessonObject& o : f.objects) {
    if (!follows(o.plugin)) continue;
    o.follow_pose = o.follow_closure = "hand";
    if (f.devices.empty()) f.devices.push_back(device(hand_, "{}"));
  }
  return f;
}

bool TestScene::make(const Wish& wish, Stepped& out, std::string& error) const {
  base::Problems problems;
  out.engine.reset();
  out.rig = assembly::assemble(file(wish), catalogue_, {}, problems);
  error = out.rig ? "" : say::kRefusedSilently();
  for (const base::Problem& p : problems)
    if (p.severity == base::Severity::kError) error = p.message;
  if (!out.rig) return false;

  std::vector<step::DevicePort*> ports;
  if (lesson_ != nullptr || plugin_.kind == SWAGE_KIND_DEVICE) {
    // the engine calls LOCKSTEP devices itself; devices with a thread of their own are replaced by a hand at rest
    out.still = std::make_unique<StillHand>(wish.at);
    // the wished hand replaces the device under test, or the first device
    const auto subject = std::find_if(out.rig->devices.begin(), out.rig->devices.end(),
                                      [&](const auto& slot) { return slot.instance->plugin_id == plugin_.id; });
    const std::size_t led = subject == out.rig->devices.end() ? 0 : static_cast<std::size_t>(subject - out.rig->devices.begin());
    for (const host::DeviceSlot& slot : out.rig->devices) {
      const bool in_step = (slot.device->flags & SWAGE_DEVICE_LOCKSTEP) != 0;
      ports.push_back(wish.hand != nullptr && ports.size() == led ? wish.hand : in_step ? nullptr : out.still.get());
    }
  } else if (!out.rig->devices.empty()) {
    out.still = std::make_unique<StillHand>(wish.at);
    ports.push_back(wish.hand != nullptr ? wish.hand : out.still.get());
  }
  try {
    out.engine = std::make_unique<step::Engine>(*out.rig, step::Options{}, ports);
  } catch (const std::exception& refused) {
    error = refused.what();
    return false;
  }
  return true;
}

}  // namespace swage::tools
