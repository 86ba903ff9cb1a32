// glisson-import REQUEST ANSWER MEMORY_BYTES CPU_SECONDS: the only process that parses files from outside. Limits itself, reads one
// request, writes one answer (a validated volume or one sentence) and ends. Progress goes to standard output, a line each:
// fraction, TAB, phase. An ending without an answer is for the parent to explain.

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcdict.h>
#include <dcmtk/oflog/oflog.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>

#include "reconstruction/errors.h"
#include "reconstruction/io/import/dicom_pixels.h"
#include "reconstruction/io/import/importers.h"
#include "reconstruction/text.h"

namespace {
using namespace glisson;

void limit(int resource, std::uint64_t value) {
  const rlimit limits{value, value};
  setrlimit(static_cast<__rlimit_resource_t>(resource), &limits);
}

void limitSelf(const char* memoryBytes, const char* cpuSeconds) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody waits for the answer any more
  limit(RLIMIT_CORE, 0);             // a core would hold the patient's data
  if (const auto seconds = parseInteger(cpuSeconds); seconds && *seconds > 0) {
    limit(RLIMIT_CPU, static_cast<std::uint64_t>(*seconds));
  }
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // sanitizers reserve terabytes of addresses
  if (const auto bytes = parseInteger(memoryBytes); bytes && *bytes > 0) {
    limit(RLIMIT_AS, static_cast<std::uint64_t>(*bytes));
  }
#else
  static_cast<void>(memoryBytes);
#endif
}

ImportAnswer answerTo(const ImportRequest& request) {
  const ExecutionContext context([](double fraction, std::string_view phase) {
    const std::string line = formatNumber(fraction, 4) + "\t" + std::string(phase) + "\n";
    static_cast<void>(!::write(STDOUT_FILENO, line.data(), line.size()));
  });
  const std::string name = request.path.string();
  try {
    switch (request.task) {
      case ImportTask::Ct:
        return import::importCt(request.path, request.options, context);
      case ImportTask::Segmentation:
        return import::importSegmentation(request.path, request.options, context);
      case ImportTask::Guess:
        return import::guessKind(request.path, request.options);
    }
    return ImportFailure{name + " cannot be read: the request is unknown; install Glisson again."};
  } catch (const Error& error) {
    return ImportFailure{error.what()};
  } catch (const std::bad_alloc&) {
    return ImportFailure{name + " needs more memory than is allowed for reading; crop or resample it first."};
  } catch (const std::filesystem::filesystem_error& error) {
    return ImportFailure{name + " cannot be read (" + error.code().message() + "); check that you may read it."};
  } catch (const std::exception& error) {
    return ImportFailure{name + " cannot be read (" + error.what() + "); export it again."};
  }
}
}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    static_cast<void>(std::fputs("glisson-import is started by Glisson itself: REQUEST ANSWER MEMORY_BYTES CPU_SECONDS\n", stderr));
    return 2;
  }
  limitSelf(argv[3], argv[4]);
  setenv("TMPDIR", std::filesystem::absolute(argv[2]).parent_path().c_str(),
         1);                      // what is left there goes with the parent's folder
  unsetenv("ITK_AUTOLOAD_PATH");  // no decoders from elsewhere
  static_cast<void>(std::setlocale(LC_ALL, "C"));
  OFLog::configure(OFLogger::OFF_LOG_LEVEL);
  try {
    const import::DicomDecoders decoders;
    const ImportRequest request = readRequest(argv[1]);
    writeAnswer(argv[2], answerTo(request));
  } catch (const std::exception&) {
    return 1;
  }
  return 0;
}
