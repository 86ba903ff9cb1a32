#pragma once
// Purpose: the libraries' sentences in the language of the window. reconstruction/, planning/ and glisson-import know no Qt and
// speak English; their sentences are also stored in cases. Here each has a row (sentences_*.cpp) that is found again by its fixed
// words. A sentence that names a flag of the command line has another text for the window. The test sentences_test reads the
// libraries' sources and fails where a sentence has no row.

#include <QString>
#include <string>

namespace glisson {

/// `sentence` in the window's language with the same names and numbers; several sentences in one text are shown one by one. What
/// has no row comes back as it is. Ask again when the language changes: keep the English sentence, not the shown one.
QString shownSentence(const QString& sentence);
inline QString shownSentence(const std::string& sentence) { return shownSentence(QString::fromStdString(sentence)); }

/// The name of a structure, resection or label: translated where it is a common word ("portal vein", "tumour 2"), else as it is.
QString shownName(const QString& name);
inline QString shownName(const std::string& name) { return shownName(QString::fromStdString(name)); }

}  // namespace glisson
