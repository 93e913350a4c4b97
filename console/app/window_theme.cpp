// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/window_theme.hpp"

#include <QApplication>

#include "console/models/own_cues.hpp"

namespace swage::console {

WindowTheme::WindowTheme(const WindowPages* pages, Settings& settings) : pages_(pages), settings_(settings) {
  connect(pages->setup(), &SetupPage::themes_chosen, this, &WindowTheme::set);
}

void WindowTheme::restore(const Launch& launch) {
  const auto or_remembered = [this](const QString& given, const char* key, const char* otherwise) {
    return given.isEmpty() ? settings_.text(key, QString::fromLatin1(otherwise)) : given;
  };
  set(or_remembered(launch.theme, "theme", "light"), or_remembered(launch.cues, "cues", "thesis"));
}

void WindowTheme::remember() const {
  settings_.set("theme", ui_);
  settings_.set("cues", cues_);
}

void WindowTheme::set(const QString& ui, const QString& cues) {
  const UiTheme theme = UiTheme::stock(ui);
  const CueTheme all_cues = cue_theme(cues, theme.dark());
  ui_ = theme.id();
  cues_ = all_cues.id();
  qApp->setPalette(theme.palette());
  qApp->setStyleSheet(theme.style_sheet());
  pages_->all()->set_themes(theme, all_cues);
  pages_->setup()->show_themes(ui_, cues_);
}

CueTheme WindowTheme::cues() const { return cue_theme(cues_, UiTheme::stock(ui_).dark()); }

// A theme names the cues that come with the program; those of other plugins are shown by their roles.
CueTheme WindowTheme::cue_theme(const QString& id, bool dark) const {
  const CueTheme all = CueTheme::stock(id).with(own_cues(pages_->run()->catalogue().plugins()));
  return dark ? all.on_dark() : all;
}

}  // namespace swage::console
