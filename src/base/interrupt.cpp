#include "base/interrupt.h"

#include <csignal>

namespace ctpbench {
namespace {

volatile std::sig_atomic_t seen = 0;

extern "C" void on_signal(int) { seen = 1; }

}  // namespace

void watch_for_interrupt() {
    struct sigaction action {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESETHAND;  // the second signal has its default effect
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() { return seen != 0; }

}  // namespace ctpbench
