// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/widgets/message_strip.hpp"

#include "console/models/said.hpp"

#include <QHBoxLayout>

#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

using Kind = record::StationMessage::Kind;
constexpr char kAccept[] = "F3", kDecline[] = "Shift+F3";

}  // namespace

MessageStrip::MessageStrip(QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("message_strip"));
  setProperty("card", true);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(14, 6, 14, 6);
  text_ = new QLabel(this);
  text_->setObjectName(QStringLiteral("message_words"));
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  row->addWidget(text_, 1);
  decline_ = make_button(tr("Not now"), QString::fromLatin1(kDecline), QStringLiteral("decline_message"), this);
  accept_ = make_button(tr("Read"), QString::fromLatin1(kAccept), QStringLiteral("accept_message"), this);
  row->addWidget(decline_);
  row->addWidget(accept_);
  connect(accept_, &QPushButton::clicked, this, &MessageStrip::accept);
  connect(decline_, &QPushButton::clicked, this, &MessageStrip::decline);
  show_first();
}

void MessageStrip::set_messages(const std::vector<record::StationMessage>& messages) {
  messages_ = messages;
  show_first();
}

void MessageStrip::set_running(bool running) {
  running_ = running;
  show_first();
}

QString MessageStrip::words() const {
  if (messages_.empty()) return {};
  const record::StationMessage& m = messages_.front();
  const QString who = QString::fromStdString(m.from);
  const QString what = m.kind == Kind::kLesson ? tr("next lesson: %1").arg(said(m.title)) : QString::fromStdString(m.body);
  return QStringLiteral("✉ %1: %2").arg(who, what);
}

void MessageStrip::show_first() {
  setVisible(!messages_.empty());
  if (!messages_.empty()) {
    const bool lesson = messages_.front().kind == Kind::kLesson;
    const size_t more = messages_.size() - 1;
    text_->setText(more == 0 ? words() : tr("%1   (and %2 more)").arg(words()).arg(more));
    const QString action = !lesson ? tr("Read") : running_ ? tr("Take it after this attempt") : tr("Take it");
    accept_->setText(QStringLiteral("%1   %2").arg(action, key_text(QString::fromLatin1(kAccept))));
    accept_->setAccessibleName(action);
    accept_->setEnabled(!lesson || !running_);
    decline_->setVisible(lesson);
  }
  Q_EMIT changed();
}

void MessageStrip::accept() {
  if (messages_.empty() || !accept_->isEnabled()) return;
  const record::StationMessage m = messages_.front();
  Q_EMIT answered(m, true);
}

// Declines a lesson. A text message can only be marked as read, at any time.
void MessageStrip::decline() {
  if (messages_.empty() || messages_.front().kind != Kind::kLesson) return;
  const record::StationMessage m = messages_.front();
  Q_EMIT answered(m, false);
}

}  // namespace swage::console
