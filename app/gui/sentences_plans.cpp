// What planning says about the patient, the edits of plans, proposed planes, islands and compared plans.

#include <QtGlobal>
#include <array>

#include "app/gui/sentence_table.h"

namespace glisson {

namespace {

constexpr auto kPlansRows = std::to_array<SentenceRow>({
    {"", QT_TRANSLATE_NOOP("Sentence", "The height is not given, so no standardised liver volume and no threshold is shown.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The weight is not given, so no standardised liver volume and no threshold is shown.")},
    {"n", QT_TRANSLATE_NOOP("Sentence",
                            "A height of %1 cm is outside 120 to 220 cm, for which the formulas hold, so no standardised liver "
                            "volume and no threshold is shown.")},
    {"n", QT_TRANSLATE_NOOP("Sentence",
                            "A weight of %1 kg is outside 30 to 250 kg, for which the formulas hold, so no standardised liver "
                            "volume and no threshold is shown.")},
    {"n", QT_TRANSLATE_NOOP("Sentence",
                            "A body surface area of %1 m2 is outside 1.2 to 2.6 m2, for which the formulas hold, so no "
                            "standardised liver volume and no threshold is shown.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The liver's condition is not given, so no threshold is shown.")},
    {"", QT_TRANSLATE_NOOP(
             "Sentence",
             "Kubota's 40 or 50 % of the functional volume depend on ICG R15, which is not asked for, so they are not shown.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The plan does not divide the liver, so there is no remnant to compare.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "below this: R1; from this on: accepted")},
    {"", QT_TRANSLATE_NOOP("Sentence", "the old rule")},
    {"", QT_TRANSLATE_NOOP("Sentence", "below this: worse, in non-anatomical resections")},
    {"", QT_TRANSLATE_NOOP("Sentence",
                           "The height and the weight must be positive numbers in cm and kg; type them again or leave them out.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "the patient has an unknown liver condition or tumour type")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The plan has no such resection; choose one of its resections first.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The point's coordinates must be finite numbers.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "A resection needs at least one plane; place it first.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The safety margin must be a number of millimetres, 0 or more.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The plan has no such assigned island; choose one of those it has.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The plan has no such measured distance; choose one of those it has.")},
    {"nf", QT_TRANSLATE_NOOP("Sentence", "move plane %1 of %2")},
    {"n", QT_TRANSLATE_NOOP("Sentence", "move plane %1")},
    {"", QT_TRANSLATE_NOOP("Sentence", "move plane")},
    {"nf", QT_TRANSLATE_NOOP("Sentence", "remove plane %1 of %2")},
    {"n", QT_TRANSLATE_NOOP("Sentence", "remove plane %1")},
    {"", QT_TRANSLATE_NOOP("Sentence", "remove plane")},
    {"nf", QT_TRANSLATE_NOOP("Sentence", "bend plane %1 of %2")},
    {"n", QT_TRANSLATE_NOOP("Sentence", "bend plane %1")},
    {"", QT_TRANSLATE_NOOP("Sentence", "bend plane")},
    {"nf", QT_TRANSLATE_NOOP("Sentence", "flatten plane %1 of %2")},
    {"n", QT_TRANSLATE_NOOP("Sentence", "flatten plane %1")},
    {"", QT_TRANSLATE_NOOP("Sentence", "flatten plane")},
    {"nf", QT_TRANSLATE_NOOP("Sentence", "spin plane %1 of %2")},
    {"n", QT_TRANSLATE_NOOP("Sentence", "spin plane %1")},
    {"", QT_TRANSLATE_NOOP("Sentence", "spin plane")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The plane has no bend; bend it first.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The plan has a bent plane, whose sides are no convex parts; flatten it first.")},
    {"", QT_TRANSLATE_NOOP(
             "Sentence",
             "A bend needs an axis within the plane, a half size of 10 to 1000 mm and 16 heights of at most 1000 mm; bend "
             "the plane again.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "a plane's bend has not 16 heights")},
    {"", QT_TRANSLATE_NOOP("Sentence", "add plane to %1")},
    {"", QT_TRANSLATE_NOOP("Sentence", "add plane")},
    {"", QT_TRANSLATE_NOOP("Sentence", "add resection")},
    {"", QT_TRANSLATE_NOOP("Sentence", "remove distance")},
    {"", QT_TRANSLATE_NOOP("Sentence", "measure distance")},
    {"", QT_TRANSLATE_NOOP("Sentence", "change safety margin")},
    {"", QT_TRANSLATE_NOOP("Sentence", "add island to the resected side")},
    {"", QT_TRANSLATE_NOOP("Sentence", "add island to the remnant")},
    {"", QT_TRANSLATE_NOOP("Sentence", "give island back")},
    {"", QT_TRANSLATE_NOOP("Sentence", "remove %1")},
    {"k", QT_TRANSLATE_NOOP("Sentence", "accept %1")},
    {"k", QT_TRANSLATE_NOOP("Sentence", "withdraw the acceptance of %1")},
    {"k", QT_TRANSLATE_NOOP("Sentence", "show %1")},
    {"k", QT_TRANSLATE_NOOP("Sentence", "hide %1")},
    {"", QT_TRANSLATE_NOOP("Sentence", "Who accepts a structure needs a name of one line, at most 200 bytes long; type it again.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The time at which a structure was accepted is no time; accept it again.")},
    {"k", QT_TRANSLATE_NOOP("Sentence", "%1 has no surface yet, so it cannot be accepted; reconstruct the model first.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "rename %1")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The three points lie on one line, so they give no plane; click one of them elsewhere.")},
    {"",
     QT_TRANSLATE_NOOP("Sentence", "The line has no length in the view, so it gives no plane; draw it again across the liver.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The case has no such plan; choose one of its plans first.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "A case keeps at least one plan; make another one before this one is deleted.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "A name cannot be empty; type another one.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The name \"%1\" is taken; type another one.")},
    {"fn", QT_TRANSLATE_NOOP("Sentence", "%1 copy %2")},
    {"", QT_TRANSLATE_NOOP("Sentence", "%1 copy")},
    {"fs", QT_TRANSLATE_NOOP("Sentence", "The case has no tumour \"%1\" that is named once; it has: %2.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "The proposed plane is geometry only: it ignores inflow, outflow and access.")},
    {"nk",
     QT_TRANSLATE_NOOP("Sentence",
                       "No plane keeps %1 mm around %2: each one that does takes the whole functional liver or nothing of it.")},
    {"k", QT_TRANSLATE_NOOP("Sentence", "The proposed plane around %1 does not keep its margin; place the plane by hand.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "margin plane")},
    {"nnn",
     QT_TRANSLATE_NOOP(
         "Sentence", "The piece at (%1, %2, %3) mm is no island of its own, so it counts on the side where the planes leave it.")},
    {"nnn", QT_TRANSLATE_NOOP(
                "Sentence",
                "The piece at (%1, %2, %3) mm is given to the other side, but on the surface it hangs together with the rest: "
                "give it back, or move the plane, then export again.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "%1 is in %2 only.")},
    {"fnfnf", QT_TRANSLATE_NOOP("Sentence", "%1 has %2 planes in %3 and %4 in %5.")},
    {"nfnnf",
     QT_TRANSLATE_NOOP("Sentence", "Plane %1 of %2 is turned by %3 degrees and lies %4 mm from where it was placed in %5.")},
    {"nff", QT_TRANSLATE_NOOP("Sentence", "Plane %1 of %2 is bent in %3 only.")},
    {"nfff", QT_TRANSLATE_NOOP("Sentence", "Plane %1 of %2 is bent in another way in %3 than in %4.")},
    {"ssfsf", QT_TRANSLATE_NOOP("Sentence", "%1: %2 in %3, %4 in %5.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "%1 and %2 are alike.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "Two to four plans can be compared; choose that many.")},
    {"", QT_TRANSLATE_NOOP("Sentence", "Safety margin")},
    {"", QT_TRANSLATE_NOOP("Sentence", "Functional remnant")},
    {"", QT_TRANSLATE_NOOP("Sentence", "Resected")},
    {"k", QT_TRANSLATE_NOOP("Sentence", "Margin of %1, at least")},
    {"", QT_TRANSLATE_NOOP("Sentence", "Vessels of 3 mm and more crossed")},
    {".n", QT_TRANSLATE_NOOP("Sentence", "%1 mL")},
    {".n", QT_TRANSLATE_NOOP("Sentence", "%1 mm")},
    {".n", QT_TRANSLATE_NOOP("Sentence", "%1 %")},
    {".n", QT_TRANSLATE_NOOP("Sentence", "%1 places")},
    {".", QT_TRANSLATE_NOOP("Sentence", "removed")},
    {".", QT_TRANSLATE_NOOP("Sentence", "cut")},
    {".", QT_TRANSLATE_NOOP("Sentence", "left")},
    {".", QT_TRANSLATE_NOOP("Sentence", "none")},
});

}  // namespace

std::span<const SentenceRow> planSentences() { return kPlansRows; }

}  // namespace glisson
