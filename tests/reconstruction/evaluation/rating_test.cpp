// A blind rating: whom what is shown, what counts, what the ratings say, and the file that a session is kept in.

#include "reconstruction/evaluation/rating.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>

#include "csv.h"
#include "reconstruction/csv.h"
#include "reconstruction/errors.h"
#include "reconstruction/evaluation/rating_csv.h"
#include "reconstruction/evaluation/rating_results.h"
#include "reconstruction/evaluation/rating_tests_csv.h"
#include "reconstruction/text.h"

namespace glisson {
namespace {

/// As in the paper: 6 patients, of each the best PSR, the similar MCSD and the best MCSD.
std::vector<RatedModel> paperModels() {
  std::vector<RatedModel> models;
  for (int patient = 1; patient <= 6; ++patient) {
    for (const char* method : {"C_best", "C_sim", "P_best"}) {
      const std::string subject = "P" + std::to_string(patient);
      models.push_back({subject + "-" + method, method, subject});
    }
  }
  return models;
}

constexpr std::uint32_t kSeed = 20161;
constexpr const char* kQuestion = "How good is it for \"planning\", and for guidance?";

RatingStudy paperStudy() { return ratingStudy(kQuestion, paperModels(), kSeed); }

/// Every showing rated by `valueOf`.
RatingSession ratedBy(RatingSession session, const std::string& name,
                      const std::function<int(const RatedModel&, const Showing&)>& valueOf) {
  session = withRater(std::move(session), name);
  double seconds = 1.5;
  while (const std::optional<Showing> showing = session.next()) {
    session = withRating(session, {valueOf(session.study.models[showing->model], *showing), seconds});
    seconds += 0.1;
  }
  return session;
}

int sameForAll(const RatedModel& /*model*/, const Showing& /*showing*/) { return 3; }

std::vector<std::size_t> ordersOf(const std::vector<Showing>& showings) {
  std::vector<std::size_t> order;
  for (const Showing& showing : showings) {
    if (showing.counts) {
      order.push_back(showing.model);
    }
  }
  return order;
}

// ---- what is shown

TEST(RatingOrder, ShowsEveryModelOnceThatCountsAndTheFirstSixBeforehand) {
  const RatingStudy study = paperStudy();
  for (std::size_t rater = 0; rater < 8; ++rater) {
    const std::vector<Showing> showings = showingsFor(study, rater);
    ASSERT_EQ(showings.size(), 24U);
    const std::vector<std::size_t> order = ordersOf(showings);
    EXPECT_EQ(std::set<std::size_t>(order.begin(), order.end()).size(), 18U);
    for (std::size_t n = 0; n < 6; ++n) {
      EXPECT_FALSE(showings[n].counts);
      EXPECT_TRUE(showings[n + 6].counts);
      EXPECT_EQ(showings[n].model, showings[n + 6].model);
    }
  }
}

// The same engine and seeding, written again in another language from the text of the standard, gave these.
TEST(RatingOrder, IsTheSameOnEveryPlatform) {
  const RatingStudy study = paperStudy();
  using Order = std::vector<std::size_t>;
  EXPECT_EQ(ordersOf(showingsFor(study, 0)), (Order{9, 12, 16, 17, 4, 1, 11, 6, 13, 14, 5, 2, 7, 15, 0, 10, 8, 3}));
  EXPECT_EQ(ordersOf(showingsFor(study, 1)), (Order{10, 3, 0, 2, 1, 17, 9, 12, 13, 6, 7, 5, 11, 4, 14, 15, 8, 16}));
  EXPECT_EQ(ordersOf(showingsFor(study, 2)), (Order{12, 9, 17, 8, 0, 2, 4, 7, 3, 1, 16, 6, 14, 10, 15, 13, 11, 5}));
}

TEST(RatingOrder, DoesNotDependOnTheOrderTheModelsWereGivenIn) {
  std::vector<RatedModel> reversed = paperModels();
  std::ranges::reverse(reversed);
  EXPECT_EQ(ratingStudy(kQuestion, reversed, kSeed), paperStudy());
}

TEST(RatingOrder, PutsEachModelAtEachPlaceEquallyOften) {
  constexpr int kSeeds = 6000;
  const std::vector<RatedModel> models{{"a", "A", ""}, {"b", "A", ""}, {"c", "B", ""}, {"d", "B", ""}};
  std::array<std::array<int, 4>, 4> seen{};
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    const std::vector<Showing> showings = showingsFor(ratingStudy("?", models, seed, 0), 0);
    for (std::size_t place = 0; place < 4; ++place) {
      ++seen[place][showings[place].model];
    }
  }
  for (const auto& place : seen) {
    for (const int count : place) {
      EXPECT_NEAR(count, 0.25 * kSeeds, 170);  // five standard deviations
    }
  }
}

TEST(RatingOrder, RepeatsNoMoreModelsThanThereAre) {
  const RatingStudy study = ratingStudy("?", {{"a", "A", ""}, {"b", "B", ""}}, 1);
  EXPECT_EQ(study.repeats, 2U);
  EXPECT_EQ(showingsFor(study, 0).size(), 4U);
}

TEST(RatingStudy, RefusesModelsThatCannotBeToldApart) {
  EXPECT_THROW(ratingStudy("?", {}, 1), std::invalid_argument);
  EXPECT_THROW(ratingStudy("?", {{"", "A", ""}}, 1), std::invalid_argument);
  EXPECT_THROW(ratingStudy("?", {{"a", "A", ""}, {"b", "A", ""}, {"a", "B", ""}}, 1), std::invalid_argument);
}

// ---- the session

TEST(RatingSession, GoesThroughAllShowingsOfOneRaterAndThenTakesTheNext) {
  RatingSession session{paperStudy(), {}};
  EXPECT_FALSE(session.next());
  EXPECT_THROW(withRating(session, {3, 1}), std::logic_error);
  session = withRater(session, "A");
  EXPECT_EQ(session.next(), showingsFor(session.study, 0).front());
  session = ratedBy({paperStudy(), {}}, "A", sameForAll);
  EXPECT_TRUE(session.finished(0));
  EXPECT_FALSE(session.next());
  session = withRater(session, "B");
  EXPECT_FALSE(session.finished(1));
  EXPECT_EQ(session.next(), showingsFor(session.study, 1).front());
}

TEST(RatingSession, RefusesWhatIsNoRatingAndARaterWithoutANameOfHisOwn) {
  const RatingSession session = withRater({paperStudy(), {}}, "A");
  for (const Rating& rating : {Rating{0, 1}, Rating{6, 1}, Rating{3, -1}, Rating{3, std::nan("")}, Rating{3, HUGE_VAL}}) {
    EXPECT_THROW(withRating(session, rating), std::invalid_argument);
  }
  const RatingSession done = ratedBy({paperStudy(), {}}, "A", sameForAll);
  EXPECT_THROW(withRater(done, "A"), UsageError);
  EXPECT_THROW(withRater(done, ""), UsageError);
}

// ---- results

int byMethod(const RatedModel& model) { return model.method == "C_best" ? 2 : model.method == "C_sim" ? 3 : 4; }

TEST(RatingResults, LeaveOutFirstLooksAndRatersThatHaveNotFinished) {
  RatingSession session = withRating(withRater({paperStudy(), {}}, "left early"), {5, 60});
  session =
      ratedBy(session, "A", [](const RatedModel& model, const Showing& showing) { return showing.counts ? byMethod(model) : 1; });
  session = withRating(withRater(session, "B"), {1, 60});
  EXPECT_EQ(ratingSessionOfCsv(ratingCsv(session), "s.csv"), session);
  const RatingResults results = ratingResults(session);
  EXPECT_EQ(results.raters, 1U);
  ASSERT_EQ(results.methods.size(), 3U);
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_EQ(results.methods[n].ratings, std::vector<double>(6, 2.0 + static_cast<double>(n)));
    EXPECT_EQ(results.methods[n].box.median, 2.0 + static_cast<double>(n));
  }
  ASSERT_EQ(results.comparisons.size(), 3U);
  EXPECT_EQ(results.comparisons[1].first, "C_best");
  EXPECT_EQ(results.comparisons[1].second, "P_best");
  EXPECT_EQ(std::get<NoTTest>(results.comparisons[1].pooled), NoTTest::NoSpread);
  EXPECT_EQ(std::get<NoTTest>(results.comparisons[1].overRaters), NoTTest::TooFew);
}

/// Four raters prefer P_best to the others by 1, the first one that of P1 by 2. `habit`: how far a rater shifts the whole scale.
RatingResults resultsOfFour(int (*habit)(int rater)) {
  RatingSession session{paperStudy(), {}};
  for (int rater = 0; rater < 4; ++rater) {
    session = ratedBy(session, "R" + std::to_string(rater), [&](const RatedModel& model, const Showing&) {
      const bool poisson = model.method == "P_best";
      return 1 + habit(rater) + (poisson ? 1 : 0) + (poisson && model.subject == "P1" && rater == 0 ? 1 : 0);
    });
  }
  return ratingResults(session);
}

TEST(RatingResults, AHabitOfARaterIsNoiseInThePooledTestAndNothingInThePairedOnes) {
  const RatingResults without = resultsOfFour([](int) { return 0; });
  const RatingResults with = resultsOfFour([](int rater) { return rater % 3; });
  for (const RatingResults* results : {&without, &with}) {
    const MethodComparison& comparison = results->comparisons[2];
    EXPECT_EQ(comparison.first + comparison.second, "C_simP_best");
    // means of the raters differ by 7/6, 1, 1, 1
    const TTest test = std::get<TTest>(comparison.overRaters);
    EXPECT_EQ(test.degreesOfFreedom, 3);
    EXPECT_NEAR(test.meanDifference, -25.0 / 24, 1e-12);
    EXPECT_NEAR(test.t, -25.0, 1e-9);
    // within the first rater: 2, 1, 1, 1, 1, 1 over the subjects; the others differ by 1 throughout
    ASSERT_EQ(comparison.withinRaters.size(), 4U);
    EXPECT_EQ(comparison.withinRaters[0].rater, "R0");
    EXPECT_NEAR(std::get<TTest>(comparison.withinRaters[0].test).t, -7.0, 1e-9);
    EXPECT_EQ(std::get<NoTTest>(comparison.withinRaters[1].test), NoTTest::NoSpread);
    EXPECT_NEAR(std::get<TTest>(comparison.pooled).meanDifference, -25.0 / 24, 1e-12);
  }
  EXPECT_GT(std::get<TTest>(with.comparisons[2].pooled).p, std::get<TTest>(without.comparisons[2].pooled).p);
}

TEST(RatingResults, PairTheGradesOfOneSubject) {
  const RatingStudy study = ratingStudy("?",
                                        {{"a3", "A", "P1", "fine"},
                                         {"a2", "A", "P1", "middle"},
                                         {"a1", "A", "P1", "coarse"},
                                         {"b2", "B", "P1", "middle"},
                                         {"b1", "B", "P1", "coarse"},
                                         {"b0", "B", "P1", "crude"}},
                                        5);
  const auto values = std::map<std::string, int>{{"a3", 1}, {"a2", 5}, {"a1", 3}, {"b2", 2}, {"b1", 2}, {"b0", 1}};
  const RatingSession session =
      ratedBy({study, {}}, "R", [&](const RatedModel& model, const Showing& /*showing*/) { return values.at(model.id); });
  const MethodComparison comparison = ratingResults(session).comparisons.at(0);
  const TTest test = std::get<TTest>(comparison.withinRaters.at(0).test);
  EXPECT_EQ(test.degreesOfFreedom, 1);
  EXPECT_NEAR(test.meanDifference, 2.0, 1e-12);  // 5 less 2, 3 less 2
  EXPECT_NEAR(test.t, 2.0, 1e-12);
  EXPECT_EQ(comparison.grades, (std::vector<std::string>{"coarse", "middle"}));
  EXPECT_NE(ratingTestsCsv(ratingResults(session)).find("paired_over_grades,R"), std::string::npos);
  EXPECT_EQ(ratingSessionOfCsv(ratingCsv(session), "s.csv"), session);
}

TEST(RatingResults, TheMedianOfAnEvenNumberIsTheMeanOfTheMiddleTwo) {
  const RatingStudy study = ratingStudy("?", {{"a", "A", "P1"}, {"b", "A", "P2"}, {"c", "B", "P1"}}, 5);
  const RatingResults results = ratingResults(ratedBy({study, {}}, "R", [](const RatedModel& model, const Showing& /*showing*/) {
    return model.id == "a" ? 2 : model.id == "b" ? 3 : 5;
  }));
  EXPECT_EQ(results.methods.at(0).box.median, 2.5);
  EXPECT_EQ(results.methods.at(1).box.median, 5.0);
}

TEST(RatingResults, OfOneSubjectHaveNoPairsWithinARater) {
  const RatingStudy study = ratingStudy("?", {{"a", "A", "P1"}, {"b", "A", "P1"}, {"c", "B", "P1"}}, 5);
  const RatingResults results = ratingResults(ratedBy({study, {}}, "R", sameForAll));
  EXPECT_EQ(std::get<NoTTest>(results.comparisons.at(0).withinRaters.at(0).test), NoTTest::TooFew);
}

TEST(RatingResults, WithoutAFinishedRaterAreEmpty) {
  const RatingResults results = ratingResults(withRater({paperStudy(), {}}, "A"));
  EXPECT_EQ(results.raters, 0U);
  EXPECT_TRUE(results.methods.empty());
  EXPECT_TRUE(results.comparisons.empty());
}

// ---- the file

TEST(RatingTestsCsv, HoldsTheNumbersOfEveryTestExactly) {
  const RatingResults results = resultsOfFour([](int rater) { return rater % 3; });
  const auto rows = test::namedRows(ratingTestsCsv(results));
  std::size_t line = 0;
  for (const MethodComparison& comparison : results.comparisons) {
    std::vector<std::pair<std::string, TTestResult>> expected{{"", comparison.pooled}, {"", comparison.overRaters}};
    for (const RaterTest& rater : comparison.withinRaters) {
      expected.emplace_back(rater.rater, rater.test);
    }
    for (std::size_t n = 0; n < expected.size(); ++n, ++line) {
      ASSERT_LT(line, rows.size());
      const auto& row = rows[line];
      EXPECT_EQ(row.at("first"), comparison.first);
      EXPECT_EQ(row.at("second"), comparison.second);
      EXPECT_EQ(row.at("test"), n == 0 ? "welch" : n == 1 ? "paired_over_raters" : "paired_over_patients");
      EXPECT_EQ(row.at("rater"), expected[n].first);
      if (const auto* test = std::get_if<TTest>(&expected[n].second)) {
        EXPECT_EQ(parseNumber(row.at("mean_difference")), test->meanDifference);
        EXPECT_EQ(parseNumber(row.at("t")), test->t);
        EXPECT_EQ(parseNumber(row.at("degrees_of_freedom")), test->degreesOfFreedom);
        EXPECT_EQ(parseNumber(row.at("p")), test->p);
        EXPECT_EQ(row.at("no_test"), "");
      } else {
        EXPECT_EQ(row.at("p"), "");
        EXPECT_EQ(row.at("no_test"), std::get<NoTTest>(expected[n].second) == NoTTest::TooFew ? "too_few" : "no_spread");
      }
      const auto second = std::ranges::find(results.methods, comparison.second, &MethodRatings::method);
      EXPECT_EQ(row.at("ratings_second"), std::to_string(second->ratings.size()));
      EXPECT_EQ(parseNumber(row.at("mean_second")), second->spread.mean);
    }
  }
  EXPECT_EQ(line, rows.size());
  EXPECT_GT(line, 0U);
}

RatingSession twoRaters(std::size_t ratingsOfTheSecond) {
  RatingSession session =
      ratedBy({paperStudy(), {}}, "O'Neil, \"J.\"\nOslo", [](const RatedModel& model, const Showing&) { return byMethod(model); });
  session = withRater(session, "Müller");
  for (std::size_t n = 0; n < ratingsOfTheSecond; ++n) {
    session = withRating(session, {1 + static_cast<int>(n % 5), 0.1 + static_cast<double>(n) / 3});
  }
  return session;
}

TEST(RatingCsv, ComesBackAsTheSameSessionWhereverItStopped) {
  for (std::size_t stopped = 0; stopped <= 24; ++stopped) {
    const RatingSession session = twoRaters(stopped);
    const RatingSession read = ratingSessionOfCsv(ratingCsv(session), "s.csv");
    EXPECT_EQ(read, session) << stopped;
    EXPECT_EQ(read.next(), session.next());
  }
}

TEST(RatingCsv, HasALineForEachShowingWithItsRatingAndTime) {
  const auto rows = test::namedRows(ratingCsv(twoRaters(2)));
  ASSERT_EQ(rows.size(), 48U);
  EXPECT_EQ(rows[0].at("rater"), "O'Neil, \"J.\"\nOslo");
  EXPECT_EQ(rows[0].at("question"), kQuestion);
  EXPECT_EQ(rows[0].at("counts"), "0");
  EXPECT_EQ(rows[6].at("counts"), "1");
  EXPECT_EQ(rows[6].at("model"), rows[0].at("model"));
  EXPECT_EQ(rows[0].at("model"), "P4-C_best");  // number 9 by id
  EXPECT_EQ(rows[0].at("method"), "C_best");
  EXPECT_EQ(rows[0].at("subject"), "P4");
  EXPECT_EQ(rows[24].at("rater"), "Müller");
  EXPECT_EQ(rows[25].at("rating"), "2");
  EXPECT_EQ(rows[24].at("seconds"), "0.1");
  EXPECT_EQ(rows[26].at("rating"), "");
  EXPECT_EQ(rows[26].at("seconds"), "");
}

TEST(RatingCsv, SavedAgainByASpreadsheetIsStillTheSession) {
  std::string text = "\xEF\xBB\xBF";
  for (const char c : ratingCsv(ratedBy({paperStudy(), {}}, "A", sameForAll))) {
    text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  }
  EXPECT_EQ(ratingSessionOfCsv(text, "s.csv").raters.front().ratings.size(), 24U);
}

TEST(RatingCsv, CutAtAnyByteIsRefusedOrNoOtherSession) {
  const std::string whole = ratingCsv(twoRaters(5));
  const RatingSession session = twoRaters(5);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    try {
      const RatingSession read = ratingSessionOfCsv(whole.substr(0, length), "s.csv");
      // without the end of the last line, or with the first rater alone, nothing is wrong
      RatingSession first = session;
      first.raters.pop_back();
      EXPECT_TRUE(read == session || read == first) << length;
    } catch (const InputError&) {
    }
  }
}

using Lines = std::vector<std::vector<std::string>>;

TEST(RatingCsv, OfAnEarlierVersionHasNoGradesAndIsTheSession) {
  const RatingSession session = twoRaters(5);
  const auto former = [&](std::size_t more) {
    std::string text;
    for (std::vector<std::string>& cells : test::readCsv(ratingCsv(session))) {
      cells.resize(text.empty() ? 11 : 11 + more);
      text += csvLine(cells);
    }
    return text;
  };
  EXPECT_EQ(ratingSessionOfCsv(former(0), "s.csv"), session);
  EXPECT_THROW(ratingSessionOfCsv(former(1), "s.csv"), InputError);
}

TEST(RatingCsv, AnAlteredFileIsRefusedInOneSentenceThatNamesFileLineAndFact) {
  struct Alteration {
    const char* what;
    std::function<void(Lines&)> alter;
    const char* expected;
  };
  const auto set = [](std::size_t line, std::size_t cell, const char* text) {
    return [=](Lines& lines) { lines[line][cell] = text; };
  };
  const std::vector<Alteration> alterations{
      {"another column", set(0, 2, "mesh"), "line 1 does not name its columns"},
      {"nothing but columns", [](Lines& lines) { lines.resize(1); }, "line 2 is missing"},
      {"a cell more", [](Lines& lines) { lines[3].emplace_back("x"); }, "line 4 has another number of cells"},
      {"rating 6", set(2, 6, "6"), "line 3 holds no such number as rating"},
      {"rating 0", set(2, 6, "0"), "line 3 holds a rating outside 1 to 5"},
      {"rating 2.5", set(2, 6, "2.5"), "line 3 holds no such number as rating"},
      {"no time", set(2, 7, ""), "line 3 holds a rating outside 1 to 5, or no time beside it"},
      {"negative time", set(2, 7, "-1"), "line 3 holds a rating outside 1 to 5, or no time beside it"},
      {"infinite time", set(2, 7, "inf"), "line 3 holds a rating outside 1 to 5, or no time beside it"},
      {"a rating taken out", [](Lines& lines) { lines[3][6] = lines[3][7] = ""; }, "behind a model that was not rated"},
      {"another seed throughout",
       [](Lines& lines) { std::for_each(lines.begin() + 1, lines.end(), [](auto& line) { line[8] = "20162"; }); },
       "line 2 does not hold the model that its seed gives"},
      {"another seed in one line", set(5, 8, "7"), "line 6 differs from the lines before in seed"},
      {"a seed too large", set(1, 8, "4294967296"), "line 2 holds no such number as seed"},
      {"another question", set(9, 10, "?"), "line 10 differs from the lines before in question"},
      {"more repeats than models", set(1, 9, "19"), "line 2 holds no such number as repeats"},
      {"another grade", set(30, 11, "fine"), "line 31 does not hold the model that its seed gives"},
      {"another method", set(30, 3, "P_best!"), "line 31 does not hold the model that its seed gives"},
      {"a model twice", set(7, 2, "P4-P_best"), "names no model, or one that was there before"},
      {"a line lost", [](Lines& lines) { lines.erase(lines.begin() + 20); }, "line 2 does not hold the model that its seed gives"},
      {"the last line lost", [](Lines& lines) { lines.pop_back(); }, "line 49 is missing, or is another rater's"},
      {"two raters of one name",
       [](Lines& lines) { std::for_each(lines.begin() + 25, lines.end(), [&](auto& line) { line[0] = lines[1][0]; }); },
       "names no model, or one that was there before"},
      {"a rater without a name",
       [](Lines& lines) { std::for_each(lines.begin() + 25, lines.end(), [](auto& line) { line[0] = ""; }); },
       "line 26 starts a rater whose name is missing"},
      {"no model counts", [](Lines& lines) { std::for_each(lines.begin() + 1, lines.end(), [](auto& line) { line[5] = "0"; }); },
       "line 2 starts a rater without models"},
  };
  for (const Alteration& alteration : alterations) {
    Lines lines = test::readCsv(ratingCsv(twoRaters(3)));
    alteration.alter(lines);
    std::string text;
    for (const auto& line : lines) {
      text += csvLine(line);
    }
    try {
      ratingSessionOfCsv(text, "ward 3/s.csv");
      ADD_FAILURE() << alteration.what << " was taken";
    } catch (const InputError& error) {
      const std::string said = error.what();
      EXPECT_NE(said.find(alteration.expected), std::string::npos) << alteration.what << ": " << said;
      EXPECT_EQ(said.find("\"ward 3/s.csv\" is no session of a blind rating"), 0U) << said;
      EXPECT_TRUE(said.ends_with("; choose a CSV file that a rating was kept in.")) << said;
    }
  }
}

TEST(RatingCsv, WithAnOpenQuoteIsRefused) {
  const std::string whole = ratingCsv(twoRaters(3));
  for (const std::string& text : {whole + "\"", "a\"b," + whole, "\"a\"b," + whole}) {
    EXPECT_THROW(ratingSessionOfCsv(text, "s.csv"), InputError);
  }
}

}  // namespace
}  // namespace glisson
