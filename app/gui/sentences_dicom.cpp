// What the readers say of DICOM series.

#include <QtGlobal>
#include <array>

#include "app/gui/sentence_table.h"

namespace glisson {

namespace {

constexpr auto kDicomRows = std::to_array<SentenceRow>({
    {"fs", QT_TRANSLATE_NOOP("Sentence", "%1 %2; copy or export the series again.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "holds colours or inverted grey (%1) instead of plain grey values")},
    {"fn",
     QT_TRANSLATE_NOOP("Sentence", "%1 holds %2 frames in one file, which is not read; export the series as one file per slice.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "has an impossible number of bits per pixel in its header")},
    {"", QT_TRANSLATE_NOOP("Sentence", "is cut off: it holds no compressed frame")},
    {"", QT_TRANSLATE_NOOP("Sentence", "is cut off within its compressed frame")},
    {"", QT_TRANSLATE_NOOP("Sentence", "is cut off: its compressed frame has no end")},
    {"", QT_TRANSLATE_NOOP("Sentence", "is cut off: it holds no pixels")},
    {"nn", QT_TRANSLATE_NOOP("Sentence", "holds %1 bytes of pixels instead of %2")},
    {"", QT_TRANSLATE_NOOP("Sentence", "stores big-endian pixels in a way that is not read")},
    {"", QT_TRANSLATE_NOOP("Sentence", "is cut off within its pixels")},
    {"", QT_TRANSLATE_NOOP("Sentence", "holds pixels of an unknown kind")},
    {"", "is damaged, or compressed in a way that is not read (%1)",
     QT_TRANSLATE_NOOP("Sentence", "is damaged, or compressed in a way that is not read")},
    {"nn",
     QT_TRANSLATE_NOOP(
         "Sentence", "holds no Hounsfield units: with its rescale slope of %1 and intercept of %2 its values leave -32768..32767")},
    {"", QT_TRANSLATE_NOOP("Sentence", "has pixels that are not finite after rescaling")},
    {"", QT_TRANSLATE_NOOP("Sentence", "%1 holds an image with many grey values, not a mask; open its folder as a CT.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "%1 holds mask series such as %2 and no CT; open it as a segmentation.")},
    {"fsff", QT_TRANSLATE_NOOP(
                 "Sentence", "%1 mixes slices of different patients (the %2 of %3 and %4 differ); give the folder of one series.")},
    {"fsff", QT_TRANSLATE_NOOP(
                 "Sentence",
                 "%1 mixes slices of different frames of reference (the %2 of %3 and %4 differ); give the folder of one series.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "%1 is a series of modality %2, not CT; choose the CT series.")},
    {"ffss",
     QT_TRANSLATE_NOOP("Sentence", "%1 holds masks on different grids: %2 has %3 and the others have %4; give masks of one CT.")},
    {"fsf",
     "%1 holds masks of different patients (the %2 of %3 differs); check the folder, or accept it with --accept other-patient.",
     QT_TRANSLATE_NOOP("Sentence",
                       "%1 holds masks of different patients (the %2 of %3 differs); check the folder, or read it all the same.")},
    {"fsf",
     "%1 holds masks of different frames of reference (the %2 of %3 differs); check the folder, or accept it with --accept "
     "other-patient.",
     QT_TRANSLATE_NOOP(
         "Sentence",
         "%1 holds masks of different frames of reference (the %2 of %3 differs); check the folder, or read it all the same.")},
    {"s", QT_TRANSLATE_NOOP("Sentence", "does not say how it lies in the patient (no %1)")},
    {"s", QT_TRANSLATE_NOOP("Sentence", "has a broken %1: it is not made of finite numbers")},
    {"", QT_TRANSLATE_NOOP("Sentence", "position")},
    {"", QT_TRANSLATE_NOOP("Sentence", "orientation")},
    {"", QT_TRANSLATE_NOOP("Sentence", "pixel spacing")},
    {"", QT_TRANSLATE_NOOP("Sentence", "has image axes that are not perpendicular unit vectors")},
    {"", QT_TRANSLATE_NOOP("Sentence", "has a pixel spacing that is not above zero")},
    {"", QT_TRANSLATE_NOOP("Sentence", "has a broken position: it lies more than 100 m from the scanner")},
    {"", QT_TRANSLATE_NOOP("Sentence", "has a rescale slope or intercept that is not a usable number")},
    {"", QT_TRANSLATE_NOOP("Sentence", "is cut off before its header")},
    {"", QT_TRANSLATE_NOOP("Sentence", "is named like the slices beside it but is no DICOM any more")},
    {"", "is damaged or cut off (%1)", QT_TRANSLATE_NOOP("Sentence", "is damaged or cut off")},
    {"", QT_TRANSLATE_NOOP("Sentence", "has no rows or columns")},
    {"nf", QT_TRANSLATE_NOOP("Sentence", "%1 file(s) hold no DICOM image and were left out, such as %2.")},
    {"fnn", QT_TRANSLATE_NOOP("Sentence",
                              "%1 has a rescale slope of %2 where its series has %3, so its Hounsfield units would be wrong; copy "
                              "or export the series again.")},
    {"f",
     QT_TRANSLATE_NOOP("Sentence",
                       "%1 lacks a rescale slope or intercept that its series has, so its Hounsfield units would be wrong; copy "
                       "or export the series again.")},
    {"nn", QT_TRANSLATE_NOOP("Sentence", "The slices have rescale slopes of their own, from %1 to %2.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "does not say to which series it belongs")},
    {"", QT_TRANSLATE_NOOP("Sentence", "says that it belongs to another series than the rest")},
    {"nnnn", QT_TRANSLATE_NOOP("Sentence", "has %1 rows and %2 columns, unlike the other slices of its series (%3 and %4)")},
    {"", QT_TRANSLATE_NOOP("Sentence", "is of modality %1, unlike the other slices of its series")},
    {"nnnn",
     QT_TRANSLATE_NOOP("Sentence", "has a pixel spacing of %1 x %2 mm, unlike the other slices of its series (%3 x %4 mm)")},
    {"", QT_TRANSLATE_NOOP("Sentence", "has another orientation than the other slices of its series")},
    {"", QT_TRANSLATE_NOOP("Sentence",
                           "%1 lies where the series of %2 lacks a slice or goes on, but says that it is a localizer; export the "
                           "series again, or take that file out of the folder.")},
    {"", QT_TRANSLATE_NOOP("Sentence",
                           "%1 lies where the series of %2 lacks a slice or goes on, but says that it is of another series; export "
                           "the series again, or take that file out of the folder.")},
    {".sf", QT_TRANSLATE_NOOP("Sentence", "%1, such as %2")},
    {"n", QT_TRANSLATE_NOOP("Sentence", "%1 image")},
    {"n", QT_TRANSLATE_NOOP("Sentence", "%1 images")},
    {"n", QT_TRANSLATE_NOOP("Sentence", "%1 image (localizer)")},
    {"n", QT_TRANSLATE_NOOP("Sentence", "%1 images (localizer)")},
    {"nf", QT_TRANSLATE_NOOP("Sentence", "%1 image of the series \"%2\"")},
    {"nf", QT_TRANSLATE_NOOP("Sentence", "%1 images of the series \"%2\"")},
    {"nf", QT_TRANSLATE_NOOP("Sentence", "%1 image of the series %2")},
    {"nf", QT_TRANSLATE_NOOP("Sentence", "%1 images of the series %2")},
    {"fss",
     "%1 holds two series of different patients: %2, and %3; give the folder of one, or one slice of it instead of the folder.",
     QT_TRANSLATE_NOOP("Sentence",
                       "%1 holds two series of different patients: %2, and %3; open the folder of one, or one slice of it.")},
    {"fss", "%1 holds two series: %2, and %3; give the folder of one, or one slice of it instead of the folder.",
     QT_TRANSLATE_NOOP("Sentence", "%1 holds two series: %2, and %3; open the folder of one, or one slice of it.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "%1 holds no DICOM slice that can be read as a volume; choose the folder with the slices.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "%1 holds only localizer images; choose the folder with the slices.")},
    {"s", QT_TRANSLATE_NOOP("Sentence", "Left out: %1.")},
    {"fn",
     QT_TRANSLATE_NOOP("Sentence", "%1 is not a volume: all %2 images lie at one position; choose the series with the volume.")},
    {"fn", QT_TRANSLATE_NOOP(
               "Sentence",
               "%1 holds %2 images at every position, so it is a time series or several phases; give the folder of one phase.")},
    {"ns", QT_TRANSLATE_NOOP("Sentence", "%1 slice(s) lie where another one lies already (%2)")},
    {".ff", QT_TRANSLATE_NOOP("Sentence", "%1 and %2")},
    {"ffnn", QT_TRANSLATE_NOOP("Sentence", "between %1 and %2 there are %3 mm instead of %4 mm (a missing or uneven slice)")},
    {"fn", QT_TRANSLATE_NOOP("Sentence", "the slice %1 lies %2 mm off the even spacing")},
    {"fnf", QT_TRANSLATE_NOOP("Sentence",
                              "%1 lies %2 mm from %3, so one of the two has a broken position; copy or export the series again.")},
    {"fsf", "%1 is no regular volume: %2; accept resampling it to a regular grid with --accept %3.",
     QT_TRANSLATE_NOOP(
         "Sentence", "%1 is no regular volume: %2; choose another series, or read it all the same, resampled to a regular grid.")},
    {".ss", QT_TRANSLATE_NOOP("Sentence", "%1, and %2")},
    {"", QT_TRANSLATE_NOOP("Sentence", "%1 is not a volume: it holds a single slice; choose the folder with the whole series.")},
    {"n", QT_TRANSLATE_NOOP("Sentence", "the gantry was tilted by %1 degrees")},
    {"n", QT_TRANSLATE_NOOP("Sentence", "slices are shifted sideways by up to %1 mm")},
    {"s", QT_TRANSLATE_NOOP("Sentence", "Resampled to a regular grid with consent: %1.")},
});

}  // namespace

std::span<const SentenceRow> dicomSentences() { return kDicomRows; }

}  // namespace glisson
