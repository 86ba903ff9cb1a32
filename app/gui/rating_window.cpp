#include "app/gui/rating_window.h"

#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRandomGenerator>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/model_builder.h"
#include "app/gui/rating_results_page.h"
#include "app/gui/sentences.h"
#include "app/jobs/job_runner.h"
#include "planning/exchange/atomic_file.h"
#include "reconstruction/errors.h"
#include "reconstruction/evaluation/rating_csv.h"
#include "reconstruction/evaluation/rating_tests_csv.h"

namespace glisson {

namespace {

std::vector<RatedModel> modelsOf(const std::vector<RatedSurface>& surfaces) {
  std::vector<RatedModel> models;
  models.reserve(surfaces.size());
  for (const RatedSurface& surface : surfaces) {
    models.push_back(surface.model);
  }
  return models;
}

/// A session of an earlier version knows no grades: those of the same models here hold.
void addGrades(std::vector<RatedModel>& read, const std::vector<RatedModel>& here) {
  for (std::size_t n = 0; n < std::min(read.size(), here.size()); ++n) {
    if (read[n].grade.empty()) {
      read[n].grade = here[n].grade;
    }
  }
}

/// The name tells nothing of the models.
QString newFile(const QString& folder) {
  const QDir place(folder);
  const QString name = QStringLiteral("rating-") + QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"));
  QString path = place.filePath(name + QStringLiteral(".csv"));
  for (int n = 2; QFileInfo::exists(path); ++n) {
    path = place.filePath(QStringLiteral("%1-%2.csv").arg(name).arg(n));
  }
  return path;
}

}  // namespace

RatingWindow::RatingWindow(std::vector<RatedSurface> surfaces, Structure structure, QString folder, QWidget* parent)
    : Translated<QWidget>(parent, Qt::Window),
      surfaces_(std::move(surfaces)),
      structure_(std::move(structure)),
      folder_(std::move(folder)),
      pages_(new QStackedWidget(this)),
      startPage_(makeStartPage()),
      ratingPage_(new RatingPage(pages_)),
      resultsPage_(new RatingResultsPage(pages_)),
      notice_(new QLabel(this)) {
  setObjectName("ratingWindow");
  setAttribute(Qt::WA_DeleteOnClose);
  setMinimumSize(760, 620);
  resize(1100, 860);
  std::ranges::sort(surfaces_, {}, [](const RatedSurface& surface) { return surface.model.id; });
  notice_->setObjectName("ratingNotice");
  notice_->setWordWrap(true);
  for (QWidget* page : std::initializer_list<QWidget*>{startPage_, ratingPage_, resultsPage_}) {
    pages_->addWidget(page);
  }
  auto* column = new QVBoxLayout(this);
  column->addWidget(pages_, 1);
  column->addWidget(notice_);
  connect(question_, &QPlainTextEdit::textChanged, this, [this] {
    questionIsDefault_ = false;
    retranslateUi();
  });
  connect(name_, &QLineEdit::textChanged, this, &RatingWindow::retranslateUi);
  connect(name_, &QLineEdit::returnPressed, start_, &QPushButton::click);
  connect(start_, &QPushButton::clicked, this, &RatingWindow::start);
  connect(resume_, &QPushButton::clicked, this, &RatingWindow::chooseSession);
  connect(change_, &QPushButton::clicked, this, [this] {
    another_ = true;
    showStart();
  });
  connect(results_, &QPushButton::clicked, this, &RatingWindow::showResults);
  connect(ratingPage_, &RatingPage::rated, this, &RatingWindow::rate);
  connect(ratingPage_, &RatingPage::pauseRequested, this, &RatingWindow::pause);
  connect(resultsPage_, &RatingResultsPage::backRequested, this, &RatingWindow::showStart);
  connect(resultsPage_, &RatingResultsPage::saveRequested, this, &RatingWindow::chooseCopy);
  showStart();
}

QWidget* RatingWindow::makeStartPage() {
  auto* page = new QWidget(pages_);
  heading_ = new QLabel(page);
  explanation_ = new QLabel(page);
  questionLabel_ = new QLabel(page);
  question_ = new QPlainTextEdit(page);
  nameLabel_ = new QLabel(page);
  name_ = new QLineEdit(page);
  start_ = new QPushButton(page);
  resume_ = new QPushButton(page);
  change_ = new QPushButton(page);
  results_ = new QPushButton(page);
  kept_ = new QLabel(page);
  heading_->setObjectName("ratingHeading");
  question_->setObjectName("ratingQuestion");
  question_->setTabChangesFocus(true);
  question_->setMaximumHeight(4 * question_->fontMetrics().lineSpacing());
  name_->setObjectName("ratingName");
  start_->setObjectName("ratingStart");
  resume_->setObjectName("ratingResume");
  change_->setObjectName("ratingAnother");
  results_->setObjectName("ratingShowResults");
  kept_->setObjectName("ratingKept");
  QFont large = heading_->font();
  large.setPointSizeF(large.pointSizeF() * 1.5);
  large.setBold(true);
  heading_->setFont(large);
  for (QLabel* label : {heading_, explanation_, kept_}) {
    label->setWordWrap(true);
  }
  questionLabel_->setBuddy(question_);
  nameLabel_->setBuddy(name_);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(start_);
  buttons->addWidget(resume_);
  buttons->addWidget(change_);
  buttons->addStretch(1);
  buttons->addWidget(results_);
  auto* column = new QVBoxLayout(page);
  column->setSpacing(10);
  for (QWidget* widget : std::initializer_list<QWidget*>{heading_, explanation_, questionLabel_, question_, nameLabel_, name_}) {
    column->addWidget(widget);
  }
  column->addLayout(buttons);
  column->addWidget(kept_);
  column->addStretch(1);
  return page;
}

QString RatingWindow::headingText() const {
  if (!session_) {
    return tr("Blind rating of %1 models").arg(surfaces_.size());
  }
  const Rater& last = session_->raters.back();
  const QString name = QString::fromStdString(last.name);
  if (raterGoesOn()) {
    const std::size_t showings = session_->study.models.size() + session_->study.repeats;
    return tr("%1 goes on with model %2 of %3.").arg(name).arg(last.ratings.size() + 1).arg(showings);
  }
  return session_->next() ? tr("%1 has not finished and takes no part in the results.").arg(name)
                          : tr("Thank you, %1: all ratings are kept.").arg(name);
}

/// The paper's, of another structure with its name.
QString RatingWindow::usualQuestion() const {
  if (structure_.kind == StructureKind::Liver) {
    return tr("Evaluate the quality of the virtual models (parenchyma) for their use in resection planning and surgery guidance.");
  }
  return tr("Evaluate the quality of the virtual models (%1) for their use in resection planning and surgery guidance.")
      .arg(structureName(structure_));
}

void RatingWindow::retranslateUi() {
  const std::size_t repeats = std::min(kPaperRepeats, surfaces_.size());
  const bool goesOn = raterGoesOn();
  setWindowTitle(tr("Blind rating"));
  heading_->setText(headingText());
  explanation_->setText(
      tr("Each rater sees the models one at a time, in a random order, and is not told how they were made. The first %1 are shown "
         "twice, and their second rating counts. The mouse turns a model; a button or the keys 1 to 5 rate it and show the next. "
         "Take less than a minute for each; a pause stops the time.")
          .arg(repeats));
  questionLabel_->setText(tr("Question"));
  if (questionIsDefault_ && !session_) {
    const QSignalBlocker blocker(question_);
    question_->setPlainText(usualQuestion());
  }
  question_->setReadOnly(session_.has_value());
  nameLabel_->setText(tr("Name of the rater"));
  name_->setReadOnly(goesOn);
  start_->setText(goesOn ? tr("Go on") : session_ ? tr("Next rater") : tr("Start rating"));
  const bool named = !name_->text().simplified().isEmpty();
  const bool asked = !question_->toPlainText().simplified().isEmpty();
  start_->setEnabled(named && asked);
  start_->setToolTip(!named ? tr("Enter the name of the rater first.") : !asked ? tr("Enter the question first.") : QString());
  resume_->setText(tr("Go on with a kept session..."));
  resume_->setVisible(!session_);
  change_->setText(tr("Another rater..."));
  change_->setVisible(goesOn);
  const bool anyFinished = session_ && session_->finishedRaters() > 0;
  results_->setText(tr("Show results"));
  results_->setEnabled(anyFinished && !goesOn);
  results_->setToolTip(!anyFinished ? tr("No rater has finished yet.")
                       : goesOn     ? tr("Results are shown after the last model.")
                                    : QString());
  kept_->setText(session_ ? tr("Kept after every rating in %1").arg(QDir::toNativeSeparators(path_)) : QString());
  notice_->setText(shownSentence(complaint_));
  notice_->setVisible(!complaint_.isEmpty());
}

bool RatingWindow::attempt(const std::function<void()>& action) {
  complaint_.clear();
  try {
    action();
  } catch (const Error& error) {
    complaint_ = messageOf(error);
  }
  retranslateUi();
  return complaint_.isEmpty();
}

void RatingWindow::start() {
  if (raterGoesOn()) {
    showNext();
    return;
  }
  const bool started = attempt([this] {
    RatingSession session = session_.value_or(RatingSession{});
    if (!session_) {
      session.study = ratingStudy(question_->toPlainText().simplified().toStdString(), modelsOf(surfaces_),
                                  QRandomGenerator::system()->generate());
    }
    session = withRater(std::move(session), name_->text().simplified().toStdString());
    if (!session_) {
      QDir().mkpath(folder_);
      path_ = newFile(folder_);
    }
    keep(session);
    session_ = std::move(session);
    another_ = false;
    paused_ = false;
  });
  if (started) {
    showNext();
  }
}

void RatingWindow::rate(const Rating& rating) {
  session_ = withRating(*session_, rating);
  attempt([this] { keep(*session_); });
  if (raterGoesOn()) {
    showNext();
  } else {
    showStart();
  }
}

void RatingWindow::pause() {
  ratingPage_->pause();
  paused_ = true;
  showStart();
}

void RatingWindow::showNext() {
  pages_->setCurrentWidget(ratingPage_);
  if (paused_) {
    paused_ = false;
    ratingPage_->goOn();
    return;
  }
  const RatingStudy& study = session_->study;
  ratingPage_->showModel(surfaces_[session_->next()->model], QString::fromStdString(study.question),
                         session_->raters.back().ratings.size() + 1, study.models.size() + study.repeats);
}

void RatingWindow::showStart() {
  const QString rater = raterGoesOn() ? QString::fromStdString(session_->raters.back().name) : QString();
  name_->setText(rater);
  retranslateUi();
  pages_->setCurrentWidget(startPage_);
  QWidget* first = raterGoesOn() ? static_cast<QWidget*>(start_) : name_;
  first->setFocus();
}

void RatingWindow::showResults() {
  resultsPage_->setResults(ratingResults(*session_));
  pages_->setCurrentWidget(resultsPage_);
}

void RatingWindow::resume(const QString& path) {
  const std::string file = QDir::toNativeSeparators(path).toStdString();
  RatingSession read = ratingSessionOfCsv(readWholeFile(file), file);
  const std::vector<RatedModel> here = modelsOf(surfaces_);
  addGrades(read.study.models, here);
  if (read.study.models != here) {
    throw InputError("\"" + file + "\" rates other models than these; open the case and the structure that it was begun with.");
  }
  session_ = std::move(read);
  path_ = path;
  paused_ = false;
  another_ = false;
  {
    const QSignalBlocker blocker(question_);
    question_->setPlainText(QString::fromStdString(session_->study.question));
  }
  showStart();
}

void RatingWindow::chooseSession() {
  auto* dialog = new QFileDialog(this, tr("Kept session"), folder_, tr("Ratings (*.csv)"));
  dialog->setObjectName("ratingOpenDialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) { attempt([&] { resume(path); }); });
  dialog->open();
}

void RatingWindow::chooseCopy() {
  auto* dialog = new QFileDialog(this, tr("Save the ratings"), QDir::homePath(), tr("Ratings (*.csv)"));
  dialog->setObjectName("ratingSaveDialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("csv"));
  dialog->selectFile(QFileInfo(path_).fileName());
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) { attempt([&] { saveCopy(path); }); });
  dialog->open();
}

void RatingWindow::saveCopy(const QString& path) const {
  writeFileAtomically(path.toStdString(), ratingCsv(*session_));
  writeFileAtomically(testsPathBeside(path).toStdString(), ratingTestsCsv(ratingResults(*session_)));
}

QString RatingWindow::testsPathBeside(const QString& path) {
  const QFileInfo file(path);
  return file.dir().filePath(file.completeBaseName() + QStringLiteral("-tests.csv"));
}

void RatingWindow::keep(const RatingSession& session) const { writeFileAtomically(path_.toStdString(), ratingCsv(session)); }

}  // namespace glisson
