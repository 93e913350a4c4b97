// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/widgets/plot_file.hpp"

#include <QAction>
#include <QEvent>
#include <QFocusFrame>
#include <QMessageBox>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QPixmap>
#include <QSaveFile>
#include <QSvgGenerator>

#include "console/widgets/save_file.hpp"

namespace swage::console {
namespace {

constexpr int kPng_scale = 2;      // sharp on paper and on a screen scaled to 200 %
constexpr int kPdf_dpi = 96;       // a pixel of the screen is one of the page

void draw(QWidget& plot, QPaintDevice& to, double scale) {
  QPainter p(&to);
  p.scale(scale, scale);
  plot.render(&p, {}, {}, QWidget::DrawChildren);
}

/// A frame around the plot with the keyboard focus.
class PlotFocus : public QObject {
 public:
  explicit PlotFocus(QWidget* plot) : QObject(plot), frame_(new QFocusFrame(plot)) { plot->installEventFilter(this); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::FocusIn) frame_->setWidget(static_cast<QWidget*>(watched));
    if (event->type() == QEvent::FocusOut) frame_->setWidget(nullptr);
    return false;
  }

 private:
  QFocusFrame* frame_;
};

}  // namespace

QString save_plot(QWidget& plot, const QString& file) {
  const auto failed = [&](const QString& why) { return QObject::tr("%1 cannot be written: %2.").arg(file, why); };
  QSaveFile out(file);
  if (!out.open(QIODevice::WriteOnly)) return failed(out.errorString());
  if (file.endsWith(QLatin1String(".pdf"), Qt::CaseInsensitive)) {
    QPdfWriter pdf(&out);
    pdf.setResolution(kPdf_dpi);
    pdf.setPageMargins({});
    pdf.setPageSize(QPageSize(QSizeF(plot.size()) * 25.4 / kPdf_dpi, QPageSize::Millimeter));
    draw(plot, pdf, 1);
  } else if (file.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive)) {
    QSvgGenerator svg;
    svg.setOutputDevice(&out);
    svg.setSize(plot.size());
    svg.setViewBox(QRect(QPoint(), plot.size()));
    svg.setResolution(kPdf_dpi);
    svg.setTitle(plot.accessibleName());
    svg.setDescription(plot.accessibleDescription());
    QPainter p(&svg);
    // a size in whole millimetres exceeds the plot by a fraction of a pixel
    p.fillRect(plot.rect().adjusted(0, 0, 1, 1), plot.palette().color(QPalette::Base));
    plot.render(&p, {}, {}, QWidget::DrawChildren);
  } else {
    QPixmap picture(plot.size() * kPng_scale);
    picture.fill(plot.palette().color(QPalette::Base));
    draw(plot, picture, kPng_scale);
    if (!picture.save(&out, "PNG")) return failed(QObject::tr("no room"));
  }
  return out.commit() ? QString() : failed(out.errorString());
}

void offer_picture(QWidget* plot, const QString& name) {
  auto* action = new QAction(QObject::tr("Save picture…"), plot);
  action->setObjectName(QStringLiteral("save_picture"));
  action->setShortcut(QKeySequence(QStringLiteral("Ctrl+Shift+P")));
  action->setShortcutContext(Qt::WidgetShortcut);
  plot->addAction(action);
  // the shortcut needs the keyboard focus on the plot, and the focus must be visible
  if (plot->focusPolicy() == Qt::NoFocus) {
    plot->setFocusPolicy(Qt::StrongFocus);
    new PlotFocus(plot);
  }
  plot->setContextMenuPolicy(Qt::ActionsContextMenu);
  QObject::connect(action, &QAction::triggered, plot, [plot, name] {
    const QString file = ask_save(plot, QObject::tr("Save picture"), name + QStringLiteral(".png"),
                                  QObject::tr("Picture (*.png);;Drawing (*.svg);;Page (*.pdf)"));
    if (file.isEmpty()) return;
    if (const QString problem = save_plot(*plot, file); !problem.isEmpty())
      QMessageBox::warning(plot, QObject::tr("Save picture"), problem);
  });
}

}  // namespace swage::console
