// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/cues/ui_theme.hpp"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>

#include "console/cues/theme_words.hpp"

namespace swage::console {

UiTheme UiTheme::load(const QString& path, QString* error) {
  UiTheme theme;
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) {
    if (error) *error = QStringLiteral("%1: %2").arg(path, file.errorString());
    return theme;
  }
  const QJsonObject root = QJsonDocument::fromJson(file.readAll()).object();
  if (root[QStringLiteral("format")] != QStringLiteral("swage-ui-theme/1")) {
    if (error)
      *error = QStringLiteral("%1: not a window theme: \"format\" must be \"swage-ui-theme/1\"").arg(path);
    return theme;
  }
  theme.title_ = theme_word(root[QStringLiteral("title")].toString());
  theme.id_ = root[QStringLiteral("id")].toString();
  const QJsonObject colours = root[QStringLiteral("colours")].toObject();
  for (auto it = colours.begin(); it != colours.end(); ++it) {
    theme.colours_.insert(it.key(), QColor(it.value().toString()));
  }
  return theme;
}

QStringList UiTheme::names() {
  return {QStringLiteral("light"), QStringLiteral("dark"), QStringLiteral("contrast")};
}

UiTheme UiTheme::stock(const QString& name) {
  return load(QStringLiteral(":/themes/ui_%1.json").arg(names().contains(name) ? name : names().first()));
}

QPalette UiTheme::palette() const {
  const UiTheme& t = *this;
  QPalette p;
  p.setColor(QPalette::Window, t["window"]);
  p.setColor(QPalette::WindowText, t["text"]);
  p.setColor(QPalette::Base, t["card"]);
  p.setColor(QPalette::AlternateBase, t["raised"]);
  p.setColor(QPalette::Text, t["text"]);
  p.setColor(QPalette::PlaceholderText, t["muted"]);
  p.setColor(QPalette::Button, t["raised"]);
  p.setColor(QPalette::ButtonText, t["text"]);
  p.setColor(QPalette::Highlight, t["accent"]);
  p.setColor(QPalette::HighlightedText, t["accent_text"]);
  p.setColor(QPalette::ToolTipBase, t["raised"]);
  p.setColor(QPalette::ToolTipText, t["text"]);
  p.setColor(QPalette::Mid, t["border"]);
  p.setColor(QPalette::Link, t["accent"]);
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    p.setColor(QPalette::Disabled, role, t["disabled"]);
  }
  return p;
}

QString UiTheme::style_sheet() const {
  QFile file(QStringLiteral(":/themes/console.qss"));
  if (!file.open(QIODevice::ReadOnly)) return {};
  QString sheet = QString::fromUtf8(file.readAll());
  // longest first, so that @accent is not replaced within @accent_text
  QStringList roles = colours_.keys();
  std::sort(roles.begin(), roles.end(),
            [](const QString& a, const QString& b) { return a.size() > b.size(); });
  // state is not told by colour alone: the tick contrasts with the accent colour
  const bool light = colours_.value(QStringLiteral("accent_text")).lightnessF() > 0.5;
  sheet.replace(QStringLiteral("%TICK%"), light ? QStringLiteral(":/themes/tick_light.svg") : QStringLiteral(":/themes/tick_dark.svg"));
  for (const QString& role : roles) sheet.replace(QLatin1Char('@') + role, colours_[role].name());
  return sheet;
}

}  // namespace swage::console
