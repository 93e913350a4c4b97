// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/lesson_draft.hpp"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QUndoCommand>
#include <algorithm>

#include "assembly/lesson_file.hpp"
#include "assembly/lesson_text.hpp"
#include "assembly/parts.hpp"
#include "console/models/qt_text.hpp"

namespace swage::console {

/// A change from one state of a draft to another.
class DraftEdit : public QUndoCommand {
 public:
  DraftEdit(LessonDraft& draft, Variant before, Variant after, const QString& words, const QString& field)
      : QUndoCommand(words), draft_(draft), before_(std::move(before)), after_(std::move(after)), field_(field) {}
  // successive edits of one field are merged
  int id() const override { return field_.isEmpty() ? -1 : 1; }
  bool mergeWith(const QUndoCommand* next) override {
    const auto* edit = static_cast<const DraftEdit*>(next);
    if (edit->field_ != field_) return false;
    after_ = edit->after_;
    setObsolete(after_ == before_);
    return true;
  }
  void redo() override {
    draft_.put(after_, !first_);
    first_ = false;
  }
  void undo() override { draft_.put(before_, true); }

 private:
  LessonDraft& draft_;
  Variant before_, after_;
  QString field_;
  bool first_ = true;
};

namespace {

using Json = nlohmann::ordered_json;

const char* list_of(LessonPart::Kind kind) {
  return kind == LessonPart::Kind::kObject ? "objects" : kind == LessonPart::Kind::kCoupling ? "couplings" : "devices";
}

QString text_of(const Json& use, const char* key) {
  const auto found = use.is_object() ? use.find(key) : use.end();
  return found != use.end() && found->is_string() ? QString::fromStdString(found->get<std::string>()) : QString();
}

// in display order
QVector<LessonPart> parts_of(const assembly::LessonFile& lesson) {
  using Kind = LessonPart::Kind;
  QVector<LessonPart> out;
  for (const assembly::LessonObject& o : lesson.objects) out += LessonPart{Kind::kObject, qt(o.name), qt(o.plugin), {}};
  for (const assembly::LessonCoupling& c : lesson.couplings)
    out += LessonPart{Kind::kCoupling, qt(c.name), qt(c.plugin), {qt(c.a), qt(c.b)}};
  for (const assembly::LessonDevice& d : lesson.devices)
    out += LessonPart{Kind::kDevice, qt(d.name), qt(d.choices.front().plugin), {}};
  return out;
}

}  // namespace

LessonDraft::LessonDraft(const Variant& begin, const QString& file, QObject* parent)
    : QObject(parent), begin_(begin), now_(begin), file_(file) {
  QFile before(file_);
  if (!before.open(QIODevice::ReadOnly)) return;
  std::optional<Variant> kept = read_variant(before.readAll());
  if (!kept) return;
  const QString base = QDir::cleanPath(QFileInfo(QFileInfo(file_).dir(), kept->base).absoluteFilePath());
  if (base != QDir::cleanPath(QFileInfo(begin_.base).absoluteFilePath())) return;
  kept->base = begin_.base;
  taken_up_ = !(*kept == begin_);
  if (taken_up_) change(std::move(*kept), tr("Changes from before"), {});
}

bool LessonDraft::words_changed() const {
  return now_.title != begin_.title || now_.summary != begin_.summary || now_.goal != begin_.goal;
}

void LessonDraft::change(Variant after, const QString& words, const QString& field) {
  if (after == now_) return;
  edits_.push(new DraftEdit(*this, now_, std::move(after), words, field));
}

void LessonDraft::put(const Variant& now, bool by_undo) {
  const bool structure = now.remove != now_.remove || now.add != now_.add;
  now_ = now;
  Q_EMIT edited(structure, by_undo);
}

void LessonDraft::set_title(const QString& title) {
  Variant after = now_;
  after.title = title;
  change(std::move(after), tr("Title"), QStringLiteral("title"));
}

void LessonDraft::set_summary(const QString& summary) {
  Variant after = now_;
  after.summary = summary;
  change(std::move(after), tr("Task"), QStringLiteral("summary"));
}

void LessonDraft::set_goal(const QString& goal) {
  Variant after = now_;
  after.goal = goal;
  change(std::move(after), tr("Learning goal"), QStringLiteral("goal"));
}

void LessonDraft::set_view(const QString& view) {
  Variant after = now_;
  after.view = view;
  change(std::move(after), tr("View at the start"), QStringLiteral("view"));
}

void LessonDraft::set_values(const QVector<std::pair<std::string, std::string>>& set, const QString& field) {
  Variant after = now_;
  after.set = set;
  change(std::move(after), tr("Value"), QStringLiteral("value ") + field);
}

void LessonDraft::add_part(LessonPart::Kind kind, const Json& part) {
  Variant after = now_;
  after.add[list_of(kind)].push_back(part);
  change(std::move(after), tr("Add %1").arg(text_of(part, "name")), {});
}

QStringList LessonDraft::remove_part(const QString& name) {
  QStringList with_it;
  for (const LessonPart& part : parts())
    if (part.between.contains(name) && part.name != name) with_it += part.name;
  Variant after = now_;
  for (const QString& gone : QStringList(name) + with_it) {
    const std::string id = gone.toStdString();
    bool own = false;
    for (auto& [list, added] : after.add.items())
      for (std::size_t i = 0; !own && i < added.size(); ++i)
        if ((own = text_of(added[i], "name") == gone)) added.erase(i);
    if (!own) after.remove.push_back(id);
    after.set.removeIf([&](const auto& value) { return value.first.starts_with(id + "."); });
  }
  const auto empty = [](const Json& list) { return list.empty(); };
  if (std::all_of(after.add.begin(), after.add.end(), empty)) after.add = Json();
  change(std::move(after), tr("Remove %1").arg(name), {});
  return with_it;
}

QVector<LessonPart> LessonDraft::parts() const {
  assembly::LessonText whole;
  base::Problems told_elsewhere;
  assembly::read_lesson_text(begin_.base.toStdString(), {}, whole, told_elsewhere);
  assembly::Places none;
  if (!now_.remove.empty()) assembly::remove_parts({now_.remove, none, ""}, whole.json, none, told_elsewhere);
  if (!now_.add.empty()) assembly::add_parts({now_.add, none, ""}, whole.json, none, told_elsewhere);
  assembly::LessonFile lesson;
  assembly::parse_lesson(whole.json.dump(), begin_.base.toStdString(), lesson, told_elsewhere);
  return parts_of(lesson);
}

QString LessonDraft::free_name(const QString& plugin) const {
  QStringList taken{QStringLiteral("lesson"), QStringLiteral("environment")};
  for (const LessonPart& part : parts()) taken += part.name;
  const QString word = QString::fromStdString(assembly::last_word(plugin.toStdString()));
  QString name = word;
  for (int n = 2; taken.contains(name); ++n) name = QStringLiteral("%1_%2").arg(word).arg(n);
  return name;
}

QString LessonDraft::write() const {
  const QString folder = QFileInfo(file_).absolutePath();
  if (!QDir().mkpath(folder)) return tr("The folder %1 cannot be made.").arg(folder);
  return write_whole(file_, variant_text(now_, folder));
}

QString LessonDraft::write_parts(const QString& parts_file) const {
  Variant parts = now_;
  parts.set.clear();
  return write_whole(parts_file, variant_text(parts, QFileInfo(parts_file).absolutePath()));
}

void LessonDraft::end() const { QFile::remove(file_); }

}  // namespace swage::console
