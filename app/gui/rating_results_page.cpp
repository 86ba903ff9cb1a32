#include "app/gui/rating_results_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <cmath>

#include "app/gui/number_text.h"
#include "app/gui/rating_plot.h"

namespace glisson {

namespace {

/// Three digits of it that count.
QString pText(double p) {
  constexpr double kLeastShown = 1e-6;
  if (p < kLeastShown) {
    return QStringLiteral("p < ") + numberText(kLeastShown, 6);
  }
  const int decimals = p >= 0.1 ? 3 : 2 - static_cast<int>(std::floor(std::log10(p)));
  return QStringLiteral("p = ") + numberText(p, decimals);
}

QString testText(const TTestResult& result) {
  if (const auto* absence = std::get_if<NoTTest>(&result)) {
    return *absence == NoTTest::TooFew ? RatingResultsPage::tr("no test: fewer than two values on a side")
                                       : RatingResultsPage::tr("no test: nothing varies");
  }
  const TTest& test = std::get<TTest>(result);
  return RatingResultsPage::tr("difference %1, t = %2, df = %3, %4")
      .arg(numberText(test.meanDifference, 3), numberText(test.t, 3), numberText(test.degreesOfFreedom, 1), pText(test.p));
}

QString cell(const QString& text, bool number) {
  return QStringLiteral("<td align=\"%1\">%2</td>").arg(number ? "right" : "left", text.toHtmlEscaped());
}

QString tableOf(const std::vector<MethodRatings>& methods) {
  QString table = QStringLiteral("<table cellpadding=\"3\"><tr>");
  for (const QString& head : {RatingResultsPage::tr("Method"), RatingResultsPage::tr("Ratings"), RatingResultsPage::tr("Mean"),
                              RatingResultsPage::tr("SD"), RatingResultsPage::tr("Median")}) {
    table += QStringLiteral("<th align=\"left\">%1</th>").arg(head.toHtmlEscaped());
  }
  for (const MethodRatings& method : methods) {
    table += QStringLiteral("</tr><tr>") + cell(QString::fromStdString(method.method), false) +
             cell(QString::number(method.ratings.size()), true) + cell(numberText(method.spread.mean, 3), true) +
             cell(numberText(method.spread.deviation, 3), true) + cell(numberText(method.box.median, 1), true);
  }
  return table + QStringLiteral("</tr></table>");
}

QString withinText(const MethodComparison& comparison, const RaterTest& rater) {
  const QString text = comparison.grades.empty() ? RatingResultsPage::tr("Paired t-test over the patients by %1 alone: %2")
                                                 : RatingResultsPage::tr("Paired t-test over the grades by %1 alone: %2");
  return text.arg(QString::fromStdString(rater.rater), testText(rater.test));
}

QString gradesText(const MethodComparison& comparison) {
  QStringList grades;
  for (const std::string& grade : comparison.grades) {
    grades << QString::fromStdString(grade);
  }
  return RatingResultsPage::tr("Models of one grade are paired: %1").arg(grades.join(QStringLiteral("; ")));
}

QString comparisonText(const MethodComparison& comparison) {
  const auto item = [](const QString& text) { return QStringLiteral("<li>%1</li>").arg(text.toHtmlEscaped()); };
  QString text = QStringLiteral("<p><b>%1</b></p><ul>")
                     .arg(RatingResultsPage::tr("%1 less %2")
                              .arg(QString::fromStdString(comparison.first), QString::fromStdString(comparison.second))
                              .toHtmlEscaped());
  text += item(RatingResultsPage::tr("Welch's t-test of all ratings: %1").arg(testText(comparison.pooled)));
  text += item(RatingResultsPage::tr("Paired t-test over the raters' means: %1").arg(testText(comparison.overRaters)));
  for (const RaterTest& rater : comparison.withinRaters) {
    text += item(withinText(comparison, rater));
  }
  if (!comparison.grades.empty()) {
    text += item(gradesText(comparison));
  }
  return text + QStringLiteral("</ul>");
}

}  // namespace

RatingResultsPage::RatingResultsPage(QWidget* parent)
    : Translated<QWidget>(parent),
      title_(new QLabel(this)),
      plot_(new RatingPlot(this)),
      text_(new QLabel),
      save_(new QPushButton(this)),
      back_(new QPushButton(this)) {
  setObjectName("ratingResults");
  title_->setObjectName("ratingResultsTitle");
  title_->setWordWrap(true);
  text_->setObjectName("ratingResultsText");
  text_->setTextFormat(Qt::RichText);
  text_->setWordWrap(true);
  text_->setAlignment(Qt::AlignTop);
  text_->setMargin(6);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  save_->setObjectName("ratingSave");
  back_->setObjectName("ratingBack");
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(text_);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* line = new QHBoxLayout;
  line->addWidget(back_);
  line->addStretch(1);
  line->addWidget(save_);
  auto* column = new QVBoxLayout(this);
  column->addWidget(title_);
  column->addWidget(plot_, 3);
  column->addWidget(scroll, 4);
  column->addLayout(line);
  connect(save_, &QPushButton::clicked, this, &RatingResultsPage::saveRequested);
  connect(back_, &QPushButton::clicked, this, &RatingResultsPage::backRequested);
  retranslateUi();
}

void RatingResultsPage::setResults(RatingResults results) {
  results_ = std::move(results);
  plot_->setMethods(results_.methods);
  retranslateUi();
}

void RatingResultsPage::retranslateUi() {
  title_->setText(tr("Raters who have finished: %1. Median time for a rating: %2 s.")
                      .arg(results_.raters)
                      .arg(numberText(results_.medianSeconds, 1)));
  plot_->setAccessibleName(tr("Box plot of the ratings by method"));
  QString text = tableOf(results_.methods);
  for (const MethodComparison& comparison : results_.comparisons) {
    text += comparisonText(comparison);
  }
  if (!results_.comparisons.empty()) {
    text += QStringLiteral("<p>%1</p>")
                .arg(tr("Welch's test takes all ratings for independent of each other. Those of one rater are not: where the tests "
                        "disagree, trust the paired one over the raters.")
                         .toHtmlEscaped());
  }
  if (results_.comparisons.size() > 1) {
    text += QStringLiteral("<p>%1</p>").arg(tr("The p values are not corrected for the number of comparisons.").toHtmlEscaped());
  }
  text_->setText(text);
  save_->setText(tr("Save CSV..."));
  save_->setToolTip(tr("Writes the ratings, and in a file beside them the numbers of all tests."));
  back_->setText(tr("Back"));
}

}  // namespace glisson
