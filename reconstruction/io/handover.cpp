#include "reconstruction/io/handover.h"

#include <bit>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <type_traits>

#include "reconstruction/errors.h"

namespace glisson {

namespace {
static_assert(std::endian::native == std::endian::little);
constexpr std::uint64_t kRequestMagic = 0x31515249534C47ULL;
constexpr std::uint64_t kAnswerMagic = 0x31534E4149534C47ULL;
constexpr std::uint64_t kMaxTextBytes = 1ULL << 20;
constexpr std::uint64_t kMaxItems = 1ULL << 16;

struct FileCloser {
  void operator()(std::FILE* file) const { static_cast<void>(std::fclose(file)); }
};
using File = std::unique_ptr<std::FILE, FileCloser>;

class Writer {
 public:
  explicit Writer(const std::filesystem::path& path) : file_(std::fopen(path.c_str(), "wbe")) {
    if (!file_) {
      throw std::runtime_error("the hand-over file cannot be written");
    }
  }
  template <typename T>
  void number(T value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes(&value, sizeof value);
  }
  void text(const std::string& value) {
    number<std::uint64_t>(value.size());
    bytes(value.data(), value.size());
  }
  template <typename T>
  void array(std::span<const T> values) {
    number<std::uint64_t>(values.size());
    bytes(values.data(), values.size_bytes());
  }
  void texts(const std::vector<std::string>& values) {
    number<std::uint64_t>(values.size());
    for (const std::string& value : values) {
      text(value);
    }
  }
  void finish() {
    std::FILE* file = file_.release();
    if (std::fclose(file) != 0) {
      throw std::runtime_error("the hand-over file cannot be written: the temporary folder is full");
    }
  }

 private:
  void bytes(const void* data, std::size_t size) {
    if (size > 0 && std::fwrite(data, 1, size, file_.get()) != size) {
      throw std::runtime_error("the hand-over file cannot be written: the temporary folder is full");
    }
  }
  File file_;
};

class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : file_(std::fopen(path.c_str(), "rbe")) {
    if (!file_) {
      throw std::runtime_error("the hand-over file is missing");
    }
    left_ = std::filesystem::file_size(path);
  }
  template <typename T>
  T number() {
    T value{};
    bytes(&value, sizeof value);
    return value;
  }
  /// A number of items, each at least one byte long.
  std::size_t count(std::uint64_t most) {
    const auto n = number<std::uint64_t>();
    if (n > most || n > left_) {
      throw std::runtime_error("the hand-over file promises more than it holds");
    }
    return n;
  }
  std::string text() {
    std::string value(count(kMaxTextBytes), '\0');
    bytes(value.data(), value.size());
    return value;
  }
  template <typename T>
  std::vector<T> array(std::size_t expected) {
    if (number<std::uint64_t>() != expected || expected > left_ / sizeof(T)) {
      throw std::runtime_error("the hand-over file's array has another size than its grid");
    }
    std::vector<T> values(expected);
    bytes(values.data(), expected * sizeof(T));
    return values;
  }
  std::vector<std::string> texts() {
    std::vector<std::string> values(count(kMaxItems));
    for (std::string& value : values) {
      value = text();
    }
    return values;
  }
  template <typename Enum>
  Enum enumerator(Enum last) {
    const auto value = number<std::uint8_t>();
    if (value > static_cast<std::uint8_t>(last)) {
      throw std::runtime_error("the hand-over file holds an unknown choice");
    }
    return static_cast<Enum>(value);
  }
  void finish() const {
    if (left_ != 0) {
      throw std::runtime_error("the hand-over file holds more than its message");
    }
  }

 private:
  void bytes(void* data, std::size_t size) {
    if (size > left_ || (size > 0 && std::fread(data, 1, size, file_.get()) != size)) {
      throw std::runtime_error("the hand-over file ends early");
    }
    left_ -= size;
  }
  File file_;
  std::uint64_t left_ = 0;
};

void writeGeometry(Writer& out, const ImageGeometry& geometry) {
  for (std::size_t a = 0; a < 3; ++a) {
    out.number(geometry.size[a]);
  }
  for (int a = 0; a < 3; ++a) {
    out.number(geometry.spacing[a]);
    out.number(geometry.origin[a]);
    for (int b = 0; b < 3; ++b) {
      out.number(geometry.direction(a, b));
    }
  }
}

ImageGeometry readGeometry(Reader& in) {
  ImageGeometry geometry;
  for (std::size_t a = 0; a < 3; ++a) {
    geometry.size[a] = in.number<int>();
  }
  for (int a = 0; a < 3; ++a) {
    geometry.spacing[a] = in.number<double>();
    geometry.origin[a] = in.number<double>();
    for (int b = 0; b < 3; ++b) {
      geometry.direction(a, b) = in.number<double>();
    }
  }
  try {
    geometry.validate("The image");
  } catch (const Error& error) {
    throw std::runtime_error(error.what());
  }
  constexpr std::size_t kMostVoxels = std::size_t{1} << 40;
  std::size_t voxels = 1;
  for (const int n : geometry.size) {
    if (static_cast<std::size_t>(n) > kMostVoxels / voxels) {
      throw std::runtime_error("the hand-over file's grid is impossibly large");
    }
    voxels *= static_cast<std::size_t>(n);
  }
  return geometry;
}

void writeCt(Writer& out, const CtVolume& ct) {
  writeGeometry(out, ct.geometry);
  for (const std::string* text : {&ct.identity.patientName, &ct.identity.patientId, &ct.identity.birthDate, &ct.identity.studyDate,
                                  &ct.identity.seriesDescription, &ct.identity.frameOfReferenceUid, &ct.source}) {
    out.text(*text);
  }
  out.texts(ct.notes);
  out.array<std::int16_t>(ct.hounsfield);
}

CtVolume readCtVolume(Reader& in) {
  CtVolume ct;
  ct.geometry = readGeometry(in);
  for (std::string* text : {&ct.identity.patientName, &ct.identity.patientId, &ct.identity.birthDate, &ct.identity.studyDate,
                            &ct.identity.seriesDescription, &ct.identity.frameOfReferenceUid, &ct.source}) {
    *text = in.text();
  }
  ct.notes = in.texts();
  ct.hounsfield = in.array<std::int16_t>(ct.geometry.voxelCount());
  return ct;
}

void writeStructure(Writer& out, const LabelledMask& structure) {
  out.text(structure.name);
  out.number(structure.label);
  out.number<std::uint8_t>(structure.kind ? 1 : 0);
  out.number(structure.kind.value_or(StructureKind::Other));
  out.number<std::uint8_t>(structure.colour ? 1 : 0);
  out.number(structure.colour.value_or(Rgb{}));
  out.number<std::uint8_t>(structure.mask ? 1 : 0);
  if (structure.mask) {
    out.number(structure.mask->box().first);
    out.number(structure.mask->box().size);
    out.array(structure.mask->values());
  }
}

LabelledMask readStructure(Reader& in, const Index3& gridSize) {
  LabelledMask structure;
  structure.name = in.text();
  structure.label = in.number<int>();
  const bool hasKind = in.number<std::uint8_t>() != 0;
  const auto kind = in.enumerator(StructureKind::Other);
  if (hasKind) {
    structure.kind = kind;
  }
  const bool hasColour = in.number<std::uint8_t>() != 0;
  const auto colour = in.number<Rgb>();
  if (hasColour) {
    structure.colour = colour;
  }
  if (in.number<std::uint8_t>() == 0) {
    if (!hasKind || kind != StructureKind::Other) {
      throw std::runtime_error("the hand-over file leaves out a mask");
    }
    return structure;
  }
  IndexBox box;
  box.first = in.number<Index3>();
  box.size = in.number<Index3>();
  for (std::size_t a = 0; a < 3; ++a) {
    if (box.first[a] < 0 || box.size[a] < 0 || box.size[a] > gridSize[a] || box.first[a] > gridSize[a] - box.size[a]) {
      throw std::runtime_error("the hand-over file's mask leaves its grid");
    }
  }
  structure.mask = std::make_shared<const Mask>(box, in.array<std::uint8_t>(box.voxelCount()));
  return structure;
}

void writeSegmentation(Writer& out, const Segmentation& segmentation) {
  writeGeometry(out, segmentation.geometry);
  out.text(segmentation.source);
  out.text(segmentation.patientId);
  out.text(segmentation.frameOfReferenceUid);
  out.texts(segmentation.notes);
  out.number<std::uint64_t>(segmentation.structures.size());
  for (const LabelledMask& structure : segmentation.structures) {
    writeStructure(out, structure);
  }
}

Segmentation readSegmentationAnswer(Reader& in) {
  Segmentation segmentation;
  segmentation.geometry = readGeometry(in);
  segmentation.source = in.text();
  segmentation.patientId = in.text();
  segmentation.frameOfReferenceUid = in.text();
  segmentation.notes = in.texts();
  const std::size_t structures = in.count(kMaxItems);
  for (std::size_t n = 0; n < structures; ++n) {
    segmentation.structures.push_back(readStructure(in, segmentation.geometry.size));
  }
  return segmentation;
}
}  // namespace

void writeRequest(const std::filesystem::path& file, const ImportRequest& request) {
  Writer out(file);
  out.number(kRequestMagic);
  out.number(request.task);
  out.text(request.path.string());
  out.number<std::uint64_t>(request.options.consents.size());
  for (const Consent consent : request.options.consents) {
    out.number(consent);
  }
  out.number(request.options.niftiFrame);
  out.number<std::uint64_t>(request.options.kindByLabel.size());
  for (const auto& [label, kind] : request.options.kindByLabel) {
    out.number(label);
    out.number(kind);
  }
  out.number<std::uint64_t>(request.options.kindByName.size());
  for (const auto& [name, kind] : request.options.kindByName) {
    out.text(name);
    out.number(kind);
  }
  out.text(request.options.labelTable);
  out.number(request.options.budgetBytes);
  out.finish();
}

ImportRequest readRequest(const std::filesystem::path& file) {
  Reader in(file);
  if (in.number<std::uint64_t>() != kRequestMagic) {
    throw std::runtime_error("not a request");
  }
  ImportRequest request;
  request.task = in.enumerator(ImportTask::Guess);
  request.path = in.text();
  for (std::size_t n = in.count(kMaxItems); n > 0; --n) {
    request.options.consents.insert(in.enumerator(Consent::OtherPatient));
  }
  request.options.niftiFrame = in.enumerator(NiftiFrame::QForm);
  for (std::size_t n = in.count(kMaxItems); n > 0; --n) {
    const int label = in.number<int>();
    request.options.kindByLabel[label] = in.enumerator(StructureKind::Other);
  }
  for (std::size_t n = in.count(kMaxItems); n > 0; --n) {
    const std::string name = in.text();
    request.options.kindByName[name] = in.enumerator(StructureKind::Other);
  }
  request.options.labelTable = in.text();
  request.options.budgetBytes = in.number<std::uint64_t>();
  in.finish();
  return request;
}

void writeAnswer(const std::filesystem::path& file, const ImportAnswer& answer) {
  Writer out(file);
  out.number(kAnswerMagic);
  out.number(static_cast<std::uint8_t>(answer.index()));
  if (const auto* failure = std::get_if<ImportFailure>(&answer)) {
    out.text(failure->message);
  } else if (const auto* ct = std::get_if<CtVolume>(&answer)) {
    writeCt(out, *ct);
  } else if (const auto* segmentation = std::get_if<Segmentation>(&answer)) {
    writeSegmentation(out, *segmentation);
  } else {
    out.number(std::get<InputKind>(answer));
  }
  out.finish();
}

ImportAnswer readAnswer(const std::filesystem::path& file) {
  Reader in(file);
  if (in.number<std::uint64_t>() != kAnswerMagic) {
    throw std::runtime_error("not an answer");
  }
  ImportAnswer answer;
  switch (in.number<std::uint8_t>()) {
    case 0:
      answer = ImportFailure{in.text()};
      break;
    case 1:
      answer = readCtVolume(in);
      break;
    case 2:
      answer = readSegmentationAnswer(in);
      break;
    case 3:
      answer = in.enumerator(InputKind::Unknown);
      break;
    default:
      throw std::runtime_error("not an answer");
  }
  in.finish();
  return answer;
}

}  // namespace glisson
