#include "app/cli/interrupt.h"

#include <pthread.h>
#include <unistd.h>

#include "app/cli/command.h"

namespace glisson::cli {

InterruptCancels::InterruptCancels(const ExecutionContext& context) {
  sigset_t waited;
  sigemptyset(&waited);
  sigaddset(&waited, SIGINT);
  sigaddset(&waited, SIGTERM);
  sigaddset(&waited, SIGUSR1);  // sent by the destructor
  pthread_sigmask(SIG_BLOCK, &waited, &before_);
  thread_ = std::thread([context, waited] {
    for (bool asked = false;;) {
      int signal = 0;
      if (sigwait(&waited, &signal) != 0 || signal == SIGUSR1) {
        return;
      }
      if (asked) {
        _exit(kInterrupted);
      }
      asked = true;
      context.cancel();
    }
  });
}

InterruptCancels::~InterruptCancels() {
  pthread_kill(thread_.native_handle(), SIGUSR1);
  thread_.join();
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

}  // namespace glisson::cli
