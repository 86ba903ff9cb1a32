// A frame draws few new props; what was drawn stays drawn, what the user hides stays hidden.

#include "viewer/first_frames.h"

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkNew.h>

namespace glisson {
namespace {

class FirstFramesTest : public testing::Test {
 protected:
  FirstFramesTest() {
    for (std::size_t n = 0; n < actors.size(); ++n) {
      (n < 5 ? model : overlay)->AddViewProp(actors[n]);
    }
    actors[2]->VisibilityOff();  // by the user
  }

  /// How many a frame would draw.
  int shown(bool peels = false) {
    held = frames.hold(std::array<vtkRenderer*, 2>{model, overlay}, peels);
    int count = 0;
    for (const auto& actor : actors) {
      count += actor->GetVisibility();
    }
    frames.release();
    return count;
  }

  vtkNew<vtkRenderer> model;
  vtkNew<vtkRenderer> overlay;
  std::array<vtkNew<vtkActor>, 9> actors;
  FirstFrames frames;
  FirstFrames::Held held;
};

TEST_F(FirstFramesTest, DrawOneThenAFewMoreUntilAllAreDrawn) {
  EXPECT_EQ(shown(), 1);
  EXPECT_TRUE(held.more);
  EXPECT_EQ(shown(), 4);
  EXPECT_TRUE(held.more);
  EXPECT_EQ(shown(), 7);
  EXPECT_TRUE(held.more);
  EXPECT_EQ(shown(), 8);
  EXPECT_TRUE(held.anyNew);
  EXPECT_FALSE(held.more);
  EXPECT_EQ(shown(), 8);
  EXPECT_FALSE(held.anyNew);
}

TEST_F(FirstFramesTest, LeaveWhatIsHiddenHiddenAndShowTheRestAgainAfterTheFrame) {
  shown();
  for (std::size_t n = 0; n < actors.size(); ++n) {
    EXPECT_EQ(actors[n]->GetVisibility(), n == 2 ? 0 : 1) << n;
  }
}

TEST_F(FirstFramesTest, BeginAnewWithDepthPeeling) {
  while (shown() < 8) {
  }
  EXPECT_EQ(shown(true), 1);
  EXPECT_EQ(shown(false), 8);
}

TEST_F(FirstFramesTest, ANewPropIsDrawnAtOnceBesideThoseDrawnBefore) {
  while (shown() < 8) {
  }
  actors[2]->VisibilityOn();
  EXPECT_EQ(shown(), 9);
  EXPECT_FALSE(held.more);
}

}  // namespace
}  // namespace glisson
