// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/language.hpp"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <algorithm>
#include <memory>
#include <vector>

#include "console/models/said.hpp"

namespace swage::console {
namespace {

std::vector<std::unique_ptr<QTranslator>>& installed() {
  static std::vector<std::unique_ptr<QTranslator>> all;
  return all;
}

void install(const QString& file, const QString& folder) {
  auto translator = std::make_unique<QTranslator>();
  if (!translator->load(file, folder)) return;
  QCoreApplication::installTranslator(translator.get());
  installed().push_back(std::move(translator));
}

}  // namespace

QStringList languages() { return {QStringLiteral("en"), QStringLiteral("de")}; }

QString language_in(const QStringList& arguments) {
  const QString name = QStringLiteral("--language");
  for (qsizetype i = 0; i < arguments.size(); ++i) {
    if (arguments[i].startsWith(name + QLatin1Char('='))) return arguments[i].mid(name.size() + 1);
    if (arguments[i] == name && i + 1 < arguments.size()) return arguments[i + 1];
  }
  return {};
}

QString language_name(const QString& code) { return code == QLatin1String("de") ? QStringLiteral("Deutsch") : QStringLiteral("English"); }

QString wanted_language(const QStringList& arguments, const Settings& settings) {
  const QString given = language_in(arguments), chosen = settings.text("language");
  const bool picture = std::any_of(arguments.begin(), arguments.end(), [](const QString& a) { return a.startsWith(QLatin1String("--screenshot")); });
  return !given.isEmpty() || picture || !languages().contains(chosen) ? given : chosen;
}

bool use_language(const QString& code) {
  if (!code.isEmpty() && !languages().contains(code)) return false;
  const QString system = QLocale::system().name().left(2);
  const QString wanted = !code.isEmpty() ? code : languages().contains(system) ? system : languages().first();
  for (const auto& translator : installed()) QCoreApplication::removeTranslator(translator.get());
  installed().clear();
  if (!code.isEmpty()) QLocale::setDefault(QLocale(code));
  set_words_language(wanted);
  if (wanted == languages().first()) return true;
  // Qt's own translations (Debian's qt6-translations-l10n) where installed; ours take precedence
  install(QStringLiteral("qtbase_") + wanted, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  install(QStringLiteral("swage_") + wanted, QStringLiteral(":/i18n"));
  return true;
}

}  // namespace swage::console
