#include "app/gui/sentences.h"

#include <QCoreApplication>
#include <QHash>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>
#include <array>
#include <optional>
#include <vector>

#include "app/gui/sentence_table.h"

namespace glisson {

namespace {

/// A row cut at its places: literals[0] %1 literals[1] %2 ...
struct Template {
  QStringList literals;
  QString places;  ///< a letter per place
  bool innerOnly = false;
  const char* shown = nullptr;
  qsizetype length = 0;  ///< of the literals together
};

Template toTemplate(const SentenceRow& row) {
  static const QRegularExpression kPlace("%\\d");
  Template made;
  made.literals = QString::fromUtf8(row.text).split(kPlace);
  made.places = QString::fromLatin1(row.places);
  made.innerOnly = made.places.startsWith('.');
  made.places = made.places.mid(made.innerOnly ? 1 : 0).leftJustified(made.literals.size() - 1, 'f');
  made.shown = row.shown != nullptr ? row.shown : row.text;
  made.length = made.literals.join(QString()).size();
  return made;
}

std::vector<Template> toTemplates(std::initializer_list<std::span<const SentenceRow>> tables) {
  std::vector<Template> made;
  for (const std::span<const SentenceRow> table : tables) {
    for (const SentenceRow& row : table) {
      made.push_back(toTemplate(row));
    }
  }
  return made;
}

const std::vector<Template>& sentenceTemplates() {
  static const std::vector<Template> kTemplates = toTemplates(
      {dicomSentences(), readingSentences(), modelSentences(), planningSentences(), planSentences(), windowSentences()});
  return kTemplates;
}

const std::vector<Template>& nameTemplates() {
  static const std::vector<Template> kTemplates = toTemplates({knownNames()});
  return kTemplates;
}

/// A text as shown, and how much of it was known: the letters of the literals that matched.
struct Shown {
  qsizetype known = 0;
  QString text;
};

/// Each %n of the translation replaced by its piece; a piece that holds a % itself stays as it is.
QString filled(const QString& translation, const QStringList& pieces) {
  QString text;
  for (qsizetype at = 0; at < translation.size(); ++at) {
    const int place = translation[at] == '%' && at + 1 < translation.size() ? translation[at + 1].digitValue() : -1;
    if (place >= 1 && place <= pieces.size()) {
      text += pieces[place - 1];
      ++at;
    } else {
      text += translation[at];
    }
  }
  return text;
}

/// Finds the best row for a text and for the pieces in it. One object per question: it remembers what it has found.
class Search {
 public:
  std::optional<Shown> sentence(const QString& text, bool inner) {
    const QString key = (inner ? '.' : ' ') + text;
    if (const auto found = found_.constFind(key); found != found_.constEnd()) {
      return *found;
    }
    std::optional<Shown> best = row(sentenceTemplates(), text, inner);
    // "A. B.": more is known of the two by themselves than of one row that swallows the other
    for (qsizetype end = text.indexOf(". "); end >= 0; end = text.indexOf(". ", end + 1)) {
      const std::optional<Shown> first = row(sentenceTemplates(), text.first(end + 1), inner);
      const std::optional<Shown> rest = first ? sentence(text.sliced(end + 2), inner) : std::nullopt;
      if (rest) {
        keep(best, {first->known + rest->known, first->text + ' ' + rest->text});
      }
    }
    found_.insert(key, best);
    return best;
  }

  std::optional<Shown> name(const QString& text) { return row(nameTemplates(), text, false); }

 private:
  static void keep(std::optional<Shown>& best, Shown candidate) {
    if (!best || candidate.known > best->known) {
      best = std::move(candidate);
    }
  }

  std::optional<Shown> row(const std::vector<Template>& templates, const QString& text, bool inner) {
    std::optional<Shown> best;
    for (const Template& candidate : templates) {
      const bool fits = (inner || !candidate.innerOnly) && text.size() >= candidate.length &&
                        text.startsWith(candidate.literals.front()) && text.endsWith(candidate.literals.back());
      if (fits) {
        QStringList pieces;
        fit(candidate, text.sliced(candidate.literals.front().size()), candidate.length, pieces, best);
      }
    }
    return best;
  }

  /// Tries every way to cut `rest` at the literals that follow the pieces found so far.
  void fit(const Template& candidate, const QString& rest, qsizetype known, QStringList& pieces, std::optional<Shown>& best) {
    const qsizetype place = pieces.size();
    if (place == candidate.places.size()) {
      if (rest.isEmpty()) {
        keep(best, {known, filled(QCoreApplication::translate("Sentence", candidate.shown), pieces)});
      }
      return;
    }
    const QString& next = candidate.literals[place + 1];
    const bool last = place + 1 == candidate.places.size();
    qsizetype end = last ? rest.size() - next.size() : rest.indexOf(next);
    if (last && !rest.endsWith(next)) {
      return;
    }
    while (end >= 0) {
      if (const std::optional<Shown> piece = shownPiece(candidate.places[place], rest.first(end))) {
        pieces.push_back(piece->text);
        fit(candidate, rest.sliced(end + next.size()), known + piece->known, pieces, best);
        pieces.pop_back();
      }
      end = last ? -1 : rest.indexOf(next, end + 1);
    }
  }

  std::optional<Shown> shownPiece(QChar kind, const QString& piece) {
    static const QRegularExpression kNumber("^[+-]?(\\d+(\\.\\d+)?(e[+-]?\\d+)?|inf|nan)( %)?$");
    if (kind == 'n') {
      return kNumber.match(piece).hasMatch() ? std::optional(Shown{0, QString(piece).replace('.', QLocale().decimalPoint())})
                                             : std::nullopt;
    }
    std::optional<Shown> known;
    if (kind == 's') {
      known = sentence(piece, true);
    } else if (kind == 'k') {
      known = name(piece);
    }
    return known ? known : Shown{0, piece};
  }

  QHash<QString, std::optional<Shown>> found_;
};

}  // namespace

QString shownSentence(const QString& sentence) {
  constexpr qsizetype kLongest = 4000;  // no sentence is longer; what is, is not searched for
  const std::optional<Shown> found = sentence.size() <= kLongest ? Search().sentence(sentence, false) : std::nullopt;
  return found ? found->text : sentence;
}

QString shownName(const QString& name) {
  const std::optional<Shown> found = Search().name(name);
  return found ? found->text : name;
}

}  // namespace glisson
