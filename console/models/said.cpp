// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/said.hpp"

#include <QDebug>
#include <QFile>
#include <QFileInfo>
#include <QHash>
#include <algorithm>
#include <string_view>

#include "console/models/words.hpp"
#include "host/words.hpp"

namespace swage::console {
namespace {

struct Known {
  QString language = QStringLiteral("en");
  host::Words words;                 // of all, the first of each
  QHash<QString, host::Words> by_folder;
  base::Problems problems;
};

Known& known() {
  static Known one;
  return one;
}

// nullptr where nobody has translated it
const std::string* find(std::string_view words) {
  const auto it = known().words.find(words);
  return it == known().words.end() ? nullptr : &it->second;
}

}  // namespace

void set_words_language(const QString& language) {
  known() = {};
  known().language = language;
  // what the host itself says; it is part of the program
  QFile own(QStringLiteral(":/i18n/words_host.%1.json").arg(language));
  if (own.open(QIODevice::ReadOnly))
    host::parse_words(own.readAll().toStdString(), own.fileName().toStdString(), language.toStdString(), known().words,
                      known().problems);
}

const QString& words_language() { return known().language; }

void learn_words(const QString& folder) {
  const QString place = QFileInfo(folder).absoluteFilePath();
  if (known().language == QLatin1String("en") || known().by_folder.contains(place)) return;
  const std::string language = known().language.toStdString();
  host::Words& own = known().by_folder[place];
  base::Problems problems;
  for (const std::string& file : host::word_files(place.toStdString(), language)) host::read_words(file, language, own, problems);
  known().words.insert(own.begin(), own.end());
  for (base::Problem& p : problems) {
    qWarning().noquote() << QString::fromStdString(p.where + ": " + p.message);
    known().problems.push_back(std::move(p));
  }
}

const base::Problems& problems_of_words() { return known().problems; }

QString said(const std::string& words) {
  const std::string* found = find(words);
  return QString::fromStdString(found ? *found : words);
}

QString said(const QString& words) { return said(words.toStdString()); }

QString said(const std::string& words, const std::string& folder) {
  const auto own = known().by_folder.constFind(QFileInfo(QString::fromStdString(folder)).absoluteFilePath());
  if (own == known().by_folder.constEnd()) return said(words);
  const auto it = own->find(words);
  return it == own->end() ? said(words) : QString::fromStdString(it->second);
}

QString said_id(const std::string& id) {
  const std::string* found = find(id);
  return found ? QString::fromStdString(*found) : human_id(QString::fromStdString(id));
}

QString said_name(const judge::Name& one, const std::vector<judge::Name>& all) {
  const auto twin = [&](const judge::Name& n) { return n.id == one.id && n.owner != one.owner; };
  const QString name = said_id(one.id);
  return std::any_of(all.begin(), all.end(), twin) ? QStringLiteral("%1 (%2)").arg(name, said_id(one.owner)) : name;
}

QString said_event(const std::string& doc) { return said(std::string(host::without_value(doc))); }

}  // namespace swage::console
