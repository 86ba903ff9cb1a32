#include "app/gui/plan_report.h"

#include <Eigen/Geometry>
#include <QAbstractTextDocumentLayout>
#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <QTextDocument>

#include "app/gui/acceptance_box.h"
#include "app/gui/flr_card_text.h"
#include "app/gui/model_builder.h"
#include "app/gui/number_text.h"
#include "app/gui/plan_panel.h"
#include "app/gui/sentences.h"
#include "app/gui/territory_box.h"
#include "planning/exchange/pseudonym.h"
#include "planning/exchange/version.h"
#include "planning/report/compare_plans.h"
#include "planning/report/decisive_tumour.h"
#include "planning/storage/surface_hash.h"
#include "planning/volumetry/tumour_measures.h"
#include "reconstruction/errors.h"

namespace glisson {

namespace {

constexpr int kDotsPerInch = 150;
constexpr double kMarginMm = 15;
constexpr int kFooterMm = 12;
constexpr int kViewWidth = 212;  ///< points; three beside each other fill the page

class ReportText {
  Q_DECLARE_TR_FUNCTIONS(glisson::ReportText)
};

QString reportCell(const QString& text, bool number = false) {
  return QStringLiteral("<td%1>%2</td>").arg(number ? QStringLiteral(" align=\"right\"") : QString(), text.toHtmlEscaped());
}

QString row(const QStringList& cells, int numbersFrom = 1) {
  QString html = QStringLiteral("<tr>");
  for (int n = 0; n < cells.size(); ++n) {
    html += reportCell(cells[n], n >= numbersFrom);
  }
  return html + QStringLiteral("</tr>");
}

QString header(const QStringList& cells) {
  QString html = QStringLiteral("<tr>");
  for (int n = 0; n < cells.size(); ++n) {
    html += QStringLiteral("<th align=\"%1\">%2</th>").arg(n == 0 ? "left" : "right", cells[n].toHtmlEscaped());
  }
  return html + QStringLiteral("</tr>");
}

QString table(const QString& rows) {
  return QStringLiteral("<table width=\"100%\" cellspacing=\"0\" cellpadding=\"2\" border=\"0\">") + rows +
         QStringLiteral("</table>");
}

QString heading(const QString& text) { return QStringLiteral("<h3>") + text.toHtmlEscaped() + QStringLiteral("</h3>"); }

QString paragraph(const QString& text) { return QStringLiteral("<p>") + text.toHtmlEscaped() + QStringLiteral("</p>"); }

QString patientLine(const PlanReport& report) {
  const PatientIdentity& patient = report.content.identity;
  QStringList parts{QString::fromStdString(report.content.code)};
  if (report.withIdentity) {
    QString name = QString::fromStdString(patient.patientName);
    name.replace('^', QStringLiteral(", "));
    const QString id = QString::fromStdString(patient.patientId);
    const QString born = dateText(patient.birthDate);
    parts << name << (id.isEmpty() ? id : ReportText::tr("id %1").arg(id))
          << (born.isEmpty() ? born : ReportText::tr("born %1").arg(born));
  }
  parts << ReportText::tr("CT of %1").arg(dateText(patient.studyDate)) << QString::fromStdString(patient.seriesDescription);
  parts.removeAll(QString());
  return parts.join(QStringLiteral(" \u00B7 "));
}

/// What the report is of, and when it was written.
QString writtenLine(const PlanReport& report) {
  return ReportText::tr("Written %1 UTC; case %2, model revision %3.")
      .arg(QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyy-MM-dd HH:mm")),
           QString::fromStdString(report.content.code), QString::number(report.content.model->revision));
}

/// Of a plan with several resections; one has the plan's own numbers.
QString resectionsOf(const PlanAssessment& assessment) {
  if (assessment.resections.size() < 2) {
    return {};
  }
  QString rows = header({ReportText::tr("Resection"), ReportText::tr("volume"), ReportText::tr("area of the cut")});
  for (const ResectionVolume& resection : assessment.resections) {
    rows += row({shownName(resection.name), mlText(resection.volumeMl, 1), areaText(resection.cutAreaMm2)});
  }
  return table(rows);
}

QString numbersOf(const PlanReport& report) {
  const PlanAssessment& a = report.assessment;
  if (!a.divides) {
    return paragraph(shownSentence(a.warning));
  }
  const QString uncertainty = QStringLiteral(" \u00B1\u00A0") + mlText(a.volumeUncertaintyMl, 1);
  const auto percent = [](double part, double whole) { return whole > 0 ? percentText(100 * part / whole, 1) : QString(); };
  QString rows = header({ReportText::tr("Volume"), ReportText::tr("value"), ReportText::tr("share")});
  rows += row({ReportText::tr("Liver, tumours in it included"), mlText(a.totalMl, 1), {}});
  rows += row({ReportText::tr("Functional liver"), mlText(a.functionalMl, 1), percent(a.functionalMl, a.totalMl)});
  rows += row({ReportText::tr("Resected"), mlText(a.resectedMl, 1) + uncertainty, percent(a.resectedMl, a.totalMl)});
  rows += row({ReportText::tr("Remnant"), mlText(a.remnantMl, 1) + uncertainty, percent(a.remnantMl, a.totalMl)});
  rows += row({ReportText::tr("Functional remnant (FLR), share of the functional liver"),
               mlText(a.functionalRemnantMl, 1) + uncertainty, percentText(a.flrPercent, 1)});
  rows += row({ReportText::tr("Area of the cut"), areaText(cutAreaMm2(a)), {}});
  QString html = table(rows) + resectionsOf(a);
  if (!a.warning.empty()) {
    html += paragraph(shownSentence(a.warning));
  }
  return html;
}

/// What matters before any margin: tumours that are cut or stay behind; empty where all are removed.
QString untreatedOf(const PlanAssessment& assessment) {
  const auto sentence = [&](TumourState state, const QString& text) {
    const QStringList names = tumourNames(assessment, state);
    const QString number = ReportText::tr("%1 of %2").arg(names.size()).arg(tumourCounts(assessment).all());
    return names.isEmpty() ? QString() : paragraph(text.arg(number, names.join(QStringLiteral(", "))));
  };
  return sentence(TumourState::Cut, ReportText::tr("Tumours cut: %1 (%2).")) +
         sentence(TumourState::Left, ReportText::tr("Tumours left behind: %1 (%2)."));
}

QString tumoursOf(const PlanReport& report) {
  const std::vector<TumourMeasures> measured = tumourMeasures(report.content);
  QString rows = header({ReportText::tr("Tumour"), ReportText::tr("volume"), ReportText::tr("longest diameter"),
                         ReportText::tr("to the capsule"), ReportText::tr("nearest vessel"), ReportText::tr("state"),
                         ReportText::tr("margin"), ReportText::tr("at least")});
  for (const TumourAssessment& tumour : report.assessment.tumours) {
    QString volume;
    QString diameter;
    QString capsule;
    QString vessel;
    for (const TumourMeasures& m : measured) {
      if (m.id == tumour.id) {
        volume = mlText(m.volumeMl, 1);
        diameter = mmText(m.longestDiameterMm);
        capsule = (m.capsuleBeyondImage ? QStringLiteral("\u2265\u00A0") : QString()) + mmText(m.capsuleMm);
        vessel = m.vesselMm ? shownName(m.nearestVessel) + QStringLiteral(", ") + mmText(*m.vesselMm) : QString();
      }
    }
    const QString margin = tumour.marginMm     ? mmText(*tumour.marginMm)
                           : tumour.distanceMm ? ReportText::tr("%1 from the cut").arg(mmText(*tumour.distanceMm))
                                               : QString();
    rows += row({shownName(tumour.name), volume, diameter, capsule, vessel, stateText(tumour.state), margin,
                 tumour.marginAtLeastMm ? mmText(*tumour.marginAtLeastMm) : QString()});
  }
  return heading(ReportText::tr("Tumours (safety margin %1)").arg(mmText(report.plan.safetyMarginMm))) +
         untreatedOf(report.assessment) + table(rows) + paragraph(shownSentence(std::string(kMarginNotice)));
}

QString islandsOf(const PlanReport& report) {
  if (report.assessment.islands.empty()) {
    return {};
  }
  QString rows = header({ReportText::tr("Separated piece"), ReportText::tr("counts with"), ReportText::tr("volume"),
                         ReportText::tr("functional"), QStringLiteral("L"), QStringLiteral("P"), QStringLiteral("S")});
  const auto side = [](bool resected) { return resected ? ReportText::tr("the resected side") : ReportText::tr("the remnant"); };
  for (const IslandAssessment& island : report.assessment.islands) {
    const bool resected = island.side == PlanSide::Resected;
    rows += row({resected ? ReportText::tr("of the resected side") : ReportText::tr("of the remnant"),
                 side(resected != island.assigned), mlText(island.volumeMl, 1), mlText(island.functionalMl, 1),
                 numberText(island.point.x(), 1), numberText(island.point.y(), 1), numberText(island.point.z(), 1)});
  }
  return heading(ReportText::tr("Separated pieces")) + table(rows);
}

QString vesselsOf(const PlanReport& report) {
  if (!report.assessment.divides) {
    return {};
  }
  QString rows = header({ReportText::tr("Vessel crossed"), ReportText::tr("diameter"), QStringLiteral("L"), QStringLiteral("P"),
                         QStringLiteral("S")});
  for (const VesselCrossing& vessel : report.assessment.vesselsCrossed) {
    rows += row({crossedText(vessel), mmText(vessel.diameterMm), numberText(vessel.positionMm.x(), 1),
                 numberText(vessel.positionMm.y(), 1), numberText(vessel.positionMm.z(), 1)});
  }
  return heading(ReportText::tr("Vessels crossed: %1").arg(report.assessment.vesselsCrossed.size())) + table(rows);
}

/// What the user said about the patient, as far as anything was said.
QString factsOf(const PatientFacts& facts) {
  QStringList parts;
  if (facts.heightCm) {
    parts << numberText(*facts.heightCm, 0) + QStringLiteral("\u00A0cm");
  }
  if (facts.weightKg) {
    parts << numberText(*facts.weightKg, 1) + QStringLiteral("\u00A0kg");
  }
  if (facts.condition) {
    parts << ReportText::tr("liver: %1").arg(conditionText(*facts.condition));
  }
  if (facts.tumourType) {
    parts << tumourTypeText(*facts.tumourType);
  }
  return parts.isEmpty() ? QString() : paragraph(parts.join(QStringLiteral(" \u00B7 ")));
}

QString cardOf(const PlanReport& report) {
  const FlrCard card = flrCard(report.content.patient, report.assessment);
  QString rows = header({ReportText::tr("Ratio"), ReportText::tr("value"), ReportText::tr("published")});
  if (card.bsaMostellerM2) {
    const QString surface = numberText(*card.bsaMostellerM2, 2) + QStringLiteral("\u00A0m\u00B2");
    rows += row({ReportText::tr("Body surface (Mosteller)"), surface, {}});
    rows += row({ReportText::tr("Standardised liver volume, SLV (Urata)"), mlText(*card.slvUrataMl), {}});
    rows += row({ReportText::tr("Standardised liver volume, SLV (Vauthey)"), mlText(*card.slvVautheyMl), {}});
  }
  for (const FlrRatio& ratio : card.ratios) {
    rows += row({flrRatioName(ratio.kind), flrRatioText(ratio.kind, ratio.value, 2), flrThresholdsText(ratio)});
  }
  QString html =
      heading(ReportText::tr("FLR card: published numbers for information, not advice")) + factsOf(card.facts) + table(rows);
  for (const QString& band : marginBandTexts(card)) {
    html += paragraph(band);
  }
  for (const std::string& reason : card.reasons) {
    html += paragraph(shownSentence(reason));
  }
  return html;
}

/// Where each tumour lies.
QString tumourTerritoriesOf(const TerritoryReport& report) {
  if (report.tumours.empty()) {
    return {};
  }
  QString rows = header({ReportText::tr("Tumour"), ReportText::tr("lies in")});
  for (const TumourTerritories& tumour : report.tumours) {
    rows += row({shownName(tumour.name), tumourTerritoriesText(tumour)});
  }
  return table(rows);
}

QString territoriesOf(const PlanReport& report) {
  if (!report.territories) {
    return {};
  }
  QString html = heading(ReportText::tr("Territories and the remnant's blood: estimates"));
  if (!report.territories->volumes.empty()) {
    QString rows =
        header({ReportText::tr("Territory"), ReportText::tr("volume"), ReportText::tr("resected"), ReportText::tr("remnant")});
    for (const TerritoryVolume& part : report.territories->volumes) {
      rows += row({territoryName(part.name), mlText(part.volumeMl, 1), mlText(part.resectedMl, 1), mlText(part.remnantMl, 1)});
    }
    html += table(rows) + tumourTerritoriesOf(*report.territories);
    if (!report.territories->territories.confirmed) {
      html += paragraph(ReportText::tr("Left and right are proposed from the main bifurcation; nobody has confirmed them."));
    }
  }
  html += paragraph(perfusionText(report.territories->effect));
  for (const std::string& note : report.territories->notes) {
    html += paragraph(shownSentence(note));
  }
  return html;
}

QString vectorText(const Vec3& v, int decimals) {
  return QStringLiteral("%1  %2  %3").arg(numberText(v.x(), decimals), numberText(v.y(), decimals), numberText(v.z(), decimals));
}

/// All that a bent plane is, beyond its point and normal.
QString bendText(const QString& name, const ResectionPlane& plane) {
  const Bend& bend = *plane.bend;
  QStringList heights;
  for (const double height : bend.heightsMm) {
    heights << numberText(height, 1);
  }
  return ReportText::tr(
             "%1 is bent: a cubic Bezier surface over a square of %2 mm around its point, u along %3, v = normal x u along %4. "
             "Control points, mm above the plane, from -u and -v on, u running fastest: %5. Beside the square it levels out: d mm "
             "beyond the border the height is the cubic one at d - d^2 / (2 w) mm, w = %6 mm, and from w on it stays the same.")
      .arg(name, numberText(2 * bend.halfSizeMm, 0), vectorText(bend.u, 4), vectorText(plane.normal.cross(bend.u), 4),
           heights.join(QStringLiteral("; ")), numberText(kBendEase * bend.halfSizeMm, 1));
}

QString planesOf(const PlanReport& report) {
  QString rows =
      header({ReportText::tr("Plane"), ReportText::tr("a point of it, mm LPS"), ReportText::tr("normal, to the resected side")});
  QString bends;
  for (const Resection& resection : report.plan.resections) {
    for (std::size_t n = 0; n < resection.planes.size(); ++n) {
      rows += row({shownName(resection.name) + QStringLiteral(", ") + QString::number(n + 1),
                   vectorText(resection.planes[n].origin, 1), vectorText(resection.planes[n].normal, 4)});
      if (resection.planes[n].bend) {
        bends +=
            paragraph(bendText(shownName(resection.name) + QStringLiteral(", ") + QString::number(n + 1), resection.planes[n]));
      }
    }
  }
  QString html = heading(ReportText::tr("Planes")) + table(rows) + bends;
  if (!report.plan.measures.empty()) {
    QString distances;
    for (const Measure& measure : report.plan.measures) {
      distances += row({shownName(measure.name), mmText(measure.mm())});
    }
    html += heading(ReportText::tr("Measured distances")) + table(distances);
  }
  return html;
}

QString structuresOf(const PlanReport& report) {
  QString rows = header({ReportText::tr("Structure"), ReportText::tr("made by"), ReportText::tr("triangles"),
                         ReportText::tr("voxels, mL"), ReportText::tr("surface, mL"), ReportText::tr("accepted by")});
  QString hashes;
  for (const Structure& structure : report.content.model->structures) {
    if (!structure.reconstruction) {
      rows += row({shownName(structure.name), ReportText::tr("no surface yet"), {}, {}, {}, {}});
      continue;
    }
    const Reconstruction& made = *structure.reconstruction;
    rows += row({shownName(structure.name), shownSentence(made.parameters.describe()),
                 QLocale().toString(static_cast<qulonglong>(made.mesh.triangles.size())), numberText(made.voxelVolumeMl, 1),
                 numberText(made.meshVolumeMl, 1), acceptanceCell(structure)});
    hashes += row({shownName(structure.name), QString::fromStdString(surfaceHash(made.mesh))});
  }
  return heading(ReportText::tr("Structures and parameters")) + table(rows) +
         heading(ReportText::tr("SHA-256 of the surfaces' vertices and triangles")) +
         QStringLiteral("<div style=\"font-family:'DejaVu Sans Mono'; font-size:6pt\">") + table(hashes) + QStringLiteral("</div>");
}

/// What the readers had to say, with every consent that was given, and what each surface is said to lack.
QString notesOf(const PlanReport& report) {
  const Case& content = report.content;
  QString html;
  for (const std::string& note : content.notes) {
    html += paragraph(shownSentence(note));
  }
  for (const Structure& structure : content.model->structures) {
    if (structure.reconstruction) {
      for (const auto* notes : {&structure.reconstruction->notes, &structure.reconstruction->deviations}) {
        for (const std::string& note : *notes) {
          html += paragraph(structureName(structure) + QStringLiteral(": ") + shownSentence(note));
        }
      }
    }
  }
  return html.isEmpty() ? html : heading(ReportText::tr("Notes on the input and the surfaces")) + html;
}

/// What nobody has looked at, on the first page.
QString notAcceptedOf(const PlanReport& report) {
  QStringList names;
  for (const Structure& structure : report.content.model->structures) {
    if (!structure.acceptance) {
      names << structureName(structure);
    }
  }
  return names.isEmpty() ? QString()
                         : paragraph(ReportText::tr("Not accepted by anybody: %1.").arg(names.join(QStringLiteral(", "))));
}

/// Free text that names the patient is taken out (hazard H8).
PlanReport withoutIdentity(const PlanReport& report) {
  PlanReport nameless = report;
  const auto clean = [&](std::string& text, const std::string& fallback) { text = pseudonymous(text, fallback, report.content); };
  nameless.content.identity.seriesDescription.clear();
  for (std::string& note : nameless.content.notes) {
    clean(note, "A note that names the patient is left out.");
  }
  clean(nameless.plan.name, "Plan");
  for (std::size_t n = 0; n < nameless.plan.resections.size(); ++n) {
    clean(nameless.plan.resections[n].name, "Resection " + std::to_string(n + 1));
  }
  for (std::size_t n = 0; n < nameless.assessment.resections.size(); ++n) {
    clean(nameless.assessment.resections[n].name, "Resection " + std::to_string(n + 1));
  }
  for (std::size_t n = 0; n < nameless.plan.measures.size(); ++n) {
    clean(nameless.plan.measures[n].name, "Distance " + std::to_string(n + 1));
  }
  auto model = std::make_shared<LiverModel>(*nameless.content.model);
  for (Structure& structure : model->structures) {
    if (structure.acceptance) {
      clean(structure.acceptance->by, "a person");
    }
  }
  nameless.content.model = std::move(model);
  return nameless;
}

QString bodyOf(const PlanReport& report) {
  QString html = QStringLiteral("<h2>") + ReportText::tr("Resection plan: %1").arg(shownName(report.plan.name)).toHtmlEscaped() +
                 QStringLiteral("</h2>") + paragraph(patientLine(report)) + paragraph(writtenLine(report));
  html += QStringLiteral("<table width=\"100%\"><tr>");
  const std::array names{ReportText::tr("from anterior"), ReportText::tr("from superior"), ReportText::tr("from the left")};
  for (std::size_t n = 0; n < names.size(); ++n) {
    // both sides: with the width alone Qt keeps the aspect on the UI thread only
    const QSize size = report.views[n].size().scaled(kViewWidth, kViewWidth, Qt::KeepAspectRatio);
    html += QStringLiteral("<td align=\"center\"><img src=\"view%1\" width=\"%2\" height=\"%3\"><br>%4</td>")
                .arg(QString::number(n), QString::number(size.width()), QString::number(size.height()), names[n].toHtmlEscaped());
  }
  html += QStringLiteral("</tr></table>") + numbersOf(report) + tumoursOf(report) + notAcceptedOf(report);
  html += paragraph(
      ReportText::tr("Pre-operative, supine, rigid: pneumoperitoneum and mobilisation move the liver by centimetres; registration "
                     "error not included. Not for clinical use."));
  html += QStringLiteral("<div style=\"page-break-before:always\"></div>") + islandsOf(report) + vesselsOf(report) +
          cardOf(report) + territoriesOf(report) + planesOf(report) + structuresOf(report) + notesOf(report);
  return html;
}

void drawPages(QPdfWriter& writer, QTextDocument& document, const QString& footer) {
  QPainter painter(&writer);
  const double perMm = kDotsPerInch / 25.4;
  const QSizeF page(writer.width(), writer.height() - kFooterMm * perMm);
  document.setPageSize(page);
  const int pages = document.pageCount();
  for (int n = 0; n < pages; ++n) {
    if (n > 0) {
      writer.newPage();
    }
    painter.save();
    painter.translate(0, -n * page.height());
    document.drawContents(&painter, QRectF(0, n * page.height(), page.width(), page.height()));
    painter.restore();
    painter.setFont(QFont(document.defaultFont().family(), 7));
    const QRectF line(0, page.height() + 3 * perMm, page.width(), (kFooterMm - 3) * perMm);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, footer);
    painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, ReportText::tr("page %1 of %2").arg(n + 1).arg(pages));
  }
}

}  // namespace

bool hasIdentity(const Case& content) {
  const PatientIdentity& patient = content.identity;
  return !patient.patientName.empty() || !patient.patientId.empty() || !patient.birthDate.empty();
}

void writePdf(const PlanReport& report, const QString& path) {
  QSaveFile file(path);
  if (!file.open(QIODevice::WriteOnly)) {
    throw InputError(path.toStdString() + " cannot be written; check the folder.");
  }
  {
    QPdfWriter writer(&file);
    writer.setResolution(kDotsPerInch);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(kMarginMm, kMarginMm, kMarginMm, kMarginMm), QPageLayout::Millimeter);
    writer.setTitle(QString::fromStdString(report.content.code));
    writer.setCreator(QStringLiteral("Glisson ") + QString::fromStdString(std::string(glissonVersion())));
    QTextDocument document;
    document.documentLayout()->setPaintDevice(&writer);
    document.setDefaultFont(QFont(QStringLiteral("DejaVu Sans"), 8));
    for (std::size_t n = 0; n < report.views.size(); ++n) {
      document.addResource(QTextDocument::ImageResource, QUrl(QStringLiteral("view%1").arg(n)), report.views[n]);
    }
    document.setHtml(bodyOf(report.withIdentity ? report : withoutIdentity(report)));
    const QString footer = QStringList{QString::fromStdString(report.content.code),
                                       ReportText::tr("CT of %1").arg(dateText(report.content.identity.studyDate)),
                                       QStringLiteral("Glisson ") + QString::fromStdString(std::string(glissonVersion())),
                                       ReportText::tr("not for clinical use")}
                               .join(QStringLiteral(" \u00B7 "));
    drawPages(writer, document, footer);
  }
  if (!file.commit()) {
    throw InputError(path.toStdString() + " cannot be written; check the folder.");
  }
}

}  // namespace glisson
