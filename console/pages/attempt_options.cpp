// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/attempt_options.hpp"

#include <utility>

#include "console/models/said.hpp"

namespace swage::console {

void AttemptOptions::set_base(const session::Options& base) {
  base_ = base;
  host::Catalogue::Options where;
  where.plugin_dirs = base.plugin_dirs;
  where.safe_mode = base.safe_mode;
  catalogue_ = host::Catalogue(where);
}

bool AttemptOptions::set_binding(const Binding& binding) {
  if (binding == binding_) return false;
  binding_ = binding;
  return true;
}

QString AttemptOptions::instrument_title() const {
  const auto name = [&](const std::string& id) {
    const host::PluginInfo* plugin = catalogue_.find(id);
    return plugin != nullptr ? said(plugin->name, plugin->bundle_dir) : QString::fromStdString(id);
  };
  QString title;
  if (binding_.any()) title = name(binding_.pose);
  if (!binding_.jaws.empty() && binding_.jaws != binding_.pose) title += QStringLiteral(" + ") + name(binding_.jaws);
  return title;
}

session::Options AttemptOptions::of(const QString& lesson_path) const {
  session::Options o = base_;
  o.lesson_path = lesson_path.toStdString();
  return o;
}

session::Options AttemptOptions::lesson(const record::Display& display) const {
  session::Options o = of(setup_.lesson());
  o.person = setup_.person().toStdString();
  o.mode = show_ ? "demo" : setup_.mode().toStdString();
  o.display = display;
  if (setup_.left_handed()) o.settings.push_back("mirror=true");
  // a demonstration is nobody's attempt and is not stored
  if (o.mode == "demo") o.store_path = ":none:";
  return o;
}

session::Options AttemptOptions::attempt(const record::Display& display, const CueTheme& cues) const {
  session::Options o = lesson(display);
  o.device = setup_.device().toStdString();
  for (const QString& meaning : cues.meanings()) {
    const CueForce f = cues.style(meaning).force;
    if (f.pulses > 0)
      o.cue_pulses.push_back({meaning.toStdString(), static_cast<uint32_t>(f.pulses), f.frequency_Hz, f.peak_N, f.length_s});
  }
  take_instrument(o, placing_ ? placing_(o.device) : std::nullopt);
  return o;
}

session::Options AttemptOptions::reader() const {
  session::Options o = of(setup_.lesson());
  o.device = setup_.device().toStdString();
  take_instrument(o, Placement{.force = false});
  return o;
}

// Applies binding and placement to the lesson's devices; the person's own instrument then stands for the lesson's first choice.
void AttemptOptions::take_instrument(session::Options& o, const std::optional<Placement>& place) const {
  const bool own = o.device == kOwnInstrument;
  for (std::string& s : instrument_settings(o.lesson_path, own ? binding_ : Binding{}, place, catalogue_)) o.settings.push_back(std::move(s));
  if (own) o.device.clear();
}

}  // namespace swage::console
