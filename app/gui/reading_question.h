#pragma once
// Purpose: a refused input that a person can let pass: asks for consent to what was found, or which of a NIfTI file's two frames
// holds. UI thread; the dialog does not block the event loop.

#include <QString>
#include <functional>

#include "reconstruction/io/read.h"

class QWidget;

namespace glisson {

/// Asks what `refusal` (an InputError's sentence, in English) is about, and calls `again` with `options` and the answer in them.
/// False where it asks nothing, or what they answer already: then it is to be shown as it is.
bool askToRead(QWidget* parent, const QString& refusal, const ReadOptions& options,
               const std::function<void(const ReadOptions&)>& again);

}  // namespace glisson
