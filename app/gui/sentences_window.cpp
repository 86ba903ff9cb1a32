// What the window itself refuses or notes; names a structure may carry.

#include <QtGlobal>
#include <array>

#include "app/gui/sentence_table.h"

namespace glisson {

namespace {

constexpr auto kWindowRows = std::to_array<SentenceRow>({
    {"ffs", QT_TRANSLATE_NOOP("Sentence", "%1 and %2 both hold %3; open one of them at a time.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "a case")},
    {"", QT_TRANSLATE_NOOP("Sentence", "a CT")},
    {"", QT_TRANSLATE_NOOP("Sentence", "a segmentation")},
    {"",
     QT_TRANSLATE_NOOP("Sentence",
                       "The CT at %1 is not the one this case was made from (its files have changed): its slices are not shown; "
                       "put the files of then back to see them.")},
    {"",
     QT_TRANSLATE_NOOP(
         "Sentence",
         "%1 holds neither a CT, nor a segmentation, nor a case; choose a DICOM folder, NIfTI, NRRD, MetaImage or .glisson file.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "%1 holds a CT without a segmentation; open the CT and its segmentation together.")},
    {"", QT_TRANSLATE_NOOP(
             "Sentence",
             "The CT at %1 is not the one this case was made from (its files have changed): the CT embedded in the case is "
             "shown.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The CT of this case is not at %1: the CT embedded in the case is shown.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The CT at %1 cannot be read: the CT embedded in the case is shown.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "A note that names the patient is left out.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "%1 is the file this case is kept in; save the copy under another name.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The CT of this case is no longer at %1; put it back to see the slices.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The CT at %1 does not lie on the grid of the labels and is not shown.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The liver's mask is empty; there is nothing to place a plane on.")},
    {"fk", "%1 has the label %2 of unknown kind; name it with --labels.",
     QT_TRANSLATE_NOOP("Sentence", "%1 has the label %2 of unknown kind; open it again and choose its kind.")},
    {"ks", QT_TRANSLATE_NOOP("Sentence", "%1 could not be reconstructed: %2")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The normal (0, 0, 0) has no direction; enter at least one component.")},
    {"", QT_TRANSLATE_NOOP("Sentence",
                           "%1 is open in another program or write-protected: changes are kept in a copy of it; save that under "
                           "another name.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The change is in no file: save the case under another name.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The plane can be placed as soon as the liver's volumes are computed.")},
    {"knnn", QT_TRANSLATE_NOOP("Sentence",
                               "The plane around %1 keeps at least %2 mm, takes by itself %3 mL of functional liver and crosses %4 "
                               "vessels of 3 mm and more.")},
    {"kn", QT_TRANSLATE_NOOP("Sentence", "It crosses %1, %2 mm wide.")},
    {"kn", QT_TRANSLATE_NOOP("Sentence", "It cuts along %1, %2 mm wide.")},
    {"k", QT_TRANSLATE_NOOP("Sentence",
                            "The plan has changed while the plane around %1 was sought, so it is not placed; ask for it again.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "Open a case first.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "%1 cannot be written; check the folder.")},
    {"", QT_TRANSLATE_NOOP("Sentence",
                           "The case holds neither name, id nor birth date of the patient; write the report without them.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The plan's numbers are still being computed; try again in a moment.")},
    {"k", QT_TRANSLATE_NOOP("Sentence", "%1 has no surface yet.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "Choose a format.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The work ended with an unknown error.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "There is not enough memory for this; close other programs and try again.")},
});

constexpr auto kNames = std::to_array<SentenceRow>({
    {"", QT_TRANSLATE_NOOP("Sentence", "liver")},
    {"", QT_TRANSLATE_NOOP("Sentence", "portal vein")},
    {"", QT_TRANSLATE_NOOP("Sentence", "hepatic vein")},
    {"", QT_TRANSLATE_NOOP("Sentence", "vena cava")},
    {"", QT_TRANSLATE_NOOP("Sentence", "artery")},
    {"", QT_TRANSLATE_NOOP("Sentence", "tumour")},
    {"", QT_TRANSLATE_NOOP("Sentence", "cyst")},
    {"", QT_TRANSLATE_NOOP("Sentence", "gallbladder")},
    {"", QT_TRANSLATE_NOOP("Sentence", "bile duct")},
    {"n", QT_TRANSLATE_NOOP("Sentence", "tumour %1")},
    {"n", QT_TRANSLATE_NOOP("Sentence", "cyst %1")},
    {"n", QT_TRANSLATE_NOOP("Sentence", "label %1")},
    {"kn", QT_TRANSLATE_NOOP("Sentence", "%1 of layer %2")},
    {"n", QT_TRANSLATE_NOOP("Sentence", "Resection %1")},
    {"n", QT_TRANSLATE_NOOP("Sentence", "Distance %1")},
    {"n", QT_TRANSLATE_NOOP("Sentence", "Territory %1")},
    {"", QT_TRANSLATE_NOOP("Sentence", "not picked")},
    {"n", QT_TRANSLATE_NOOP("Sentence", "Plan %1")},
});

}  // namespace

std::span<const SentenceRow> windowSentences() { return kWindowRows; }

std::span<const SentenceRow> knownNames() { return kNames; }

}  // namespace glisson
