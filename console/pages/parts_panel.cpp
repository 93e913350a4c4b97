// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/parts_panel.hpp"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QRegularExpressionValidator>
#include <QShortcut>
#include <algorithm>

#include "console/models/said.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

using Kind = LessonPart::Kind;
using Json = nlohmann::ordered_json;

constexpr double kFarthest_mm = 100;  // largest coordinate: a scene is some centimetres wide

int32_t kind_of(Kind kind) {
  return kind == Kind::kObject ? SWAGE_KIND_OBJECT : kind == Kind::kCoupling ? SWAGE_KIND_COUPLING : SWAGE_KIND_DEVICE;
}

QString title_of(const host::Catalogue& catalogue, const QString& plugin) {
  const host::PluginInfo* found = catalogue.find(plugin.toStdString());
  return found != nullptr ? said(found->name, found->bundle_dir) : plugin;
}

/// True for plugins with a text or file parameter that has no default, which the form cannot fill in.
bool needs_words(const host::PluginInfo& plugin) {
  return std::any_of(plugin.params.begin(), plugin.params.end(), [](const host::Param& p) {
    return p.required() && (p.type == SWAGE_PARAM_TEXT || p.type == SWAGE_PARAM_FILE);
  });
}

}  // namespace

PartDialog::PartDialog(Kind kind, const LessonDraft& draft, const host::Catalogue& catalogue, QWidget* parent)
    : QDialog(parent), kind_(kind), draft_(draft), parts_(draft.parts()) {
  setObjectName(QStringLiteral("part"));
  setWindowTitle(kind == Kind::kObject ? tr("Add an object") : kind == Kind::kCoupling ? tr("Add a coupling") : tr("Add a device"));
  auto* column = new QVBoxLayout(this);
  form_ = new QFormLayout;
  plugin_ = new QComboBox(this);
  plugin_->setObjectName(QStringLiteral("part_plugin"));
  for (const host::PluginInfo* p : catalogue.of_kind(kind_of(kind)))
    if (!needs_words(*p)) {
      plugin_->addItem(said(p->name, p->bundle_dir), QString::fromStdString(p->id));
      plugin_->setItemData(plugin_->count() - 1, said(p->summary, p->bundle_dir), Qt::ToolTipRole);
    }
  name_ = new QLineEdit(this);
  name_->setObjectName(QStringLiteral("part_name"));
  name_->setValidator(new QRegularExpressionValidator(QRegularExpression(QStringLiteral("[a-z][a-z0-9_]*")), name_));
  form_->addRow(tr("&What"), plugin_);
  form_->addRow(tr("&Name"), name_);
  if (kind == Kind::kObject) add_place();
  if (kind == Kind::kCoupling) add_pair();
  column->addLayout(form_);
  problem_ = make_muted({}, this);
  problem_->setObjectName(QStringLiteral("part_problem"));
  column->addWidget(problem_);
  auto* row = new QHBoxLayout;
  auto* cancel = make_button(tr("Cancel"), QStringLiteral("Esc"), QStringLiteral("part_cancel"), this);
  add_ = make_button(tr("Add"), QStringLiteral("Enter"), QStringLiteral("part_add"), this);
  add_->setDefault(true);
  row->addStretch(1);
  row->addWidget(cancel);
  row->addWidget(add_);
  column->addLayout(row);
  setMinimumWidth(420);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(add_, &QPushButton::clicked, this, &QDialog::accept);
  const auto propose = [this] { name_->setText(draft_.free_name(plugin_->currentData().toString())); };
  connect(plugin_, &QComboBox::currentIndexChanged, this, propose);
  connect(name_, &QLineEdit::textChanged, this, &PartDialog::check);
  propose();
  check();
}

void PartDialog::add_place() {
  auto* row = new QHBoxLayout;
  const QStringList axes{tr("x"), tr("y"), tr("z")};
  for (int i = 0; i < 3; ++i) {
    auto* at = new QDoubleSpinBox(this);
    at->setObjectName(QStringLiteral("part_at_%1").arg(i));
    at->setAccessibleName(tr("Place, %1").arg(axes[i]));
    at->setRange(-kFarthest_mm, kFarthest_mm);
    at->setDecimals(2);
    at->setPrefix(axes[i] + QChar(0x2007));
    at->setSuffix(QChar(0x202f) + QStringLiteral("mm"));
    row->addWidget(at, 1);
    at_ += at;
  }
  auto* label = new QLabel(tr("&Place"), this);
  label->setBuddy(at_.first());  // without a buddy the label would show its mnemonic's ampersand
  form_->addRow(label, row);
  follows_ = new QComboBox(this);
  follows_->setObjectName(QStringLiteral("part_follows"));
  follows_->addItem(tr("Nothing: it stands or moves by itself"));
  for (const LessonPart& part : parts_)
    if (part.kind == Kind::kDevice) follows_->addItem(said_id(part.name.toStdString()), part.name);
  form_->addRow(tr("Led &by"), follows_);
}

void PartDialog::add_pair() {
  const auto box = [this](const char* name, const QString& label, int index) {
    auto* objects = new QComboBox(this);
    objects->setObjectName(QString::fromLatin1(name));
    for (const LessonPart& part : parts_)
      if (part.kind == Kind::kObject) objects->addItem(said_id(part.name.toStdString()), part.name);
    objects->setCurrentIndex(std::min(index, objects->count() - 1));
    connect(objects, &QComboBox::currentIndexChanged, this, &PartDialog::check);
    form_->addRow(label, objects);
    return objects;
  };
  a_ = box("part_a", tr("B&etween"), 0);
  b_ = box("part_b", tr("a&nd"), 1);
}

void PartDialog::check() {
  if (!add_) return;
  const QString name = name_->text();
  const bool taken = std::any_of(parts_.begin(), parts_.end(), [&](const LessonPart& p) { return p.name == name; });
  QString problem;
  if (plugin_->count() == 0) problem = tr("Nothing of that kind is installed.");
  if (name.isEmpty()) problem = tr("A part has a name: lower-case letters, digits and _.");
  if (taken || name == QLatin1String("lesson") || name == QLatin1String("environment"))
    problem = tr("There is a part called \"%1\" already.").arg(name);
  if (a_ && (a_->count() < 2 || a_->currentIndex() == b_->currentIndex())) problem = tr("A coupling binds two objects.");
  problem_->setText(problem);
  add_->setEnabled(problem.isEmpty());
}

Json PartDialog::part() const {
  Json part;
  part["name"] = name_->text().toStdString();
  part["plugin"] = plugin_->currentData().toString().toStdString();
  if (kind_ == Kind::kCoupling) part["between"] = {a_->currentData().toString().toStdString(), b_->currentData().toString().toStdString()};
  if (kind_ != Kind::kObject) return part;
  Json p = Json::array();
  for (const QDoubleSpinBox* at : at_) p.push_back(QString::number(at->value()).toStdString() + " mm");
  part["pose"]["p"] = p;
  const std::string device = follows_->currentData().toString().toStdString();
  if (!device.empty()) part["follows"] = {{"pose", device}, {"closure", device}};
  return part;
}

PartsPanel::PartsPanel(LessonDraft* draft, const host::Catalogue* catalogue, QWidget* parent)
    : QFrame(parent), draft_(draft), catalogue_(catalogue) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  Card card = make_card(tr("Parts"), this);
  list_ = new QListWidget(card.frame);
  list_->setObjectName(QStringLiteral("parts"));
  list_->setAccessibleName(tr("Parts"));
  list_->setMinimumHeight(90);
  card.body->addWidget(list_, 1);
  auto* row = new QHBoxLayout;
  const auto button = [&](const QString& words, const char* key, const char* name, auto&& call) {
    auto* made = make_button(words, {}, QString::fromLatin1(name), card.frame);  // without its key, to leave room for the values
    give_key(made, QString::fromLatin1(key));
    made->setAutoDefault(false);
    connect(made, &QPushButton::clicked, this, call);
    row->addWidget(made);
    return made;
  };
  row->addWidget(make_muted(tr("Add"), card.frame));
  button(tr("Object…"), "Ctrl+Shift+O", "add_object", [this] { add(Kind::kObject); });
  button(tr("Coupling…"), "Ctrl+Shift+C", "add_coupling", [this] { add(Kind::kCoupling); });
  button(tr("Device…"), "Ctrl+Shift+D", "add_device", [this] { add(Kind::kDevice); });
  row->addStretch(1);
  remove_ = button(tr("Remove"), "Ctrl+Del", "remove_part", [this] { remove(); });
  auto* key = new QShortcut(QKeySequence(Qt::Key_Delete), list_, nullptr, nullptr, Qt::WidgetShortcut);
  connect(key, &QShortcut::activated, this, &PartsPanel::remove);
  card.body->addLayout(row);
  column->addWidget(card.frame);
  connect(list_, &QListWidget::currentRowChanged, this, [this](int at) { remove_->setEnabled(at >= 0); });
  refresh();
}

void PartsPanel::refresh() {
  const int at = list_->currentRow();
  list_->clear();
  for (const LessonPart& part : draft_->parts()) {
    QStringList what{title_of(*catalogue_, part.plugin)};
    QStringList between;
    for (const QString& name : part.between) between += said_id(name.toStdString());
    if (!between.isEmpty()) what += between.join(QStringLiteral(" – "));
    auto* item = new QListWidgetItem(QStringLiteral("%1: %2").arg(said_id(part.name.toStdString()), what.join(QStringLiteral(", "))), list_);
    item->setData(Qt::UserRole, part.name);
  }
  list_->setCurrentRow(std::min(at, list_->count() - 1));
  remove_->setEnabled(list_->currentRow() >= 0);
}

void PartsPanel::add(Kind kind) {
  PartDialog dialog(kind, *draft_, *catalogue_, this);
  if (dialog.exec() != QDialog::Accepted) return;
  const Json part = dialog.part();
  const QString name = QString::fromStdString(part["name"].get<std::string>());
  draft_->add_part(kind, part);
  for (int i = 0; i < list_->count(); ++i)
    if (list_->item(i)->data(Qt::UserRole).toString() == name) list_->setCurrentRow(i);
  Q_EMIT told({});
}

void PartsPanel::remove() {
  const QListWidgetItem* item = list_->currentItem();
  if (!item) return;
  QStringList words;
  for (const QString& name : draft_->remove_part(item->data(Qt::UserRole).toString())) words += said_id(name.toStdString());
  Q_EMIT told(words.isEmpty() ? QString() : tr("Its couplings were removed with it: %1.").arg(words.join(QStringLiteral(", "))));
}

}  // namespace swage::console
