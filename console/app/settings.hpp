// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QSettings>
#include <QString>

namespace swage::console {

/// What the program remembers between launches.
class Settings {
 public:
  Settings() : store_(QStringLiteral("swage"), QStringLiteral("console")) {}
  explicit Settings(const QString& file) : store_(file, QSettings::IniFormat) {}

  QString text(const char* key, const QString& otherwise = {}) const {
    return store_.value(QString::fromLatin1(key), otherwise).toString();
  }
  void set(const char* key, const QVariant& value) { store_.setValue(QString::fromLatin1(key), value); }
  QByteArray bytes(const char* key) const { return store_.value(QString::fromLatin1(key)).toByteArray(); }

 private:
  QSettings store_;
};

}  // namespace swage::console
