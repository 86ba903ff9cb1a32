#include "planning/storage/case_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <thread>

#include "reconstruction/errors.h"
#include "reconstruction/file_lock.h"
#include "tests/planning/storage/run_sql.h"
#include "tests/planning/voxel_bodies.h"

namespace glisson {
namespace {
using namespace test;
namespace fs = std::filesystem;

class CaseFileTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "glisson-storage-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] fs::path file() const { return folder_ / "F\xC3\xA4lle 1.glisson"; }
  [[nodiscard]] std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};

std::vector<char> contentOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void writeContent(const fs::path& path, const std::vector<char>& content) {
  std::ofstream(path, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
}

std::string refusalOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

SurfaceMesh tetrahedron() {
  SurfaceMesh mesh;
  mesh.vertices = {Vec3(0, 0, 0), Vec3(1.0 / 3, 0, 0), Vec3(0, 0.1, 0), Vec3(0, 0, 1e-7)};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  return mesh;
}

Case sampleCase() {
  const ImageGeometry g = gridOf({40, 40, 24}, Vec3(0.1 + 0.2, 1, 1.6), Vec3(-20, 30, 400));
  const Vec3 c = g.toWorld(Vec3(20, 20, 12));
  auto segmentation = segmentationOf(g, {{"Leber \xC3\xA4", StructureKind::Liver, ball(c, 6)},
                                         {"tumour", StructureKind::Tumour, ball(c + Vec3(2, 0, 0), 2)},
                                         {"portal vein", StructureKind::PortalVein, tube(c, Vec3::UnitX(), 1.5)},
                                         {"spleen", StructureKind::Other, ball(c, 1)}});
  segmentation->structures[3].mask = nullptr;
  segmentation->structures[1].colour = Rgb{1, 2, 3};
  Case made = newCase(nullptr, segmentation);
  made.identity = {"Doe^Jane", "4711", "19700101", "20200202", "portal venous", "1.2.3"};
  made.notes.emplace_back("a note");
  made.patient = {170.1, std::nullopt, LiverCondition::LongChemotherapy, TumourType::ColorectalMetastases};
  made.territories = {{{"left", {Vec3(1, 2.0 / 3, -7)}}, {"Rücken", {Vec3(4, 5, 6), Vec3(0, 0, 0)}}}, true};
  Structure built = *made.model->find("tumour_01");
  auto reconstruction = std::make_shared<Reconstruction>();
  reconstruction->mesh = tetrahedron();
  reconstruction->parameters = ReconstructionParameters::defaultsFor(StructureKind::Tumour);
  reconstruction->meshVolumeMl = std::numeric_limits<double>::quiet_NaN();
  reconstruction->voxelVolumeMl = 0.1;
  reconstruction->defects.openEdges = 3;
  reconstruction->notes = {"thin"};
  reconstruction->deviations = {"lost a piece"};
  reconstruction->centrelineInside = 0.75;
  built.reconstruction = reconstruction;
  built.visible = false;
  made.model = withStructure(*made.model, built);
  made.plans[0].resections.push_back({"Resection 1", {{Vec3(0.1, 1.0 / 3, -7), Vec3(1, 2, 3).normalized()}}});
  return made;
}

ResectionPlan movedPlan(double x) { return {"Plan 1", {{"Resection 1", {{Vec3(x, 0, 0), Vec3::UnitX()}}}}, 10}; }

bool equal(const Mask& a, const Mask& b) {
  return a.box() == b.box() && std::equal(a.values().begin(), a.values().end(), b.values().begin(), b.values().end());
}

void expectEqual(const Case& a, const Case& b) {
  EXPECT_EQ(a.code, b.code);
  EXPECT_EQ(a.identity.patientName, b.identity.patientName);
  EXPECT_EQ(a.identity.frameOfReferenceUid, b.identity.frameOfReferenceUid);
  EXPECT_EQ(a.ctSource, b.ctSource);
  EXPECT_EQ(a.notes, b.notes);
  EXPECT_EQ(a.patient, b.patient);
  EXPECT_EQ(a.territories, b.territories);
  EXPECT_EQ(a.segmentation->geometry.spacing, b.segmentation->geometry.spacing);
  EXPECT_EQ(a.segmentation->geometry.origin, b.segmentation->geometry.origin);
  EXPECT_EQ(a.segmentation->geometry.direction, b.segmentation->geometry.direction);
  ASSERT_EQ(a.segmentation->structures.size(), b.segmentation->structures.size());
  for (std::size_t n = 0; n < a.segmentation->structures.size(); ++n) {
    const LabelledMask& x = a.segmentation->structures[n];
    const LabelledMask& y = b.segmentation->structures[n];
    EXPECT_EQ(x.name, y.name);
    EXPECT_EQ(x.kind, y.kind);
    EXPECT_EQ(x.label, y.label);
    EXPECT_EQ(x.colour, y.colour);
    ASSERT_EQ(x.mask == nullptr, y.mask == nullptr);
    EXPECT_TRUE(!x.mask || equal(*x.mask, *y.mask));
  }
  EXPECT_TRUE(equal(a.liver->liver, b.liver->liver));
  EXPECT_TRUE(equal(a.liver->tumour, b.liver->tumour));
  EXPECT_TRUE(equal(a.liver->functional, b.liver->functional));
  EXPECT_EQ(a.liver->notes, b.liver->notes);
  ASSERT_EQ(a.plans.size(), b.plans.size());
  for (std::size_t p = 0; p < a.plans.size(); ++p) {
    EXPECT_EQ(a.plans[p].name, b.plans[p].name);
    EXPECT_EQ(a.plans[p].safetyMarginMm, b.plans[p].safetyMarginMm);
    ASSERT_EQ(a.plans[p].resections.size(), b.plans[p].resections.size());
    for (std::size_t r = 0; r < a.plans[p].resections.size(); ++r) {
      EXPECT_EQ(a.plans[p].resections[r].planes[0].origin, b.plans[p].resections[r].planes[0].origin) << "bit for bit";
      EXPECT_EQ(a.plans[p].resections[r].planes[0].normal, b.plans[p].resections[r].planes[0].normal);
    }
  }
  EXPECT_EQ(a.model->revision, b.model->revision);
  ASSERT_EQ(a.model->structures.size(), b.model->structures.size());
}

TEST_F(CaseFileTest, WholeCaseComesBackAsItWas) {
  const Case source = sampleCase();
  { CaseFile::create(file(), source); }
  const Case read = CaseFile::open(file()).load();
  expectEqual(source, read);
  const Structure& tumour = *read.model->find("tumour_01");
  EXPECT_FALSE(tumour.visible);
  EXPECT_EQ(tumour.colour, (Rgb{1, 2, 3}));
  ASSERT_TRUE(tumour.reconstruction);
  EXPECT_EQ(tumour.reconstruction->mesh.vertices, tetrahedron().vertices) << "doubles bit for bit";
  EXPECT_EQ(tumour.reconstruction->mesh.triangles, tetrahedron().triangles);
  EXPECT_TRUE(std::isnan(tumour.reconstruction->meshVolumeMl));
  EXPECT_EQ(tumour.reconstruction->defects.openEdges, 3U);
  EXPECT_EQ(tumour.reconstruction->deviations, std::vector<std::string>{"lost a piece"});
  EXPECT_EQ(tumour.reconstruction->centrelineInside, 0.75);
  EXPECT_FALSE(read.model->find("parenchyma")->reconstruction);
  EXPECT_EQ(read.ct, nullptr);
}

TEST_F(CaseFileTest, NothingIsLeftBesideTheFile) {
  {
    CaseFile made = CaseFile::create(file(), sampleCase());
    made.storePlans({movedPlan(1)});
    EXPECT_EQ(entries(), 1U);
  }
  EXPECT_EQ(entries(), 1U);
}

TEST_F(CaseFileTest, EditsComeBackWithTheirUndoRecord) {
  const Case source = sampleCase();
  {
    CaseFile made = CaseFile::create(file(), source);
    made.storePlans({movedPlan(1)});
    made.storePlans({movedPlan(1)});
    made.storePlans({movedPlan(2)});
  }
  const CaseFile opened = CaseFile::open(file());
  EXPECT_EQ(opened.load().plans[0].resections[0].planes[0].origin[0], 2);
  const auto steps = opened.history();
  ASSERT_EQ(steps.size(), 2U) << "equal plans are no edit";
  EXPECT_EQ(steps[0].before[0].resections[0].planes[0].origin, source.plans[0].resections[0].planes[0].origin);
  EXPECT_EQ(steps[0].after[0].resections[0].planes[0].origin[0], 1);
  EXPECT_EQ(steps[1].before[0].resections[0].planes[0].origin[0], 1);
  EXPECT_EQ(steps[1].after[0].resections[0].planes[0].origin[0], 2);
  EXPECT_EQ(opened.history(1)[0].after[0].resections[0].planes[0].origin[0], 2);
}

TEST_F(CaseFileTest, ModelIsReplacedAsAWhole) {
  const Case source = sampleCase();
  CaseFile made = CaseFile::create(file(), source);
  Structure portal = *source.model->find("portal_vein");
  auto reconstruction = std::make_shared<Reconstruction>();
  reconstruction->mesh = tetrahedron();
  reconstruction->mesh.vertices[0] = Vec3(-1, -1, -1);
  portal.reconstruction = reconstruction;
  auto model = std::make_shared<LiverModel>(*withStructure(*source.model, portal));
  model->structures[1].reconstruction = nullptr;
  made.storeModel(*model);
  const Case read = made.load();
  EXPECT_EQ(read.model->revision, model->revision);
  EXPECT_EQ(read.model->find("portal_vein")->reconstruction->mesh.vertices[0], Vec3(-1, -1, -1));
  EXPECT_FALSE(read.model->find("tumour_01")->reconstruction);
}

TEST_F(CaseFileTest, PlanThatIsNotFiniteIsRefusedAndTheFileKeepsItsPlan) {
  CaseFile made = CaseFile::create(file(), sampleCase());
  made.storePlans({movedPlan(1)});
  EXPECT_THROW(made.storePlans({movedPlan(std::numeric_limits<double>::quiet_NaN())}), PlanningError);
  EXPECT_EQ(made.load().plans[0].resections[0].planes[0].origin[0], 1);
}

TEST_F(CaseFileTest, SecondOpenerReadsOnlyAndSeesWhatIsCommitted) {
  CaseFile writer = CaseFile::create(file(), sampleCase());
  CaseFile reader = CaseFile::open(file());
  EXPECT_FALSE(writer.readOnly());
  EXPECT_TRUE(reader.readOnly());
  writer.storePlans({movedPlan(5)});
  EXPECT_EQ(reader.load().plans[0].resections[0].planes[0].origin[0], 5);
  EXPECT_NE(refusalOf([&] { reader.storePlans({movedPlan(6)}); }).find("read-only"), std::string::npos);
  EXPECT_NE(refusalOf([&] { CaseFile::create(file(), sampleCase()); }).find("being edited"), std::string::npos);
  EXPECT_EQ(writer.load().plans[0].resections[0].planes[0].origin[0], 5);
}

TEST_F(CaseFileTest, WriterOfAnotherProcessIsRespectedUntilItEnds) {
  { CaseFile::create(file(), sampleCase()); }
  std::array<int, 2> ready{};
  std::array<int, 2> end{};
  ASSERT_EQ(::pipe(ready.data()), 0);
  ASSERT_EQ(::pipe(end.data()), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const CaseFile held = CaseFile::open(file());
    char byte = held.readOnly() ? 'r' : 'w';
    (void)!::write(ready[1], &byte, 1);
    (void)!::read(end[0], &byte, 1);
    ::_exit(0);
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  EXPECT_EQ(byte, 'w');
  EXPECT_TRUE(CaseFile::open(file()).readOnly());
  ASSERT_EQ(::write(end[1], &byte, 1), 1);
  ::waitpid(child, nullptr, 0);
  EXPECT_FALSE(CaseFile::open(file()).readOnly());
}

TEST_F(CaseFileTest, KilledAtAnyInstantOpensWithTheStateBeforeOrAfterAnEdit) {
  { CaseFile::create(file(), sampleCase()); }
  for (int n = 0; n < 30; ++n) {
    std::array<int, 2> pipe{};
    ASSERT_EQ(::pipe(pipe.data()), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      CaseFile opened = CaseFile::open(file());
      for (std::int64_t step = 1;; ++step) {
        opened.storePlans({movedPlan(static_cast<double>(1000 * n + step))});
        (void)!::write(pipe[1], &step, sizeof(step));  // told only once it is committed
      }
    }
    ::close(pipe[1]);
    std::int64_t told = 0;
    while (told < 2) {
      ASSERT_EQ(::read(pipe[0], &told, sizeof(told)), static_cast<ssize_t>(sizeof(told)));
    }
    std::this_thread::sleep_for(std::chrono::microseconds(397 * n));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    std::int64_t more = 0;
    while (::read(pipe[0], &more, sizeof(more)) == static_cast<ssize_t>(sizeof(more))) {
      told = more;
    }
    ::close(pipe[0]);
    const CaseFile opened = CaseFile::open(file());
    EXPECT_FALSE(opened.readOnly());
    const double found = opened.load().plans[0].resections[0].planes[0].origin[0] - 1000 * n;
    EXPECT_GE(found, static_cast<double>(told)) << "a committed edit is lost";
    EXPECT_LE(found, static_cast<double>(told) + 1) << "an edit that was never made";
    EXPECT_EQ(opened.history(1)[0].after[0].resections[0].planes[0].origin[0], found + 1000 * n);
  }
  // A kill between making and filling SQLite's journal leaves an empty one behind; the next edit takes it away.
  CaseFile::open(file()).storePlans({movedPlan(1)});
  EXPECT_EQ(entries(), 1U);
}

TEST_F(CaseFileTest, KilledWhileCreatingLeavesTheOldFile) {
  { CaseFile::create(file(), sampleCase()); }
  for (int n = 0; n < 10; ++n) {
    const pid_t child = ::fork();
    if (child == 0) {
      for (;;) {
        Case other = sampleCase();
        other.plans = {movedPlan(77)};
        CaseFile::create(file(), other);
      }
    }
    std::this_thread::sleep_for(std::chrono::microseconds(2311 * n));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    expectEqual(CaseFile::open(file()).load(), CaseFile::open(file()).load());
  }
}

TEST_F(CaseFileTest, FolderThatCannotBeWrittenIsRefusedAndNothingIsLeft) {
  EXPECT_NE(refusalOf([&] { CaseFile::create(folder_ / "missing" / "a.glisson", sampleCase()); }).find("cannot be written"),
            std::string::npos);
  fs::create_directory(folder_ / "taken.glisson");
  EXPECT_FALSE(refusalOf([&] { CaseFile::create(folder_ / "taken.glisson", sampleCase()); }).empty());
  EXPECT_EQ(entries(), 1U);
}

TEST_F(CaseFileTest, FullDiskIsRefusedAndTheFileKeepsItsState) {
  {
    CaseFile made = CaseFile::create(file(), sampleCase());
    made.storePlans({movedPlan(1)});
  }
  const pid_t child = ::fork();
  if (child == 0) {
    // A limit on the file's size meets SQLite's writes as a full disk does.
    CaseFile made = CaseFile::open(file());
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{static_cast<rlim_t>(fs::file_size(file())), static_cast<rlim_t>(fs::file_size(file()))};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    int refused = 1;
    try {
      for (int n = 0; n < 1000; ++n) {
        made.storePlans({movedPlan(n + 100)});
      }
    } catch (const InputError&) {
      refused = 0;
    }
    ::_exit(refused);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0) << "the child met no limit";
  EXPECT_GE(CaseFile::open(file()).load().plans[0].resections[0].planes[0].origin[0], 1);
}

TEST_F(CaseFileTest, NewerVersionIsRefusedWithASentence) {
  { CaseFile::create(file(), sampleCase()); }
  runSql(file(), "PRAGMA user_version=4");
  EXPECT_NE(refusalOf([&] { CaseFile::open(file()); }).find("newer Glisson"), std::string::npos);
}

TEST_F(CaseFileTest, OtherFilesAreNoCase) {
  writeContent(folder_ / "text", std::vector<char>(5000, 'x'));
  writeContent(folder_ / "empty", {});
  runSql(folder_ / "other", "CREATE TABLE a(b)");
  for (const char* name : {"text", "empty", "other"}) {
    EXPECT_NE(refusalOf([&] { CaseFile::open(folder_ / name); }).find("is not a Glisson case"), std::string::npos) << name;
  }
  EXPECT_FALSE(refusalOf([&] { CaseFile::open(folder_); }).empty());
  EXPECT_FALSE(refusalOf([&] { CaseFile::open(folder_ / "missing"); }).empty());
}

TEST_F(CaseFileTest, TruncatedFileIsRefusedAtEveryLength) {
  { CaseFile::create(file(), sampleCase()); }
  const std::vector<char> whole = contentOf(file());
  const fs::path cut = folder_ / "cut.glisson";
  for (std::size_t n = 0; n < 300; ++n) {
    writeContent(cut, std::vector<char>(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.size() * n / 300)));
    EXPECT_FALSE(refusalOf([&] { (void)CaseFile::open(cut).load(); }).empty()) << n << " of 300";
  }
}

TEST_F(CaseFileTest, ChangedByteIsRefusedOrWithoutEffect) {
  { CaseFile::create(file(), sampleCase()); }
  const std::vector<char> whole = contentOf(file());
  const Case source = CaseFile::open(file()).load();
  const fs::path changed = folder_ / "changed.glisson";
  int refused = 0;
  for (std::size_t n = 0; n < 400; ++n) {
    std::vector<char> content = whole;
    content[content.size() * n / 400 + n % 7] ^= static_cast<char>(1U << (n % 8));
    writeContent(changed, content);
    try {
      expectEqual(source, CaseFile::open(changed).load());
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 20);
}

TEST_F(CaseFileTest, DocumentThatDoesNotFitIsRefused) {
  { CaseFile::create(file(), sampleCase()); }
  runSql(file(), "UPDATE part SET data = zeroblob(100) WHERE key = 'mask/0'");
  EXPECT_NE(refusalOf([&] { (void)CaseFile::open(file()).load(); }).find("damaged"), std::string::npos);
  { CaseFile::create(file(), sampleCase()); }
  runSql(file(), "UPDATE document SET json = replace(json, '10.0', '90.0') WHERE key = 'plans'");
  EXPECT_NE(refusalOf([&] { (void)CaseFile::open(file()).load(); }).find("checksum"), std::string::npos);
}

TEST_F(CaseFileTest, KnowsWhetherTheCtIsStillTheSame) {
  fs::create_directory(folder_ / "ct");
  writeContent(folder_ / "ct" / "a", {'a'});
  writeContent(folder_ / "ct" / "b", {'b'});
  Case source = sampleCase();
  source.ctSource = (folder_ / "ct").string();
  const CaseFile made = CaseFile::create(file(), source);
  EXPECT_TRUE(made.ctUnchanged());
  writeContent(folder_ / "ct" / "b", {'c'});
  EXPECT_FALSE(made.ctUnchanged());
  fs::remove_all(folder_ / "ct");
  EXPECT_FALSE(made.ctUnchanged());
}

TEST_F(CaseFileTest, CtThatMayNotBeReadIsNotKnownToBeTheSame) {
  fs::create_directory(folder_ / "ct");
  writeContent(folder_ / "ct" / "a", {'a'});
  Case source = sampleCase();
  source.ctSource = (folder_ / "ct").string();
  const CaseFile made = CaseFile::create(file(), source);
  fs::remove(folder_ / "ct" / "a");
  fs::create_symlink("/proc/self/mem", folder_ / "ct" / "a");  // a regular file that nobody can read from its beginning
  EXPECT_THROW((void)hashCtFiles(folder_ / "ct"), InputError);
  EXPECT_FALSE(made.ctUnchanged());
}

TEST_F(CaseFileTest, ADraftOfAKilledProgramIsRemovedAndThatOfALivingOneIsNot) {
  std::array<int, 2> ready{};
  ASSERT_EQ(::pipe(ready.data()), 0);
  const fs::path draft = folder_ / ("." + file().filename().string() + ".a1B2c3");
  const pid_t child = ::fork();
  if (child == 0) {
    std::ofstream(draft) << "half a case";
    const FileLock held(draft);
    const char byte = held.isWriter() ? 'w' : 'r';
    (void)!::write(ready[1], &byte, 1);
    ::pause();
    ::_exit(0);
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  ASSERT_EQ(byte, 'w');
  (void)CaseFile::create(file(), sampleCase());
  EXPECT_TRUE(fs::exists(draft));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  (void)CaseFile::create(file(), sampleCase());
  EXPECT_EQ(entries(), 1U);
}

}  // namespace
}  // namespace glisson
