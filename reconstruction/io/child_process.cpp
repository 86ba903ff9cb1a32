#include "reconstruction/io/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <limits>

#include "reconstruction/errors.h"
#include "reconstruction/file_lock.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kPollMs = 50;

class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  void close() {
    if (value_ >= 0) {
      ::close(value_);
      value_ = -1;
    }
  }
  [[nodiscard]] int get() const { return value_; }

 private:
  int value_;
};

/// A private folder that goes with the object, or with the next one where the program is killed.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const fs::path place = fs::temp_directory_path();
    const std::string prefix = "glisson-import-";
    removeAbandoned(place, [&](const std::string& name) { return name.starts_with(prefix) && isOld(place / name); });
    std::string pattern = (place / (prefix + "XXXXXX")).string();
    if (::mkdtemp(pattern.data()) == nullptr) {
      throw InputError("No temporary folder can be made in " + place.string() + "; free some space there.");
    }
    path_ = pattern;
    lock_ = FileLock(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] fs::path file(const char* name) const { return path_ / name; }

 private:
  /// A younger one may be another program's that has not locked it yet.
  static bool isOld(const fs::path& folder) {
    constexpr auto kMinute = std::chrono::minutes(1);
    std::error_code gone;
    const fs::file_time_type changed = fs::last_write_time(folder, gone);
    return !gone && fs::file_time_type::clock::now() - changed >= kMinute;
  }

  fs::path path_;
  FileLock lock_;
};

/// A started child; killed and reaped with the object unless it was waited for.
class Child {
 public:
  explicit Child(pid_t pid) : pid_(pid) {}
  ~Child() {
    if (pid_ > 0) {
      ::kill(pid_, SIGKILL);
      wait();
    }
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  int wait() {
    int status = 0;
    while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
    return status;
  }

 private:
  pid_t pid_;
};

/// In its own process group, so that Ctrl+C in a terminal reaches the program first, which then reports a cancel.
pid_t spawn(const fs::path& program, const std::vector<std::string>& arguments, int standardOutput) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, standardOutput, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  std::string name = program.string();
  std::vector<std::string> words = arguments;
  std::vector<char*> argv{name.data()};
  for (std::string& word : words) {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);
  pid_t pid = -1;
  const int error = posix_spawn(&pid, name.c_str(), &actions, &attributes, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  return error == 0 ? pid : -1;
}

/// "0.25<TAB>slices" lines become progress.
void tellProgress(std::string& pending, const ExecutionContext& context) {
  std::size_t end = 0;
  while ((end = pending.find('\n')) != std::string::npos) {
    const std::string line = pending.substr(0, end);
    pending.erase(0, end + 1);
    const std::size_t tab = line.find('\t');
    if (tab == std::string::npos) {
      continue;
    }
    if (const auto fraction = parseNumber(line.substr(0, tab)); fraction && *fraction >= 0 && *fraction <= 1) {
      context.report(*fraction, line.substr(tab + 1));
    }
  }
  if (pending.size() > 4096) {
    pending.clear();
  }
}

/// Follows the child's progress until it closes its output. False where the time limit passed. Throws Cancelled.
bool follow(int descriptor, int timeLimitSeconds, const ExecutionContext& context) {
  const auto deadline = Clock::now() + std::chrono::seconds(timeLimitSeconds);
  std::string pending;
  while (true) {
    context.throwIfCancelled();
    if (Clock::now() > deadline) {
      return false;
    }
    pollfd ready{descriptor, POLLIN, 0};
    if (::poll(&ready, 1, kPollMs) <= 0) {
      continue;
    }
    std::array<char, 4096> buffer{};
    const ssize_t n = ::read(descriptor, buffer.data(), buffer.size());
    if (n == 0 || (n < 0 && errno != EINTR && errno != EAGAIN)) {
      return true;
    }
    if (n > 0) {
      pending.append(buffer.data(), static_cast<std::size_t>(n));
      tellProgress(pending, context);
    }
  }
}

/// Room for the file's own copy, the volume made of it and the libraries.
std::uint64_t memoryLimit(std::uint64_t budgetBytes) {
  constexpr std::uint64_t kLibraries = 1ULL << 30;
  constexpr std::uint64_t kMost = std::numeric_limits<std::int64_t>::max();
  return budgetBytes > (kMost - kLibraries) / 3 ? kMost : budgetBytes * 3 + kLibraries;
}

[[noreturn]] void throwTimeOut(const ImportRequest& request) {
  throw InputError(request.path.string() + " was not read within " + std::to_string(request.options.timeLimitSeconds) +
                   " seconds; check the file, or copy it to a faster disk.");
}
}  // namespace

fs::path findImporter() {
  if (const char* named = std::getenv("GLISSON_IMPORT"); named != nullptr && *named != '\0') {
    return fs::exists(named) ? fs::path(named) : fs::path();
  }
  std::error_code ignored;
  const fs::path here = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const fs::path& folder : {here, here / "../lib/glisson", here / "../libexec/glisson"}) {
    if (fs::exists(folder / "glisson-import", ignored)) {
      return folder / "glisson-import";
    }
  }
  return {};
}

ImportAnswer runImporter(const ImportRequest& request, const ExecutionContext& context) {
  context.throwIfCancelled();
  const std::string name = request.path.string();
  const fs::path program = findImporter();
  if (program.empty()) {
    throw InputError(name + " cannot be read because the program part glisson-import is missing; install Glisson again.");
  }
  const TemporaryFolder folder;
  const fs::path answerFile = folder.file("answer");
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw InputError(name + " cannot be read because the system has no free file handles; close other programs.");
  }
  Descriptor readEnd(ends[0]);
  Descriptor writeEnd(ends[1]);
  try {
    writeRequest(folder.file("request"), request);
  } catch (const std::runtime_error& error) {
    throw InputError(name + " cannot be read because " + error.what() + "; free some space there.");
  }
  const int cpuSeconds = request.options.timeLimitSeconds * 8 + 10;  // several threads; the wall time is the tighter limit
  const pid_t pid = spawn(program,
                          {folder.file("request").string(), answerFile.string(),
                           std::to_string(memoryLimit(request.options.budgetBytes)), std::to_string(cpuSeconds)},
                          writeEnd.get());
  writeEnd.close();
  if (pid < 0) {
    throw InputError(name + " cannot be read because " + program.string() + " does not start; install Glisson again.");
  }
  Child child(pid);
  if (!follow(readEnd.get(), request.options.timeLimitSeconds, context)) {
    throwTimeOut(request);
  }
  const int status = child.wait();
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) {
    throwTimeOut(request);
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw InputError(name + " cannot be read because its decoder failed on it, as a damaged file makes it do; export it again.");
  }
  ImportAnswer answer;
  try {
    answer = readAnswer(answerFile);
  } catch (const std::exception& error) {
    throw InputError(name + " cannot be read because " + error.what() + "; export it again.");
  }
  if (const auto* failure = std::get_if<ImportFailure>(&answer)) {
    throw InputError(failure->message);
  }
  return answer;
}

}  // namespace glisson
