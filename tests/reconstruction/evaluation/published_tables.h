#pragma once
// Purpose: Tables 2 to 5 of Palomar et al. 2016 as printed, for tests of the formulas.

#include <array>

namespace glisson::test {

struct PublishedModel {
  double kiloTriangles;
  double meanErrorMm;
  double score;
};

struct PublishedPatient {
  std::array<double, 4> psrScores;      ///< Table 2, d = 5..8
  PublishedModel bestPsr;               ///< Table 3, I
  PublishedModel mostSimilar;           ///< Table 3, II
  PublishedModel bestMcsd;              ///< Table 3, III
  std::array<double, 4> psrCurvatures;  ///< Table 4, d = 5..8, 1e-3
  double similarCurvature;
  double bestMcsdCurvature;
  std::array<double, 3> seconds;  ///< Table 5: PSR d = 7, most similar MCSD, best MCSD
};

inline constexpr std::array<PublishedPatient, 6> kPublished{{
    {{1.000, 0.416, 0.184, 0.405},
     {62, 1.11, 0.18},
     {625, 0.64, 1.00},
     {125, 0.98, 0.22},
     {4.56, 0.29, 0.19, 0.19},
     0.19,
     1.60,
     {14.5, 9.4, 13.7}},
    {{1.000, 0.341, 0.248, 0.541},
     {75, 1.37, 0.24},
     {207, 1.48, 0.70},
     {59, 1.79, 0.25},
     {11.17, 31.96, 0.706, 14.34},
     0.72,
     6186.43,
     {12.4, 5.8, 6.2}},
    {{1.000, 0.404, 0.165, 0.439},
     {71, 0.94, 0.16},
     {263, 0.81, 0.40},
     {131, 0.89, 0.22},
     {37.19, 52.42, 28.28, 0.75},
     17.56,
     21743.83,
     {13.8, 13.8, 13.0}},
    {{1.000, 0.418, 0.161, 0.461},
     {82, 0.84, 0.16},
     {293, 0.72, 0.40},
     {73, 1.05, 0.21},
     {8.22, 14.86, 151.16, 3.15},
     77.46,
     20474.71,
     {15.8, 15.5, 15.7}},
    {{1.000, 0.416, 0.152, 0.312},
     {68, 0.99, 0.15},
     {715, 0.61, 0.79},
     {89, 1.13, 0.19},
     {2.06, 3.27, 0.68, 0.36},
     0.68,
     18494.12,
     {15.2, 16.6, 19.2}},
    {{1.000, 0.379, 0.148, 0.228},
     {74, 0.88, 0.14},
     {655, 0.58, 0.89},
     {72, 1.11, 0.20},
     {7.61, 5.78, 0.32, 0.20},
     0.32,
     681.94,
     {15.3, 11.2, 16.7}},
}};

}  // namespace glisson::test
