// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/said.hpp"

#include <QDebug>
#include <QFile>
#include <QFileInfo>
#include <QHash>
#include <algorithm>
#include <string_view>

#include "console/models/sentence_words.hpp"
#include "console/models/words.hpp"
#include "host/words.hpp"

namespace swage::console {
namespace {

struct Known {
  QString language;
  host::Words words;                 // from all files; of two translations the first
  host::Words english;               // English names of events and signals, used where this language has none
  QHash<QString, host::Words> by_folder;
  SentenceWords sentences{};         // of `words`
  base::Problems problems;
};

constexpr char kEnglish[] = "en";

// The host's own texts: their translations are part of the program.
Known in_language(const QString& language) {
  Known out;
  out.language = language;
  const auto read_own = [&](const QString& in, host::Words& words) {
    QFile own(QStringLiteral(":/i18n/words_host.%1.json").arg(in));
    if (own.open(QIODevice::ReadOnly))
      host::parse_words(own.readAll().toStdString(), own.fileName().toStdString(), in.toStdString(), words, out.problems);
  };
  read_own(language, out.words);
  if (language != QLatin1String(kEnglish)) read_own(QString::fromLatin1(kEnglish), out.english);
  return out;
}

Known& known() {
  static Known one = in_language(QString::fromLatin1(kEnglish));
  return one;
}

// nullptr without a translation
const std::string* find(std::string_view words) {
  const auto it = known().words.find(words);
  return it == known().words.end() ? nullptr : &it->second;
}

}  // namespace

void set_words_language(const QString& language) {
  known() = in_language(language);
  known().sentences = SentenceWords(known().words);
}

const QString& words_language() { return known().language; }

void learn_words(const QString& folder) {
  const QString place = QFileInfo(folder).absoluteFilePath();
  if (known().by_folder.contains(place)) return;
  const std::string language = known().language.toStdString();
  host::Words& own = known().by_folder[place];
  base::Problems problems;
  const auto read = [&](const std::string& in, host::Words& out) {
    for (const std::string& file : host::word_files(place.toStdString(), in)) host::read_words(file, in, out, problems);
  };
  read(language, own);
  if (language != kEnglish) read(kEnglish, known().english);
  known().words.insert(own.begin(), own.end());
  known().sentences = SentenceWords(known().words);
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

QString said_message(const std::string& message) {
  const std::string sentences = known().sentences.of(message);
  return QString::fromStdString(sentences.empty() ? message : sentences);
}

QString said_of_file(const std::string& path, const std::string& message) {
  const std::string begin = path + ": ";
  return message.starts_with(begin) ? QString::fromStdString(begin) + said_message(message.substr(begin.size())) : said_message(message);
}

QString said(const std::string& words, const std::string& folder) {
  const auto own = known().by_folder.constFind(QFileInfo(QString::fromStdString(folder)).absoluteFilePath());
  if (own == known().by_folder.constEnd()) return said(words);
  const auto it = own->find(words);
  return it == own->end() ? said(words) : QString::fromStdString(it->second);
}

QString said_id(const std::string& id) {
  if (const std::string* found = find(id)) return QString::fromStdString(*found);
  const auto english = known().english.find(id);
  return english != known().english.end() ? QString::fromStdString(english->second) : human_id(QString::fromStdString(id));
}

QString said_name(const judge::Name& one, const std::vector<judge::Name>& all) {
  const auto twin = [&](const judge::Name& n) { return n.id == one.id && n.owner != one.owner; };
  const QString name = said_id(one.id);
  return std::any_of(all.begin(), all.end(), twin) ? QStringLiteral("%1 (%2)").arg(name, said_id(one.owner)) : name;
}

QString said_event(const std::string& doc) { return said(std::string(host::without_value(doc))); }

}  // namespace swage::console
