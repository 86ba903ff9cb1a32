// The section, the handles and the coarse stand-in without any drawing: analytic bodies.

#include "viewer/plane_section.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "tests/viewer/bodies.h"
#include "viewer/clustering.h"
#include "viewer/plane_handles.h"

namespace glisson {
namespace {

using test::sphere;

SurfaceMesh both(SurfaceMesh a, const SurfaceMesh& b) {
  const auto offset = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Triangle& t : b.triangles) {
    a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  return a;
}

ViewCamera anteriorCamera() {
  ViewCamera camera;
  camera.position = Vec3(0, -500, 0);
  camera.forward = Vec3::UnitY();
  camera.up = Vec3::UnitZ();
  camera.viewAngle = std::numbers::pi / 6;
  camera.width = 640;
  camera.height = 480;
  return camera;
}

TEST(PlaneSectionTest, ASphereIsCutInOneCircleOfTheRightRadius) {
  const HalfSpace plane{Vec3(10, 20, 30) + 15 * Vec3(1, 2, 2) / 3, Vec3(1, 2, 2) / 3};
  const auto loops = sectionLoops(sphere(Vec3(10, 20, 30), Vec3(25, 25, 25), 60), plane);
  ASSERT_EQ(loops.size(), 1U);
  for (const Vec3& point : loops[0]) {
    EXPECT_NEAR((point - plane.origin).norm(), 20.0, 0.1);
    EXPECT_NEAR(plane.normal.dot(point - plane.origin), 0.0, 1e-9);
  }
  EXPECT_LT((centreOf(loops, plane) - plane.origin).norm(), 0.1);
  EXPECT_NEAR(reach(loops, plane, plane.origin, axesOf(plane.normal).u), 20.0, 0.1);
}

TEST(PlaneSectionTest, APlaneThroughVerticesGivesClosedLoopsToo) {
  const auto loops = sectionLoops(sphere(Vec3::Zero(), Vec3(25, 25, 25), 12), HalfSpace{Vec3::Zero(), Vec3::UnitZ()});
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_TRUE(isInside(loops, {Vec3::Zero(), Vec3::UnitZ()}, Vec3(24, 0, 0)));
  EXPECT_FALSE(isInside(loops, {Vec3::Zero(), Vec3::UnitZ()}, Vec3(25.5, 0, 0)));
}

TEST(PlaneSectionTest, APlaneBesideTheBodyHasNoSection) {
  EXPECT_TRUE(sectionLoops(sphere(Vec3::Zero(), Vec3(25, 25, 25)), HalfSpace{Vec3(30, 0, 0), Vec3::UnitX()}).empty());
}

TEST(PlaneSectionTest, AHoleIsOutsideAndTheGridStopsAtIt) {
  const SurfaceMesh shell = both(sphere(Vec3::Zero(), Vec3(40, 40, 40), 40), sphere(Vec3::Zero(), Vec3(15, 15, 15), 40));
  const HalfSpace plane{Vec3(0, 0, 1), Vec3::UnitZ()};
  const auto loops = sectionLoops(shell, plane);
  EXPECT_EQ(loops.size(), 2U);
  EXPECT_FALSE(isInside(loops, plane, Vec3(3, 2, 1)));
  EXPECT_TRUE(isInside(loops, plane, Vec3(25, 0, 1)));
  const auto lines = gridLines(loops, plane, 10.0);
  ASSERT_FALSE(lines.empty());
  for (const auto& [from, to] : lines) {
    EXPECT_TRUE(isInside(loops, plane, 0.5 * (from + to)));
  }
}

TEST(PlaneSectionTest, AxesAreRightHandedUnitVectorsInThePlane) {
  for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(0.3, -0.5, 0.8), Vec3(-1, 2, 0.1)}) {
    const Vec3 normal = direction.normalized();
    const PlaneAxes axes = axesOf(normal);
    EXPECT_TRUE(axes.u.cross(axes.v).isApprox(normal, 1e-12));
    EXPECT_NEAR(axes.u.norm(), 1.0, 1e-12);
  }
}

TEST(ViewCameraTest, ThePixelOfAPointGivesARayThroughIt) {
  const ViewCamera camera = anteriorCamera();
  const Vec3 point(31, 12, -47);
  const Ray ray = camera.rayAt(camera.toPixel(point));
  EXPECT_LT((point - ray.origin).cross(ray.direction).norm(), 1e-9);
  EXPECT_GT(camera.toPixel(Vec3(50, 0, 0)).x(), 320);  // the patient's left is on the picture's right
  EXPECT_LT(camera.toPixel(Vec3(0, 0, 50)).y(), 240);  // the head is up
}

TEST(PlaneHandlesTest, TheAnchorIsTheOriginInsideTheSectionAndTheSectionsCentreElse) {
  const SurfaceMesh body = sphere(Vec3::Zero(), Vec3(40, 40, 40), 40);
  const HalfSpace inside{Vec3(0, 10, 5), Vec3::UnitX()};
  EXPECT_TRUE(anchorOf(inside, sectionLoops(body, inside)).isApprox(inside.origin));
  const HalfSpace outside{Vec3(0, 100, 5), Vec3::UnitX()};
  EXPECT_LT(anchorOf(outside, sectionLoops(body, outside)).norm(), 0.1);
}

TEST(PlaneHandlesTest, EachHandleIsFoundAtItsOwnPixelAndNothingElsewhere) {
  const ViewCamera camera = anteriorCamera();
  const HalfSpace plane{Vec3::Zero(), Vec3(1, -1, 0.4).normalized()};
  const auto loops = sectionLoops(sphere(Vec3::Zero(), Vec3(60, 60, 60), 40), plane);
  const HandleLayout layout = layoutHandles(plane, Vec3::Zero(), loops, camera);
  EXPECT_EQ(handleAt(layout, camera, camera.toPixel(layout.anchor)), PlaneHandle::Centre);
  EXPECT_EQ(handleAt(layout, camera, camera.toPixel(layout.arrowTip)), PlaneHandle::Normal);
  EXPECT_EQ(handleAt(layout, camera, camera.toPixel(layout.tilts[0])), PlaneHandle::TiltRight);
  EXPECT_EQ(handleAt(layout, camera, camera.toPixel(layout.tilts[3])), PlaneHandle::TiltDown);
  EXPECT_TRUE(layout.spinShown);
  EXPECT_EQ(handleAt(layout, camera, camera.toPixel(layout.spin)), PlaneHandle::Spin);
  EXPECT_EQ(handleAt(layout, camera, Pixel(20, 20)), std::nullopt);
}

TEST(PlaneHandlesTest, TheWordAtTheArrowStaysInsideTheView) {
  const ViewCamera camera = anteriorCamera();
  for (const Vec3& normal : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(0, 1, 0)}) {
    for (const double at : {0.0, 100.0, 150.0}) {
      const HalfSpace plane{at * normal, normal};
      const Pixel word = camera.toPixel(layoutHandles(plane, plane.origin, {}, camera).label);
      EXPECT_GE(word.x(), kLabelHalfWidth - 1e-6);
      EXPECT_LE(word.x(), camera.width - kLabelHalfWidth + 1e-6);
      EXPECT_GE(word.y(), kLabelHalfHeight - 1e-6);
      EXPECT_LE(word.y(), camera.height - kLabelHalfHeight + 1e-6);
      const HandleLayout layout = layoutHandles(plane, plane.origin, {}, camera);
      const Pixel tip = camera.toPixel(layout.arrowTip);
      EXPECT_TRUE(std::abs(word.x() - tip.x()) >= kLabelHalfWidth - 16 || std::abs(word.y() - tip.y()) >= kLabelHalfHeight)
          << "the arrow would cross the word";
    }
  }
}

TEST(PlaneHandlesTest, ADragBackToItsStartGivesTheSamePlane) {
  const ViewCamera camera = anteriorCamera();
  const HalfSpace plane{Vec3(5, 3, 2), Vec3(1, -1, 0.4).normalized()};
  const auto loops = sectionLoops(sphere(Vec3::Zero(), Vec3(60, 60, 60), 40), plane);
  const HandleLayout layout = layoutHandles(plane, anchorOf(plane, loops), loops, camera);
  for (const PlaneHandle handle : {PlaneHandle::Centre, PlaneHandle::Normal, PlaneHandle::TiltRight, PlaneHandle::TiltUp,
                                   PlaneHandle::TiltLeft, PlaneHandle::TiltDown}) {
    const Pixel start(330, 200);
    const HalfSpace same = PlaneDrag(handle, plane, layout, camera, start).planeAt(start);
    EXPECT_LT((same.normal - plane.normal).norm(), 1e-6);
    EXPECT_NEAR(plane.normal.dot(same.origin - plane.origin), 0.0, 1e-6);
  }
}

TEST(PlaneHandlesTest, ABentPlanesOriginGoesAlongWithTheAnchor) {
  const ViewCamera camera = anteriorCamera();
  ResectionPlane plane(Vec3(5, 3, 2), Vec3(1, -1, 0.4).normalized());
  plane.bend = flatBend(plane, 40);
  const Vec3 anchor = plane.origin + 20 * axesOf(plane.normal).u;
  const auto loops = sectionLoops(sphere(Vec3::Zero(), Vec3(60, 60, 60), 40), plane);
  const HandleLayout layout = layoutHandles(plane, anchor, loops, camera);
  for (const PlaneHandle handle : {PlaneHandle::Centre, PlaneHandle::TiltRight, PlaneHandle::TiltUp}) {
    const Pixel start(330, 200);
    const PlaneDrag drag(handle, plane, layout, camera, start);
    const HalfSpace moved = drag.planeAt(start + Pixel(1, 0));
    const Vec3 carried = moved.origin - drag.anchorFor(moved);
    EXPECT_NEAR(carried.norm(), 20, 1e-6);
    EXPECT_NEAR(carried.dot(moved.normal), 0, 1e-6);
    EXPECT_LT((moved.origin - plane.origin).norm(), 3) << "it does not jump";
    EXPECT_GT((moved.origin - plane.origin).norm() + (moved.normal - plane.normal).norm(), 1e-4);
  }
}

TEST(PlaneHandlesTest, AnArrowSeenEndOnStillMovesThePlane) {
  const ViewCamera camera = anteriorCamera();
  const HalfSpace plane{Vec3::Zero(), Vec3::UnitY()};
  const HandleLayout layout = layoutHandles(plane, Vec3::Zero(), {}, camera);
  const PlaneDrag drag(PlaneHandle::Normal, plane, layout, camera, Pixel(320, 240));
  EXPECT_NEAR(drag.planeAt(Pixel(320, 220)).origin.y(), 20 * layout.mmPerPixel, 1e-9);
}

TEST(ClusteredTest, TheStandInIsSmallAndStaysWithinTheBody) {
  const SurfaceMesh fine = sphere(Vec3(5, 5, 5), Vec3(60, 50, 40), 120);
  const SurfaceMesh coarse = clustered(fine, 5000);
  EXPECT_LT(coarse.triangles.size(), 10000U);
  EXPECT_GT(coarse.triangles.size(), 2000U);
  EXPECT_NEAR((boundsOf(coarse).high - boundsOf(fine).high).norm(), 0.0, 3.0);
  EXPECT_NEAR(signedVolumeMm3(coarse) / signedVolumeMm3(fine), 1.0, 0.03);
  EXPECT_EQ(clustered(fine, 1000000).triangles.size(), fine.triangles.size());
}

}  // namespace
}  // namespace glisson
