// Student's t-tests against published vectors, closed forms of the distribution, and the paper's own p values.

#include "reconstruction/evaluation/t_test.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace glisson {
namespace {

using Values = std::vector<double>;

constexpr double kExact = 1e-9;

struct Published {
  Values first;
  Values second;
  double t;
  double degreesOfFreedom;
  double p;
};

void expectTest(const TTestResult& result, const Published& published) {
  const auto* test = std::get_if<TTest>(&result);
  ASSERT_NE(test, nullptr);
  EXPECT_NEAR(test->t, published.t, kExact);
  EXPECT_NEAR(test->degreesOfFreedom, published.degreesOfFreedom, kExact);
  EXPECT_NEAR(test->p, published.p, kExact);
}

// Hours of sleep gained with two drugs: Student 1908; R's data set "sleep".
const Values kFirstDrug{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
const Values kSecondDrug{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};

// R prints t = -4.0621, df = 9, p = 0.002833 and t = -1.8608, df = 17.776, p = 0.07939; the further digits are those of a
// computation with 40 digits.
TEST(TTest, OfStudentsSleepDataIsThePublishedOne) {
  expectTest(pairedTTest(kFirstDrug, kSecondDrug), {{}, {}, -4.0621276833820361, 9, 0.0028328901973842727});
  expectTest(welchTTest(kFirstDrug, kSecondDrug), {{}, {}, -1.8608134674868531, 17.776473516178490, 0.079394140187358138});
}

// G. D. Ruxton's three situations (equal variances; unequal ones and sizes; a small variance in the larger group), as Wikipedia's
// article on Welch's t-test has them with t = -2.46, -1.57, -2.22, df = 25.0, 9.9, 24.5 and p = 0.021, 0.149, 0.036.
TEST(WelchTTest, OfThePublishedExamplesIsExact) {
  const std::vector<Published> examples{
      {{27.5, 21.0, 19.0, 23.6, 17.0, 17.9, 16.9, 20.1, 21.9, 22.6, 23.1, 19.6, 19.0, 21.7, 21.4},
       {27.1, 22.0, 20.8, 23.4, 23.4, 23.5, 25.8, 22.0, 24.8, 20.2, 21.9, 22.1, 22.9, 20.5, 24.4},
       -2.4553563982860051,
       24.988529290231414,
       0.021378001462867032},
      {{17.2, 20.9, 22.6, 18.1, 21.7, 21.4, 23.5, 24.2, 14.7, 21.8},
       {21.5, 22.8, 21.0, 23.0, 21.6, 23.6, 22.5, 20.7, 23.4, 21.8, 20.7, 21.7, 21.5, 22.5, 23.6, 21.5, 22.5, 23.5, 21.5, 21.8},
       -1.5654335235985052,
       9.9047412486508289,
       0.14884169660532799},
      {{19.8, 20.4, 19.6, 17.8, 18.5, 18.9, 18.3, 18.9, 19.5, 22.0},
       {28.2, 26.6, 20.1, 23.3, 25.2, 22.1, 17.7, 27.6, 20.6, 13.7, 23.2, 17.5, 20.6, 18.0, 23.9, 21.6, 24.3, 20.4, 24.0, 13.2},
       -2.2192409158236249,
       24.496223124201239,
       0.035972271029796707}};
  for (const Published& example : examples) {
    expectTest(welchTTest(example.first, example.second), example);
  }
}

Values ratings(std::initializer_list<int> counts) {
  Values values;
  int value = 0;
  for (const int count : counts) {
    values.insert(values.end(), static_cast<std::size_t>(count), ++value);
  }
  return values;
}

// The paper tells 48 ratings a method with means 2.729, 3.291 and 3.333, and three p values. Of all sums of squares that whole
// ratings can have, one triple alone (399, 544, 558) gives the three p values: the ratings themselves are not told by it, but every
// test of them is.
TEST(WelchTTest, GivesTheThreePValuesOfThePaper) {
  const Values best = ratings({7, 6, 30, 3, 2});
  const Values similar = ratings({0, 5, 26, 15, 2});
  const Values poisson = ratings({0, 5, 24, 17, 2});
  ASSERT_EQ(best.size(), 48U);
  ASSERT_EQ(similar.size(), 48U);
  ASSERT_EQ(poisson.size(), 48U);
  const auto test = [](const Values& a, const Values& b) { return std::get<TTest>(welchTTest(a, b)); };
  EXPECT_NEAR(test(poisson, best).meanDifference, 3.333 - 2.729, 1e-3);
  EXPECT_NEAR(test(poisson, best).p, 0.0006661, 5e-8);
  EXPECT_NEAR(test(similar, best).p, 0.001382, 5e-7);
  EXPECT_NEAR(test(poisson, similar).p, 0.777, 5e-4);
}

/// Pairs whose differences are these.
TTest ofDifferences(const Values& differences) {
  return std::get<TTest>(pairedTTest(differences, Values(differences.size(), 0.0)));
}

TEST(PairedTTest, HasThePOfTheDistributionsClosedForms) {
  for (double shift = -3; shift <= 3; shift += 0.37) {
    const TTest one = ofDifferences({shift - 1, shift + 1});  // one degree of freedom: Cauchy's distribution
    EXPECT_NEAR(one.t, shift, kExact);
    EXPECT_NEAR(one.p, 1 - 2 / std::numbers::pi * std::atan(std::abs(shift)), kExact);
    const TTest two = ofDifferences({shift - 1, shift, shift + 1});
    EXPECT_EQ(two.degreesOfFreedom, 2);
    EXPECT_NEAR(two.t, shift * std::sqrt(3.0), kExact);
    EXPECT_NEAR(two.p, 1 - std::abs(two.t) / std::sqrt(2 + two.t * two.t), kExact);
  }
}

TEST(WelchTTest, OfTwoEquallySpreadGroupsOfTwoHasTwoDegreesOfFreedom) {
  const TTest test = std::get<TTest>(welchTTest(Values{1, 3}, Values{4, 6}));
  EXPECT_NEAR(test.t, -3 / std::sqrt(2.0), kExact);
  EXPECT_NEAR(test.degreesOfFreedom, 2, kExact);
  EXPECT_NEAR(test.p, 1 - std::abs(test.t) / std::sqrt(2 + test.t * test.t), kExact);
}

TEST(WelchTTest, WithOneConstantGroupHasTheDegreesOfFreedomOfTheOther) {
  const TTest test = std::get<TTest>(welchTTest(Values{2, 3, 4}, Values{3.5, 3.5, 3.5, 3.5}));
  EXPECT_NEAR(test.degreesOfFreedom, 2, kExact);
  EXPECT_NEAR(test.t, -0.5 * std::sqrt(3.0), kExact);
}

TEST(TTest, ExchangedGroupsGiveTheOppositeAndAScaleChangesNothing) {
  const TTest test = std::get<TTest>(welchTTest(kFirstDrug, kSecondDrug));
  const TTest exchanged = std::get<TTest>(welchTTest(kSecondDrug, kFirstDrug));
  EXPECT_EQ(exchanged.t, -test.t);
  EXPECT_EQ(exchanged.p, test.p);
  EXPECT_EQ(exchanged.meanDifference, -test.meanDifference);
  for (const double factor : {1e-100, 1e-6, 1e6, 1e100}) {
    Values first = kFirstDrug;
    Values second = kSecondDrug;
    for (Values* values : {&first, &second}) {
      for (double& value : *values) {
        value *= factor;
      }
    }
    const TTest scaled = std::get<TTest>(welchTTest(first, second));
    EXPECT_NEAR(scaled.t, test.t, kExact) << factor;
    EXPECT_NEAR(scaled.degreesOfFreedom, test.degreesOfFreedom, kExact) << factor;
    EXPECT_NEAR(scaled.p, test.p, kExact) << factor;
  }
}

TEST(TTest, EqualMeansHaveAPOfOne) {
  EXPECT_EQ(std::get<TTest>(welchTTest(Values{1, 2, 3}, Values{0, 2, 4})).p, 1);
  EXPECT_EQ(std::get<TTest>(pairedTTest(Values{1, 2, 3}, Values{2, 1, 3})).p, 1);
}

TEST(TTest, OfFewerThanTwoValuesIsNamedAsTooFew) {
  EXPECT_EQ(std::get<NoTTest>(welchTTest({}, {})), NoTTest::TooFew);
  EXPECT_EQ(std::get<NoTTest>(welchTTest(Values{1}, Values{1, 2, 3})), NoTTest::TooFew);
  EXPECT_EQ(std::get<NoTTest>(welchTTest(Values{1, 2, 3}, Values{1})), NoTTest::TooFew);
  EXPECT_EQ(std::get<NoTTest>(pairedTTest({}, {})), NoTTest::TooFew);
  EXPECT_EQ(std::get<NoTTest>(pairedTTest(Values{1}, Values{3})), NoTTest::TooFew);
}

TEST(TTest, WithoutSpreadIsNamedSoAlsoWhereRoundingLeavesARest) {
  EXPECT_EQ(std::get<NoTTest>(welchTTest(Values{3, 3, 3}, Values{3, 3})), NoTTest::NoSpread);
  EXPECT_EQ(std::get<NoTTest>(welchTTest(Values{4, 4, 4}, Values{3, 3})), NoTTest::NoSpread);
  EXPECT_EQ(std::get<NoTTest>(welchTTest(Values(7, 0.1), Values(3, 0.7))), NoTTest::NoSpread);
  EXPECT_EQ(std::get<NoTTest>(pairedTTest(Values{1, 2, 5}, Values{2, 3, 6})), NoTTest::NoSpread);
  EXPECT_EQ(std::get<NoTTest>(pairedTTest(Values{1.1, 2.3, 4.7}, Values{1.4, 2.6, 5.0})), NoTTest::NoSpread);
  EXPECT_EQ(std::get<NoTTest>(pairedTTest(Values{2, 3}, Values{2, 3})), NoTTest::NoSpread);
}

TEST(PairedTTest, RefusesGroupsOfDifferentLength) {
  EXPECT_THROW(pairedTTest(Values{1, 2, 3}, Values{1, 2}), std::invalid_argument);
}

}  // namespace
}  // namespace glisson
