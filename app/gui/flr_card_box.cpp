#include "app/gui/flr_card_box.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "app/gui/flr_card_text.h"
#include "app/gui/number_text.h"
#include "app/gui/sentences.h"

namespace glisson {

namespace {

QDoubleSpinBox* makeField(const QString& name, double most, QWidget* parent) {
  auto* field = new QDoubleSpinBox(parent);
  field->setObjectName(name);
  field->setRange(0, most);
  field->setDecimals(1);
  field->setKeyboardTracking(false);
  field->setButtonSymbols(QAbstractSpinBox::NoButtons);
  return field;
}

QComboBox* makeChoice(const QString& name, int count, QWidget* parent) {
  auto* choice = new QComboBox(parent);
  choice->setObjectName(name);
  choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  choice->setMinimumContentsLength(8);
  for (int n = 0; n < count; ++n) {
    choice->addItem(QString());
  }
  return choice;
}

QString row(const QString& name, const QString& value, const QString& beside) {
  return QStringLiteral("<tr><td>%1</td><td align=\"right\"><b>%2</b></td><td>%3</td></tr>")
      .arg(name.toHtmlEscaped(), value.toHtmlEscaped(), beside.toHtmlEscaped());
}

}  // namespace

FlrCardBox::FlrCardBox(Document& document, QWidget* parent)
    : Translated<QGroupBox>(parent),
      document_(document),
      heightLabel_(new QLabel(this)),
      weightLabel_(new QLabel(this)),
      conditionLabel_(new QLabel(this)),
      typeLabel_(new QLabel(this)),
      height_(makeField("patientHeight", 260, this)),
      weight_(makeField("patientWeight", 400, this)),
      condition_(makeChoice("liverCondition", 4, this)),
      type_(makeChoice("tumourType", 3, this)),
      card_(new QLabel(this)) {
  setObjectName("flrCard");
  card_->setObjectName("flrCardText");
  card_->setWordWrap(true);
  card_->setTextFormat(Qt::RichText);
  QSizePolicy policy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // the panel gives the width
  policy.setHeightForWidth(true);
  card_->setSizePolicy(policy);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(6, 4, 6, 6);
  grid->setVerticalSpacing(3);
  grid->setColumnStretch(1, 1);
  int line = 0;
  for (const auto& [label, field] : std::initializer_list<std::pair<QLabel*, QWidget*>>{
           {heightLabel_, height_}, {weightLabel_, weight_}, {conditionLabel_, condition_}, {typeLabel_, type_}}) {
    grid->addWidget(label, line, 0);
    grid->addWidget(field, line++, 1);
  }
  grid->addWidget(card_, line, 0, 1, 2);
  connect(height_, &QDoubleSpinBox::valueChanged, this, &FlrCardBox::commit);
  connect(weight_, &QDoubleSpinBox::valueChanged, this, &FlrCardBox::commit);
  connect(condition_, &QComboBox::activated, this, &FlrCardBox::commit);
  connect(type_, &QComboBox::activated, this, &FlrCardBox::commit);
  connect(&document_, &Document::patientChanged, this, &FlrCardBox::refreshFacts);
  connect(&document_, &Document::caseChanged, this, &FlrCardBox::refreshFacts);
  connect(&document_, &Document::assessmentChanged, this, &FlrCardBox::refreshCard);
  retranslateUi();
}

void FlrCardBox::retranslateUi() {
  setTitle(tr("FLR card"));
  heightLabel_->setText(tr("Height"));
  weightLabel_->setText(tr("Weight"));
  conditionLabel_->setText(tr("Liver"));
  typeLabel_->setText(tr("Tumour"));
  height_->setSuffix(QStringLiteral(" cm"));
  weight_->setSuffix(QStringLiteral(" kg"));
  for (QDoubleSpinBox* field : {height_, weight_}) {
    field->setLocale(QLocale());
    field->setSpecialValueText(tr("not given"));
  }
  const QStringList conditions{tr("not given"), conditionText(LiverCondition::Normal),
                               conditionText(LiverCondition::LongChemotherapy), conditionText(LiverCondition::Injured)};
  const QStringList types{tr("not given"), tumourTypeText(TumourType::ColorectalMetastases),
                          tumourTypeText(TumourType::HepatocellularCarcinoma)};
  for (int n = 0; n < condition_->count(); ++n) {
    condition_->setItemText(n, conditions[n]);
  }
  for (int n = 0; n < type_->count(); ++n) {
    type_->setItemText(n, types[n]);
  }
  refreshFacts();
}

void FlrCardBox::commit() {
  const auto given = [](const QDoubleSpinBox* field) {
    return field->value() > 0 ? std::optional<double>(field->value()) : std::nullopt;
  };
  PatientFacts facts{given(height_), given(weight_), {}, {}};
  if (condition_->currentIndex() > 0) {
    facts.condition = static_cast<LiverCondition>(condition_->currentIndex() - 1);
  }
  if (type_->currentIndex() > 0) {
    facts.tumourType = static_cast<TumourType>(type_->currentIndex() - 1);
  }
  document_.setPatient(facts);
}

void FlrCardBox::refreshFacts() {
  const PatientFacts& facts = document_.content().patient;
  const bool open = document_.isOpen();
  for (QWidget* control : std::initializer_list<QWidget*>{height_, weight_, condition_, type_}) {
    control->setEnabled(open);
    control->setToolTip(open ? QString() : tr("Open a case first."));
  }
  const QSignalBlocker quietHeight(height_);
  const QSignalBlocker quietWeight(weight_);
  height_->setValue(facts.heightCm.value_or(0));
  weight_->setValue(facts.weightKg.value_or(0));
  condition_->setCurrentIndex(facts.condition ? static_cast<int>(*facts.condition) + 1 : 0);
  type_->setCurrentIndex(facts.tumourType ? static_cast<int>(*facts.tumourType) + 1 : 0);
  refreshCard();
}

void FlrCardBox::refreshCard() {
  if (!document_.isOpen() || document_.freshness() == Freshness::None) {
    card_->setText(document_.isOpen() ? tr("computing") : QString());
    return;
  }
  const FlrCard card = flrCard(document_.content().patient, document_.assessment());
  QString text = QStringLiteral("<table cellspacing=\"2\" width=\"100%\">");
  if (card.bsaMostellerM2) {
    text += row(tr("Body surface"), numberText(*card.bsaMostellerM2, 2) + QStringLiteral("\u00A0m\u00B2"), tr("Mosteller"));
    text += row(tr("SLV"), mlText(*card.slvUrataMl), tr("Urata"));
    text += row(tr("SLV"), mlText(*card.slvVautheyMl), tr("Vauthey"));
  }
  for (const FlrRatio& ratio : card.ratios) {
    text += row(flrRatioName(ratio.kind), flrRatioText(ratio.kind, ratio.value, 1), flrThresholdsText(ratio));
  }
  text += QStringLiteral("</table>");
  for (const QString& band : marginBandTexts(card)) {
    text += QStringLiteral("<p style=\"margin:2px\">") + band.toHtmlEscaped() + QStringLiteral("</p>");
  }
  for (const std::string& reason : card.reasons) {
    text += QStringLiteral("<p style=\"margin:2px\"><i>") + shownSentence(reason).toHtmlEscaped() + QStringLiteral("</i></p>");
  }
  text += QStringLiteral("<p style=\"margin:2px\">") + tr("Published numbers for information, not advice.").toHtmlEscaped() +
          QStringLiteral("</p>");
  card_->setText(text);
}

}  // namespace glisson
