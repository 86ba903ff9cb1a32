#include "app/gui/rating_page.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace glisson {

namespace {

constexpr Rgb kNeutral{200, 200, 200};

/// The value that the key stands for; 0: none.
int valueOf(const QKeyEvent& event) {
  const int value = event.key() - Qt::Key_0;
  const bool plain = (event.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
  return plain && value >= kLowestRating && value <= kHighestRating ? value : 0;
}

}  // namespace

RatedSurroundings surroundingsOf(const LiverModel& model) {
  RatedSurroundings surroundings;
  for (Structure structure : model.structures) {
    const bool surface = structure.reconstruction && !structure.reconstruction->mesh.empty();
    if (surface && (isVessel(structure.kind) || isLesion(structure.kind))) {
      structure.opacity = 1;
      structure.visible = true;
      surroundings.ready.push_back(makeDisplayMesh(structure.reconstruction));
      surroundings.structures.push_back(std::move(structure));
    }
  }
  return surroundings;
}

RatedSurface ratedSurface(RatedModel model, SurfaceMesh mesh, const RatedSurroundings& surroundings) {
  auto made = std::make_shared<Reconstruction>();
  made->mesh = std::move(mesh);
  Structure structure;
  structure.id = "model";
  structure.kind = StructureKind::Liver;
  structure.colour = kNeutral;
  structure.reconstruction = made;
  auto shown = std::make_shared<LiverModel>();
  shown->structures = surroundings.structures;
  shown->structures.push_back(std::move(structure));
  RatedSurface surface{std::move(model), shown, surroundings.ready};
  surface.ready.push_back(makeDisplayMesh(made));
  return surface;
}

QString ratingTag(int value) {
  const std::array<QString, kHighestRating> tags{RatingPage::tr("Very low"), RatingPage::tr("Low"), RatingPage::tr("Medium"),
                                                 RatingPage::tr("High"), RatingPage::tr("Very high")};
  return tags[static_cast<std::size_t>(value - kLowestRating)];
}

RatingPage::RatingPage(QWidget* parent)
    : Translated<QWidget>(parent),
      progress_(new QLabel(this)),
      pause_(new QPushButton(this)),
      view_(new ModelView(this)),
      question_(new QLabel(this)) {
  setObjectName("ratingPage");
  progress_->setObjectName("ratingProgress");
  pause_->setObjectName("ratingPause");
  view_->setObjectName("ratingView");
  view_->setHandlesShown(false);
  view_->setFullDetail(true);
  view_->installEventFilter(this);
  question_->setObjectName("ratingQuestionShown");
  question_->setWordWrap(true);
  question_->setAlignment(Qt::AlignHCenter);
  QFont large = question_->font();
  large.setPointSizeF(large.pointSizeF() * 1.3);
  question_->setFont(large);

  auto* line = new QHBoxLayout;
  line->addWidget(progress_);
  line->addStretch(1);
  line->addWidget(pause_);
  auto* scale = new QHBoxLayout;
  for (int value = kLowestRating; value <= kHighestRating; ++value) {
    auto* button = new QPushButton(this);
    button->setObjectName(QStringLiteral("rate%1").arg(value));
    button->setFont(large);
    button->setMinimumHeight(44);
    connect(button, &QPushButton::clicked, this, [this, value] { rate(value); });
    scale->addWidget(button, 1);
    buttons_[static_cast<std::size_t>(value - kLowestRating)] = button;
  }
  auto* column = new QVBoxLayout(this);
  column->addLayout(line);
  column->addWidget(view_, 1);
  column->addWidget(question_);
  column->addLayout(scale);
  connect(pause_, &QPushButton::clicked, this, &RatingPage::pauseRequested);
  retranslateUi();
}

void RatingPage::retranslateUi() {
  progress_->setText(tr("Model %1 of %2").arg(number_).arg(total_));
  pause_->setText(tr("Pause"));
  for (int value = kLowestRating; value <= kHighestRating; ++value) {
    buttons_[static_cast<std::size_t>(value - kLowestRating)]->setText(QStringLiteral("%1  %2").arg(value).arg(ratingTag(value)));
  }
}

void RatingPage::showModel(const RatedSurface& model, const QString& question, std::size_t number, std::size_t total) {
  view_->setModel(model.shown, model.ready);
  view_->setStandardView(ModelView::StandardView::Anterior);
  question_->setText(question);
  number_ = number;
  total_ = total;
  earlierMs_ = 0;
  retranslateUi();
  goOn();
}

void RatingPage::pause() {
  if (clock_.isValid()) {
    earlierMs_ += clock_.elapsed();
    clock_.invalidate();
  }
}

void RatingPage::goOn() {
  clock_.start();
  view_->setFocus();
}

void RatingPage::rate(int value) {
  pause();
  emit rated({value, static_cast<double>(earlierMs_) / 1000.0});
}

bool RatingPage::rateByKey(const QKeyEvent& event) {
  const int value = valueOf(event);
  if (value != 0 && !event.isAutoRepeat()) {
    rate(value);
  }
  return value != 0;
}

void RatingPage::keyPressEvent(QKeyEvent* event) {
  if (!rateByKey(*event)) {
    QWidget::keyPressEvent(event);
  }
}

/// In the 3D view 1 and 3 would turn the model.
bool RatingPage::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_ && event->type() == QEvent::KeyPress && rateByKey(*static_cast<QKeyEvent*>(event))) {
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace glisson
