// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Colours of the window, light or dark, from resources/themes.
#pragma once

#include <QColor>
#include <QHash>
#include <QPalette>
#include <QString>
#include <QStringList>

namespace swage::console {

class UiTheme {
 public:
  static UiTheme load(const QString& path, QString* error = nullptr);
  static QStringList names();  // "light", "dark", "contrast"
  static UiTheme stock(const QString& name);
  const QString& id() const { return id_; }
  const QString& title() const { return title_; }  // name shown to people
  /// Roles are the keys of the file; an unknown role is magenta, so that the error is visible.
  QColor colour(const QString& role) const { return colours_.value(role, Qt::magenta); }
  QColor operator[](const char* role) const { return colour(QString::fromLatin1(role)); }
  /// Whether text is light and backgrounds dark.
  bool dark() const { return colour(QStringLiteral("window")).lightness() < 128; }
  QPalette palette() const;
  QString style_sheet() const;

 private:
  QString id_, title_;
  QHash<QString, QColor> colours_;
};

}  // namespace swage::console
