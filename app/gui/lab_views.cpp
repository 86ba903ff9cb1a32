#include "app/gui/lab_views.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/error_legend.h"
#include "app/gui/lab_colours.h"
#include "app/gui/lab_side.h"
#include "planning/case/structure_mask.h"
#include "viewer/error_colours.h"

namespace glisson {

namespace {

constexpr Rgb kVoxelColour{240, 240, 240};

Rgb toRgb(const QColor& colour) {
  return {static_cast<std::uint8_t>(colour.red()), static_cast<std::uint8_t>(colour.green()),
          static_cast<std::uint8_t>(colour.blue())};
}

/// Kept free for the numbers while there are none: the views must not change their size when a model is chosen.
constexpr int kNumberLines = 7;

/// A or B in its colour, as rich text.
QString badgeText(std::size_t side, const QString& letter) {
  return QStringLiteral("<b style=\"background:%1;color:#101010\">&nbsp;%2&nbsp;</b>").arg(kLabColours[side].name(), letter);
}

}  // namespace

LabViews::LabViews(Document& document, std::array<LabSide*, 2> sides, QWidget* parent)
    : Translated<QWidget>(parent),
      document_(document),
      sides_(sides),
      looks_(new QButtonGroup(this)),
      wireframe_(new QCheckBox(this)),
      legend_(new ErrorLegend(this)),
      pages_(new QStackedWidget(this)) {
  setObjectName("labViews");
  build();
  SurfaceView::link(*views_[0], *views_[1]);
  connect(looks_, &QButtonGroup::idClicked, this, [this](int id) { setLook(static_cast<LabLook>(id)); });
  connect(wireframe_, &QCheckBox::toggled, this, [this](bool wires) {
    for (SurfaceView* view : views_) {
      view->setWireframe(wires);
    }
  });
  for (SliceView* slice : slices_) {
    connect(slice, &SliceView::crosshairMoved, this, &LabViews::setCrosshair);
    connect(slice, &SliceView::windowLevelChanged, this, [this](const WindowLevel& windowLevel) {
      for (SliceView* other : slices_) {
        other->setWindowLevel(windowLevel);
      }
    });
  }
  for (LabSide* side : sides_) {
    connect(side, &LabSide::changed, this, &LabViews::refresh);
  }
  retranslateUi();
}

void LabViews::build() {
  constexpr std::array kLookNames{"labSideBySide", "labSwipe", "labSlices"};
  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(4, 2, 4, 2);
  for (std::size_t n = 0; n < lookButtons_.size(); ++n) {
    lookButtons_[n] = new QToolButton(this);
    lookButtons_[n]->setObjectName(kLookNames[n]);
    lookButtons_[n]->setCheckable(true);
    looks_->addButton(lookButtons_[n], static_cast<int>(n));
    bar->addWidget(lookButtons_[n]);
  }
  lookButtons_[0]->setChecked(true);
  wireframe_->setObjectName("labWireframe");
  bar->addSpacing(8);
  bar->addWidget(wireframe_);
  bar->addStretch(1);
  bar->addWidget(legend_);

  auto* surfaces = new QWidget(pages_);
  auto* row = new QHBoxLayout(surfaces);
  auto* slices = new QWidget(pages_);
  auto* sliceRow = new QHBoxLayout(slices);
  for (QHBoxLayout* layout : {row, sliceRow}) {
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
  }
  for (std::size_t side = 0; side < views_.size(); ++side) {
    views_[side] = new SurfaceView(surfaces);
    views_[side]->setObjectName("labView" + sides_[side]->letter());
    row->addWidget(views_[side], 1);
    // the letter in the view's corner; while the first view shows both, B stands in its other corner
    auto* corners = new QHBoxLayout(views_[side]);
    for (std::size_t letter = side; letter < sides_.size(); ++letter) {
      auto* badge = new QLabel(badgeText(letter, sides_[letter]->letter()), views_[side]);
      badge->setAttribute(Qt::WA_TransparentForMouseEvents);
      corners->addWidget(badge, 0, Qt::AlignTop);
      if (letter == side) {
        corners->addStretch(1);
      } else {
        swipeBadge_ = badge;
      }
    }
  }
  for (const SliceAxis axis : {SliceAxis::Axial, SliceAxis::Coronal, SliceAxis::Sagittal}) {
    auto* slice = new SliceView(axis, slices);
    slice->setObjectName("lab_" + slice->objectName());
    slice->setSurfacesCompared(true);
    slices_[static_cast<std::size_t>(axis)] = slice;
    sliceRow->addWidget(slice, 1);
  }
  pages_->addWidget(surfaces);
  pages_->addWidget(slices);

  auto* below = new QHBoxLayout;
  below->setContentsMargins(4, 2, 4, 2);
  for (std::size_t side = 0; side < sides_.size(); ++side) {
    panels_[side] = new QWidget(this);
    auto* column = new QVBoxLayout(panels_[side]);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    names_[side] = new QLabel(panels_[side]);
    names_[side]->setObjectName("labName" + sides_[side]->letter());
    numbers_[side] = new QLabel(panels_[side]);
    numbers_[side]->setObjectName("labNumbers" + sides_[side]->letter());
    numbers_[side]->setTextFormat(Qt::RichText);
    numbers_[side]->setWordWrap(true);
    numbers_[side]->setTextInteractionFlags(Qt::TextSelectableByMouse);
    numbers_[side]->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    numbers_[side]->setMinimumHeight(kNumberLines * fontMetrics().lineSpacing());
    column->addWidget(names_[side]);
    column->addWidget(numbers_[side], 1);
    below->addWidget(panels_[side], 1);
  }
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(bar);
  column->addWidget(pages_, 1);
  column->addLayout(below);
}

void LabViews::retranslateUi() {
  lookButtons_[0]->setText(tr("Side by side"));
  lookButtons_[1]->setText(tr("Swipe"));
  lookButtons_[1]->setToolTip(tr("One view: A left of the line, B right of it. Drag the line, or move it with the arrow keys."));
  lookButtons_[2]->setText(tr("Slices"));
  lookButtons_[2]->setToolTip(tr("Outlines of A, B and the voxels over the CT"));
  wireframe_->setText(tr("Wireframe"));
  refreshNames();
}

void LabViews::setLook(LabLook look) {
  look_ = look;
  lookButtons_[static_cast<std::size_t>(look)]->setChecked(true);
  pages_->setCurrentIndex(look == LabLook::Slices ? 1 : 0);
  wireframe_->setEnabled(look != LabLook::Slices);
  wireframe_->setToolTip(look == LabLook::Slices ? tr("Slices show outlines; choose side by side or swipe.") : QString());
  refresh();
}

void LabViews::setStructure(const Structure& structure) {
  structure_ = structure;
  structure_.colour = kVoxelColour;
  structure_.visible = true;
  structure_.reconstruction.reset();
  const Case& content = document_.content();
  for (SliceView* slice : slices_) {
    slice->setVolumes(content.ct, content.segmentation, content.liver);
  }
  if (document_.isOpen() && !maskOf(content, structure_).empty()) {
    setCrosshair(voxelCentre(maskOf(content, structure_), content.segmentation->geometry));
  }
  refreshSlices();
}

void LabViews::setCrosshair(const Vec3& worldMm) {
  for (SliceView* slice : slices_) {
    slice->setCrosshair(worldMm);
  }
}

void LabViews::refresh() {
  double p95 = 0;
  for (const LabSide* side : sides_) {
    p95 = std::max(p95, side->p95Mm().value_or(0.0));
  }
  const double scale = errorScaleMm(p95);
  legend_->setScale(scale);
  const bool swipe = look_ == LabLook::Swipe;
  for (std::size_t side = 0; side < views_.size(); ++side) {
    views_[side]->setScale(scale);
    views_[side]->setSurfaces(sides_[side]->surface(), swipe && side == 0 ? sides_[1]->surface() : ShownSurface());
  }
  views_[1]->setVisible(!swipe);
  swipeBadge_->setVisible(swipe);
  refreshSlices();
  refreshNames();
}

void LabViews::refreshSlices() {
  if (look_ != LabLook::Slices) {
    return;
  }
  auto model = std::make_shared<LiverModel>();
  model->structures.push_back(structure_);
  for (std::size_t side = 0; side < sides_.size(); ++side) {
    Structure surface;
    surface.id = sides_[side]->letter().toStdString();
    surface.colour = toRgb(kLabColours[side]);
    surface.reconstruction = sides_[side]->reconstruction();
    model->structures.push_back(std::move(surface));
  }
  for (SliceView* slice : slices_) {
    slice->setModel(model);
  }
}

void LabViews::refreshNames() {
  for (std::size_t side = 0; side < sides_.size(); ++side) {
    const LabSide& shown = *sides_[side];
    QString text;
    if (!shown.recipe()) {
      text = side == 0 ? tr("click a model in the plot") : tr("click a model with Shift or the right button");
    } else if (shown.pending()) {
      text = tr("%1 is being made ...").arg(QString::fromStdString(modelName(*shown.recipe())));
    } else {
      text = QString::fromStdString(shown.model() ? shown.model()->name() : modelName(*shown.recipe()));
      text = shown.unfinished() ? tr("%1, its errors are being measured ...").arg(text) : text;
    }
    names_[side]->setText(badgeText(side, shown.letter()) + QStringLiteral("&nbsp;&nbsp;<b>%1</b>").arg(text.toHtmlEscaped()));
  }
}

QString LabViews::numbersOf(const LabRow& row) const {
  if (row.model == nullptr) {
    return {};
  }
  const auto bold = [](const QString& text) { return QStringLiteral("<b>%1</b>").arg(text.toHtmlEscaped()); };
  QString heads;
  QString errors;
  QStringList others;
  const char* name = "";
  for (const LabColumn& column : labColumns()) {
    const QString value = labValueText(column, row);
    if (*column.part == '\0') {
      const QString unit = *column.unit == '\0' ? QString() : QStringLiteral("\u00A0") + QString::fromUtf8(column.unit);
      others << labText(column.name).toHtmlEscaped() + QStringLiteral("\u00A0") + bold(value + unit);
      continue;
    }
    if (heads.count(QStringLiteral("<td")) < 3) {
      heads += QStringLiteral("<td align=right>&nbsp;&nbsp;%1</td>").arg(labText(column.part).toHtmlEscaped());
    }
    if (column.name != name) {
      errors += QStringLiteral("<tr><td>%1&nbsp;(mm)</td>").arg(labText(column.name).toHtmlEscaped());
      name = column.name;
    }
    errors += QStringLiteral("<td align=right>&nbsp;&nbsp;%1</td>").arg(bold(value));
  }
  others << tr("Defects: %1").arg(labDefectsText(*row.model)).toHtmlEscaped();
  return QStringLiteral("<table cellspacing=0 cellpadding=0><tr><td></td>%1</tr>%2</table>%3")
      .arg(heads, errors, others.join(QStringLiteral(" \u00B7 ")));
}

void LabViews::setNumbers(const std::array<LabRow, 2>& rows) {
  for (std::size_t side = 0; side < sides_.size(); ++side) {
    numbers_[side]->setText(numbersOf(rows[side]));
  }
}

}  // namespace glisson
