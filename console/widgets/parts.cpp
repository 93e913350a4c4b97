// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/widgets/parts.hpp"

#include <QApplication>
#include <QHeaderView>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionButton>
#include <QStylePainter>
#include <algorithm>

namespace swage::console {

QLabel* make_heading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text.toUpper(), parent);
  label->setProperty("heading", true);
  return label;
}

QLabel* make_muted(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setProperty("muted", true);
  label->setWordWrap(true);
  return label;
}

QString list_text(const QString& heading, const QStringList& lines) {
  if (lines.isEmpty()) return {};
  QString out = QStringLiteral("<p style=\"margin:6px 0 2px 0\"><b>%1</b></p><ul style=\"margin:0 0 0 12px; -qt-list-indent:0\">").arg(heading.toHtmlEscaped());
  for (const QString& line : lines) out += QStringLiteral("<li>%1</li>").arg(line.toHtmlEscaped());
  return out + QStringLiteral("</ul>");
}

Card make_card(const QString& heading, QWidget* parent) {
  auto* frame = new QFrame(parent);
  frame->setProperty("card", true);
  auto* body = new QVBoxLayout(frame);
  body->setContentsMargins(14, 12, 14, 12);
  body->setSpacing(8);
  if (!heading.isEmpty()) body->addWidget(make_heading(heading, frame));
  return {frame, body};
}

QString key_text(const QString& shortcut) { return QKeySequence(shortcut).toString(QKeySequence::NativeText); }

namespace {

const QString kBesideWords = QStringLiteral("   ");  // between words and key

template <class Button>
Button* make_button_as(const QString& text, const QString& shortcut_id, const QString& name, QWidget* parent) {
  const QString shortcut = key_text(shortcut_id);
  auto* button = new Button(shortcut.isEmpty() ? text : text + kBesideWords + shortcut, parent);
  button->setObjectName(name);
  button->setAccessibleName(text);
  // focus by keys only: a click leaves the keyboard focus to the instrument
  button->setFocusPolicy(Qt::TabFocus);
  if (!shortcut.isEmpty()) button->setToolTip(QStringLiteral("%1 (%2)").arg(text, shortcut));
  return button;
}

}  // namespace

QPushButton* make_button(const QString& text, const QString& shortcut, const QString& name, QWidget* parent) {
  return make_button_as<QPushButton>(text, shortcut, name, parent);
}

KeyedButton* make_keyed_button(const QString& text, const QString& shortcut, const QString& name, QWidget* parent) {
  auto* button = make_button_as<KeyedButton>(text, shortcut, name, parent);
  button->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);  // it may get smaller than its text with the key
  return button;
}

QString KeyedButton::words() const { return text().section(kBesideWords, 0, 0).section(QLatin1Char('\n'), 0, 0); }

QSize KeyedButton::minimumSizeHint() const {
  const QSize whole = sizeHint();
  const auto width = [this](const QString& line) { return fontMetrics().horizontalAdvance(line); };
  int wanted = 0;
  for (const QString& line : text().split(QLatin1Char('\n'))) wanted = std::max(wanted, width(line));
  return {whole.width() - wanted + width(words()), whole.height()};
}

void KeyedButton::paintEvent(QPaintEvent*) {
  QStylePainter painter(this);
  QStyleOptionButton option;
  initStyleOption(&option);
  const int room = style()->subElementRect(QStyle::SE_PushButtonContents, &option, this).width();
  for (const QString& line : option.text.split(QLatin1Char('\n')))
    if (fontMetrics().horizontalAdvance(line) > room) option.text = words();
  painter.drawControl(QStyle::CE_PushButton, option);
}

void give_key(QPushButton* button, const QString& shortcut) {
  button->setShortcut(QKeySequence(shortcut));
  const QString tip = button->toolTip().isEmpty() ? button->accessibleName() : button->toolTip();
  button->setToolTip(QStringLiteral("%1 (%2)").arg(tip, key_text(shortcut)));
}

QLineEdit* make_search(const QString& what, const QString& name, QWidget* parent) {
  auto* line = new QLineEdit(parent);
  line->setObjectName(name);
  line->setAccessibleName(what);
  line->setPlaceholderText(what);
  line->setClearButtonEnabled(true);
  for (QAbstractButton* clear : line->findChildren<QAbstractButton*>()) clear->setAccessibleName(QObject::tr("Clear the search"));
  return line;
}

namespace {

// Room between the columns as wide as a letter; the style's padding would move the text of a chosen row alone.
class RowDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    constexpr int kBetween_px = 10;
    return QStyledItemDelegate::sizeHint(option, index) + QSize(kBetween_px, 0);
  }
};

}  // namespace

QTableView* make_row_table(QAbstractItemModel* model, const QString& title, const QString& name, QWidget* parent) {
  constexpr int kRow_px = 28;
  auto* table = new QTableView(parent);
  table->setObjectName(name);
  table->setAccessibleName(title);
  table->setModel(model);
  table->setShowGrid(false);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setTabKeyNavigation(false);
  table->setItemDelegate(new RowDelegate(table));
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(kRow_px);
  table->horizontalHeader()->setHighlightSections(false);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  return table;
}

QScrollArea* make_scroll(QWidget* parent) {
  auto* scroll = new QScrollArea(parent);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  // transparent, on the page's background
  scroll->setProperty("bare", true);
  return scroll;
}

void size_as_shown(QStackedWidget* stack) {
  const auto fit = [stack] {
    for (int i = 0; i < stack->count(); ++i) {
      QWidget* page = stack->widget(i);
      page->setSizePolicy(page->sizePolicy().horizontalPolicy(), i == stack->currentIndex() ? QSizePolicy::Preferred : QSizePolicy::Ignored);
    }
  };
  QObject::connect(stack, &QStackedWidget::currentChanged, stack, fit);
  fit();
}

ElidedLabel::ElidedLabel(QWidget* parent, int most) : QLabel(parent), most_(most) {
  QSizePolicy policy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  policy.setHeightForWidth(most > 1);
  setSizePolicy(policy);
}

int ElidedLabel::heightForWidth(int width) const {
  const auto more = static_cast<int>(lines(width).size()) - 1;
  return QLabel::minimumSizeHint().height() + std::max(0, more) * fontMetrics().lineSpacing();
}

QStringList ElidedLabel::lines(int width) const {
  QStringList out;
  QString rest = text();
  while (out.size() + 1 < most_ && fontMetrics().horizontalAdvance(rest) > width) {
    qsizetype end = rest.lastIndexOf(QLatin1Char(' '));
    while (end > 0 && fontMetrics().horizontalAdvance(rest.left(end)) > width) end = rest.lastIndexOf(QLatin1Char(' '), end - 1);
    if (end <= 0) break;
    out += rest.left(end);
    rest = rest.mid(end + 1);
  }
  out += fontMetrics().elidedText(rest, Qt::ElideRight, width);
  return out;
}

void ElidedLabel::paintEvent(QPaintEvent*) {
  QPainter p(this);
  const QStringList shown = lines(width());
  style()->drawItemText(&p, rect(), Qt::AlignLeft | Qt::AlignVCenter, palette(), isEnabled(), shown.join(QLatin1Char('\n')), foregroundRole());
  if (const QString tip = shown.join(QLatin1Char(' ')) == text() ? QString() : text(); tip != toolTip()) setToolTip(tip);
}

CueBadge::CueBadge(QWidget* parent) : QWidget(parent) { setFixedSize(sizeHint()); }

void CueBadge::set_style(const CueStyle& style) {
  style_ = style;
  update();
}

void CueBadge::paintEvent(QPaintEvent*) {
  QPainter p(this);
  if (!style_.shape.isEmpty()) paint_cue_shape(p, {0, 0}, height(), style_);
}

QSize TwoLineDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const int line = option.fontMetrics.height();
  const bool two = !index.data(role_).toString().isEmpty();
  return {160, two ? 2 * line + 16 : line + 14};
}

void TwoLineDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const {
  QStyleOptionViewItem item = option;
  initStyleOption(&item, index);
  item.text.clear();
  const QStyle* style = item.widget ? item.widget->style() : QApplication::style();
  style->drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget);

  const bool selected = option.state & QStyle::State_Selected;
  const QRect r = option.rect.adjusted(12, 6, -10, -6);
  const QString summary = index.data(role_).toString();
  painter->save();
  QFont bold = option.font;
  bold.setWeight(QFont::DemiBold);
  painter->setFont(bold);
  painter->setPen(option.palette.color(selected ? QPalette::HighlightedText : QPalette::Text));
  const int line = option.fontMetrics.height();
  const QString title = index.data().toString();
  // titles of a series differ in their last words: a long title also uses the line of the summary
  if (!summary.isEmpty() && QFontMetrics(bold).horizontalAdvance(title) > r.width()) {
    painter->drawText(r.adjusted(0, -2, 0, 2), Qt::AlignVCenter | Qt::TextWordWrap, title);
    painter->restore();
    return;
  }
  painter->drawText(QRect(r.left(), summary.isEmpty() ? r.center().y() - line / 2 : r.top(), r.width(), line),
                    Qt::AlignVCenter, QFontMetrics(bold).elidedText(title, Qt::ElideRight, r.width()));
  painter->setFont(option.font);
  if (!selected) painter->setPen(option.palette.color(QPalette::PlaceholderText));
  painter->drawText(QRect(r.left(), r.top() + line + 2, r.width(), line), Qt::AlignVCenter,
                    option.fontMetrics.elidedText(summary, Qt::ElideRight, r.width()));
  painter->restore();
}

}  // namespace swage::console
